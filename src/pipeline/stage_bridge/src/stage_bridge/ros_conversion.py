"""Messages of 2012 for a stage outside, and what is made of its answers."""

import itertools
from typing import AbstractSet, Any, Dict, Iterable, List, Sequence, Tuple

from roboframenet_msgs.msg import (
    Clause,
    CommandLexicalUnits,
    FilledFrameElement,
    FilledLexicalUnitList,
    FilledSemanticFrame,
    FilledSemanticFrameList,
    FilledSemanticFrameListList,
    FrameServers,
    LexicalUnitReading,
    Plan,
    PlanCandidate,
    PlanNode,
    ServerProfile,
)

from arbitrator.ros_messages import any_from_message, procedure_to_message

#: An answer with more is refused.
MOST_UNITS = 64
MOST_SEQUENCES = 64
MOST_FRAMES = 20
MOST_ELEMENTS = 32
MOST_CHARACTERS = 1000
#: Frame, and server without its first slash.
Registered = AbstractSet[Tuple[str, str]]


class NotIn2012(ValueError):
    """The messages of 2012 cannot say the command; the text says why."""


class NoAnswer(ValueError):
    """The stage outside has found nothing; the text is for the person."""


class WrongAnswer(ValueError):
    """An answer that nothing may be done by; the text says why."""


def registered_in(message: FrameServers) -> Registered:
    """Return the frames and servers that can be asked to act."""
    return frozenset(
        (one.frame_name, one.callback_topic.lstrip("/"))
        for one in message.callbacks
        if one.is_alive and one.profile.purpose == ServerProfile.ACTS
    )


def units_sent(message: CommandLexicalUnits) -> FilledLexicalUnitList:
    """Return the readings of a command as the 2012 message.

    Raises:
        NotIn2012: it has several clauses, or a plan: as alternatives, their order would be lost
    """
    if message.plan.nodes or len(message.clauses) != 1:
        raise NotIn2012("The messages of 2012 hold one thing to do. Please say one at a time.")
    return FilledLexicalUnitList([reading.lexical_unit for reading in message.clauses[0].readings])


def frames_sent(plan: Plan) -> FilledSemanticFrameListList:
    """Return the candidates of a plan as the 2012 message.

    Raises:
        NotIn2012: the plan has conditions, repetitions or parts that run at the same time, or is a standing order
    """
    procedure = procedure_to_message(any_from_message(plan))
    if procedure is None:
        raise NotIn2012("The messages of 2012 hold no conditions, repetitions or times. Please say it without.")
    return FilledSemanticFrameListList(procedure.frame_lists)


def clause_of(answer: FilledLexicalUnitList, words: str) -> Clause:
    """Return the clause that a framer outside has read.

    Raises:
        NoAnswer: it has filled no lexical unit
        WrongAnswer: it is too large, or lacks a name
    """
    if not answer.lexical_units:
        raise NoAnswer("The framer outside found no frame for that.")
    _check_count(answer.lexical_units, MOST_UNITS, "lexical units")
    for unit in answer.lexical_units:
        _check_elements(unit.frame_name, unit.frame_elements)
    return Clause(
        words=words,
        readings=[LexicalUnitReading(lexical_unit=unit, coverage=1.0) for unit in answer.lexical_units],
    )


def candidates_of(answer: Any, registered: Registered) -> List[PlanCandidate]:
    """Return the candidates of a ``FilledSemanticFrameListList`` or a ``Procedure``, in its order.

    A frame with several servers becomes several candidates.

    Raises:
        NoAnswer: there is no sequence
        WrongAnswer: it is too large, or names a server that is not registered for its frame
    """
    if not answer.frame_lists:
        raise NoAnswer("The stage outside found no way to do that.")
    _check_count(answer.frame_lists, MOST_SEQUENCES, "sequences")
    found: List[PlanCandidate] = []
    for sequence in answer.frame_lists:
        if not sequence.frames:
            raise WrongAnswer("a sequence without frames")
        _check_count(sequence.frames, MOST_FRAMES, "frames in a sequence")
        choices = [list(_with_each_server(frame, registered)) for frame in sequence.frames]
        for frames in itertools.islice(itertools.product(*choices), MOST_SEQUENCES - len(found)):
            found.append(PlanCandidate(frames=list(frames), coverage=1.0, preference=len(found)))
    return found


def _with_each_server(frame: FilledSemanticFrame, registered: Registered) -> Iterable[FilledSemanticFrame]:
    _check_elements(frame.name, frame.frame_elements)
    if not frame.action_server_topics:
        raise WrongAnswer(f"the frame {frame.name} without a server")
    for server in frame.action_server_topics:
        if (frame.name, server.lstrip("/")) not in registered:
            raise WrongAnswer(f"{server[:60]} is not registered for {frame.name}, or does not answer")
        yield FilledSemanticFrame(frame.name, frame.frame_elements, [server])


def plan_of(candidates: Sequence[PlanCandidate], label: str, beginning: int = Plan.REPLACE) -> Plan:
    """Return a plan of one clause."""
    return Plan(nodes=[PlanNode(kind=PlanNode.DO, label=label, candidates=list(candidates))], beginning=beginning)


def ordered_plan(sent: Plan, answer: Any, registered: Registered, label: str) -> Plan:
    """Return a plan with its candidates in the order of an arbitrator outside; those that it left out are not tried.

    Raises:
        NoAnswer: it left out all
        WrongAnswer: it holds a sequence that it was not given
    """
    given = {_key(sequence): place for place, sequence in reversed(list(enumerate(frames_sent(sent).frame_lists)))}
    for sequence in answer.frame_lists:
        if _key(sequence) not in given:
            names = ", then ".join(frame.name for frame in sequence.frames) or "nothing"
            raise WrongAnswer(f"a sequence that no registrar found: {names}"[:MOST_CHARACTERS])
    checked = candidates_of(answer, registered)
    if len(sent.nodes) > 1:
        return plan_of(checked, label, sent.beginning)
    node = sent.nodes[0]
    # The candidates that were sent know more than words: their arguments are typed.
    places: Dict[int, None] = dict.fromkeys(given[_key(sequence)] for sequence in answer.frame_lists)
    chosen = [node.candidates[place] for place in places]
    first = PlanNode(kind=node.kind, label=node.label, candidates=chosen, arguments=node.arguments, limit=node.limit)
    first.is_limit_said = node.is_limit_said
    return Plan(nodes=[first], beginning=sent.beginning)


def _key(sequence: FilledSemanticFrameList) -> Tuple[Any, ...]:
    return tuple(
        (frame.name, tuple((one.name, one.argument) for one in frame.frame_elements), tuple(frame.action_server_topics))
        for frame in sequence.frames
    )


def _check_count(found: Sequence[Any], most: int, what: str) -> None:
    if len(found) > most:
        raise WrongAnswer(f"{len(found)} {what}; at most {most} are taken")


def _check_elements(name: str, elements: Sequence[FilledFrameElement]) -> None:
    if not name or len(name) > MOST_CHARACTERS:
        raise WrongAnswer("a frame without a name" if not name else "a name that is too long")
    _check_count(elements, MOST_ELEMENTS, "elements of a frame")
    for element in elements:
        if not element.name or len(element.name) > MOST_CHARACTERS:
            raise WrongAnswer(f"an element of {name} without a name, or with one that is too long")
        if len(element.argument) > MOST_CHARACTERS:
            raise WrongAnswer(f"{element.name} of {name} has {len(element.argument)} characters")
