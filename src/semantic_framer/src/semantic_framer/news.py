"""News that somebody wants to hear when it happens: "tell me when the oven is off", "let me know if the bell rings"."""

from typing import Sequence

from semantic_framer.clause_plan import Clauses
from semantic_framer.condition_part import happens
from semantic_framer.conditions import read_condition
from semantic_framer.findings_told import element_told
from semantic_framer.frame_roles import MESSAGE, TELLING
from semantic_framer.framed_lexicon import FramedLexicon
from semantic_framer.joints import Joint, Joints
from semantic_framer.link_file import LinkKind, shipped_links
from semantic_framer.reading import Reading, with_argument
from semantic_framer.sentence import Sentence
from typed_arguments import Source, TypedArgument
from word_classes import word_class

#: Links before news.
_OF_NEWS = (LinkKind.WHEN, LinkKind.ANEW, LinkKind.WHENEVER)
_PARTICIPANTS = word_class("participants") | word_class("possessives_of_participants")


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
    link, length = shipped_links().link_at([sentence.word(index).form.lower() for index in positions])
    if link is None or link.kind not in (LinkKind.IF, *_OF_NEWS) or _names_participants(sentence, positions):
        return Joints()
    condition = read_condition(sentence, known, positions[length:])
    if condition is None or not happens(condition, sentence.tree, known.frames):
        return Joints()
    kind = LinkKind.WHEN if link.kind is LinkKind.IF else link.kind
    words = sentence.text(positions[:length])
    return Joints((Joint(kind, positions[0], frozenset(positions), condition, words=words),))


def with_news(clauses: Clauses, sentence: Sentence, joints: Joints, known: FramedLexicon) -> Clauses:
    """Return clauses in which what the robot waits for or looks at is what it tells: "tell me when the oven is off",
    "if the door is open, tell me"."""
    kinds = [joint.kind for joint in joints.found]
    if LinkKind.OTHERWISE in kinds:
        return clauses  # "..., otherwise tell me" tells something else.
    news = [joint.condition for joint in joints.found if joint.condition and joint.kind in (LinkKind.IF, *_OF_NEWS)]
    if len(news) != 1:
        return clauses
    positions = sorted(news[0].positions)
    if _names_participants(sentence, positions):
        return clauses  # "You see Anna" would be said of the person.
    said = news[0].words or sentence.text(positions).strip(" ,.!?")
    return tuple(tuple(_told(reading, said, known) for reading in readings) for readings in clauses)


def _told(reading: Reading, said: str, known: FramedLexicon) -> Reading:
    element = element_told(reading, known.frames)
    if element is None:
        return reading
    return with_argument(reading, TypedArgument(element.name, said, Source.INFERRED, words=said))


def _names_participants(sentence: Sentence, positions: Sequence[int]) -> bool:
    return bool(_PARTICIPANTS & {sentence.word(index).form.lower() for index in positions})
