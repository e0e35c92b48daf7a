"""The last check of an utterance: no word of it is lost.

Each word of the text *as it was said* must be part of what was understood, of a formula around a command
(``formulas.yaml``), of its mood, or of the closed list of words that may go unread (``unread_words.yaml``). The check
knows the text, the words of the tree, and what the readings name. It knows no pass and no rule that made them, so no
pass can lose a word behind its back.
"""

import re
import unicodedata
from dataclasses import dataclass
from difflib import SequenceMatcher
from functools import lru_cache
from html import unescape
from pathlib import Path
from typing import AbstractSet, FrozenSet, Iterable, List, Optional, Sequence, Set, Tuple

from semantic_framer.phrase_table import PhraseTable
from semantic_framer.reading import Reading
from semantic_frames.marked_yaml import Reader
from semantic_frames.source_files import read_text
from typed_arguments import TypedArgument
from utterance_passes.formula_file import is_filler, pattern_of
from utterance_passes.tree import ABANDONED, DependencyTree, Word
from word_classes import word_class

#: Next to this module in the source, devel and install space.
UNREAD_WORDS_FILE = Path(__file__).resolve().parent / "unread_words.yaml"
#: More words would hide what a person wants.
MOST_UNREAD_WORDS = 40
_FORMULAS = tuple(
    pattern_of(kind)
    for kind in (
        "openings",
        "modal_openings",
        "gerund_openings",
        "anywhere",
        "apart",
        "comparisons",
        "endings",
        "tails",
        "set_off_tails",
        "editing_terms",
        "withdrawals",
        "phrases_of_hesitation",
    )
)
_OBJECTIONS = pattern_of("objections")
#: The most words of a formula.
_LONGEST = 16
_PADDING = word_class("padding")
_AUXILIARIES = word_class("modals") | word_class("polite_modals") | word_class("forms_of_be") | word_class("forms_of_do")
_SUBJECTS = word_class("hearers") | word_class("speaker_subjects")
_WRAPPING = word_class("verbs_around_requests") | word_class("assuring_verbs")
_ADDRESSED = word_class("robot_names") | word_class("those_addressed") | word_class("greetings")
_ARTICLES = word_class("articles")
_ASPECTUAL = word_class("aspectual_verbs")
#: A letter, a digit, or a sign of either.
_RUN = re.compile(r"[^\W_]+")


def load_unread_words(text: str, path: str) -> PhraseTable[str]:
    """Read the words that may go unread, each with its reason.

    Args:
        text: content of the file
        path: path of the file, for problems
    Raises:
        FileRefused: lists every mistake in the file
    """
    reader = Reader(path)
    found = {}
    for key, item in reader.sequence(reader.compose(text, "a list of words"), ""):
        entries = reader.mapping(item, key, ("words", "reason"), required=("words", "reason"))
        reason = reader.name(entries.get("reason"), f"{key}.reason")
        for phrase in reader.texts(entries["words"], f"{key}.words") if "words" in entries else ():
            found[tuple(phrase.split())] = reason
    count = sum(map(len, found))
    if count > MOST_UNREAD_WORDS:
        reader.report("TOO_MANY", None, "", f"{count} words", f"at most {MOST_UNREAD_WORDS}")
    reader.refuse_if_wrong()
    return PhraseTable(found)


@lru_cache(maxsize=None)
def shipped_unread_words() -> PhraseTable[str]:
    """Return the words of ``unread_words.yaml``, read once.

    Raises:
        FileRefused: the file is wrong
    """
    return load_unread_words(read_text(str(UNREAD_WORDS_FILE)), str(UNREAD_WORDS_FILE))


def positions_named(readings: Iterable[Reading]) -> FrozenSet[int]:
    """Return the positions of all words that readings name: verbs, arguments, and how often or how long."""
    found: Set[int] = set()
    for reading in readings:
        found.update(reading.verb_positions, reading.control.positions)
        for argument in (*reading.arguments, *(reading.extra or ())):
            _add(argument, found)
    return frozenset(found)


