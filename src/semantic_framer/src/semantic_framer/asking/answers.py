"""Questions about missing elements, and the values with which the next utterance answers them."""

from dataclasses import replace
from itertools import takewhile
from typing import Dict, List, Optional, Sequence, Tuple

from phrase_meanings.arguments import amount_argument, unit_argument
from semantic_framer.clauses.fragments import answering_words
from semantic_framer.filling.attachment import words_before_amount
from semantic_framer.kinds.mood_file import UtteranceKind
from semantic_framer.kinds.utterance_kind import kind_without_clause, kinds_of_clauses
from semantic_framer.referring.chosen_things import chosen, nearest_of
from semantic_framer.referring.persons_spoken_of import PERSONAL_PRONOUNS
from semantic_framer.units.frame_roles import DIRECTION, GOAL, MESSAGE
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.word_patterns import argument_of
from semantic_framer.values.clause_plan import PlanPart
from semantic_framer.values.dialogue import PRONOUNS, Pending, is_ignorant, is_indifferent, is_yes
from semantic_framer.values.reading import Reading, with_argument
from semantic_framer.values.sentence import Sentence
from semantic_framer.values.things import is_direction, is_unfinished
from semantic_frames.frame import FrameElement, Quantity, SemanticFrame
from typed_arguments import TypedArgument
from utterance_passes.phrases.amounts import Amount
from utterance_passes.phrases.clauses import find_clauses
from utterance_passes.phrases.clock_times import clock_time_at
from utterance_passes.phrases.measures import find_amounts
from utterance_passes.phrases.verb_matching import match_verbs
from word_classes import word_class

_ARTICLES = word_class("articles")
_LEAD_IN = word_class("lead_in")
#: What the hearer is asked to do or told begins with these: "to come home", "that dinner is ready".
_BEFORE_MESSAGES = frozenset(["to", "that"])
_PRONOUNS = PRONOUNS | PERSONAL_PRONOUNS
_QUESTION_WORDS = word_class("question_words")
#: The most words of a question about a question: "which one".
_LONGEST_ASKED_BACK = 3
#: An utterance with one of these words is more than an answer.
_NO_ANSWER = word_class("negations") | word_class("conditions")
_HEARER, _SPEAKER = word_class("words_of_the_hearer"), word_class("words_of_the_speaker")


def question_for(element: FrameElement) -> str:
    """Return the question that asks a person for an element, with an example of an answer."""
    question = element.question or f"What is the {element.name.replace('_', ' ')}?"
    return f'{question} For instance: "{element.answer}".' if element.answer else question


def question_of(readings: Sequence[Reading]) -> str:
    """Return one question if all readings ask for the same element first, else one for each of these elements."""
    asked = [reading.asked[0] for reading in readings]
    if len({element.name for element in asked}) == 1:
        return question_for(asked[0])
    questions = list(dict.fromkeys(question_for(element) for element in asked))
    return " Or: ".join(questions)


def answer(
    sentence: Sentence, pending: Pending, known: FramedLexicon, *, is_strict: bool
) -> Optional[Tuple[Tuple[Reading, ...], ...]]:
    """Take an utterance as the answer to the open question.

    Args:
        sentence: the utterance
        pending: the question
        known: lexical units and frames; an utterance that uses one of their verbs is a command, not an answer
        is_strict: whether every content word must belong to the answer
    Returns:
        the clauses, completed by the answer, or as they were if it leaves the question open ("which one?"); None if the
        utterance is not an answer, or says more than an answer
    """
    if any(reading.unit.frame_name not in known.frames for readings in pending.clauses for reading in readings):
        return None
    if not pending.elements:
        return pending.clauses if is_yes(sentence.tree.text) else None
    leaves_it_open = bool(pending.offered) and is_indifferent(sentence.tree.text)
    if not leaves_it_open:
        if _leaves_open(sentence, known):
            return pending.clauses
        if _is_said_for_itself(sentence, pending, known):
            return None
    fitting: Dict[bool, List[Reading]] = {True: [], False: []}
    for reading, name in zip(pending.clauses[pending.clause], pending.elements):
        frame = known.frames[reading.unit.frame_name]
        name = name if pending.offered else _element_meant(sentence, reading, name, known)
        # "Give Bob." - "To Anna." says two persons who get something, and not what.
        before = reading.argument(name) if name not in pending.elements else None
        if before is not None and before.text.lower() not in _PRONOUNS:
            continue
        values = _values(sentence, pending, frame, name, is_strict)
        element = frame.element(name)
        asked = reading.argument(name)
        if pending.offered and asked is not None and (values or leaves_it_open):
            nearest = nearest_of(asked, pending.offered, known.world) if leaves_it_open else None
            value = nearest or chosen(asked, values[0], pending.offered, known.world)
            values = [] if value is None else [value]
        for value in values:
            reading = with_argument(reading, value)
        if values and element is not None:
            fitting[bool(element.values) or element.quantity is not None].append(reading)
    # "Left" is a direction if the question asks for one, although a thing could have that name too.
    filled = fitting[True] or fitting[False]
    if not filled:
        return None
    complete = tuple(reading for reading in filled if not reading.missing)
    return tuple(
        (complete or tuple(filled)) if position == pending.clause else readings
        for position, readings in enumerate(pending.clauses)
    )


