"""A simulated robot with the whole pipeline under a master of its own, to be talked to and attacked."""

import math
import os
import signal
import socket
import subprocess
import tempfile
import threading
import time
from collections import Counter
from contextlib import contextmanager
from typing import Any, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple

import psutil

from roboframenet_testing import comes_true, wait_until

from .reply_counts import count_replies

#: Nodes of the pipeline, in the order of the stages, and those of the robot.
STAGES = (
    "command_server",
    "stanford_parser_ros",
    "semantic_framer",
    "frame_registrar",
    "arbitrator",
    "executor",
)
NODES = (*STAGES, "stop_server", "move_action_server", "ping", "turtlebot_sim")
#: Faster than this counts as motion, metres or radians per second.
MOTION = 0.01
START_TIMEOUT_S = 180.0
_END_TIMEOUT_S = 45.0
#: Memory that has not changed for so many seconds stands still.
_STILL_S = 5


class Robot:
    """What the robot says and does, with the times at which that arrived, monotonic seconds."""

    def __init__(self, launched: "Launched") -> None:
        """Connect.

        Args:
            launched: the robot; the environment names its master
        """
        import rospy
        from actionlib_msgs.msg import GoalID
        from geometry_msgs.msg import Twist
        from nav_msgs.msg import Odometry
        from roboframenet_msgs.msg import Command, FilledSemanticFrameActionGoal, Reply
        from std_msgs.msg import String

        self._rospy, self._string = rospy, String
        self.launched = launched
        self._lock = threading.Lock()
        self._replies: List[Tuple[float, Any]] = []
        self._counts: Counter = Counter()
        self._said: Counter = Counter()
        #: When each command was heard that went to the parser, by its id.
        self._heard_s: Dict[str, float] = {}
        self.zero_s: List[float] = []
        self.cancel_s: List[float] = []
        self.turn_goal_s: List[float] = []
        self.speed, self.moved_s = math.inf, 0.0
        self.position = (0.0, 0.0)
        self._text = rospy.Publisher("text", String, queue_size=1000)
        self._subscribers = [
            rospy.Subscriber("reply", Reply, self._on_reply, queue_size=10000),
            rospy.Subscriber("command_text", Command, self._on_heard, queue_size=10000),
            rospy.Subscriber("odom", Odometry, self._on_odometry, queue_size=10),
            rospy.Subscriber("cmd_vel", Twist, self._on_velocity, queue_size=100),
            rospy.Subscriber("moving_forward/cancel", GoalID, lambda _: self.cancel_s.append(time.monotonic())),
            rospy.Subscriber(
                "turning/goal", FilledSemanticFrameActionGoal, lambda _: self.turn_goal_s.append(time.monotonic())
            ),
        ]

    def _on_reply(self, reply: Any) -> None:
        with self._lock:
            self._replies.append((time.monotonic(), reply))
            self._counts[reply.command.id] += 1

    def _on_heard(self, command: Any) -> None:
        with self._lock:
            self._heard_s[command.id] = time.monotonic()

    def _on_odometry(self, message: Any) -> None:
        self.speed = max(abs(message.twist.twist.linear.x), abs(message.twist.twist.angular.z))
        self.position = (message.pose.pose.position.x, message.pose.pose.position.y)
        if self.speed > MOTION:
            self.moved_s = time.monotonic()

    def _on_velocity(self, message: Any) -> None:
        if not any((message.linear.x, message.linear.y, message.angular.z)):
            self.zero_s.append(time.monotonic())

    def forget(self) -> None:
        """Forget all replies and times."""
        with self._lock:
            self._replies.clear()
            self._counts.clear()
            self._said.clear()
        for times in (self.zero_s, self.cancel_s, self.turn_goal_s):
            times.clear()

    def wait_until_ready(self) -> float:
        """Wait until a command is carried out; returns how long that took, seconds.

        Raises:
            AssertionError: the robot does not come up
        """
        begin_s = time.monotonic()
        wait_until(lambda: self._text.get_num_connections() >= 2, START_TIMEOUT_S, "nobody listens to text")
        wait_until(lambda: self.outcome_of("Ping.", 3.0) == "DONE", START_TIMEOUT_S, "Ping. is not done")
        return time.monotonic() - begin_s

    def wait_until_settled(self) -> None:
        """Wait until the memory of the parser stands still: its first parses take some.

        Raises:
            AssertionError: it grows on
        """
        sizes: List[float] = []

        def is_still() -> bool:
            sizes.append(self.memory_mb(["stanford_parser_ros"]).get("stanford_parser_ros", 0.0))
            time.sleep(1.0)
            last = sizes[-_STILL_S:]
            return len(last) == _STILL_S and max(last) < 1.01 * min(last)

        wait_until(is_still, START_TIMEOUT_S, "the parser grows on")

    def say(self, text: str) -> float:
        """Publish a text; returns when."""
        now_s = time.monotonic()
        with self._lock:
            self._said[text] += 1
        self._text.publish(self._string(data=text))
        return now_s

    def replies(self, since_s: float = 0.0, text: Optional[str] = None) -> List[Tuple[float, Any]]:
        """Return replies that arrived since a time; to a text, those to what was heard since then.

        "A newer command took its place" is the reply to an older command, though its words may be the same.
        """
        with self._lock:
            since = [(at_s, reply) for at_s, reply in self._replies if at_s >= since_s]
            if text is None:
                return since
            return [
                (at_s, reply)
                for at_s, reply in since
                if reply.command.text == text and self._heard_s.get(reply.command.id, at_s) >= since_s
            ]

    def reply_to(self, text: str, timeout_s: float) -> Optional[Tuple[float, Any]]:
        """Say a text; return its first reply and when it came, None for none."""
        since_s = self.say(text)
        found: List[Tuple[float, Any]] = []

        def is_answered() -> bool:
            found[:] = self.replies(since_s, text)
            return bool(found)

        comes_true(is_answered, timeout_s)
        return found[0] if found else None

    def outcome_of(self, text: str, timeout_s: float) -> str:
        """Say a text; return the name of the outcome of its reply, empty for no reply."""
        answered = self.reply_to(text, timeout_s)
        return "" if answered is None else outcome_name(answered[1])

    def doubled(self) -> int:
        """Number of commands that got more than one reply."""
        with self._lock:
            return sum(count > 1 for count in self._counts.values())

    def counts(self) -> Tuple[int, int]:
        """Return how many texts have no reply since `forget`, and how many replies there are beyond one for each."""
        with self._lock:
            return count_replies(self._said, [(reply.command.text, reply.command.id) for _, reply in self._replies])

    def is_all_answered(self) -> bool:
        """Whether each text that was said since `forget` has a reply of its own."""
        return self.counts()[0] == 0

    def drive(self) -> None:
        """Begin to drive a long way; returns when the robot moves."""
        since_s = self.say("Move forward 20 metres.")
        wait_until(
            lambda: self.speed > 0.1, 30.0, lambda: [reply.sentence for _, reply in self.replies(since_s)] or "no reply"
        )

    def stand(self, timeout_s: float = 20.0) -> bool:
        """Wait until the robot has stood for a quarter of a second; returns whether it does."""
        return comes_true(lambda: self.speed <= MOTION and time.monotonic() - self.moved_s > 0.25, timeout_s)

    def pid_of(self, node: str) -> int:
        """Return the process id of a node, 0 while it does not run."""
        from roboframenet_ros.ros_master import NO_ANSWER, TimedMaster
        from roboframenet_ros.timed_transport import TimedTransport

        try:
            uri = TimedMaster(timeout_s=2.0).uri_of(self._rospy.resolve_name(node))
            import xmlrpc.client

            api = xmlrpc.client.ServerProxy(uri, transport=TimedTransport(2.0))
            return int(api.getPid(self._rospy.get_name())[2])
        except NO_ANSWER:
            return 0

    def pids(self, nodes: Sequence[str] = NODES) -> Dict[str, int]:
        """Return the process ids of nodes that run."""
        found = {node: self.pid_of(node) for node in nodes}
        return {node: pid for node, pid in found.items() if pid}

    def memory_mb(self, nodes: Sequence[str] = NODES) -> Dict[str, float]:
        """Return the resident memory of nodes, megabytes."""
        sizes = {}
        for node, pid in self.pids(nodes).items():
            try:
                sizes[node] = psutil.Process(pid).memory_info().rss / 1e6
            except psutil.NoSuchProcess:
                continue
        return sizes


