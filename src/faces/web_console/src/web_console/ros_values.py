"""Converts messages of the pipeline to view models."""

from typing import Iterable, List, Sequence, Tuple

import numpy as np
import rospy
from geometry_msgs.msg import Pose as PoseMessage
from nav_msgs.msg import OccupancyGrid
from roboframenet_msgs.msg import (
    CommandLexicalUnits,
    CommandParse,
    FileProblem,
    FilledSemanticFrame,
    FrameServers,
    Learned,
    LexicalUnitReading,
    Plan,
    PlanCandidate,
    PlanNode,
    Procedure,
    Reply,
    StageEvent,
    StandingOrders,
    World,
    WorldObject,
)
from roboframenet_msgs.msg import TypedArgument as ArgumentMessage

from typed_arguments import TypedArgument
from typed_arguments.ros_messages import frames_from_messages, from_message
from web_console.arcs import ParsedWord
from web_console.arguments import argument_view, trace_lines
from web_console.conversations import Frame
from web_console.ground import Pose, heading_of, map_png
from web_console.suggestions import Present
from web_console.telling import help_after
from web_console.views import (
    ArgumentView,
    CandidateView,
    ClauseView,
    KnownView,
    LandmarkView,
    LearnedItemView,
    LearnedView,
    MapView,
    OrdersView,
    OrderView,
    PlanView,
    ProblemView,
    ReadingView,
    ReplyView,
    StageView,
    StepView,
    WorldView,
)

#: Constants of a message by their value.
OUTCOMES = {getattr(Reply, name): name for name in "DONE FAILED REFUSED NEEDS_INFORMATION SUPERSEDED".split()}
KINDS = {
    getattr(PlanNode, name): name
    for name in (
        "DO SEQUENCE PARALLEL ANY_ORDER FALLBACK IF UNTIL WHILE REPEAT WAIT AT WHENEVER CONDITION ALL ANY".split()
    )
}
_MOST_CANDIDATES = 8
_MOST_READINGS = 12
_MOST_LEVELS = 32
_MOST_NODES = 400
_MOST_KNOWN = 200
#: Sorts of what a hand takes something from.
_LIES_ON = (WorldObject.THING, WorldObject.DEVICE)
#: What is at least so long is drawn with its edges.
_FURNITURE_M = 0.3


def seconds(stamp: rospy.Time) -> float:
    """Return a stamp in seconds."""
    return float(stamp.to_sec())


def stage_view(event: StageEvent) -> StageView:
    """Return the event of a stage."""
    return StageView(
        name=event.stage,
        sentence=event.sentence,
        after_s=round(max(0.0, seconds(event.stamp) - seconds(event.command.stamp)), 3),
        is_final=event.is_final,
        trace=trace_lines(event.trace),
    )


def reply_view(reply: Reply) -> ReplyView:
    """Return a reply."""
    return ReplyView(
        outcome=OUTCOMES.get(reply.outcome, str(reply.outcome)),
        code=reply.code,
        sentence=reply.sentence,
        stage=reply.stage,
        after_s=round(max(0.0, seconds(reply.stamp) - seconds(reply.command.stamp)), 3),
        help=help_after(OUTCOMES.get(reply.outcome, ""), reply.code),
    )


def parsed_words(message: CommandParse) -> List[ParsedWord]:
    """Return the words of a parse."""
    return [ParsedWord(word.index, word.form, word.upos, word.head, word.deprel) for word in message.words]


def clause_views(message: CommandLexicalUnits) -> Tuple[ClauseView, ...]:
    """Return the clauses of the framer."""
    return tuple(
        ClauseView(clause.words, tuple(_reading(reading) for reading in clause.readings[:_MOST_READINGS]))
        for clause in message.clauses
    )


def frames_of(message: CommandLexicalUnits) -> Tuple[Frame, ...]:
    """Return the best reading of each clause, as ``rfn record`` writes it."""
    units = (min(clause.readings, key=lambda one: one.preference).lexical_unit for clause in message.clauses)
    return tuple(
        (unit.frame_name, tuple(sorted((one.name, one.argument) for one in unit.frame_elements if one.argument)))
        for unit in units
    )


def _reading(reading: LexicalUnitReading) -> ReadingView:
    unit = reading.lexical_unit
    typed = {argument.name: _argument(argument) for argument in reading.arguments}
    return ReadingView(
        frame=unit.frame_name,
        verb=unit.verb,
        arguments=tuple(
            typed.get(element.name, ArgumentView(element.name, element.argument)) for element in unit.frame_elements
        ),
        left_over=tuple(reading.left_over),
        coverage=round(reading.coverage, 2),
        source=reading.source.rpartition("/")[2],
    )