def _leaves_open(sentence: Sentence, known: FramedLexicon) -> bool:
    """Whether an utterance is about the question, and leaves it open: "which one?", "I don't know", "you choose"."""
    tree = sentence.tree
    if is_ignorant(tree.text) or is_indifferent(tree.text):
        return True
    asks = tree.words[0].said in _QUESTION_WORDS and len(answering_words(tree)) <= _LONGEST_ASKED_BACK
    return asks and kind_without_clause(tree).kind is UtteranceKind.QUESTION and not find_clauses(tree, known)


def _is_said_for_itself(sentence: Sentence, pending: Pending, known: FramedLexicon) -> bool:
    """Whether an utterance is no answer, because it is a command, or asks further: "and the plate?".

    Any statement may be what somebody is to be told.
    """
    tree = sentence.tree
    if tree.words[0].said == "and" and tree.text.rstrip().endswith("?"):
        return True
    clauses = find_clauses(tree, known)
    asked = zip(pending.clauses[pending.clause], pending.elements)
    elements = [known.frames[reading.unit.frame_name].element(name) for reading, name in asked]
    if all(element is not None and element.framenet == MESSAGE for element in elements):
        if tree.words[0].said in _BEFORE_MESSAGES:
            return False
        kinds = kinds_of_clauses(tree, clauses, known)
        return any(kind.acts or kind.kind is UtteranceKind.QUESTION for kind in kinds)
    answering = frozenset(answering_words(tree))
    if any(match_verbs(tree, clause, known) for clause in clauses if clause.verb in answering):
        return True
    # "Bob knows."
    return any(
        root.upos == "VERB" and root.index in answering and _has_subject(sentence, root.index)
        for root in sentence.children(0)
    )


def _has_subject(sentence: Sentence, verb: int) -> bool:
    return sentence.tree.subject(verb) is not None


def time_answered(sentence: Sentence, pending: Pending) -> Optional[PlanPart]:
    """Return the plan of the open question with the time that the person says; None if the utterance is no time.

    Args:
        sentence: the utterance: "at nine", "nine o'clock", "in the morning"
        pending: the question: "At what time tomorrow?"
    """
    plan = pending.plan
    fillers = sentence.tree.fillers
    said = [word.said for word in sentence.tree.words if word.upos != "PUNCT" and word.index not in fillers]
    if plan is None or plan.kind != "AT" or not said:
        return None
    for between in ((), ("at",)):
        forms = (*pending.open_time, *between, *said)
        clock = clock_time_at(forms)
        if clock is not None and clock.when is not None and clock.length == len(forms):
            return replace(plan, when=clock.when)
    return None


def _values(
    sentence: Sentence, pending: Pending, frame: SemanticFrame, name: str, is_strict: bool
) -> List[TypedArgument]:
    """Return the values that an utterance gives to an element and to its unit element; nothing if it does not fit."""
    element = frame.element(name)
    values = _fragment_values(sentence, frame, element) if element is not None else []
    is_quoted = element is not None and element.framenet == MESSAGE
    if element is None or not values or not (is_quoted or _is_all_said(sentence, values, is_strict)):
        return []
    if pending.choices and not any(_is_choice(values[0], choice) for choice in pending.choices):
        return []
    # A single question accepts any answer. With several questions, the answer shows which reading was meant.
    allowed = [value.lower() for value in element.values]
    if len(pending.elements) > 1 and allowed and values[0].text.lower() not in allowed:
        return []
    return values


def _element_meant(sentence: Sentence, reading: Reading, name: str, known: FramedLexicon) -> str:
    """Return the element that an answer names by its preposition, in the unit of a reading or another one of its verb
    and frame, otherwise the one that was asked for: "what should I bring?" - "*to* Anna"."""
    answering = answering_words(sentence.tree)
    heads = [index for index in answering if sentence.word(index).head not in answering]
    cases = [child for head in heads[:1] for child in sentence.tree.prepositions(head)]
    said = [child.said for child in cases if child.index in answering]
    others = (unit for unit in known.units_of(reading.verb) if unit.frame_name == reading.unit.frame_name)
    for unit in (reading.unit, *others) if said else ():
        marked = [
            relation.name for relation in unit.relations if any(path.preposition in said for path in relation.relations)
        ]
        if marked:
            return name if name in marked else marked[0]
    return name


