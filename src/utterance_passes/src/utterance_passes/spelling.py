"""Rewrites spellings that a tokenizer trained on text does not split: "90°", "3ft", "-3", "2½"."""

import re
import unicodedata
from dataclasses import dataclass, replace
from functools import partial
from typing import Callable, List, Tuple, Union

from spoken_quantities import DEGREE_SIGNS, number_words, plain_digits, unit_words
from utterance_passes.formula_file import WRITTEN_OUT, any_of, shipped_formulas
from word_classes import word_class, word_list

#: Words that can begin a number.
_NUMBER = f"(?:{'|'.join(number_words())})"

#: Marks of transcribers and of speech recognisers: "<pause>", "<no speech>".
TRANSCRIBERS_MARK = re.compile(r"<[a-zA-Z _-]{1,30}>")
APOSTROPHE = re.compile(r"[‘’ʼ`]")
_QUOTATION_MARK = re.compile(r"[“”«»]")
#: Words between single marks: 'I'm here'. An apostrophe inside a word, or at the end of "dogs'", is no mark; nor is
#: that of "pick 'em up".
_SINGLE_MARKED = re.compile(
    rf"(?<![\w'])'(?!(?:{'|'.join(word_list('elided_words'))})\b)"
    r"(?=[^\W\d])((?:[^'\"]|(?<=\w)'(?=\w))*[^\s'\"])'(?!\w)",
    re.IGNORECASE,
)
DASH = re.compile(r"[‐‑–—\u2212]")
#: A sign for a fraction, or a digit, a letter or a mark of another width: "½", "\uff13".
NUMBER_SIGN = re.compile(r"[¼½¾⅐-⅞]|[\uff01-\uff5e]|(?![0-9])\d")
FRACTION_SLASH = re.compile(r"(?<=\d)\u2044(?=\d)")
DEGREE_SIGN = re.compile(rf"(?<=\w)\s*[{DEGREE_SIGNS}]")
#: The place between a number and the unit that touches it.
UNIT_AT_NUMBER = re.compile(
    rf"(?<=\d)(?=(?:{'|'.join(sorted(filter(str.isalpha, unit_words()), key=len, reverse=True))})\b)", re.IGNORECASE
)
MINUS_SIGN = re.compile(rf"(?<!\S)-(?=\.?\d|{_NUMBER}\b)", re.IGNORECASE)
NEGATIVE_SIGN = re.compile(rf"\bnegative\s+(?=\.?\d|{_NUMBER}\b)", re.IGNORECASE)
RATIO = re.compile(r"(?<=\d)/(?=\d)")
BLANKS = re.compile(r"\s+")
_CONTRACTIONS = tuple(
    (re.compile(rf"(?<![\w'-])(?:{formula.pattern.pattern})(?![\w'-])", re.IGNORECASE), formula.written)
    for formula in shipped_formulas()[WRITTEN_OUT]
)


@dataclass(frozen=True)
class Spelling:
    """A text as the parser receives it.

    Attributes:
        text: the rewritten text
        origins: for each character of the text, and one past its end, the position in the text as it was said
    """

    text: str
    origins: Tuple[int, ...]

    def part(self, start: int, end: int) -> "Spelling":
        """Return the part between two positions of the rewritten text."""
        return Spelling(self.text[start:end], self.origins[start : end + 1])

    def without(self, start: int, end: int) -> "Spelling":
        """Return the spelling without the part between two positions of the rewritten text."""
        return Spelling(self.text[:start] + self.text[end:], self.origins[:start] + self.origins[end:])


def as_said(text: str) -> Spelling:
    """Return the spelling of a text before any rewriting."""
    return Spelling(text, tuple(range(len(text) + 1)))


def number_sign(sign: "re.Match[str]") -> str:
    """Return "½" as "1/2", with a blank between it and digits before it, and another sign as a plain one."""
    plain = plain_digits(sign.group(0))
    if plain != sign.group(0):
        return plain
    digits = unicodedata.normalize("NFKC", sign.group(0)).replace("\u2044", "/")
    return (" " if sign.string[: sign.start()][-1:].isalnum() else "") + digits


def replaced(
    spelling: Spelling, pattern: "re.Pattern[str]", replacement: Union[str, Callable[["re.Match[str]"], str]]
) -> Spelling:
    """Rewrite a text, and keep the origin of each character."""
    pieces: List[str] = []
    sources: List[int] = []
    position = 0
    for match in pattern.finditer(spelling.text):
        pieces.append(spelling.text[position : match.start()])
        sources += spelling.origins[position : match.start()]
        written = replacement if isinstance(replacement, str) else replacement(match)
        pieces.append(written)
        sources += [spelling.origins[match.start()]] * len(written)
        position = match.end()
    if not pieces:
        return spelling
    pieces.append(spelling.text[position:])
    sources += spelling.origins[position:]
    return Spelling("".join(pieces), tuple(sources))


def with_quotation_marks_alike(spelling: Spelling) -> Spelling:
    """Write each quotation mark, also single ones, as \"."""
    text = _SINGLE_MARKED.sub(r'"\1"', _QUOTATION_MARK.sub('"', spelling.text))
    return replace(spelling, text=text)


