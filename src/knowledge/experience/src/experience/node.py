"""The node of experience: keeps what was tried, and tells the arbitrator what is known from it.

Callbacks only enqueue; one worker thread owns the memory and its file. Nothing waits for it: the executor publishes and
goes on, and when this node is slow or dead, the oldest messages are lost, and no command.
"""

import os
import queue
import threading
import time
import uuid
from typing import Dict, FrozenSet, List, Union

import rospy
from roboframenet_msgs.msg import (
    Experience,
    FilledSemanticFrameResult,
    FrameCatalogue,
    FrameServers,
    StageEvent,
    TriedFrame,
    World,
)
from std_srvs.srv import Trigger, TriggerRequest, TriggerResponse

from experience.explorable import explorable
from experience.memory import Memory
from experience.ros_messages import snapshot_to_message, trial_from_message
from experience.settings import Settings
from experience.snapshot import Snapshot
from experience.store import Store
from experience.teaching import TEACHING, Answer, Asked
from experience.trial import Outcome, Trial
from experience.whereabouts import Sequences, Whereabouts
from rfnserver import RFNServer, TypedFrame
from roboframenet_ros.health import Health, Level
from roboframenet_ros.home_folder import file_in_ros_home
from roboframenet_ros.ros_node import StartError, read_parameters, run_node
from roboframenet_ros.ros_place import Place
from roboframenet_ros.ros_publishing import publish
from roboframenet_ros.sqlite_file import StoreError
from semantic_frames import load_frame
from semantic_frames.frame import SemanticFrame
from semantic_frames.read_once import ReadOnce
from world_model.ros_messages import world_from_message

#: Messages that wait for the worker; a robot tries a few frames in a second.
_MOST_WAITING = 1000
#: Trials that are stored in one change.
_MOST_AT_ONCE = 200
_TURN_S = 0.5
_ANSWER_S = 4.0
#: Commands of which it is known why a server was asked first.
_MOST_REASONS = 200


class _Reload:
    """Somebody has changed the file."""

    def __init__(self) -> None:
        self.is_done = threading.Event()
        self.problem = ""


class _Request:
    """What a person says to the server; the worker sets the answer."""

    def __init__(self, frame: TypedFrame) -> None:
        self.frame = frame
        self.is_answered = threading.Event()
        self.answer = ""


_Event = Union[TriedFrame, StageEvent, World, FrameCatalogue, FrameServers, _Reload, _Request, None]


