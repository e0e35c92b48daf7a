"""Converts readings to messages."""

from typing import Dict, List, Mapping, Sequence, Tuple

import rospy
from roboframenet_msgs.msg import (
    Clause,
    FilledFrameElement,
    FilledLexicalUnit,
    FilledLexicalUnitList,
    FrameServers,
    Learned,
    LearnedItem,
    LexicalUnitReading,
    Plan,
    PlanNode,
    TimeExpression,
)

from nearest_meaning.learned import LearnedUnit
from semantic_framer.values.clause_plan import nodes_of, plan_of
from semantic_framer.values.outcome import Understood
from semantic_framer.values.reading import Reading
from semantic_frames.ros_server_profile import profile_from_message
from semantic_frames.server_profile import Purpose, ServerProfile
from typed_arguments.ros_messages import time_to_message, to_message
from utterance_passes.trees.tree import DependencyTree

#: So many of what persons taught are told: those taught last.
MOST_LEARNED = 200


def to_learned(units: Sequence[LearnedUnit]) -> Learned:
    """Return the message of what persons taught; the units are those taught first at the front."""
    items = [
        LearnedItem(
            name=unit.name,
            said=unit.said,
            meaning=unit.meaning,
            who=unit.who,
            stamp=rospy.Time.from_sec(max(0.0, unit.when_s)),
            sentence=unit.sentence,
        )
        for unit in reversed(units[-MOST_LEARNED:])
    ]
    return Learned(items=items, left_out=len(units) - len(items))


def acting_servers(message: FrameServers, robot: str = "") -> Mapping[str, Sequence[ServerProfile]]:
    """Return the profiles of the live servers that act, for each frame that has one.

    Args:
        message: all servers
        robot: whose; those that belong to no robot are everybody's. Empty for the servers of all
    """
    found: Dict[str, List[ServerProfile]] = {}
    for callback in message.callbacks:
        is_own = not robot or callback.profile.robot in ("", robot)
        if callback.is_alive and is_own and callback.profile.purpose == Purpose.ACTS:
            found.setdefault(callback.frame_name, []).append(profile_from_message(callback.profile))
    return found


def to_clauses(clauses: Sequence[Tuple[Reading, ...]], tree: DependencyTree) -> Sequence[Clause]:
    """Return readings as messages."""
    return [
        Clause(
            words=readings[0].clause_text,
            readings=[_reading(reading, tree, preference) for preference, reading in enumerate(readings)],
        )
        for readings in clauses
    ]


def to_plan(understood: Understood, text: str) -> Plan:
    """Return how the clauses of a command are joined; without nodes when they are done one after the other."""
    part = understood.plan or plan_of(understood.clauses, text)
    beginning = getattr(Plan, understood.beginning)
    if part is None:
        return Plan(beginning=beginning)
    unknown = TimeExpression()
    return Plan(
        beginning=beginning,
        nodes=[
            PlanNode(
                kind=getattr(PlanNode, node.kind),
                label=node.label,
                children=children,
                count=node.count,
                most=node.most,
                duration=rospy.Duration.from_sec(node.duration_s),
                period=rospy.Duration.from_sec(node.period_s),
                limit=rospy.Duration.from_sec(node.limit_s),
                is_limit_said=node.limit_s > 0.0,
                trigger=getattr(PlanNode, node.trigger),
                is_negated=node.is_negated,
                when=unknown if node.when is None else time_to_message(node.when),
            )
            for node, children in nodes_of(part)
        ],
    )


def with_beginning(plan: Plan, beginning: str) -> Plan:
    """Return a plan that says what happens to the command that runs: REPLACE, FOLLOW or BESIDE."""
    plan.beginning = getattr(Plan, beginning)
    return plan


def to_filled_units(clauses: Sequence[Tuple[Reading, ...]]) -> FilledLexicalUnitList:
    """Return readings as the message of 2012."""
    return FilledLexicalUnitList(lexical_units=[_unit(reading) for readings in clauses for reading in readings])


def _unit(reading: Reading) -> FilledLexicalUnit:
    return FilledLexicalUnit(
        frame_name=reading.unit.frame_name,
        verb=reading.verb,
        frame_elements=[
            FilledFrameElement(name=argument.name, argument=argument.text) for argument in reading.arguments
        ],
    )


def _reading(reading: Reading, tree: DependencyTree, preference: int) -> LexicalUnitReading:
    count = len(tree.words)
    return LexicalUnitReading(
        lexical_unit=_unit(reading),
        arguments=[to_message(argument) for argument in reading.arguments],
        verb_position=reading.verb_positions[0] if reading.verb_positions else 0,
        left_over=[tree.word(index).form for index in reading.left_over if index <= count],
        coverage=reading.coverage,
        preference=preference,
        source=reading.unit.path,
    )
