"""The frame registrar node: filled frames in, candidates for each clause out."""

import threading
import uuid
from dataclasses import dataclass
from typing import Dict, FrozenSet, List, Sequence, Tuple, Union

import rosgraph
import rospy
from roboframenet_msgs.msg import (
    CommandLexicalUnits,
    CommandSemanticFrames,
    EmptySemanticFrame,
    FilledSemanticFrameListList,
    Fleet,
    FrameCallback,
    FrameCatalogue,
    FrameServers,
    Plan,
    PlanNode,
    Reply,
)
from roboframenet_msgs.srv import (
    AddFrame,
    AddFrameRequest,
    AddFrameResponse,
    GetEmptyFrame,
    GetEmptyFrameRequest,
    GetEmptyFrameResponse,
    RegisterServer,
    RegisterServerRequest,
    RegisterServerResponse,
    RegisterWithFrame,
    RegisterWithFrameRequest,
    RegisterWithFrameResponse,
)

from frame_registrar.beginning import Beginning
from frame_registrar.graph import FrameGraph
from frame_registrar.ros_candidate_topics import CandidateTopics
from frame_registrar.ros_frame_files import FrameFiles
from frame_registrar.ros_liveness import LivenessWatch
from frame_registrar.ros_messages import (
    conditions_in,
    to_clauses,
    to_empty_frame,
    to_frame_lists,
    to_plan,
)
from frame_registrar.search import Found, Refusal, combinations, reply_outcome, search
from roboframenet_ros.health import Health, Level
from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_node import read_parameters, run_node
from roboframenet_ros.ros_place import Place
from roboframenet_ros.ros_robots import PublisherOfEachRobot, is_robot_name
from roboframenet_ros.ros_stage import Stage
from semantic_frames.ros_server_profile import profile_from_message, profile_to_message
from semantic_frames.server_profile import AS_IN_2012, ServerProfile


@dataclass(frozen=True)
class Settings(Parameters):
    """Parameters of the node, checked.

    Attributes:
        frame_paths: files, and folders with folders named ``frames``
        max_candidates: the search for a clause ends at this number
        liveness_period_s: pause between two rounds of asking the servers
        liveness_timeout_s: how long a node may take to answer
        settle_s: how long after its start a command waits for its servers, which register again; each that does gives
            the next one as long
    """

    frame_paths: Tuple[str, ...] = parameter((), may_be_single=True)
    max_candidates: int = parameter(64, least=1, most=10000)
    liveness_period_s: float = parameter(5.0, least=0.1, most=60.0)
    liveness_timeout_s: float = parameter(1.0, least=0.05, most=10.0)
    settle_s: float = parameter(3.0, least=0.0, most=10.0)


