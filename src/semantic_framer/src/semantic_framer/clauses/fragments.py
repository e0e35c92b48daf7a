"""Recognises fragments: utterances without a verb of their own that change or repeat the last command.

"Ten feet", "to the left", "and now the red one" name elements; "again", "more", "a bit more" and "the other way" say
what to do with the whole command. The words are in ``fragments.yaml``.
"""

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import List, Mapping, Optional, Pattern, Sequence, Tuple

from checked_files.source_files import read_text
from semantic_framer.kinds.mood_file import UtteranceKind
from semantic_framer.kinds.utterance_kind import kind_without_clause
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.fragment_kind import FragmentKind
from semantic_framer.values.iterations import times_said
from semantic_framer.values.sentence import Sentence
from semantic_framer.values.slight_amounts import slight_words
from utterance_passes.asides.objections import plain
from utterance_passes.phrases.clauses import Clause
from utterance_passes.phrases.verb_matching import match_verbs
from utterance_passes.trees.formula_file import Formula, any_of, is_filler, load_formulas
from utterance_passes.trees.tree import ABANDONED, DependencyTree, Word
from word_classes import agreement, word_class

#: Next to this module in the source, devel and install space.
FRAGMENTS_FILE = Path(__file__).resolve().parent / "fragments.yaml"
KINDS = (
    "openings",
    "replacing",
    "asking",
    "before_answers",
    "endings",
    "whole_command",
    "one_more",
    "as_much_again",
    "a_bit_more",
    "faster",
    "slower",
    "louder",
    "quieter",
    "other_side",
)
#: The most words of an opening or an ending.
_LONGEST = 6
_NOT = word_class("not")
_LEFT_AND_RIGHT = word_class("left_and_right")
_MORE = word_class("more_words")
#: Alone, they name nothing that was not said already.
_NOTHING_NEW = word_class("pronouns") | word_class("place_adverbs") - {"home"}
#: What may stand before a number of times and nothing else: "another three times".
#: "*Another* three times", "*do it* twice".
_AGAIN = word_class("more_words") | word_class("forms_of_do") | word_class("pronouns_of_things")
_NO_FRAGMENT = word_class("negations") | word_class("conditions") | word_class("question_words")


@dataclass(frozen=True)
class Fragment:
    """An utterance that changes or repeats the last command.

    Attributes:
        kind: what it does
        positions: of the words that count, ascending
        is_more: whether its amount comes on top: "ten more"
        times: how often the command is repeated: "do that again *three times*"; 0 if it does not say
        is_instead: whether its amount takes the place of the one before: "*make that* ten"
        is_asked: whether it is said as a question: "and the pepper*?*"
    """

    kind: FragmentKind
    positions: Tuple[int, ...]
    is_more: bool = False
    times: int = 0
    is_instead: bool = False
    is_asked: bool = False

    @property
    def needs_command(self) -> bool:
        """Whether the words mean nothing without an earlier command, so that the robot asks what is meant."""
        return self.kind in _NEEDING_A_COMMAND


_NEEDING_A_COMMAND = frozenset(
    [
        FragmentKind.REPEAT,
        FragmentKind.ONE_MORE,
        FragmentKind.MORE,
        FragmentKind.BIT,
        FragmentKind.FASTER,
        FragmentKind.SLOWER,
        FragmentKind.LOUDER,
        FragmentKind.QUIETER,
    ]
)


@lru_cache(maxsize=None)
def shipped_fragments() -> Mapping[str, Tuple[Formula, ...]]:
    """Return the patterns of ``fragments.yaml``, read once.

    Raises:
        FileRefused: the file is wrong
    """
    return load_formulas(read_text(str(FRAGMENTS_FILE)), str(FRAGMENTS_FILE), KINDS, keys=("pattern", "example"))


_REPLACING, _ASKING = (shipped_fragments()[name] for name in ("replacing", "asking"))
_OPENINGS = any_of((*shipped_fragments()["openings"], *_REPLACING, *_ASKING))
_OPENINGS_OF_QUESTIONS = any_of((*shipped_fragments()["openings"], *_ASKING))
_OPENINGS_OF_ANSWERS = any_of((*shipped_fragments()["openings"], *_ASKING, *shipped_fragments()["before_answers"]))
_ENDINGS = any_of(shipped_fragments()["endings"])
_INSTEAD = any_of(_REPLACING)
_ASKED = any_of(_ASKING)
_WHOLE: Tuple[Tuple[FragmentKind, Pattern[str]], ...] = tuple(
    (kind, any_of(shipped_fragments()[name]))
    for kind, name in (
        (FragmentKind.REPEAT, "whole_command"),
        (FragmentKind.ONE_MORE, "one_more"),
        (FragmentKind.MORE, "as_much_again"),
        (FragmentKind.BIT, "a_bit_more"),
        (FragmentKind.FASTER, "faster"),
        (FragmentKind.SLOWER, "slower"),
        (FragmentKind.LOUDER, "louder"),
        (FragmentKind.QUIETER, "quieter"),
        (FragmentKind.OPPOSITE, "other_side"),
    )
)


