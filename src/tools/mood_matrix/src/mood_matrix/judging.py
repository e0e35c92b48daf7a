"""Compares what the offline pipeline answers with what is right.

Everything that depends on how the framer writes a meaning down stands here: names of frames of questions, their
elements, and codes of replies.
"""

from dataclasses import dataclass
from enum import Enum
from typing import Callable, FrozenSet, Iterator, Mapping, Optional, Tuple

from mood_matrix.constructions import NOBODY, ROBOT, Deed, Expected, Outcome, Sentence
from mood_matrix.english import NounPhrase
from mood_matrix.units import Served, words_of
from offline_pipeline.pipeline import Pipeline, Understanding
from semantic_framer.values.clause_plan import CONDITION, PlanPart, leaves_of
from semantic_framer.values.reading import Reading
from semantic_frames.server_profile import HeededElement, Purpose, ServerProfile
from typed_arguments import EmbeddedFrame, Source, TypedArgument

#: The frame of a question about a deed, and its elements.
QUESTION_OF_EVENT, DEED, ASKS, ASPECT, AGENT = "question_of_event", "deed", "asks", "aspect", "agent"
#: Patterns whose answer is the same where their deed, in words, is the whole deed: what is asked, and the aspect.
PATTERNS_WITH_DEED: Mapping[str, Tuple[str, str]] = {"question_of_reason": ("why", "done")}
#: A prohibition is noted: what runs against it ends, and nothing begins.
PROHIBITED = frozenset(["NEGATED"])
#: Nothing happens, and the reply says that no command was heard.
NOTHING_TO_NOTE = frozenset(["REPORT"])
#: No server watches the condition, or none for whom or what was said; the reply names it.
CANNOT_NOTICE = frozenset(["NO_SERVER", "VALUE_NOT_ALLOWED"])
#: Frames of states: what is noted of a report, and what is waited for beside the event itself.
STATES = frozenset(
    [
        "being_in_state",
        "being_in_category",
        "being_located",
        "having",
        "condition_of_state",
        "condition_of_place",
        "condition_of_possession",
    ]
)
#: Frames that check or make sure of their content.
ASSURING = frozenset(["verifying"])
#: Frames that tell an answer to somebody.
TELLING = frozenset(["telling"])
GOING = frozenset(["navigating_to_location"])
#: Frames of the stop server.
STOPS = frozenset(["stopping", "waiting"])
#: Whoever speaks.
_SPEAKER = frozenset(["me", "us"])
#: Conditions that no shipped server watches.
UNWATCHED = frozenset(["condition_of_act"])
#: Frames that change nothing, beside questions and conditions.
_IDLE = frozenset(["praising_a_deed", "criticizing_a_deed"])
_ROBOTS = frozenset(["you", "robot", "ya"])
#: What stands for the thing that a relative clause describes, or that is asked for.
_GAPS = frozenset(["that", "which", "who"])
_STANDING = frozenset(["AT", "WHENEVER"])


class Verdict(Enum):
    """What became of a sentence.

    Attributes:
        RIGHT: the right answer
        ASKED: a question to the speaker instead
        REFUSED: refused instead, or an error
        ANSWERED: an answer, a note or a wait that is not right; nothing is done
        ACTED: something is done that is not right
    """

    RIGHT = "right"
    ASKED = "asked"
    REFUSED = "refused"
    ANSWERED = "answered wrongly"
    ACTED = "acted on wrongly"


@dataclass(frozen=True)
class Judged:
    """A sentence and its verdict; ``cause`` is the code of the reply, or the frames that were read instead."""

    sentence: Sentence
    verdict: Verdict
    cause: str
    reply: str


