"""Reads questions and remarks by the patterns of lexical units; the frames are questions: none acts."""

from typing import List, Mapping, Optional, Sequence, Tuple

from semantic_framer.filling.default_values import value_of_verb
from semantic_framer.judging.verdicts import Case
from semantic_framer.kinds.clause_features import Form, features_of
from semantic_framer.kinds.mood_file import UtteranceKind
from semantic_framer.kinds.question_extent import ends_inside, words_of_question
from semantic_framer.kinds.question_orders import direct_orders, length_of_opening
from semantic_framer.kinds.question_words import compiled
from semantic_framer.kinds.utterance_kind import kind_without_clause
from semantic_framer.queries.shaped_clauses import shaped_reading
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.word_patterns import argument_of, heads
from semantic_framer.values.reading import Reading, rank
from semantic_framer.values.sentence import Sentence
from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import LexicalUnit, WordPattern
from typed_arguments import Source, TypedArgument
from utterance_passes.engine.trace import Trace
from utterance_passes.trees.tree import NOUNS, VERBS, Word
from word_classes import word_class

_NEGATIONS = word_class("negations")
#: Spellings that patterns do not have, if the word is a verb.
_VERBS_IN_FULL: Mapping[str, str] = {"'s": "is", "'re": "are", "'m": "am", "'d": "would", "ca": "can", "wo": "will"}
_NOT = "n't"
_SENTENCE_ENDS = frozenset([".", "!", "?"])


def question_readings(case: Case) -> Tuple[Reading, ...]:
    """Return the readings of a sentence that only asks something, the best first; none if no pattern fits.

    A frame that no server answers is left out while other frames have servers.
    """
    words = words_of_question(case.sentence)
    if ends_inside(case.sentence, words):
        return ()
    length = length_of_opening([spelling(word) for word in words])
    orders = list(direct_orders(words[length:])) if length else []
    # "Can you see Bob in the hall?" begins like a request, and asks.
    if length or only_asks(case, words):
        orders.append(tuple(words))
    return _readings(case, orders)


def only_asks(case: Case, words: Sequence[Word]) -> bool:
    """Whether the words of a question ask for nothing to be done."""
    spoken = {word.index for word in words}
    # "Excuse me" is no command in front of a question.
    acts = any(kind.acts and clause.verb in spoken for clause, kind in zip(case.clauses, case.kinds))
    return not acts and not ends_inside(case.sentence, words) and _is_question(case)


def remark_readings(sentence: Sentence, known: FramedLexicon, trace: Optional[Trace] = None) -> Tuple[Reading, ...]:
    """Return the readings of a sentence of which all words fit a remark, whatever kind of sentence it is.

    "Well done." is talk, "never use the left arm" a prohibition, "next time use the other arm" a command without a verb
    that anybody carries out; a unit that lists these words knows better. A frame that no server answers is left out.
    """
    found = [
        read
        for read in _told(sentence, known) + _remarks(sentence, known)
        if known.frames[read.unit.frame_name].is_question
        if not known.heeded or read.unit.frame_name in known.heeded
    ]
    best = tuple(sorted(found, key=lambda reading: (-len(reading.verb_positions), rank(reading)))[:1])
    if best and trace is not None:
        trace.add("remark", str(best[0]), after=f'answered, by "{best[0].verb}"')
    return best


def idiom_readings(sentence: Sentence, known: FramedLexicon) -> Tuple[Reading, ...]:
    """Return the readings of a sentence that is as a whole another way to command a deed, the last one added first."""
    return tuple(read for read in reversed(_remarks(sentence, known)) if known.frames[read.unit.frame_name].acts)


def _remarks(sentence: Sentence, known: FramedLexicon) -> List[Reading]:
    # "Well" and "now" may also be words around a sentence.
    whole, inner = _whole(sentence), words_of_question(sentence)
    return [
        read
        for words in ([whole, inner] if len(inner) < len(whole) else [whole])
        for unit in known.lexicon.remark_units([spelling(word) for word in words])
        if unit.frame_name in known.frames
        for pattern in unit.remarks
        for read in [_read(sentence, unit, known.frames[unit.frame_name], pattern, words)]
        if read is not None
    ]