def fragment_of(
    sentence: Sentence, clauses: Sequence[Clause], known: FramedLexicon, *, is_asked: bool = False
) -> Optional[Fragment]:
    """Return an utterance as a fragment; None if it is none, or a command of its own.

    Args:
        sentence: the utterance
        clauses: its clauses
        known: an utterance with a verb of the lexicon is a command
        is_asked: whether the last command was a question, so that this may be one: "and Bob?"
    """
    tree = sentence.tree
    hidden = {word.index for word in tree.words if word.deprel == ABANDONED}
    said = [word for word in tree.words if word.upos != "PUNCT" and not is_filler(word.form)]
    whole = [word for word in said if word.index not in hidden]
    said = _behind_contrast(tree, whole)
    forms = [plain(word) for word in said]
    first, last = _core(forms, _OPENINGS_OF_QUESTIONS if is_asked else _OPENINGS)
    core = " ".join(forms[first:last])
    positions = tuple(word.index for word in said[first:last])
    # "Right" alone agrees; "now right" and "no, right" do not.
    if not core or (agreement(core) is True and last - first == len(whole)):
        return None
    kind = next((kind for kind, pattern in _WHOLE if pattern.fullmatch(core)), None)
    if kind is not None:
        return Fragment(kind, positions)
    times, length = _times_at_end(forms[first:last])
    rest = " ".join(forms[first : last - length])
    # "Once" alone begins a condition.
    if times > (not rest) and (_AGAIN.issuperset(rest.split()) or _WHOLE[0][1].fullmatch(rest)):
        return Fragment(FragmentKind.REPEAT, positions, times=times)
    if core in _LEFT_AND_RIGHT:
        # The parser takes "left" for a verb.
        return Fragment(FragmentKind.ELEMENTS, positions)
    is_instead = _INSTEAD.search(" ".join(forms[:first])) is not None
    verbs = [clause for clause in clauses if not is_instead or clause.verb in positions]
    if any(match_verbs(tree, clause, known) for clause in verbs) or frozenset(forms[first:last]) & _NO_FRAGMENT:
        return None
    if core in _NOTHING_NEW or tree.times or tree.quoted:
        return None
    kind_of_all = kind_without_clause(tree).kind
    may_be_asked = is_asked or forms[0] == "and" or _ASKED.fullmatch(" ".join(forms[:first])) is not None
    if kind_of_all is not UtteranceKind.ANSWER and not (kind_of_all is UtteranceKind.QUESTION and may_be_asked):
        return None
    is_more = bool(_MORE & frozenset(forms[first:last]))
    slight = slight_words(tree, positions)
    if forms[last - 1] in _MORE and last - first > 1:
        positions = positions[:-1]
    elif is_more and slight:
        # "A bit more to the left" is "a bit to the left", from where the robot is.
        positions = tuple(index for index in positions if index not in slight or plain(tree.word(index)) not in _MORE)
        is_more = False
    return Fragment(
        FragmentKind.ELEMENTS,
        positions,
        is_more,
        is_instead=is_instead,
        is_asked=kind_of_all is UtteranceKind.QUESTION,
    )


def answering_words(tree: DependencyTree) -> Tuple[int, ...]:
    """Return the positions of the words that answer a question, without what is said around them: "I mean *the red
    cup*", "I'd say *on the table*"."""
    said = [word for word in tree.words if word.upos != "PUNCT" and not is_filler(word.form)]
    first, last = _core([plain(word) for word in said], _OPENINGS_OF_ANSWERS)
    return tuple(word.index for word in said[first:last])


def _times_at_end(forms: Sequence[str]) -> Tuple[int, int]:
    """Return the number of times that words end with, and the number of its words: "twice", "four more times"."""
    for end in range(len(forms), max(0, len(forms) - 2), -1):
        if end < len(forms) and forms[end] not in _MORE:
            break
        for length in (1, 2, 3):
            said = [form for form in forms[max(0, end - length) : end] if form not in _MORE]
            times = times_said(said) if length <= end else None
            if times is not None and times[1] == len(said):
                return times[0], len(forms) - end + length
    return 0, 0


def _behind_contrast(tree: DependencyTree, said: Sequence[Word]) -> List[Word]:
    """Return the words behind what is not meant: "not the kitchen, *the office*"."""
    if not said or plain(said[0]) not in _NOT:
        return list(said)
    pauses = [word.index for word in tree.words if word.form == "," and word.index > said[0].index]
    behind = [word for word in said if pauses and word.index > pauses[0]]
    return behind or list(said)


def _core(forms: Sequence[str], openings: Pattern[str]) -> Tuple[int, int]:
    """Return the bounds of the words between openings and endings."""
    first, last = 0, len(forms)
    if not any(pattern.fullmatch(" ".join(forms)) for _, pattern in _WHOLE):
        first = _behind(forms, openings)
        while last > first:
            length = next(
                (
                    length
                    for length in range(min(_LONGEST, last - first), 0, -1)
                    if _ENDINGS.fullmatch(" ".join(forms[last - length : last]))
                ),
                0,
            )
            if not length:
                break
            last -= length
    return first, last


def _behind(forms: Sequence[str], openings: Pattern[str]) -> int:
    """Return the number of words that openings take."""
    first = 0
    while first < len(forms):
        length = next(
            (
                length
                for length in range(min(_LONGEST, len(forms) - first), 0, -1)
                if openings.fullmatch(" ".join(forms[first : first + length]))
            ),
            0,
        )
        if not length:
            break
        first += length
    return first