class Judge:
    """Understands sentences, and compares.

    Args:
        pipeline: the stages from text to candidates
        served: what shipped servers do and watch
    """

    def __init__(self, pipeline: Pipeline, served: Served) -> None:
        self._pipeline = pipeline
        # What nobody watches on a robot as it is shipped, whatever is pretended.
        graph, frames = pipeline.knowledge.graph, pipeline.knowledge.frames
        graph.set_dead(UNWATCHED)
        for frame, element, values in (
            ("condition_of_state", "state", served.states),
            ("condition_of_perceiving", "perceiver", served.perceivers),
        ):
            if frame in frames:
                heeded = HeededElement(element, values=tuple(values))
                graph.register(frame, frame, ServerProfile(purpose=Purpose.WATCHES, heeds=(heeded,)))
        self._idle: FrozenSet[str] = frozenset(name for name, frame in frames.items() if not frame.acts) | (
            _IDLE | STATES
        )

    def judge(self, sentence: Sentence) -> Judged:
        """Understand a sentence and compare the result with the right answer."""
        return self.verdict(sentence, self._pipeline.understand_safely(sentence.text))

    def verdict(self, sentence: Sentence, said: Understanding) -> Judged:
        """Compare a result with the right answer."""
        cause = said.reply.code
        if said.reply.outcome == "DONE":
            cause = ", ".join(reading.unit.frame_name for reading in said.readings) or "a stop"
        if is_right(sentence.expected, said):
            verdict = Verdict.RIGHT
        elif said.reply.outcome == "NEEDS_INFORMATION":
            verdict = Verdict.ASKED
        elif said.reply.outcome != "DONE":
            verdict = Verdict.REFUSED
        else:
            verdict = Verdict.ACTED if self._acts(said) else Verdict.ANSWERED
        return Judged(sentence, verdict, cause, said.reply.sentence)

    def _acts(self, said: Understanding) -> bool:
        """Whether something would be done: a stop, a standing order, a deed, a rule that is kept."""
        if said.behind is not None or not said.readings:
            return True
        if said.plan is None:
            return not all(map(self._is_idle, said.readings))
        deeds = (leaf for leaf in leaves_of(said.plan) if leaf.kind != CONDITION)
        is_standing = any(part.kind in _STANDING for part in _parts(said.plan))
        return is_standing or not all(self._is_idle(_reading_of(leaf, said)) for leaf in deeds)

    def _is_idle(self, reading: Reading) -> bool:
        """Whether a reading only answers: what is told to the speaker is an answer, too."""
        if reading.unit.frame_name in TELLING:
            return any(value.name == "addressee" and value.text in _SPEAKER for value in reading.arguments)
        return reading.unit.frame_name in self._idle


def is_right(expected: Expected, said: Understanding) -> bool:
    """Whether the result is the right answer."""
    return _RULES[expected.outcome](expected, said)


def _done(said: Understanding) -> bool:
    return said.reply.outcome == "DONE" and said.behind is None


def _is_act(expected: Expected, said: Understanding) -> bool:
    if not _done(said):
        return False
    if expected.deed.frame in STOPS and not expected.deed.elements and not said.readings:
        return True
    return said.plan is None and len(said.readings) == 1 and _does(said.readings[0], expected.deed)


def _is_act_or_question(expected: Expected, said: Understanding) -> bool:
    is_asked = said.reply.outcome == "NEEDS_INFORMATION" and len(said.readings) == 1
    return _is_act(expected, said) or (is_asked and _is_deed(said.readings[0], expected.deed))


def _is_stop(_: Expected, said: Understanding) -> bool:
    return _done(said) and not said.readings


def _is_prohibited(_: Expected, said: Understanding) -> bool:
    return said.reply.code in PROHIBITED


def _is_answer(expected: Expected, said: Understanding) -> bool:
    if not (_done(said) and said.plan is None and len(said.readings) == 1):
        return False
    return _asks(said.readings[0], expected) or _asks_in_words(said.readings[0], expected)


def _is_told(expected: Expected, said: Understanding) -> bool:
    if _is_answer(expected, said):
        return True
    if not (_done(said) and said.plan is None and len(said.readings) == 1):
        return False
    reading = said.readings[0]
    return reading.unit.frame_name in TELLING and any(
        frame.mood == "question" and _embeds(frame, expected.deed) for frame in _embedded(reading)
    )


def _asks(reading: Reading, expected: Expected) -> bool:
    """Whether a reading is the query for what is expected."""
    if reading.unit.frame_name != QUESTION_OF_EVENT:
        return False
    said = {value.name: value for value in reading.arguments}
    texts = {name: value.text for name, value in said.items()}
    if (texts.get(ASKS), texts.get(ASPECT), texts.get(AGENT)) != (expected.asks, expected.aspect, expected.agent):
        return False
    frames = said[DEED].frames if DEED in said else ()
    return bool(frames) and _embeds(frames[0], expected.deed, is_negated=expected.polarity == "negative")


def _asks_in_words(reading: Reading, expected: Expected) -> bool:
    """Whether a pattern asks the same and its words are the whole deed."""
    asked = PATTERNS_WITH_DEED.get(reading.unit.frame_name)
    if asked != (expected.asks, expected.aspect) or not expected.said:
        return False
    return any(value.name == DEED and value.text.lower() == expected.said.lower() for value in reading.arguments)