def _argument(message: ArgumentMessage) -> ArgumentView:
    try:
        return argument_view(from_message(message))
    except ValueError:
        text = message.phrases[0].text if message.phrases else ""
        return ArgumentView(message.name, text)


def plan_view(plan: Plan) -> PlanView:
    """Return a plan as a tree; nodes that are no tree are left out."""
    if not plan.nodes or len(plan.nodes) > _MOST_NODES:
        return PlanView("SEQUENCE", "")
    return _node(plan.nodes, 0, frozenset())


def _node(nodes: Sequence[PlanNode], position: int, above: "frozenset[int]") -> PlanView:
    node, path = nodes[position], above | {position}
    inner = [child for child in node.children if 0 <= child < len(nodes) and child not in path]
    children = tuple(_node(nodes, child, path) for child in inner) if len(path) < _MOST_LEVELS else ()
    shared = _shared(node.arguments)
    return PlanView(
        kind=KINDS.get(node.kind, str(node.kind)),
        label=node.label,
        notes=tuple(_notes(node)),
        children=children,
        candidates=tuple(_candidate(candidate, shared) for candidate in node.candidates[:_MOST_CANDIDATES]),
        more=max(0, len(node.candidates) - _MOST_CANDIDATES),
    )


def sequences_of(procedure: Procedure) -> List[List[Tuple[str, str]]]:
    """Return the frames of each combination of candidates, each with its server."""
    return [
        [(frame.name, ", ".join(name.lstrip("/") for name in frame.action_server_topics)) for frame in frames.frames]
        for frames in procedure.frame_lists
    ]


def _shared(arguments: Iterable[ArgumentMessage]) -> Tuple[TypedArgument, ...]:
    try:
        return tuple(from_message(argument) for argument in arguments)
    except ValueError:
        return ()


def _notes(node: PlanNode) -> Iterable[str]:
    if node.count or node.most:
        yield (
            f"{node.count} times"
            if node.count == node.most
            else f"{node.count} to {node.most or 'any number of'} times"
        )
    for name, duration in (("for", node.duration), ("every", node.period), ("at most", node.limit)):
        if duration.to_sec() > 0:
            yield f"{name} {duration.to_sec():g} s"
    if node.when.words:
        yield node.when.words
    if node.is_negated:
        yield "not"


def _candidate(candidate: PlanCandidate, shared: Tuple[TypedArgument, ...]) -> CandidateView:
    try:
        frames = frames_from_messages(candidate.frames, shared, candidate.arguments)
        steps = [
            StepView(frame.name, frame.server.lstrip("/"), tuple(map(argument_view, frame.arguments)))
            for frame in frames
        ]
    except ValueError:
        steps = [_plain_step(frame) for frame in candidate.frames]
    return CandidateView(tuple(steps), tuple(candidate.left_over))


def _plain_step(frame: FilledSemanticFrame) -> StepView:
    return StepView(
        frame.name,
        ", ".join(name.lstrip("/") for name in frame.action_server_topics),
        tuple(ArgumentView(element.name, element.argument) for element in frame.frame_elements),
    )


def problem_view(problem: FileProblem) -> ProblemView:
    """Return a problem of a file."""
    place = f"{problem.path}:{problem.line}" if problem.line else problem.path
    return ProblemView(
        place=f"{place} ({problem.key})" if problem.key else place,
        code=problem.code,
        found=problem.found,
        expected=problem.expected,
        hint=problem.hint,
    )


def living_servers(message: FrameServers) -> "dict[str, Tuple[str, ...]]":
    """Return the servers that live, by frame."""
    found: dict[str, Tuple[str, ...]] = {}
    for callback in message.callbacks:
        if callback.is_alive:
            found[callback.frame_name] = (*found.get(callback.frame_name, ()), callback.callback_topic.lstrip("/"))
    return found


def servers_of(message: FrameServers) -> Tuple[Tuple[str, str, bool], ...]:
    """Return name, frames and life of each server."""
    frames: dict[str, List[str]] = {}
    alive: dict[str, bool] = {}
    for callback in message.callbacks:
        frames.setdefault(callback.callback_topic, []).append(callback.frame_name)
        alive[callback.callback_topic] = callback.is_alive
    return tuple((name, ", ".join(sorted(names)), alive[name]) for name, names in sorted(frames.items()))