def _add(argument: TypedArgument, found: Set[int]) -> None:
    found.update(argument.positions)
    found.update(one.position for one in argument.modifiers)
    for part in (argument.possessor, argument.complement, *argument.members, *argument.exceptions):
        if part is not None:
            _add(part, found)
    for frame in argument.frames:
        found.update(frame.positions)
        for element in frame.frame_elements:
            _add(element, found)


def words_left(tree: DependencyTree, named: AbstractSet[int]) -> Tuple[str, ...]:
    """Return the words as they were said that nothing accounts for, in order; none if no word is lost.

    Args:
        tree: the sentence that was understood, with its text as it was said
        named: positions of the words that are understood: of readings, links, and of what was only told
    """
    return _Check(tree, frozenset(named)).left()


@dataclass(frozen=True)
class _Said:
    """A word of the text: letters and digits without a mark between them."""

    form: str
    start: int
    end: int


class _Check:
    def __init__(self, tree: DependencyTree, named: FrozenSet[int]) -> None:
        self._tree = tree
        self._named = named
        self._covered = _phrase_positions(tree)
        self._left = frozenset(word.index for run in self._runs() for word in _unread_of(self, run))

    def left(self) -> Tuple[str, ...]:
        """Return the words that nothing accounts for."""
        places = {word.start: word.form for word in self._lost_in_rewriting()}
        places.update((word.start_character, word.form) for word in self._tree.words if word.index in self._left)
        return (*(places[place] for place in sorted(places)), *_signs(self._tree.text))

    def _runs(self) -> Iterable[List[Word]]:
        """Yield the words between those that are understood."""
        run: List[Word] = []
        for word in self._tree.words:
            if word.index in self._named or word.index in self._covered:
                if run:
                    yield run
                run = []
            elif _RUN.search(word.form):
                run.append(word)
        if run:
            yield run

    # --- what the text says, and the tree does not

    def _lost_in_rewriting(self) -> List[_Said]:
        """Return the words of the text that passes took out, or wrote in a way that means nothing."""
        said = _said(self._tree.text)
        written = [
            (part, word.index) for word in self._tree.words for part in _RUN.findall(_plain(word.form))
        ]
        matcher = SequenceMatcher(None, [one.form for one in said], [form for form, _ in written], autojunk=False)
        gone: List[_Said] = []
        new: List[Tuple[str, int]] = []
        for tag, first, last, begin, end in matcher.get_opcodes():
            if tag == "equal":
                continue
            block, words = said[first:last], written[begin:end]
            if "".join(one.form for one in block) == "".join(form for form, _ in words):
                continue
            is_meant = any(index in self._named for _, index in words)
            if block and is_meant and tag == "replace":
                continue
            new += words
            if block and not _is_taken_back(self._tree.text, said, first, last):
                gone += block
        moved = [form for form, _ in new]
        left = []
        for one in gone:
            if one.form in moved:
                moved.remove(one.form)
            else:
                left.append(one)
        return _not_unread(left, said)


def _phrase_positions(tree: DependencyTree) -> FrozenSet[int]:
    """Return the positions of the phrases that may go unread as they stand: "off *of*", "straight *ahead*"."""
    words = [word for word in tree.words if _RUN.search(word.form)]
    forms = [word.form.lower() for word in words]
    found: Set[int] = set()
    for place in range(len(words)):
        length = shipped_unread_words().at(forms[place:])[1]
        if length > 1:
            found.update(word.index for word in words[place : place + length])
    return frozenset(found)


def _plain(text: str) -> str:
    return unicodedata.normalize("NFKC", text).lower()


def _said(text: str) -> List[_Said]:
    return [_Said(_plain(match.group()), *match.span()) for match in _RUN.finditer(text)]