def _waits(expected: Expected, said: Understanding) -> bool:
    """Whether the robot waits for the right event or state, and then does what was said for then."""
    plan = said.plan
    if not _done(said) or plan is None:
        return False
    if expected.then is None:
        return plan.kind == "WAIT" and len(plan.children) == 1 and _is_condition(plan.children[0], expected, said)
    condition, then = _guarded(plan, said)
    if condition is None or then is None or condition.is_negated:
        return False
    return _is_condition(condition, expected, said) and _does(then, expected.then)


def _cannot_notice(expected: Expected, said: Understanding) -> bool:
    return said.reply.outcome == "REFUSED" and said.reply.code in CANNOT_NOTICE


def _are_both(expected: Expected, said: Understanding) -> bool:
    if not _done(said) or expected.then is None or len(said.readings) != 2:
        return False
    if said.plan is not None:
        is_sequence = said.plan.kind == "SEQUENCE" and [child.kind for child in said.plan.children] == ["DO", "DO"]
        if not is_sequence:
            return False
    return _does(said.readings[0], expected.deed) and _does(said.readings[1], expected.then)


def _is_decided(expected: Expected, said: Understanding) -> bool:
    plan = said.plan
    if not _done(said) or plan is None or plan.kind != "IF" or len(plan.children) != 2 or expected.then is None:
        return False
    condition, then = plan.children
    if condition.kind != CONDITION or then.kind != "DO" or not _does(_reading_of(then, said), expected.then):
        return False
    reading = _reading_of(condition, said)
    # The deed inside the condition may repeat its negation.
    is_negated = condition.is_negated or any(frame.is_negated for frame in _embedded(reading))
    return is_negated and _is_event(reading, expected, is_negated=None)


def _is_order(expected: Expected, said: Understanding) -> bool:
    """Whether the other deed waits for the deed, and nothing is done now."""
    if not _done(said) or said.plan is None or expected.then is None:
        return False
    condition, then = _guarded(said.plan, said)
    if condition is None or then is None or condition.is_negated:
        return False
    return _is_event(_reading_of(condition, said), expected) and _does(then, expected.then)


def _is_visit(expected: Expected, said: Understanding) -> bool:
    if not (_done(said) and said.plan is None and len(said.readings) == 1):
        return False
    (reading,) = said.readings
    goals = [value for value in reading.arguments if value.name == "goal"]
    if reading.unit.frame_name not in GOING or len(goals) != 1:
        return False
    (goal,) = goals
    is_thing = expected.theme.lower() in (goal.head.lower(), goal.lemma.lower(), NounPhrase(goal.text).head.lower())
    is_known = any(_embeds(frame, expected.deed) for frame in goal.frames)
    return is_thing and (is_known or any(_is_deed(one, expected.deed) for one in said.descriptions))


def _is_noted(expected: Expected, said: Understanding) -> bool:
    """Whether the world learns the deed of a person, or the state that it results in."""
    if not (_done(said) and said.plan is None and len(said.readings) == 1):
        return False
    return _is_state(said.readings[0], expected) or _is_event(said.readings[0], expected)


def _is_nothing(_: Expected, said: Understanding) -> bool:
    return said.reply.outcome == "REFUSED" and said.reply.code in NOTHING_TO_NOTE


_RULES: Mapping[Outcome, Callable[[Expected, Understanding], bool]] = {
    Outcome.ACT: _is_act,
    Outcome.ACT_OR_ASK: _is_act_or_question,
    Outcome.STOP: _is_stop,
    Outcome.RULE: _is_prohibited,
    Outcome.ANSWER: _is_answer,
    Outcome.TELL: _is_told,
    Outcome.WAIT: _waits,
    Outcome.CANNOT_NOTICE: _cannot_notice,
    Outcome.BOTH: _are_both,
    Outcome.DECIDE: _is_decided,
    Outcome.ORDER: _is_order,
    Outcome.VISIT: _is_visit,
    Outcome.NOTE: _is_noted,
    Outcome.NOTHING_TO_NOTE: _is_nothing,
}


def _parts(plan: PlanPart) -> Iterator[PlanPart]:
    yield plan
    for child in plan.children:
        yield from _parts(child)


def _reading_of(leaf: PlanPart, said: Understanding) -> Reading:
    return said.readings[leaf.clause]


