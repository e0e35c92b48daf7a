"""Reads questions about deeds by the units of the verbs that command them: "did you close the door".

The same unit that fills the frame of a command fills the frame that is asked about. The features of the clause say
what is asked: whether, when, where, why, how often, who, or one of the elements.
"""

from dataclasses import replace
from typing import Optional, Sequence, Tuple

from semantic_framer.clauses.deed_clauses import HOW, WHETHER, DeedClause, of_own_deed, with_going
from semantic_framer.judging.verdicts import Case
from semantic_framer.kinds.clause_features import Aspect, ClauseFeatures, Form, features_among, features_of
from semantic_framer.kinds.question_extent import words_of_question
from semantic_framer.kinds.question_orders import length_of_opening
from semantic_framer.queries.questions import only_asks, spelling
from semantic_framer.referring.references import resolve
from semantic_framer.referring.world_references import refer
from semantic_framer.units.frame_roles import PLACES
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.dialogue import Context
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from typed_arguments import Source, TypedArgument
from utterance_passes.trees.tree import NOMINALS, Word
from utterance_passes.trees.vocabulary import Speech
from word_classes import word_class

#: The frame that asks about another frame, and its elements beside the deed, its agent and its time.
QUESTION_OF_EVENT = "question_of_event"
ASKS, ASPECT, ABLE = "asks", "aspect", "able"
_SPEAKER_OBJECTS, _WHETHER = word_class("speaker_objects"), word_class("whether_words")
_QUESTION_WORDS = word_class("question_words")
_PLEASE = "please"
_INFINITIVES = frozenset(["xcomp", "ccomp", "csubj"])
#: "Could you close it" is a request, whatever it is embedded in.
_CAN = "can"
_ABILITIES = frozenset([_CAN, "ca"])


def deed_question(case: Case, features: ClauseFeatures, context: Context) -> Tuple[Reading, ...]:
    """Return the readings of a clause that asks what was done, runs, is planned or can be done; none for others.

    Args:
        case: the sentence
        features: of the clause that asks
        context: what was said before, for its pronouns
    """
    if case.known.frames.get(QUESTION_OF_EVENT) is None:
        return ()
    if case.known.heeded and QUESTION_OF_EVENT not in case.known.heeded:
        return ()
    return _asked_of(case, features, context)


def asking_features(case: Case) -> Optional[ClauseFeatures]:
    """Return the features of the clause that asks, if a sentence only asks one thing; None for other sentences."""
    words = words_of_question(case.sentence)
    features = _features(case.sentence, words)
    # "Can you see Bob in the hall?" begins like a request, and asks.
    is_question = only_asks(case, words) or bool(length_of_opening([spelling(word) for word in words]))
    if features is None or not is_question:
        return None
    is_marked = features.form is Form.PLAIN and case.sentence.tree.text.rstrip().endswith("?")
    return replace(features, form=Form.POLAR) if is_marked else features


def ability_question(case: Case, context: Context) -> Tuple[Reading, ...]:
    """Return the reading of "can you close doors": whoever names a kind, and no thing, asks for nothing to be done."""
    features = _features(case.sentence, words_of_question(case.sentence))
    if features is None or features.modal not in _ABILITIES or features.form is not Form.POLAR or features.is_negated:
        return ()
    found = deed_question(case, features, context)
    if not found:
        return ()
    (deed,) = found[0].arguments[0].frames
    # "Can you fetch newspapers from the kitchen" names a kind; "can you bring me cups" wants some.
    said = [element for element in deed.frame_elements if _is_object(element, case.sentence)]
    frame = case.known.frames[deed.frame_name]
    places = {element.name for element in frame.frame_elements if element.framenet in PLACES}
    # "Can you show guests where the bathroom is."
    said = [element for element in said if element.name not in places] or said
    is_general = bool(said) and all(map(_is_kind, said))
    is_courteous = any(word.said == _PLEASE for word in case.sentence.tree.words)
    return found if is_general and not is_courteous else ()


def _is_object(argument: TypedArgument, sentence: Sentence) -> bool:
    """Whether an argument names what is handled: no place, no amount, no adverb."""
    is_bare = bool(argument.positions) and not argument.relation and argument.measure is None and argument.time is None
    return is_bare and bool(argument.head_position) and sentence.word(argument.head_position).upos in NOMINALS


def _is_kind(argument: TypedArgument) -> bool:
    """Whether an argument names a kind: "doors", and not "the doors", "two doors", "doors of the hall"."""
    is_one = argument.quantifier or argument.possessor or argument.count or argument.frames or argument.members
    return argument.is_plural and not is_one


def embedded_features(case: Case) -> Optional[ClauseFeatures]:
    """Return the features of a question behind words that only ask for it: "I want to know whether *you left*"; None
    for other sentences."""
    words = words_of_question(case.sentence)
    length = length_of_opening([spelling(word) for word in words])
    if not 0 < length < len(words):
        return None
    features = _features(case.sentence, words[length:])
    return features.as_question() if features is not None else None


