"""News that somebody wants to hear when it happens: "tell me when the oven is off", "let me know if the bell rings"."""

from typing import AbstractSet, Sequence

from semantic_framer.clauses.conditions import read_condition
from semantic_framer.linking.joints import Joint, Joints
from semantic_framer.linking.link_file import LinkKind, shipped_links
from semantic_framer.referring.findings_told import element_told
from semantic_framer.units.frame_roles import ADDRESSEE, MESSAGE, TELLING
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.clause_plan import Clauses
from semantic_framer.values.condition_part import happens
from semantic_framer.values.reading import Reading, with_argument
from semantic_framer.values.sentence import Sentence
from typed_arguments import EmbeddedFrame, Source, TypedArgument
from utterance_passes.trees.tree import Word
from word_classes import turned_round, word_class, word_list

#: Links before news.
_OF_NEWS = (LinkKind.WHEN, LinkKind.ANEW, LinkKind.WHENEVER)
_TOLD = (LinkKind.IF, LinkKind.UNLESS, *_OF_NEWS)
_FORMS_OF_BE = word_class("forms_of_be")
_SOME = word_class("articles") | frozenset(["any", "some"])
_NEGATIONS = word_class("negations")
_OF_SPEAKER = word_class("words_of_the_speaker") | word_class("speaker_subjects") | word_class("speaker_objects")
_OF_TWO = _OF_SPEAKER | word_class("words_of_the_hearer")
_SPEAKER_OBJECTS = word_class("speaker_objects")


def told_when(sentence: Sentence, known: FramedLexicon, readings: Sequence[Reading]) -> Joints:
    """Return the condition that was taken for a message: "tell me *if the bell rings*"; nothing if there is none.

    "Tell me if the door is open" asks how the door is now, and "tell me when Anna comes back home" may ask for a time:
    only what happens in a moment, said in the simple present, is waited for.
    """
    messages = [
        sorted(argument.positions)
        for reading in readings
        for frame in [known.frames[reading.unit.frame_name]]
        # Who is *asked* "if the bell rings" is to answer.
        if frame.framenet == TELLING
        for argument in reading.arguments
        for element in [frame.element(argument.name)]
        if element is not None and element.framenet == MESSAGE and argument.positions
    ]
    if len(messages) != 1:
        return Joints()
    positions = messages[0]
    link, length = shipped_links().link_at([sentence.word(index).said for index in positions])
    if link is None or link.kind not in (LinkKind.IF, *_OF_NEWS) or _has(sentence.text(positions), _OF_TWO):
        return Joints()
    condition = read_condition(sentence, known, positions[length:])
    if condition is None or not happens(condition, sentence.tree, known.frames):
        return Joints()
    kind = LinkKind.WHEN if link.kind is LinkKind.IF else link.kind
    words = sentence.text(positions[:length])
    return Joints((Joint(kind, positions[0], frozenset(positions), condition, words=words),))


def with_news(clauses: Clauses, sentence: Sentence, joints: Joints, known: FramedLexicon) -> Clauses:
    """Return clauses in which what the robot waits for or looks at is what it tells: "tell me when the oven is off",
    "if the door is open, tell me". In the other case it tells the opposite: "is it open? if not, tell me"."""
    kinds = [joint.kind for joint in joints.found]
    if LinkKind.OTHERWISE in kinds:
        return clauses  # "..., otherwise tell me" tells something else.
    news = [(joint.condition, joint.kind) for joint in joints.found if joint.condition and joint.kind in _TOLD]
    if len(news) != 1:
        return clauses
    condition, kind = news[0]
    said = (condition.words or sentence.text(sorted(condition.positions))).strip(" ,.!?")
    if kind is LinkKind.UNLESS:
        said = _denied(said)
    if not said:
        return clauses
    is_of_speaker = _has(said, _OF_SPEAKER)
    told = turned_round(said, is_clause=True)
    return tuple(
        # "When my phone rings, tell Bob": to Bob, it is neither "my phone" nor "your phone".
        readings
        if is_of_speaker and not _is_told_to_speaker(readings[0], known)
        else tuple(_told(reading, told, known) for reading in readings)
        for readings in clauses
    )


def with_end_told(clauses: Clauses, sentence: Sentence, positions: Sequence[int], known: FramedLexicon) -> Clauses:
    """Return clauses that tell that the robot is done, if they say nothing else: "tell me *when you are done*".

    Args:
        clauses: readings of the rest of the sentence
        sentence: the sentence
        positions: of the words that say when the rest begins, ascending
        known: lexical units and frames
    """
    said = [_in_full(sentence.word(index)) for index in positions]
    _, length = shipped_links().link_at(said)
    if said[length : length + 1] != [word_list("words_of_the_hearer")[0]]:
        return clauses
    told = turned_round(" ".join(said[length:]), is_clause=True)
    return tuple(tuple(_told(reading, told, known) for reading in readings) for readings in clauses)


def _denied(said: str) -> str:
    """Return the opposite of a statement with a form of "be"; empty for another one, and for one that denies."""
    words = said.split()
    finite = next((place for place, word in enumerate(words) if word.lower() in _FORMS_OF_BE), None)
    if finite is None or _has(said, _NEGATIONS):
        return ""
    before, behind = words[: finite + 1], words[finite + 1 :]
    is_existence = "there" in (word.lower() for word in before)
    if is_existence and behind and behind[0].lower() in _SOME:
        behind = behind[1:]
    return " ".join([*before, "no" if is_existence else "not", *behind])


def _in_full(word: Word) -> str:
    """Return a word in lower case, and a contracted verb in full: "are" for "'re", "have" for "'ve"."""
    form = word.said
    if form[0] not in "'\u2019":
        return form
    return "are" if word.lemma.lower() == "be" else word.lemma.lower()


def _is_told_to_speaker(reading: Reading, known: FramedLexicon) -> bool:
    hearer = reading.argument_in_role(ADDRESSEE, known.frames[reading.unit.frame_name])
    return hearer is None or hearer.text.lower() in _SPEAKER_OBJECTS


def _told(reading: Reading, said: str, known: FramedLexicon) -> Reading:
    element = element_told(reading, known.frames)
    if element is None:
        return reading
    statement = EmbeddedFrame(role="says", words=said, mood="statement")
    return with_argument(reading, TypedArgument(element.name, said, Source.INFERRED, words=said, frames=(statement,)))


def _has(text: str, words: AbstractSet[str]) -> bool:
    return not words.isdisjoint(text.lower().split())