def _is_all_said(sentence: Sentence, values: List[TypedArgument], is_strict: bool) -> bool:
    """Whether an answer says only its values: no "not", condition or time and, if strict, no other content word."""
    used = frozenset(position for value in values for position in value.positions)
    answering = frozenset(answering_words(sentence.tree))
    if sentence.tree.times:
        return False
    for word in sentence.tree.words:
        if word.said in _NO_ANSWER:
            return False
        is_said = word.index in used or word.said in _HEARER  # "To your right" is to the right.
        if is_strict and not is_said and word.index in answering and sentence.is_content(word.index):
            return False
    return True


def _is_choice(value: TypedArgument, choice: str) -> bool:
    """Whether an answer names one of the offered things: "the plate", "plate"."""
    said, offered = value.words.lower().split(), choice.lower().split()
    return [word for word in said if word not in _ARTICLES] == [word for word in offered if word not in _ARTICLES]


def _fragment_values(sentence: Sentence, frame: SemanticFrame, element: FrameElement) -> List[TypedArgument]:
    # "Hello" may be the message.
    is_message = element.framenet == MESSAGE
    left_out_tags = ("PUNCT",) if is_message else ("PUNCT", "INTJ")
    answering = [word.index for word in sentence.tree.words] if is_message else answering_words(sentence.tree)
    positions = [index for index in answering if sentence.word(index).upos not in left_out_tags]
    amounts = find_amounts(sentence.tree, [word.index for word in sentence.tree.words])
    sound = amounts if not any(amount.is_doubtful for amount in amounts) else ()
    if element.quantity is not None:
        directions = _direction_values(sentence, frame)
        return _amount_values(sentence, element, sound[0]) + directions if sound else directions
    # "Three feet" is neither a place nor a thing.
    is_measure = any(amount.unit and set(positions) <= set(amount.positions) for amount in amounts)
    is_unit = any(other.unit_element == element.name for other in frame.frame_elements)
    if not positions or (is_measure and not is_unit):
        return []
    heads = [index for index in positions if sentence.word(index).head not in positions]
    head = heads[0] if heads else positions[0]
    is_no_place = element.framenet == GOAL and is_direction(sentence.tree, head)
    if is_no_place or is_unfinished(sentence.tree, head):
        return []
    # "Now the book", "and the book"
    before = takewhile(lambda index: sentence.word(index).said in _LEAD_IN and index != head, positions)
    left_out = frozenset(before).union(
        word.index
        for word in sentence.tree.words
        if word.index not in answering or (word.deprel.startswith("discourse") and word.upos in left_out_tags)
    )
    named = _named_values(sentence, element)
    if len(named) != 1:
        return [sentence.phrases.argument(element.name, head, left_out=left_out)]
    # "Left, 90 degrees" and "ninety degrees to the left" say more than was asked.
    said = [argument_of(sentence, element.name, named)]
    measured = [(other, other.quantity.value) for other in frame.frame_elements if other.quantity is not None]
    for other, quantity in measured:
        meant = (quantity, Quantity.NUMBER.value) if len(measured) == 1 else (quantity,)
        said += [value for one in sound[:1] if one.quantity in meant for value in _amount_values(sentence, other, one)]
    return said


def _direction_values(sentence: Sentence, frame: SemanticFrame) -> List[TypedArgument]:
    """Return the direction that an answer names besides what was asked: "how far?" - "forward two feet"."""
    element = next((one for one in frame.frame_elements if one.framenet == DIRECTION), None)
    named = _named_values(sentence, element) if element is not None else []
    return [argument_of(sentence, element.name, named)] if element is not None and len(named) == 1 else []


def _named_values(sentence: Sentence, element: FrameElement) -> List[int]:
    """Return the words of an utterance that are values of an element; "to my right" is not the robot's right."""
    words = {word.index: word.said for word in sentence.tree.words}
    allowed = {value.lower() for value in element.values}
    return [index for index, form in words.items() if form in allowed] if _SPEAKER.isdisjoint(words.values()) else []


def _amount_values(sentence: Sentence, element: FrameElement, amount: Amount) -> List[TypedArgument]:
    """Return the values of an amount, with the words before it: "about two metres"."""
    value = amount_argument(sentence.tree, element.name, amount, is_whole=not element.unit_element)
    hedges = words_before_amount(sentence.tree, min(amount.positions))
    values = [replace(value, positions=tuple(sorted({*hedges, *value.positions})))]
    if element.unit_element and amount.unit:
        values.append(unit_argument(sentence.tree, element.unit_element, amount))
    return values