class ExperienceNode:
    """Remembers what was tried.

    Subscribes: ``tried_frames``, ``stage_events``, ``world``, ``frame_catalogue``, ``frame_servers``.
    Publishes: ``experience`` (latched). Services: ``reload_experience`` (std_srvs/Trigger).
    Actions: ``experience_server``: every frame of :data:`experience.teaching.TEACHING`.
    Parameters: see :class:`experience.settings.Settings`.
    """

    def __init__(self, settings: Settings) -> None:
        """
        Raises:
            StartError: there is no file, not even a new one
        """
        self._settings = settings
        self._path = os.path.expanduser(settings.file or file_in_ros_home("experience.sqlite"))
        try:
            self._store = Store(self._path, most_trials=settings.most_trials)
            self._memory = self._remembered()
        except StoreError as error:
            raise StartError(str(error)) from error
        self._inbox: queue.Queue[_Event] = queue.Queue(_MOST_WAITING)
        self._lost = 0
        self._unstored: List[Trial] = []
        self._problem = ""
        self._whereabouts = Whereabouts()
        self._sequences = Sequences()
        self._robots: Dict[str, str] = {}
        self._servers: Dict[str, FrozenSet[str]] = {}
        self._reasons: Dict[str, str] = {}
        self._said = ""
        self._frame_files: ReadOnce[SemanticFrame] = ReadOnce(load_frame)
        self._explorable: FrozenSet[str] = frozenset()
        self._start_name, self._version, self._is_new, self._told_s = uuid.uuid4().hex[:8], 0, True, 0.0
        self._experience = rospy.Publisher("experience", Experience, queue_size=1, latch=True)
        self._server = RFNServer("experience_server", self._on_request)
        self._worker = threading.Thread(target=self._work, name="experience")

    def start(self) -> None:
        """Start to remember."""
        rospy.on_shutdown(self._shutdown)
        self._worker.start()
        self._subscribers = [
            rospy.Subscriber(name, kind, self._hear, queue_size=size)
            for name, kind, size in (
                ("tried_frames", TriedFrame, _MOST_WAITING),
                ("stage_events", StageEvent, _MOST_WAITING),
                ("world", World, 1),
                ("frame_catalogue", FrameCatalogue, 1),
                ("frame_servers", FrameServers, 1),
            )
        ]
        self._service = rospy.Service("reload_experience", Trigger, self._on_reload)
        # A registrar that is not there yet is waited for; the memory is not.
        self._server.start()
        for name in TEACHING:
            self._server.register_with_frame(name)
        rospy.loginfo("ready: %d trials, %d rules", len(self._memory.trials), len(self._memory.rules))

    def health(self) -> Health:
        """How the node is."""
        values = {"trials": len(self._memory.trials), "rules": len(self._memory.rules), "lost": self._lost}
        return Health(Level.WARN, self._problem, values) if self._problem else Health(values=values)

    def _remembered(self) -> Memory:
        memory = Memory(self._store.trials(), self._store.rules(), most_trials=self._settings.most_trials)
        for problem in self._store.problems:
            rospy.logerr("%s", problem)
        return memory

    def _hear(self, message: _Event) -> None:
        try:
            self._inbox.put_nowait(message)
        except queue.Full:
            self._lost += 1
            rospy.logerr_throttle(10.0, f"{self._lost} messages were lost: the disk is too slow")

    def _on_reload(self, _: TriggerRequest) -> TriggerResponse:
        event = _Reload()
        self._hear(event)
        if not event.is_done.wait(_ANSWER_S):
            return TriggerResponse(success=False, message="The node does not answer.")
        text = event.problem or f"{len(self._memory.trials)} trials are known."
        return TriggerResponse(success=not event.problem, message=text)

    def _shutdown(self) -> None:
        try:
            self._inbox.put(None, timeout=1.0)
            self._worker.join(5.0)
        except queue.Full:
            pass  # the file is whole without the last trials
        self._store.close()

    def _work(self) -> None:
        while True:
            wait_s = _TURN_S
            if self._is_new:
                wait_s = min(_TURN_S, max(0.0, self._told_s + self._settings.snapshot_period_s - time.monotonic()))
            try:
                event = self._inbox.get(timeout=max(0.001, wait_s))
                if event is None:
                    self._write()
                    return
                self._handle(event)
            except queue.Empty:
                pass
            except Exception as error:  # boundary: one message must not end the work on all others
                rospy.logerr("experience: %s: %s", type(error).__name__, error)
            if self._inbox.empty() or len(self._unstored) >= _MOST_AT_ONCE:
                self._write()
            self._tell()

    def _handle(self, event: _Event) -> None:
        if isinstance(event, TriedFrame):
            self._remember(event)
        elif isinstance(event, World):
            world = world_from_message(event)
            room = world.room_of(world.robot) if world.robot is not None else None
            self._is_new |= self._whereabouts.hear(room.id if room is not None else "", rospy.Time.now().to_sec())
        elif isinstance(event, FrameCatalogue):
            # The registrar has said which it refused.
            contents, _ = self._frame_files.contents((file.path, file.text) for file in event.files)
            self._explorable, self._is_new = frozenset(explorable(contents)), True
        elif isinstance(event, FrameServers):
            self._robots = {one.callback_topic: one.profile.robot for one in event.callbacks}
            names = {one.frame_name for one in event.callbacks}
            self._servers = {
                name: frozenset(one.callback_topic for one in event.callbacks if one.frame_name == name)
                for name in names
            }
        elif isinstance(event, StageEvent):
            self._hear_stage(event)
        elif isinstance(event, _Request):
            event.answer = self._answer(event.frame)
            event.is_answered.set()
        elif isinstance(event, _Reload):
            self._reload(event)

    def _remember(self, message: TriedFrame) -> None:
        server = (message.frame.action_server_topics or [""])[0]
        succeeded = message.outcome == int(Outcome.SUCCEEDED)
        trial = trial_from_message(
            message,
            sequence=self._sequences.hear(
                message.command.id, message.clause, message.frame.name, server, succeeded=succeeded
            ),
            place=self._whereabouts.at(message.began.to_sec()),
            robot=self._robots.get(server, ""),
        )
        self._unstored.append(trial)
        dropped = self._memory.hear(trial)
        self._is_new = True
        if dropped:
            self._write()
            self._store.write_rules((), dropped)

    def _hear_stage(self, event: StageEvent) -> None:
        """Remember what was said last, and why the arbitrator asked a server first."""
        self._said = event.command.text
        lines = event.trace.split("\n") if event.stage == "arbitrator" else []
        reasons = [line.partition(": ")[2] for line in lines if line.startswith("policy: ")]
        reasons += [line.partition(": ")[2] for line in lines if line.startswith("rule: I ")]
        if reasons:
            self._reasons[event.command.id] = reasons[-1]
            if len(self._reasons) > _MOST_REASONS:
                del self._reasons[next(iter(self._reasons))]

    def _on_request(self, frame: TypedFrame) -> None:
        request = _Request(frame)
        self._hear(request)
        if not request.is_answered.wait(_ANSWER_S):
            self._server.set_aborted(FilledSemanticFrameResult(success=False), "is busy")
            return
        self._server.set_succeeded(FilledSemanticFrameResult(success=True), request.answer)

    def _answer(self, frame: TypedFrame) -> str:
        asked = Asked(
            self._memory,
            {argument.name: argument for argument in frame.arguments},
            self._servers,
            self._reasons,
            self._said,
            rospy.Time.now().to_sec(),
        )
        answer = TEACHING[frame.name](asked)
        self._is_new |= answer.is_change
        return answer.sentence if self._is_stored(answer) else f"{answer.sentence} But I could not save it."

    def _is_stored(self, answer: Answer) -> bool:
        self._write()
        try:
            if answer.judged is not None:
                self._store.judge(*answer.judged)
            if answer.kept or answer.dropped:
                self._store.write_rules(answer.kept, [rule.rule_id for rule in answer.dropped])
        except StoreError as error:
            self._problem = str(error)
            rospy.logerr_throttle(10.0, str(error))
            return False
        return True

    def _reload(self, event: _Reload) -> None:
        try:
            self._write()
            self._memory = self._remembered()
            self._is_new = True
        except StoreError as error:
            event.problem = str(error)
        event.is_done.set()

    def _write(self) -> None:
        """Store what is not stored yet; what cannot be stored is known until the node ends."""
        if not self._unstored:
            return
        trials, self._unstored = self._unstored, []
        try:
            self._store.add(trials)
            self._problem = ""
        except StoreError as error:
            self._problem = str(error)
            rospy.logerr_throttle(10.0, str(error))

    def _tell(self) -> None:
        now_s = time.monotonic()
        if not self._is_new or now_s < self._told_s + self._settings.snapshot_period_s:
            return
        self._is_new, self._told_s = False, now_s
        self._version += 1
        known = Snapshot(self._memory.experience, self._memory.rules, self._explorable, self._whereabouts.now)
        publish(self._experience, snapshot_to_message(known, f"{self._start_name}-{self._version}"))


def start(place: Place) -> ExperienceNode:
    """Start the node.

    Raises:
        ParameterError: a parameter is wrong
        StartError: there is no file
    """
    node = ExperienceNode(read_parameters(Settings, prefix=place.private))
    node.start()
    return node


def main() -> None:
    """Run the node until ROS shuts down; exit with a message if it cannot start."""
    run_node("experience", lambda: start(Place()))