def _is_taken_back(text: str, said: Sequence[_Said], first: int, last: int) -> bool:
    """Whether words that were taken out were broken off, said for thinking, or are said again."""
    block = [one.form for one in said[first:last]]
    if block == [one.form for one in said[last : last + len(block)]]:
        return True
    if block == [one.form for one in said[max(0, first - len(block)) : first]]:
        return True
    return any(is_filler(form) for form in block) or text[said[last - 1].end : said[last - 1].end + 1] == "-"


def _not_unread(words: List[_Said], said: Sequence[_Said]) -> List[_Said]:
    """Return the words that may not go unread where they stand in the text."""
    forms = [one.form for one in said]
    unread: Set[int] = set()
    for place in range(len(said)):
        unread.update(one.start for one in said[place : place + _unread_length(forms[place:])])
    return [one for one in words if one.start not in unread]


def _unread_length(forms: Sequence[str]) -> int:
    if not forms:
        return 0
    length = shipped_unread_words().at(forms)[1]
    return length or int(is_filler(forms[0]))


def _signs(text: str) -> Tuple[str, ...]:
    """Return what no person says: invisible marks inside the text, and codes of web pages."""
    found = [f"U+{ord(sign):04X}" for sign in text.strip("\ufeff") if unicodedata.category(sign) in ("Cf", "Co", "Cn")]
    if unescape(text) != text:
        found += re.findall(r"&#?\w+;?", text)
    return tuple(dict.fromkeys(found))


def _unread_of(check: _Check, run: List[Word]) -> List[Word]:
    """Return the words of a run that are no formula, no mood and no word that may go unread."""
    tree, named = check._tree, check._named
    forms = [word.form.lower().replace("’", "'") for word in run]
    left: List[Word] = []
    place = 0
    while place < len(run):
        length = _formula_length(forms[place:]) or _unread_length(forms[place:])
        judges = (_is_of_mood, _is_article, _is_address, _is_taken_back_in_tree)
        if not length and any(judge(tree, run[place], named) for judge in judges):
            length = 1
        if not length:
            left.append(run[place])
        place += length or 1
    return left


def _formula_length(forms: Sequence[str]) -> int:
    for end in range(min(len(forms), _LONGEST), 0, -1):
        text = " ".join(forms[:end])
        padded = " ".join(form for form in forms[:end] if form not in _PADDING)
        if any(pattern.fullmatch(text) or (padded and pattern.fullmatch(padded)) for pattern in _FORMULAS):
            return end
    return 0


def _is_of_mood(tree: DependencyTree, word: Word, named: AbstractSet[int]) -> bool:
    """Whether a word only says of what kind a clause is: "*could you* go", "*I want you to* go"."""
    form, relation = word.form.lower(), word.deprel.split(":")[0]
    if (relation in ("aux", "cop") and form in _AUXILIARIES) or (relation == "nsubj" and form in _SUBJECTS):
        return True
    if relation == "mark" and form == "to":
        return True
    behind = next((other for other in tree.words[word.index :] if other.form.lower() != "to"), None)
    if word.lemma.lower() in _ASPECTUAL and behind is not None and behind.index in named:
        return True
    return bool(named & tree.subtree(word.index)) and word.lemma.lower() in _WRAPPING


def _is_article(tree: DependencyTree, word: Word, named: AbstractSet[int]) -> bool:
    """Whether a word is the article of a noun that is understood: "make *a* turn"."""
    return word.form.lower() in _ARTICLES and word.deprel == "det" and word.head in named


def _is_address(tree: DependencyTree, word: Word, named: AbstractSet[int]) -> bool:
    if word.form.lower() in _ADDRESSED:
        return True
    return word.deprel == "vocative" and word.upos == "PROPN"


def _is_taken_back_in_tree(tree: DependencyTree, word: Word, named: AbstractSet[int]) -> bool:
    return word.deprel == ABANDONED