class FrameRegistrar:
    """Keeps the graph of frames, and answers each command with the candidates of its clauses or a refusal.

    Subscribes:
        command_lexical_units (CommandLexicalUnits), fleet (Fleet, latched), learned_frames (FrameCatalogue, latched)
    Publishes:
        command_semantic_frames (CommandSemanticFrames), filled_semantic_frames (FilledSemanticFrameListList),
        frame_servers (FrameServers, latched), stage_events (StageEvent);
        what :class:`.ros_frame_files.FrameFiles` does
    Services:
        add_frame, get_empty_frame, register_with_frame, register_server
    Parameters: see :class:`Settings`.
    """

    def __init__(self, settings: Settings, place: Place) -> None:
        self._settings = settings
        self._lock = threading.Lock()
        self._graph = FrameGraph()
        self._dead: FrozenSet[str] = frozenset()
        self._id = uuid.uuid4().hex
        self._files = FrameFiles(self._graph, self._lock, place, registrar_id=self._id)
        self._servers = PublisherOfEachRobot("frame_servers", FrameServers, queue_size=1, latch=True)
        self._told: Dict[str, FrameServers] = {}
        self._robots: FrozenSet[str] = frozenset()
        self._candidates = CandidateTopics(self._is_question)
        self._candidates_2012 = rospy.Publisher("filled_semantic_frames", FilledSemanticFrameListList, queue_size=100)
        self._stage = Stage("frame_registrar")
        self._files.load(settings.frame_paths)
        self._beginning = Beginning(settings.settle_s)
        self._subscriber = rospy.Subscriber(
            "command_lexical_units", CommandLexicalUnits, self._on_command, queue_size=100
        )
        self._fleet = rospy.Subscriber("fleet", Fleet, self._on_fleet, queue_size=1)
        self._learned = rospy.Subscriber("learned_frames", FrameCatalogue, self._on_learned, queue_size=1)
        self._services = [
            rospy.Service("add_frame", AddFrame, self._on_add_frame),
            rospy.Service("get_empty_frame", GetEmptyFrame, self._on_get_empty_frame),
            # Before the service of 2012: a server that finds only that one registers as in 2012.
            rospy.Service("register_server", RegisterServer, self._on_register_server),
            rospy.Service("register_with_frame", RegisterWithFrame, self._on_register),
        ]
        self._files.publish()
        self._publish_servers()
        self._watch = LivenessWatch(
            self._registered_servers,
            self._on_dead,
            period_s=settings.liveness_period_s,
            timeout_s=settings.liveness_timeout_s,
        )
        rospy.on_shutdown(self._watch.close)
        rospy.loginfo("ready: %d frames, %d problems, %s", len(self._graph.frames), len(self._files.problems), settings)

    def health(self) -> Health:
        """How the node is."""
        faults = []
        if self._files.problems:
            faults.append(f"Problems in files: {len(self._files.problems)}; see file_problems.")
        if self._dead:
            faults.append(f"Not running: {', '.join(sorted(self._dead))}.")
        values = {"frames": len(self._files.paths), "problems in files": len(self._files.problems)}
        return Health(Level.WARN, " ".join(faults), values) if faults else Health(values=values)

    def _on_add_frame(self, request: AddFrameRequest) -> AddFrameResponse:
        is_added = self._files.add(request.absolute_file_path)
        if is_added:
            self._publish_servers()
        return AddFrameResponse(success=is_added)

    def _on_learned(self, message: FrameCatalogue) -> None:
        if self._files.set_learned(message.files):
            self._publish_servers()

    def _on_get_empty_frame(self, request: GetEmptyFrameRequest) -> GetEmptyFrameResponse:
        frame = self._graph.frame(request.frame_name)
        return GetEmptyFrameResponse(frame=to_empty_frame(frame) if frame else EmptySemanticFrame())

    def _on_register(self, request: RegisterWithFrameRequest) -> RegisterWithFrameResponse:
        errors, remark = self._register(request.frame_name, request.callback_topic, AS_IN_2012)
        return RegisterWithFrameResponse(success=not errors, error=_told(errors, remark))

    def _on_register_server(self, request: RegisterServerRequest) -> RegisterServerResponse:
        try:
            profile = profile_from_message(request.profile)
        except ValueError as error:
            return RegisterServerResponse(success=False, error=[f"purpose: {error}"])
        errors, remark = self._register(request.frame_name, request.server, profile)
        return RegisterServerResponse(success=not errors, error=_told(errors, remark))

    def _register(self, frame_name: str, server: str, profile: ServerProfile) -> Tuple[Tuple[str, ...], str]:
        """Register a server; return why that is refused, and what is odd about it."""
        if server.strip() and not _is_server_name(server):
            errors: Tuple[str, ...] = (
                f"{server[:40]!r} is not the name of an action server: expected a graph name without '~'",
            )
        elif profile.robot and not is_robot_name(profile.robot):
            errors = (f"{profile.robot[:40]!r} is not the name of a robot: expected that of its namespace",)
        else:
            with self._lock:
                if self._graph.knows(frame_name, server, profile):
                    # Servers repeat themselves; what everybody has heard is not published to everybody again.
                    return (), self._graph.remark(frame_name, server)
                errors = self._graph.register(frame_name, server, profile)
        for error in errors:
            rospy.logerr("registration refused: %s", error)
        if errors:
            return errors, ""
        self._candidates.prepare(profile.robot)
        self._publish_servers()
        self._beginning.hear_registration()
        remark = self._graph.remark(frame_name, server)
        if remark:
            rospy.logwarn("'%s' registered for a frame: %s", server, remark)
        return (), remark

    def _on_fleet(self, fleet: Fleet) -> None:
        """The servers of a robot that joins register when they hear of this registrar."""
        robots = frozenset(robot.name for robot in fleet.robots if is_robot_name(robot.name))
        if not robots <= self._robots:
            self._robots |= robots
            for robot in robots:
                self._candidates.prepare(robot)
            self._publish_servers()

    def _registered_servers(self) -> FrozenSet[str]:
        with self._lock:
            return frozenset(server for _, server in self._graph.registrations())

    def _on_dead(self, servers: FrozenSet[str]) -> None:
        with self._lock:
            is_changed = self._graph.set_dead(servers)
            self._dead = servers
        if is_changed:
            rospy.loginfo("action servers that are not running: %s", ", ".join(sorted(servers)) or "none")
            self._publish_servers()

    def _publish_servers(self) -> None:
        with self._lock:
            callbacks = [
                FrameCallback(
                    frame_name=frame,
                    callback_topic=server,
                    is_alive=self._graph.is_alive(server),
                    profile=profile_to_message(self._graph.profile(frame, server)),
                )
                for frame, server in self._graph.registrations()
            ]
            paths = self._files.paths
            self._servers.publish("", FrameServers(registrar_id=self._id, paths=paths, callbacks=callbacks))
            # Each robot hears of its own servers, when they change; those of no robot are for all.
            for robot in sorted(self._robots.union(callback.profile.robot for callback in callbacks) - {""}):
                own = [callback for callback in callbacks if callback.profile.robot in ("", robot)]
                message = FrameServers(registrar_id=self._id, paths=paths, callbacks=own)
                if message != self._told.get(robot):
                    self._told[robot] = message
                    self._servers.publish(robot, message)

    def _is_question(self, name: str) -> bool:
        """Whether a frame is a question."""
        with self._lock:
            frame = self._graph.frame(name)
        return frame is not None and frame.is_question

    def _search(self, message: CommandLexicalUnits) -> Union[Tuple[Found, ...], Refusal]:
        with self._lock:
            return search(
                self._graph,
                to_clauses(message.clauses),
                max_candidates=self._settings.max_candidates,
                robot=message.command.robot,
                conditions=conditions_in(message.plan, message.clauses),
            )

    def _on_command(self, message: CommandLexicalUnits) -> None:
        try:
            outcome = self._beginning.search(lambda: self._search(message))
            if not isinstance(outcome, Refusal):
                plan = to_plan(message.clauses, message.command.text, outcome, message.plan)
        except Exception as error:  # boundary: the command gets its reply, whatever fails
            rospy.logerr("cmd=%s failed: %s", message.command.id, error, exc_info=True)
            self._stage.ends(
                message.command,
                outcome=Reply.FAILED,
                code="STAGE_ERROR",
                sentence=f"The frame registrar failed: {error}",
            )
            return
        if isinstance(outcome, Refusal):
            rospy.loginfo("cmd=%s refused: %s", message.command.id, outcome.sentence)
            self._stage.ends(
                message.command,
                outcome=getattr(Reply, reply_outcome(outcome)),
                code=outcome.code,
                sentence=outcome.sentence,
            )
            return
        if not self._candidates.publish(CommandSemanticFrames(command=message.command, plan=plan)):
            self._stage.ends(
                message.command,
                outcome=Reply.REFUSED,
                code="QUESTION",
                sentence=f'I do not know how to answer "{message.command.text.rstrip(" ?.!")}".',
            )
            return
        # The next stage works while the others are told.
        self._stage.passes_on(message.command, describe(plan))
        if not message.plan.nodes:
            # 2012 cannot say how often or for how long.
            self._candidates_2012.publish(to_frame_lists(combinations(outcome, self._settings.max_candidates)))


