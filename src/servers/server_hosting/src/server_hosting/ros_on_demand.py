"""The node ``on_demand``: carries out frames by servers that it starts when they are needed."""

import contextlib
import queue
import threading
import time
from dataclasses import dataclass
from typing import Dict, List, Optional, Sequence, Tuple, Union

import rospy
from actionlib_msgs.msg import GoalStatus, GoalStatusArray
from roboframenet_msgs.msg import (
    FilledSemanticFrame,
    FilledSemanticFrameAction,
    FilledSemanticFrameGoal,
)

from checked_files.problem import FileRefused
from checked_files.source_files import read_text
from rfnserver import RFNServer
from rfnserver.results import BY_STATUS
from rfnserver.ros_frame_adapter import conclude
from rfnserver.ros_goal_forwarding import ForwardedEnd, ForwardingDeadlines, GoalForwarder
from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_node import StartError, read_parameters, run_node
from server_hosting.manifest import Manifest, by_frame, load_manifests
from server_hosting.ros_launching import Launched, LaunchError
from server_hosting.server_lease import ServerLease

#: How often the main thread checks for servers that are idle or have died, seconds.
LOOK_S = 0.5
BUSY = (GoalStatus.PENDING, GoalStatus.ACTIVE, GoalStatus.PREEMPTING, GoalStatus.RECALLING)


@dataclass(frozen=True)
class Settings(Parameters):
    """Private parameters, checked.

    Attributes:
        files: manifest files

    Raises:
        ParameterError: not a list of names
    """

    files: Tuple[str, ...] = parameter((), may_be_single=True)


@dataclass(frozen=True)
class _Need:
    """A goal needs a server; the answer is why it cannot be started, empty when it runs."""

    manifest: Manifest
    answer: "queue.Queue[str]"


@dataclass(frozen=True)
class _Release:
    manifest: Manifest


class _Server:
    """A server that was started at least once. The main thread owns it; ``is_up`` is read by others."""

    def __init__(self, manifest: Manifest) -> None:
        self.manifest = manifest
        self.lease = ServerLease()
        self.launched: Optional[Launched] = None
        self.is_up = threading.Event()
        self._busy = threading.Event()
        self._status = rospy.Subscriber(manifest.server + "/status", GoalStatusArray, self._on_status, queue_size=1)

    def _on_status(self, message: GoalStatusArray) -> None:
        # Once it runs, it is registered itself, and also gets goals directly.
        if any(status.status in BUSY for status in message.status_list):
            self._busy.set()
        else:
            self._busy.clear()

    def look(self, now_s: float) -> None:
        """Check whether it has died, works, or has been idle for too long."""
        if self.launched is None:
            return
        if not self.launched.is_running():
            rospy.logwarn("%s has died", self.manifest.server)
            self.end()
        elif self._busy.is_set():
            self.lease = self.lease.seen_busy(now_s)
        elif self.lease.is_expired(idle_s=self.manifest.idle_s, now_s=now_s):
            rospy.loginfo("%s was idle for %g s and is stopped", self.manifest.server, self.manifest.idle_s)
            self.end()

    def enter(self, now_s: float) -> None:
        """Start it, unless it is running.

        Raises:
            LaunchError: it cannot be started
        """
        if self.launched is not None and not self.launched.is_running():
            # A goal that arrives just after it died must not wait for it.
            rospy.logwarn("%s has died", self.manifest.server)
            self.end()
        if self.launched is None:
            rospy.loginfo("starting %s", self.manifest.server)
            self.launched = Launched(self.manifest)
            self.is_up.set()
        self.lease = self.lease.acquired(now_s)

    def leave(self, now_s: float) -> None:
        """A goal has finished with it."""
        self.lease = self.lease.released(now_s)

    def end(self) -> None:
        """End its processes."""
        launched, self.launched = self.launched, None
        self.is_up.clear()
        self._busy.clear()
        self.lease = self.lease.ended()
        if launched is not None:
            launched.end()


