"""Reads questions by the patterns of lexical units; only frames that are questions are evoked, and they never act."""

import re
from dataclasses import replace
from functools import lru_cache
from typing import List, Mapping, Optional, Pattern, Sequence, Tuple

from semantic_framer.indirect_questions import direct_orders, length_of_opening, unquoted
from semantic_framer.mood_file import UtteranceKind
from semantic_framer.reading import Reading, rank
from semantic_framer.utterance_kind import kind_without_clause
from semantic_framer.verdicts import Case
from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import LexicalUnit, WordPattern
from typed_arguments import TypedArgument
from utterance_passes.tree import Word
from word_classes import word_class

_PADDING = word_class("question_padding")
_NEGATIONS = word_class("negations")
_PREPOSITIONS = word_class("place_prepositions") | word_class("complex_prepositions")
#: Spellings that patterns do not have, if the word is a verb, and negations.
_VERBS_IN_FULL: Mapping[str, str] = {
    **{f"{mark}{end}": verb for mark in "'’" for end, verb in (("s", "is"), ("re", "are"), ("m", "am"), ("d", "would"))},
    **dict.fromkeys(["n't", "n’t", "nt"], "not"),
}

_OF_A_PLACE = "|".join(sorted(map(re.escape, _PREPOSITIONS), key=len, reverse=True))
#: A regular expression for each kind of words that fills an element.
_WORDS_OF_SLOTS: Mapping[str, str] = {
    "": ".+?",
    "word": r"\S+",
    "place": rf"(?:(?:{_OF_A_PLACE}) .+?|here)",
}


def question_readings(case: Case) -> Tuple[Reading, ...]:
    """Return the readings of a sentence that only asks something, the best first; none if no pattern fits.

    A frame that no server answers is left out while other frames have servers.
    """
    words = _words(case)
    length = length_of_opening([_spelling(word) for word in words])
    orders = list(direct_orders(words[length:])) if length else []
    if not case.acts and (length or _is_question(case)):
        orders.append(tuple(words))
    return _readings(case, orders)


def with_embedded_question(case: Case, reading: Reading) -> Reading:
    """Return a reading whose message holds the question that it asks: "tell Anna *where the keys are*"."""
    arguments = []
    for argument in reading.arguments:
        said = next((frame for frame in argument.frames if frame.role == "says" and frame.mood == "question"), None)
        if said is not None and not said.frame_name:
            tree = unquoted(case.sentence.tree, said.positions)
            quoted = replace(case, sentence=case.sentence.attached(tree))
            words = [tree.word(position) for position in said.positions]
            found = _readings(quoted, list(direct_orders([word for word in words if word.upos != "PUNCT"])))
            if found:
                asked = replace(
                    said,
                    frame_name=found[0].unit.frame_name,
                    frame_elements=tuple(one for one in found[0].arguments if one.positions),
                )
                frames = tuple(asked if frame is said else frame for frame in argument.frames)
                argument = replace(argument, frames=frames)
        arguments.append(argument)
    return replace(reading, arguments=tuple(arguments))


def _readings(case: Case, orders: Sequence[Sequence[Word]]) -> Tuple[Reading, ...]:
    """Return the readings of the words of a question in the first order that a pattern fits, the best first."""
    for words in orders:
        found = _readings_in_order(case, words)
        if found:
            return found
    return ()


def _readings_in_order(case: Case, words: Sequence[Word]) -> Tuple[Reading, ...]:
    known = case.known
    found: List[Reading] = []
    for unit in known.lexicon.question_units:
        frame = known.frames.get(unit.frame_name)
        if frame is None or not frame.is_question or (known.heeded and frame.name not in known.heeded):
            continue
        reading = next(
            (read for pattern in unit.questions for read in [_read(case, unit, frame, pattern, words)] if read), None
        )
        if reading is not None:
            found.append(reading)
    # "How many chairs are there in the hall" has a place, though a pattern without a place fits too.
    return tuple(sorted(found, key=lambda reading: (-len(reading.verb_positions), rank(reading))))


def _is_question(case: Case) -> bool:
    if not case.clauses:
        return kind_without_clause(case.sentence.tree).kind is UtteranceKind.QUESTION
    return any(kind.kind is UtteranceKind.QUESTION for kind in case.kinds)


def _words(case: Case) -> List[Word]:
    """Return the words of a sentence without the words around a question."""
    tree = case.sentence.tree
    hidden = tree.abandoned | tree.fillers
    words = [word for word in tree.words if word.index not in hidden and word.upos != "PUNCT"]
    while words and words[0].form.lower() in _PADDING:
        words.pop(0)
    while words and words[-1].form.lower() in _PADDING:
        words.pop()
    return words


def _read(
    case: Case, unit: LexicalUnit, frame: SemanticFrame, question: WordPattern, words: Sequence[Word]
) -> Optional[Reading]:
    """Return the reading of words that are all in a pattern; None for other words."""
    forms = [_spelling(word) for word in words]
    match = _compiled(question.text).fullmatch(" ".join(forms))
    if match is None:
        return None
    arguments = []
    inside: List[int] = []
    for name, kind in question.slots:
        if match.group(name) is None:
            continue
        first = len(match.string[: match.start(name)].split())
        positions = [word.index for word in words[first : first + len(match.group(name).split())]]
        if not kind and len(_heads(case, positions)) > 1:
            return None  # "is the door heavy to open": these words are no phrase
        if any(case.sentence.word(index).form.lower() in _NEGATIONS for index in positions):
            return None  # "who is not in the kitchen" asks for the others
        inside += positions
        arguments.append(_argument(case, name, positions))
    filled = {argument.name for argument in arguments}
    own = tuple(word.index for word in words if word.index not in inside)
    return Reading(
        unit=unit,
        verb=question.text,
        verb_positions=own or (words[0].index,),
        arguments=tuple(
            sorted(arguments, key=lambda one: [element.name for element in frame.frame_elements].index(one.name))
        ),
        missing=tuple(element for element in frame.frame_elements if element.is_core and element.name not in filled),
        left_over=(),
        coverage=1.0,
        clause_text=case.sentence.tree.text.strip(),
    )


@lru_cache(maxsize=1024)
def _compiled(text: str) -> Pattern[str]:
    return WordPattern(text).compile(_WORDS_OF_SLOTS)


def _spelling(word: Word) -> str:
    form = word.form.lower()
    return _VERBS_IN_FULL.get(form, form) if word.upos in ("AUX", "VERB", "PART") else form


def _heads(case: Case, positions: Sequence[int]) -> List[int]:
    """Return the words of some that depend on none of the others."""
    return [index for index in positions if case.sentence.word(index).head not in positions]


def _argument(case: Case, name: str, positions: List[int]) -> TypedArgument:
    """Return the argument of the words of an element, whatever the parser attached them to."""
    sentence = case.sentence
    inside = frozenset(positions)
    heads = _heads(case, positions)
    nouns = [index for index in heads if sentence.word(index).upos in ("NOUN", "PROPN", "PRON", "NUM")]
    head = (nouns or heads)[0]
    below = sentence.subtree(head)
    return sentence.phrases.argument(name, head, left_out=below - inside, attached=inside - below)