def _told(errors: Sequence[str], remark: str) -> List[str]:
    return list(errors) if errors or not remark else [remark]


def _is_server_name(name: str) -> bool:
    return not name.startswith("~") and not name.endswith("/") and bool(rosgraph.names.is_legal_name(name))


def describe(plan: Plan) -> str:
    """Return the candidates of a plan in words: "2 candidates: turning @ turning; ..."."""
    leaves = [node for node in plan.nodes if node.candidates]
    if len(leaves) == 1:
        return _describe_candidates(leaves[0])
    is_list = not any(leaf.kind == PlanNode.CONDITION for leaf in leaves)
    told = [f'"{leaf.label}": {_describe_candidates(leaf)}' for leaf in leaves]
    return ("; then " if is_list else "; ").join(told)


def _describe_candidates(leaf: PlanNode) -> str:
    shown = "; ".join(
        ", then ".join(f"{frame.name} @ {frame.action_server_topics[0]}" for frame in candidate.frames)
        for candidate in leaf.candidates[:3]
    )
    count, what = len(leaf.candidates), "watch" if leaf.kind == PlanNode.CONDITION else "candidate"
    plural = "es" if what == "watch" else "s"
    return f"{count} {what}{plural if count > 1 else ''}: {shown}{'; ...' if count > 3 else ''}"


def start(place: Place) -> FrameRegistrar:
    """Start the stage.

    Raises:
        ParameterError: a parameter is wrong
    """
    return FrameRegistrar(read_parameters(Settings, prefix=place.private), place)


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("frame_registrar", lambda: start(Place()))