def told_features(case: Case) -> Optional[ClauseFeatures]:
    """Return the features of a question that the speaker wants to be told: "tell me when *you left*"; None for others.

    "Tell me when it is off" may wait for that; only what is over is certainly asked.
    """
    sentence = case.sentence
    if not is_told_to_speaker(sentence, case.known):
        return None
    (top,) = sentence.children(0)
    for word in sentence.children(top.index):
        begin = sentence.word(sentence.tree.phrase_start(word.index)).said
        if word.index > top.index and word.deprel in ("ccomp", "advcl") and begin in _WHETHER | _QUESTION_WORDS:
            return features_of(sentence.tree, word.index).as_question()
    return None


def _features(sentence: Sentence, words: Sequence[Word]) -> Optional[ClauseFeatures]:
    return features_among(sentence.tree, [word.index for word in words])


def is_told_to_speaker(sentence: Sentence, known: FramedLexicon) -> bool:
    """Whether a sentence asks the robot to tell its speaker something, and nothing else: "tell me ..."."""
    tops = sentence.children(0)
    if len(tops) != 1 or known.speech_of(tops[0].lemma.lower()) is not Speech.TOLD:
        return False
    children = sentence.children(tops[0].index)
    told = [child for child in children if child.deprel in ("iobj", "obj") and child.said in _SPEAKER_OBJECTS]
    return bool(told) and not any(child.deprel in ("conj", "parataxis") for child in children)


def _asked_of(case: Case, features: ClauseFeatures, context: Context) -> Tuple[Reading, ...]:
    known = case.known
    sentence, features = with_going(case.sentence, features)
    case = replace(case, sentence=sentence)
    if features.form is Form.POLAR:  # "Tell me when you are docked" asks for no time.
        features = of_own_deed(sentence, features, known)
    top, features = _of_what_is_meant(sentence, features.top, features)
    aspect = _aspect(features)
    # "Is it closed" asks for a state, "when was it closed" for a deed.
    is_state = not (features.is_passive and features.asked) and any(
        child.deprel == "cop" for child in sentence.children(top)
    )
    if features.form is Form.PLAIN or not aspect or is_state or not (features.agent or features.is_passive):
        return ()
    clause = DeedClause(case, top, features)
    if not _is_answerable(clause, aspect):
        return ()
    deed = clause.deed()
    if deed is None or (aspect == ABLE and clause.said_when):
        return ()
    meant = resolve(deed, context, known)
    if isinstance(meant, TypedArgument):
        return ()
    meant, _ = refer(meant, known, context)
    return (_reading(sentence, meant, clause, aspect),)


def _is_answerable(clause: DeedClause, aspect: str) -> bool:
    """Whether the robot can know it: what it did, does and can do, and what persons did."""
    if clause.asks == HOW:
        return False
    if aspect == ABLE:
        return clause.is_of_robot and clause.asks in (WHETHER, "")
    if clause.is_of_robot or not clause.features.agent:
        return True
    return aspect in (Aspect.DONE.value, Aspect.EVER_DONE.value) and clause.is_of_person


def _aspect(features: ClauseFeatures) -> str:
    """Return which deeds are asked about; empty for what asks how things are, and for requests ("will you")."""
    if features.modal in _ABILITIES:
        return ABLE
    if features.modal or features.aspect is Aspect.PRESENT:
        return ""
    return str(features.aspect.value)


def _of_what_is_meant(sentence: Sentence, top: int, features: ClauseFeatures) -> Tuple[int, ClauseFeatures]:
    """Return the verb of "are you *going to close* the door", with when it happens; others stay as they are."""
    lemma = sentence.word(top).lemma.lower()
    inside = [child for child in sentence.children(top) if child.deprel in _INFINITIVES and child.upos == "VERB"]
    inner = next((child for child in inside if sentence.tree.is_infinitive(child.index)), None)
    if inner is None:
        return top, features
    if lemma == "take" and features.asked:
        # "How long did it take *you* to close it?"
        who = next((child.index for child in sentence.children(top) if child.deprel in ("obj", "iobj")), 0)
        return (inner.index, replace(features, agent=who)) if who else (top, features)
    if not features.agent:
        return top, features
    if lemma == "go" and features.aspect is Aspect.RUNNING:
        return inner.index, replace(features, aspect=Aspect.PLANNED)
    if lemma == "need" and features.asked:
        return inner.index, features
    is_known = lemma == "know" and any(child.said == HOW for child in sentence.children(inner.index))
    if lemma == ABLE or is_known:
        return inner.index, replace(features, modal=_CAN)
    return top, features


def _reading(sentence: Sentence, deed: Reading, clause: DeedClause, aspect: str) -> Reading:
    words = [word for word in sentence.tree.words if word.upos != "PUNCT"]
    return Reading(
        unit=replace(deed.unit, frame_name=QUESTION_OF_EVENT),
        verb=deed.verb,
        verb_positions=tuple(word.index for word in words),
        arguments=(
            clause.argument(deed, "question"),
            TypedArgument(ASKS, clause.asked_element(deed), Source.INFERRED),
            TypedArgument(ASPECT, aspect, Source.INFERRED),
            clause.agent(),
            *clause.said_when,
        ),
        missing=(),
        left_over=(),
        coverage=1.0,
        clause_text=sentence.tree.text.strip(),
    )