def _guarded(plan: PlanPart, said: Understanding) -> Tuple[Optional[PlanPart], Optional[Reading]]:
    """Return the condition of a plan and the one deed that waits for it; None where a plan has another form."""
    condition: Optional[PlanPart] = None
    if plan.kind == "WHENEVER" and len(plan.children) == 2:
        condition, then = plan.children
    elif plan.kind == "SEQUENCE" and [child.kind for child in plan.children] == ["WAIT", "DO"]:
        waiting, then = plan.children
        condition = waiting.children[0] if len(waiting.children) == 1 else None
    else:
        return None, None
    if condition is None or condition.kind != CONDITION or then.kind != "DO":
        return None, None
    return condition, _reading_of(then, said)


def _is_condition(leaf: PlanPart, expected: Expected, said: Understanding) -> bool:
    if leaf.kind != CONDITION or leaf.is_negated:
        return False
    reading = _reading_of(leaf, said)
    return _is_event(reading, expected) or _is_watched(reading, expected) or _is_state(reading, expected)


def _is_event(reading: Reading, expected: Expected, *, is_negated: Optional[bool] = False) -> bool:
    """Whether a reading is the deed itself, by the right agent."""
    frames = _embedded(reading)
    if reading.unit.frame_name == expected.deed.frame:
        return _fills(reading.arguments, expected.deed, agent=expected.agent)
    agents = [value.text for value in reading.arguments if value.name == AGENT]
    is_agent = not agents or agents == [expected.agent]
    deed, agent = expected.deed, expected.agent
    return is_agent and any(_embeds(frame, deed, is_negated=is_negated, agent=agent) for frame in frames)


def _is_watched(reading: Reading, expected: Expected) -> bool:
    """Whether a reading is the condition that a shipped server watches for the deed of a person."""
    if reading.unit.frame_name not in expected.watched_as:
        return False
    texts = {value.text.lower() for value in reading.arguments}
    places = {text.lower() for text in expected.deed.elements.values()} - {"left", "forward", "here"}
    return expected.agent.lower() in texts and places <= texts


def _is_state(reading: Reading, expected: Expected) -> bool:
    """Whether a reading says that things are in the state, or in the relation, that results."""
    texts = {value.text.lower() for value in reading.arguments}
    if reading.unit.frame_name not in STATES or not all(thing and thing.lower() in texts for thing in expected.things):
        return False
    return not expected.states or bool(texts & {state.lower() for state in expected.states})


def _embedded(reading: Reading) -> Tuple[EmbeddedFrame, ...]:
    return tuple(frame for value in reading.arguments for frame in value.frames)


def _embeds(frame: EmbeddedFrame, deed: Deed, *, is_negated: Optional[bool] = False, agent: str = "") -> bool:
    """Whether a clause inside a phrase is a deed; ``is_negated`` is None where that is judged elsewhere."""
    if frame.frame_name != deed.frame or is_negated not in (None, frame.is_negated):
        return False
    return _fills(frame.frame_elements, deed, agent=agent)


def _does(reading: Reading, deed: Deed) -> bool:
    """Whether a reading does a deed, also by making sure of it."""
    if reading.unit.frame_name in ASSURING and deed.frame not in ASSURING:
        return any(_embeds(frame, deed) for frame in _embedded(reading))
    return _is_deed(reading, deed)


def _is_deed(reading: Reading, deed: Deed) -> bool:
    return reading.unit.frame_name == deed.frame and _fills(reading.arguments, deed)


def _fills(arguments: Tuple[TypedArgument, ...], deed: Deed, *, agent: str = "") -> bool:
    """Whether arguments are those of a deed. Who does it, what is asked or described, and defaults may be there too.

    Args:
        arguments: of a frame
        deed: what is right
        agent: who must do it, if the arguments say who; empty if it does not matter
    """
    said = {value.name: value for value in arguments if value.text or value.frames}
    for name, text in deed.elements.items():
        if name not in said or _plain(said[name].text) != _plain(text):
            return False
    doers = _ROBOTS | ({agent.lower()} if agent not in ("", ROBOT, NOBODY, "who") else {"who"})
    for name, value in said.items():
        is_free = value.source is not Source.SAID or value.is_asked or _plain(value.text) in doers | _GAPS
        if name in deed.elements or name == deed.asked or is_free:
            continue
        is_loose = words_of(value.text) <= deed.loose
        if not is_loose and _plain(value.text) != _plain(deed.optional.get(name, "")):
            return False
    if agent in ("", ROBOT, NOBODY, "who"):
        return True
    return any(_plain(value.text) == agent.lower() for value in said.values())


def _plain(text: str) -> str:
    return " ".join(text.lower().split())