class OnDemand:
    """Takes every frame of the manifests, in one process.

    Actions:
        on_demand (roboframenet_msgs/FilledSemanticFrameAction): all frames
        SERVER (roboframenet_msgs/FilledSemanticFrameAction): client of each running server
    Subscribes:
        SERVER/status (actionlib_msgs/GoalStatusArray): whether they work for other clients
    """

    def __init__(self, manifests: Dict[str, Manifest]) -> None:
        """
        Args:
            manifests: by frame
        """
        self._manifests = manifests
        self._inbox: queue.Queue[Union[_Need, _Release]] = queue.Queue()
        self._lock = threading.Lock()
        self._servers: Dict[str, _Server] = {}
        self._forwarders: Dict[str, GoalForwarder] = {}
        self._server = RFNServer("on_demand", self._on_frame)
        self._server.start()

    def register(self) -> None:
        """Register for the frames."""
        for frame_name in self._manifests:
            if rospy.is_shutdown():
                return
            self._server.register_with_frame(frame_name)

    def run(self) -> None:
        """Start and end servers until the node shuts down, in the main thread, as roslaunch requires."""
        while not rospy.is_shutdown():
            with contextlib.suppress(queue.Empty):
                self._handle(self._inbox.get(timeout=LOOK_S))
            for server in self._servers.values():
                server.look(time.monotonic())
        for server in self._servers.values():
            server.end()

    def _handle(self, event: Union[_Need, _Release]) -> None:
        server = self._server_of(event.manifest)
        if isinstance(event, _Release):
            server.leave(time.monotonic())
            return
        try:
            server.enter(time.monotonic())
            event.answer.put("")
        except LaunchError as error:
            rospy.logerr("%s", error)
            event.answer.put(str(error))

    def _server_of(self, manifest: Manifest) -> _Server:
        with self._lock:
            if manifest.server not in self._servers:
                self._servers[manifest.server] = _Server(manifest)
            return self._servers[manifest.server]

    def _on_frame(self, frame: FilledSemanticFrame) -> None:
        manifest = self._manifests.get(frame.name)
        if manifest is None:
            self._server.set_aborted(None, f"no manifest names a server for {frame.name}")
            return
        need = _Need(manifest, queue.Queue())
        self._inbox.put(need)
        try:
            fault = need.answer.get(timeout=manifest.start_timeout_s)
        except queue.Empty:
            fault = f"{manifest.server} was not started within {manifest.start_timeout_s:g} s"
            # It may still start later: nobody uses it then.
            self._inbox.put(_Release(manifest))
        if fault:
            self._server.set_aborted(None, fault)
            return
        try:
            conclude(self._server, self._forward(manifest, frame))
        finally:
            self._inbox.put(_Release(manifest))

    def _forward(self, manifest: Manifest, frame: FilledSemanticFrame) -> ForwardedEnd:
        server = self._server_of(manifest)
        if manifest.server not in self._forwarders:
            deadlines = ForwardingDeadlines(server_s=manifest.start_timeout_s)
            self._forwarders[manifest.server] = GoalForwarder(
                manifest.server, FilledSemanticFrameAction, deadlines, result_names=BY_STATUS
            )
        end = self._forwarders[manifest.server].carry_out(
            FilledSemanticFrameGoal(frame=frame),
            is_to_end=lambda: self._server.is_preempt_requested() or not server.is_up.is_set(),
            on_feedback=self._server.publish_feedback,
        )
        if end.status == GoalStatus.PREEMPTED and not self._server.is_preempt_requested():
            return ForwardedEnd(GoalStatus.ABORTED, f"{manifest.server} died before it had finished")
        return end


def read_manifests(paths: Sequence[str]) -> Dict[str, Manifest]:
    """Read manifest files; files with mistakes are logged and skipped."""
    manifests: List[Manifest] = []
    for path in paths:
        try:
            manifests.extend(load_manifests(read_text(path), path))
        except FileRefused as refused:
            for problem in refused.problems:
                rospy.logerr("%s", problem)
    chosen, doubles = by_frame(manifests)
    for double in doubles:
        rospy.logerr("%s", double)
    return chosen


def _start() -> OnDemand:
    settings = read_parameters(Settings)
    manifests = read_manifests(settings.files)
    if not manifests:
        raise StartError(f"no server is to be started on demand; ~files: {', '.join(settings.files) or 'empty'}")
    node = OnDemand(manifests)
    registering = threading.Thread(target=node.register, name="registering", daemon=True)
    registering.start()
    rospy.loginfo("%d frames on demand", len(manifests))
    return node


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when it cannot start."""
    run_node("on_demand", _start, work=OnDemand.run)