def landmarks_of(world: World) -> Tuple[LandmarkView, ...]:
    """Return the objects whose pose is known, without the robot."""
    me = {one.id for one in world.objects if one.sort == WorldObject.ROBOT}
    return tuple(_landmark(one, me) for one in world.objects if one.pose.header.frame_id and one.id not in me)


def _landmark(one: WorldObject, robots: "set[str]") -> LandmarkView:
    pose = pose_value(one.pose.pose)
    kind, is_wide = one.sort, one.size.x > 0 and one.size.y > 0
    if is_wide and kind == WorldObject.PLACE:
        kind = "room"
    elif is_wide and kind in (WorldObject.THING, WorldObject.DEVICE) and max(one.size.x, one.size.y) >= _FURNITURE_M:
        kind = "furniture"
    return LandmarkView(
        name=_name(one),
        kind=kind,
        x_m=round(pose.x_m, 3),
        y_m=round(pose.y_m, 3),
        width_m=round(one.size.x, 3),
        depth_m=round(one.size.y, 3),
        heading_rad=round(pose.heading_rad, 3),
        states=tuple(one.states),
        is_held=any(relation.relation == "held_by" and relation.reference in robots for relation in one.relations),
    )


def present_objects(world: World) -> Tuple[Present, ...]:
    """Return what suggestions need of the objects, without the robot."""
    sorts = {one.id: one.sort for one in world.objects}
    carriers = {below.reference for one in world.objects for below in one.relations if below.relation == "on"}
    return tuple(
        Present(
            name=_name(one),
            sort=one.sort,
            states=frozenset(one.states),
            is_wide=one.size.x > 0 and one.size.y > 0,
            is_loose=any(sorts.get(relation.reference) in _LIES_ON for relation in one.relations),
            carries=one.id in carriers,
            holder=next((sorts.get(held.reference, "") for held in one.relations if held.relation == "held_by"), ""),
            is_before=one.place_of_before.to_sec() > 0,
        )
        for one in world.objects
        if one.sort != WorldObject.ROBOT
    )


def world_view(world: World) -> WorldView:
    """Return what the robot knows, in words."""
    names = {one.id: _name(one) for one in world.objects}
    known = [
        KnownView(
            name=_name(one),
            sort=one.sort,
            where=", ".join(
                f"{relation.relation.replace('_', ' ')} {names.get(relation.reference, relation.reference)}"
                for relation in one.relations
            ),
            attributes=(*one.attributes, *one.states),
        )
        for one in world.objects
        if one.sort != WorldObject.ROBOT
    ]
    return WorldView(tuple(known[:_MOST_KNOWN]), max(0, len(known) - _MOST_KNOWN) + world.left_out)


def orders_view(message: StandingOrders) -> OrdersView:
    """Return the standing orders that are kept."""
    return OrdersView(
        tuple(
            OrderView(one.sentence, one.state, one.reason, seconds(one.next), int(one.count)) for one in message.orders
        )
    )


def learned_view(message: Learned) -> LearnedView:
    """Return what was taught."""
    items = (
        LearnedItemView(
            said=one.said,
            meaning=one.meaning,
            who=one.who,
            when_s=one.stamp.to_sec(),
            sentence=one.sentence,
            forgets=f'Forget what I taught you about "{one.said}".',
        )
        for one in message.items
    )
    return LearnedView(tuple(items), int(message.left_out))


def _name(one: WorldObject) -> str:
    return one.name or " ".join([*one.attributes, one.category or one.id])


def pose_value(pose: PoseMessage) -> Pose:
    """Return a pose on the ground."""
    turn = pose.orientation
    return Pose(pose.position.x, pose.position.y, heading_of(turn.x, turn.y, turn.z, turn.w))


def map_of(grid: OccupancyGrid, address: str) -> Tuple[MapView, bytes]:
    """Return the view of a map and its picture.

    Raises:
        ValueError: the cells are not as many as the map says
    """
    cells = np.asarray(grid.data, dtype=np.int8).reshape(grid.info.height, grid.info.width)
    origin = pose_value(grid.info.origin)
    view = MapView(
        address=address,
        width_m=round(grid.info.width * grid.info.resolution, 3),
        height_m=round(grid.info.height * grid.info.resolution, 3),
        x_m=origin.x_m,
        y_m=origin.y_m,
        heading_rad=origin.heading_rad,
    )
    return view, map_png(cells)
