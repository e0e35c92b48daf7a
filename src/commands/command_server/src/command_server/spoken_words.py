"""Splits an utterance into words in plain spelling, whatever keyboard or speech recogniser wrote it."""

import re
import unicodedata
from typing import Dict, Iterable, List, Mapping, NamedTuple, Sequence, Tuple

Phrase = Tuple[str, ...]

# People say less than this at a time; the rest is ignored.
_MOST_CHARACTERS = 4000


class Token(NamedTuple):
    """A word in plain spelling, "," for a pause or "." for the end of a sentence, with its position in the text."""

    word: str
    start: int
    end: int


_TOKEN = re.compile(
    r"\d+(?:[.:,]\d+)*|[^\W_]+(?:'[^\W_]+)*|\.\.+|[.!?;\n]+|[,:()\u2026\u2013\u2014]+|(?<!\w)-+|-+(?!\w)"
)
_QUOTED = re.compile(r"\"[^\"]*\"|(?<!\w)'[^']*'(?!\w)")
_LENGTHENED = re.compile(r"([^\W\d_])\1{2,}")
_CONTRACTIONS: Mapping[str, str] = {
    "dont": "do not",
    "cant": "can not",
    "can't": "can not",
    "cannot": "can not",
    "wont": "will not",
    "won't": "will not",
    "didnt": "did not",
    "doesnt": "does not",
    "isnt": "is not",
    "shouldnt": "should not",
    "mustnt": "must not",
    "neednt": "need not",
    "im": "i am",
    "ive": "i have",
    "youre": "you are",
    "youll": "you will",
    "thats": "that is",
    "theres": "there is",
    "its": "it is",
    "whats": "what is",
    "lets": "let us",
    "let's": "let us",
    "gonna": "going to",
    "wanna": "want to",
    "gotta": "have to",
    "'m": "am",
    "'re": "are",
    "'ve": "have",
    "'ll": "will",
    "'d": "would",
    "'s": "s",
}
_IS = frozenset("it that there what where he she who here".split())


def _spelled_out(word: str) -> Sequence[str]:
    """Return the words of a word: "don't" are two."""
    if word in _CONTRACTIONS:
        return _CONTRACTIONS[word].split()
    if "'" not in word:
        return [word]
    if word.endswith("n't"):
        return [word[:-3], "not"]
    stem, ending = word.rsplit("'", 1)
    if ending == "s" and stem in _IS:
        return [stem, "is"]
    return [stem, *_CONTRACTIONS.get("'" + ending, ending).split()]


def plain_text(text: str) -> Tuple[str, str]:
    """Return the beginning of a text in plain characters, and the same with blanks for what is quoted in it."""
    text = unicodedata.normalize("NFKC", text[:_MOST_CHARACTERS])[:_MOST_CHARACTERS]
    for fancy, plain in (("\u2018", "'"), ("\u2019", "'"), ("\u201c", '"'), ("\u201d", '"')):
        text = text.replace(fancy, plain)
    unquoted = _QUOTED.sub(lambda quoted: " " * len(quoted.group()), text)
    # A text that is quoted as a whole was typed with quotation marks, so its words count.
    return text, unquoted if re.search(r"\w", unquoted) else text


def tokens_of(plain: str) -> List[Token]:
    """Return the words and pauses of a text."""
    found: List[Token] = []
    last = before_last = ""
    # "Stooop" is "stop".
    lengthened = _LENGTHENED.search(plain) is not None
    for match in _TOKEN.finditer(plain):
        said, (start, end) = match.group().lower(), match.span()
        if lengthened:
            said = _LENGTHENED.sub(r"\1", said)
        if not said[0].isalnum():
            said = "." if said[0] in ".!?;\n" and (end - start == 1 or said[1] != ".") else ","
            if said == "." and last in ("", "."):
                continue
            found.append(Token(said, start, end))
        elif said in _CONTRACTIONS or "'" in said:
            found.extend(Token(word, start, end) for word in _spelled_out(said))
        else:
            if said == before_last == "no" and last == ".":
                # "No! No!" is one cry.
                found.pop()
            found.append(Token(said, start, end))
        before_last, last = last, found[-1].word
    return found


def words_of(text: str) -> str:
    """Return the words of a text in lower case with one space between them, without marks."""
    return " ".join(token.word for token in tokens_of(plain_text(text)[1]) if token.word[:1].isalnum())


def phrases_by_first_word(phrases: Iterable[str]) -> Mapping[str, Tuple[Phrase, ...]]:
    """Return phrases by their first word, the longest first."""
    found: Dict[str, List[Phrase]] = {}
    for phrase in phrases:
        words = tuple(phrase.split())
        found.setdefault(words[0], []).append(words)
    return {first: tuple(sorted(of_it, key=len, reverse=True)) for first, of_it in found.items()}


def phrase_at(words: Sequence[str], position: int, phrases: Mapping[str, Tuple[Phrase, ...]]) -> int:
    """Return the number of words of the longest phrase at a position, 0 for none."""
    if position >= len(words):
        return 0
    return next(
        (
            len(phrase)
            for phrase in phrases.get(words[position], ())
            if tuple(words[position : position + len(phrase)]) == phrase
        ),
        0,
    )