def written_out(spelling: Spelling) -> Spelling:
    """Write contracted words in full: "gonna", "dont"."""
    for pattern, written in _CONTRACTIONS:
        spelling = replaced(spelling, pattern, partial(_in_full, written=written))
    return spelling


def _in_full(short: "re.Match[str]", written: str) -> str:
    full = short.expand(written)
    return full[:1].upper() + full[1:] if short.group()[:1].isupper() else full


def stripped(spelling: Spelling) -> Spelling:
    """Remove blanks at both ends."""
    lead = len(spelling.text) - len(spelling.text.lstrip())
    text = spelling.text.strip()
    return Spelling(text, spelling.origins[lead : lead + len(text)] + (spelling.origins[lead + len(text)],))


#: A word that was broken off: "the ki- ...", but not "two- or three-metre".
_BROKEN_OFF = re.compile(rf"(?<![\w-])(?!{_NUMBER}-)[^\W\d_]+-,?(?=\s+(?!(?:or|and|to)\b)\S)", re.IGNORECASE)
_SAID = re.compile(r"[\w']+")
_PHRASE = any_of(shipped_formulas()["phrases_of_hesitation"]).pattern
_SET_OFF = f"{_PHRASE}|{any_of(shipped_formulas()['fillers']).pattern}|like"
_NUMERAL = re.compile(rf"\d+|{_NUMBER}", re.IGNORECASE)
_BETWEEN_COMMAS = re.compile(rf",\s*(?:{_SET_OFF})\s*,", re.IGNORECASE)
_OBJECT = "|".join(word_list("objects_of_knowing"))
_HESITATION = re.compile(rf"(?<![\w'-])(?:{_PHRASE})(?![\w'-])(?!\s*(?:{_OBJECT})\b)", re.IGNORECASE)
_BEFORE_KNOWING = re.compile(rf"(?:{'|'.join(word_list('before_knowing'))})\s*$", re.IGNORECASE)
_SAYING = word_class("saying_verbs")
_UNFINISHED = word_class("only_before_nouns") | word_class("to_prepositions") | word_class("placing_prepositions")
#: A filler behind a word that another one must follow: "go to *uh* the kitchen". A parser takes it for a verb.
_INSIDE_PHRASE = re.compile(
    rf"(?<![\w'-])(?P<before>{'|'.join(sorted(_UNFINISHED))})\s*,?\s+(?:{any_of(shipped_formulas()['fillers']).pattern})"
    r"\s*,?(?=\s+\w)",
    re.IGNORECASE,
)


def without_false_starts(spelling: Spelling) -> Spelling:
    """Remove words that the speaker broke off, and what they say again: "go to the ki- go to the kitchen"."""
    while True:
        match = _BROKEN_OFF.search(spelling.text)
        if match is None:
            return spelling
        before = list(_SAID.finditer(spelling.text, 0, match.start()))
        behind = _SAID.search(spelling.text, match.end())
        again = behind.group().lower() if behind else ""
        start = next((word.start() for word in reversed(before) if word.group().lower() == again), match.start())
        end = behind.start() if behind else match.end()
        spelling = spelling.without(start, end)


def without_repeated_starts(spelling: Spelling) -> Spelling:
    """Remove the beginning of a phrase that the speaker begins again: "go to the go to the office"."""
    words = list(_SAID.finditer(spelling.text))
    forms = [word.group().lower() for word in words]
    for length in range(len(forms) // 2, 1, -1):
        for first in range(len(forms) - 2 * length):
            second = first + length
            if forms[first:second] == forms[second : second + length] and forms[second - 1] in _UNFINISHED:
                return without_repeated_starts(spelling.without(words[first].start(), words[second].start()))
    return spelling


def _without_filler(found: "re.Match[str]") -> str:
    """Return nothing for a filler between commas; between two numbers it stays, because one may correct the other."""
    before = re.findall(r"[^\W_]+", found.string[: found.start()])[-1:]
    behind = re.findall(r"[^\W_]+", found.string[found.end() :])[:1]
    return found.group() if len([word for word in before + behind if _NUMERAL.fullmatch(word)]) == 2 else ""


def without_hesitation(spelling: Spelling) -> Spelling:
    """Remove phrases that people say while they think, unless somebody is to say them: "the, you know, kitchen"."""
    if _SAYING & {word.group().lower() for word in _SAID.finditer(spelling.text)}:
        return spelling  # They may be part of the message.
    spelling = replaced(spelling, _BETWEEN_COMMAS, _without_filler)
    spelling = replaced(spelling, _INSIDE_PHRASE, lambda match: match["before"])
    found = _HESITATION.finditer(spelling.text)
    match = next((one for one in found if not _BEFORE_KNOWING.search(spelling.text[: one.start()])), None)
    if match is None or not spelling.text[match.end() :].strip(" .!?,"):
        return spelling
    return without_hesitation(spelling.without(match.start(), match.end()))
