"""Converts what is known to messages and back."""

from typing import Tuple

import rospy
from roboframenet_msgs import msg

from experience.belief import RATES
from experience.known import Cell, Experience, Record, Subject
from experience.rules import Rule, RuleKind
from experience.snapshot import Snapshot
from experience.trial import MOST_CHARACTERS, Circumstances, Outcome, Trial, kinds_of, referents_of
from typed_arguments.ros_messages import from_message


def snapshot_to_message(known: Snapshot, version: str) -> msg.Experience:
    """Convert what is known."""
    return msg.Experience(
        version=version,
        place=known.place,
        explorable=sorted(known.explorable),
        servers=[
            _record_to_message(subject, record, known.experience.ticks.get(subject.frame, 0))
            for subject, record in known.experience.records.items()
        ],
        rules=[rule_to_message(rule) for rule in known.rules],
    )


def snapshot_from_message(message: msg.Experience) -> Snapshot:
    """Convert what is known.

    Raises:
        ValueError: an entry is malformed
    """
    experience = Experience()
    for one in message.servers:
        subject = Subject(one.frame_name, one.server, one.robot)
        cells = {(cell.aspect, cell.value): _cell(cell) for cell in one.cells}
        experience.records[subject] = Record(cells, one.tick, one.took)
        experience.ticks[one.frame_name] = one.trials_of_frame
    rules = tuple(rule_from_message(rule) for rule in message.rules)
    robots = {one.server: one.robot for one in message.servers if one.robot}
    return Snapshot(experience, rules, frozenset(message.explorable), message.place, robots)


def _record_to_message(subject: Subject, record: Record, ticks: int) -> msg.ServerExperience:
    return msg.ServerExperience(
        frame_name=subject.frame,
        server=subject.server,
        robot=subject.robot,
        took=record.took_s,
        trials_of_frame=ticks,
        tick=record.tick,
        cells=[
            msg.ExperienceCell(
                aspect=aspect,
                value=value,
                belief=list(cell.belief),
                recent=bytes(cell.recent),
            )
            for (aspect, value), cell in record.cells.items()
        ],
    )


def _cell(message: msg.ExperienceCell) -> Cell:
    if len(message.belief) != len(RATES):
        raise ValueError(f"a belief has {len(message.belief)} shares, not {len(RATES)}")
    return Cell(tuple(message.belief), tuple(bool(one) for one in bytes(message.recent)))


def rule_to_message(rule: Rule) -> msg.ServerRule:
    """Convert a rule."""
    return msg.ServerRule(
        id=rule.rule_id,
        kind=int(rule.kind),
        server=rule.server,
        frame_name=rule.frame,
        thing=rule.thing,
        is_once=rule.is_once,
        said=rule.said,
        stamp=rospy.Time.from_sec(rule.stamp_s),
    )


def rule_from_message(message: msg.ServerRule) -> Rule:
    """Convert a rule.

    Raises:
        ValueError: its kind is unknown
    """
    return Rule(
        message.id,
        RuleKind(message.kind),
        message.server,
        message.frame_name,
        message.thing,
        message.is_once,
        message.said,
        message.stamp.to_sec(),
    )


def trial_from_message(message: msg.TriedFrame, *, sequence: str, place: str, robot: str) -> Trial:
    """Convert a frame that was tried.

    Args:
        message: what the executor says
        sequence: what the candidate did up to here
        place: where the robot was when it began
        robot: whose server it is
    Raises:
        ValueError: it is malformed
    """
    (server,) = _one_server(message)
    arguments = [from_message(argument) for argument in message.arguments]
    return Trial(
        command_id=message.command.id[:MOST_CHARACTERS],
        said=message.command.text[:MOST_CHARACTERS],
        began_s=message.began.to_sec(),
        frame=message.frame.name,
        server=server,
        sequence=sequence[:MOST_CHARACTERS],
        circumstances=Circumstances(kinds_of(arguments), referents_of(arguments), place, robot),
        took_s=max(0.0, message.took.to_sec()),
        outcome=Outcome(message.outcome),
        reason=message.reason[:MOST_CHARACTERS],
    )


def _one_server(message: msg.TriedFrame) -> Tuple[str]:
    servers = message.frame.action_server_topics
    if len(servers) != 1 or not message.frame.name:
        raise ValueError(f"the frame {message.frame.name!r} names {len(servers)} servers")
    return (servers[0],)