def _whole(sentence: Sentence) -> List[Word]:
    return [word for word in sentence.tree.words if word.upos != "PUNCT"]


def _told(sentence: Sentence, known: FramedLexicon) -> List[Reading]:
    """Return the reading of a sentence that tells the robot something about itself: "never use the left arm"."""
    tops, words = sentence.children(0), _whole(sentence)
    if len(tops) != 1 or ends_inside(sentence, words):
        return []
    features = features_of(sentence.tree, tops[0].index)
    if features.form is not Form.PLAIN:
        return []
    positions = frozenset(word.index for word in words)
    found = shaped_reading(sentence, known, features, positions, needs_server=False)
    return [found] if found is not None else []


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
    for unit in known.lexicon.question_units([spelling(word) for word in words]):
        frame = known.frames.get(unit.frame_name)
        if frame is None or not frame.is_question or (known.heeded and frame.name not in known.heeded):
            continue
        reading = next(
            (
                read
                for pattern in unit.questions
                for read in [_read(case.sentence, unit, frame, pattern, words)]
                if read
            ),
            None,
        )
        if reading is not None:
            found.append(reading)
    # "How many chairs are there in the hall" has a place, though a pattern without a place fits too.
    return tuple(sorted(found, key=lambda reading: (-len(reading.verb_positions), rank(reading))))


def _is_question(case: Case) -> bool:
    if not case.clauses:
        return kind_without_clause(case.sentence.tree).kind is UtteranceKind.QUESTION
    # "Where has Bob gone?" is parsed like the clause of a report.
    is_marked = case.sentence.tree.text.rstrip().endswith("?")
    return is_marked or any(kind.kind is UtteranceKind.QUESTION for kind in case.kinds)


def _read(
    sentence: Sentence, unit: LexicalUnit, frame: SemanticFrame, question: WordPattern, words: Sequence[Word]
) -> Optional[Reading]:
    """Return the reading of words that are all in a pattern; None for other words."""
    forms = [spelling(word) for word in words]
    match = compiled(question.text).fullmatch(" ".join(forms))
    if match is None:
        return None
    arguments = []
    inside: List[int] = []
    for name, kind in question.slots:
        if match.group(name) is None:
            continue
        first = len(match.string[: match.start(name)].split())
        positions = [word.index for word in words[first : first + len(match.group(name).split())]]
        if not kind and len(heads(sentence.tree, positions)) > 1:
            return None  # "is the door heavy to open": these words are no phrase
        if kind == "place" and _ends_in_state(sentence, positions):
            return None  # "is the cup on the table red" names no place "on the table red"
        if kind == "place" and any(time & set(positions) for time in sentence.tree.times):
            return None  # "is the door open at 18:30" asks about another time
        if not kind and sentence.word(positions[0]).upos == "ADP":
            return None  # "can you see to the washing" asks for no thing
        if not kind and any(sentence.word(index).upos == "AUX" for index in positions):
            return None  # "do you know which is bigger" names nobody
        if any(sentence.word(index).form in _SENTENCE_ENDS for index in range(positions[0], positions[-1])):
            return None  # "never use the arm. Go home" has two sentences
        if any(sentence.word(index).said in _NEGATIONS for index in positions):
            return None  # "who is not in the kitchen" asks for the others
        inside += positions
        arguments.append(argument_of(sentence, name, positions))
    arguments += [
        value_of_verb(name, text) if frame.acts else TypedArgument(name, text, Source.INFERRED)
        for name, text in unit.values.items()
    ]
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
        clause_text=sentence.tree.text.strip(),
    )


def _ends_in_state(sentence: Sentence, positions: Sequence[int]) -> bool:
    """Whether the last of some words says how something is, and is no part of the phrase before it."""
    last = sentence.word(positions[-1])
    has_noun = any(sentence.word(index).upos in NOUNS for index in positions[:-1])
    return last.upos in ("ADJ", "VERB") and has_noun and last.head not in positions


def spelling(word: Word) -> str:
    """Return a word as the patterns and openings of questions have it: "would" for "'d"."""
    form = word.said.replace("\u2019", "'")
    if form == _NOT:
        return "not"
    return _VERBS_IN_FULL.get(form, form) if word.upos in VERBS else form