def outcome_name(reply: Any) -> str:
    """Return the name of the outcome of a reply."""
    names = ("DONE", "FAILED", "REFUSED", "NEEDS_INFORMATION", "SUPERSEDED")
    return next((name for name in names if getattr(reply, name, None) == reply.outcome), str(reply.outcome))


def free_port() -> int:
    """Return a port that nobody listens to."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


class Launched:
    """A roslaunch process with a master of its own."""

    def __init__(
        self, arguments: Sequence[str], program: Sequence[str] = ("roslaunch",), *, has_master_apart: bool = False
    ) -> None:
        """
        Args:
            arguments: of roslaunch
            program: what is run in its place
            has_master_apart: the master is no child of roslaunch, which ends its nodes when its own master dies
        """
        self.port = free_port()
        self.uri = f"http://127.0.0.1:{self.port}"
        environment = dict(os.environ, ROS_MASTER_URI=self.uri)
        self.master: Optional[subprocess.Popen[bytes]] = None
        if has_master_apart:
            self.master = subprocess.Popen(
                ["rosmaster", "--core", "-p", str(self.port)], env=environment, stdout=subprocess.DEVNULL
            )
        command = [*program, "-p", str(self.port), *arguments]
        self.process = subprocess.Popen(
            command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True
        )

    def descendants(self) -> List[psutil.Process]:
        """Return every process that was started."""
        try:
            return psutil.Process(self.process.pid).children(recursive=True)
        except psutil.NoSuchProcess:
            return []

    def end(self) -> Mapping[str, Any]:
        """Interrupt; return exit status, seconds, and the number of processes that were left over."""
        children = self.descendants()
        begin_s = time.monotonic()
        self.process.send_signal(signal.SIGINT)
        try:
            status: Optional[int] = self.process.wait(_END_TIMEOUT_S)
        except subprocess.TimeoutExpired:
            status = None
        took_s = time.monotonic() - begin_s
        left = [child for child in children if child.is_running() and child.status() != psutil.STATUS_ZOMBIE]
        for child in left:
            child.kill()
        if status is None:
            self.process.kill()
        if self.master is not None:
            self.master.kill()
            self.master.wait()
        return {"exit_status": status, "exit_s": took_s, "orphans": len(left)}


@contextmanager
def running_robot(*arguments: str, file: str = "", has_master_apart: bool = False) -> Iterator[Robot]:
    """Start a robot, and end it at the end; one per process, because rospy has one node per process.

    Args:
        arguments: of the launch file
        file: a launch file in place of robot.launch
        has_master_apart: the robot outlives its master
    """
    # What the robot learns must not outlive the trials.
    with tempfile.TemporaryDirectory() as folder:
        launch_file = [file] if file else ["roboframenet_bringup", "robot.launch"]
        launched = Launched(
            [*launch_file, f"world_memory_file:={folder}/world.sqlite", "seed:=1", *arguments],
            has_master_apart=has_master_apart,
        )
        os.environ["ROS_MASTER_URI"] = launched.uri
        try:
            import rosgraph
            import rospy

            wait_until(rosgraph.is_master_online, 60.0, "no master")
            rospy.init_node("reliability_campaign", disable_signals=True)
            yield Robot(launched)
        finally:
            launched.end()


@contextmanager
def suspended(pids: Sequence[int]) -> Iterator[None]:
    """Suspend processes for the length of a block."""
    for pid in pids:
        os.kill(pid, signal.SIGSTOP)
    try:
        yield
    finally:
        for pid in pids:
            try:
                os.kill(pid, signal.SIGCONT)
            except ProcessLookupError:
                continue
