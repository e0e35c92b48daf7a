"""The stop server node: "Stop." without parser, framer, registrar, arbitrator or executor.

Callbacks only enqueue; one worker thread stops the robot.
"""
import queue
import threading
import time
import uuid
from dataclasses import dataclass
from typing import List, Optional

import rospy
from actionlib_msgs.msg import GoalID
from command_server.stop_words import is_stop
from geometry_msgs.msg import Twist
from roboframenet_msgs.msg import Command, ExecuteCommandActionGoal, FrameCatalogue, Reply, StopReport
from std_msgs.msg import String

from stop_server.ros_cancel_publishers import CancelPublishers
from stop_server.ros_stopping_frame import SERVER, StoppingFrame
from stop_server.settings import Settings
from stop_server.stop_window import StopWindow

STAGE = "stop_server"
_IDLE_WAIT_S = 0.5
_JOIN_TIMEOUT_S = 2.0


@dataclass(frozen=True)
class _StopHeard:
    """A stop: `text` as it was said, `command_id` of a goal or empty, `is_frame` when it came as a frame."""

    text: str
    stamp: rospy.Time
    command_id: str = ""
    is_frame: bool = False


class StopServerNode:
    """Stops the robot.

    Subscribes: ``text``, ``command/goal``, ``frame_catalogue``. Publishes: ``stop_report``, ``reply``,
    ``<server>/cancel`` of every action server, zero velocity. Actions: ``stopping``.
    """

    def __init__(self, settings: Settings) -> None:
        self._period_s = 1.0 / settings.zero_velocity_rate_hz
        self._window = StopWindow(duration_s=settings.zero_velocity_duration_s)
        self._last_stop: Optional[_StopHeard] = None
        self._run_tag = uuid.uuid4().hex[:8]
        self._count = 0
        self._stops: "queue.Queue[Optional[_StopHeard]]" = queue.Queue()
        self._velocities = [rospy.Publisher(topic, Twist, queue_size=1) for topic in settings.velocity_topics]
        self._reply = rospy.Publisher("reply", Reply, queue_size=100)
        self._report = rospy.Publisher("stop_report", StopReport, queue_size=100)
        self._cancels = CancelPublishers(
            also_cancel=tuple(rospy.resolve_name(name) for name in settings.also_cancel),
            refresh_period_s=settings.refresh_period_s, master_timeout_s=settings.master_timeout_s)
        self._own_server = rospy.resolve_name(SERVER)
        self._frame = StoppingFrame(self._stop_for_frame)
        self._worker = threading.Thread(target=self._work, name="stop_server_worker")

    def start(self) -> None:
        """Begin to hear."""
        rospy.on_shutdown(self._shutdown)
        self._worker.start()
        self._cancels.start()
        self._subscribers = [
            rospy.Subscriber("text", String, lambda message: self._hear(message.data, "")),
            rospy.Subscriber("command/goal", ExecuteCommandActionGoal,
                             lambda message: self._hear(message.goal.text, message.goal_id.id)),
            rospy.Subscriber("frame_catalogue", FrameCatalogue, self._hear_catalogue)]
        self._frame.start()

    def _shutdown(self) -> None:
        self._stops.put(None)
        self._worker.join(_JOIN_TIMEOUT_S)
        self._cancels.close(timeout_s=_JOIN_TIMEOUT_S)
        self._frame.close(timeout_s=_JOIN_TIMEOUT_S)

    def _hear(self, text: str, command_id: str) -> None:
        if is_stop(text):
            self._stops.put(_StopHeard(text=text, stamp=rospy.Time.now(), command_id=command_id))

    def _hear_catalogue(self, catalogue: FrameCatalogue) -> None:
        self._cancels.set_registered(frozenset(
            rospy.resolve_name(callback.callback_topic) for callback in catalogue.callbacks if callback.callback_topic))

    def _stop_for_frame(self) -> None:
        # The executor has preempted what ran before; what moves the robot without it is stopped here.
        self._stops.put(_StopHeard(text="", stamp=rospy.Time.now(), is_frame=True))

    def _work(self) -> None:
        while True:
            try:
                heard = self._stops.get(timeout=self._period_s if self._window.is_open else _IDLE_WAIT_S)
            except queue.Empty:
                heard = None
                if not self._window.is_open:
                    continue
            else:
                if heard is None:
                    return
            try:
                if heard is not None:
                    self._stop(heard)
                else:
                    self._repeat()
            except Exception as error:  # boundary: whatever is wrong with one stop, the next one must be heard
                rospy.logerr("stop_server: %s: %s", type(error).__name__, error)

    def _stop(self, heard: _StopHeard) -> None:
        began_s = time.monotonic()
        self._publish_zero_velocity()
        if heard.is_frame:
            cancelled = self._cancels.cancel(GoalID(stamp=heard.stamp), except_server=self._own_server)
        else:
            # The empty id cancels every goal, also those whose stamp comes from a clock that is ahead.
            cancelled = self._cancels.cancel(GoalID())
        self._last_stop = heard
        self._window.open()
        self._cancels.refresh_soon()
        rospy.loginfo("stopped in %.1f ms, cancelled %s", 1000.0 * (time.monotonic() - began_s), cancelled)
        if not heard.is_frame:
            self._answer(heard, cancelled)

    def _repeat(self) -> None:
        """Stop what was starting, or on its way, when the stop was heard."""
        self._publish_zero_velocity()
        stop = self._last_stop
        # A cancel without a stamp would take a command with it that was given after the stop.
        if stop is not None and not stop.stamp.is_zero():
            self._cancels.cancel(GoalID(stamp=stop.stamp), except_server=self._own_server if stop.is_frame else "")

    def _publish_zero_velocity(self) -> None:
        for publisher in self._velocities:
            publisher.publish(Twist())

    def _answer(self, heard: _StopHeard, cancelled: List[str]) -> None:
        self._count += 1
        command_id = heard.command_id or f"stop-{self._run_tag}-{self._count}"
        command = Command(id=command_id, stamp=heard.stamp, text=heard.text)
        servers = f"{len(cancelled)} action server{'' if len(cancelled) == 1 else 's'}"
        reply = Reply(command=command, outcome=Reply.DONE, stage=STAGE, code="DONE",
                      sentence=f"Stopped: zero velocity, and every goal of {servers} cancelled.",
                      stamp=rospy.Time.now())
        # The executor must not start the next step: the report goes first.
        self._report.publish(StopReport(
            command=command, stop_stamp=heard.stamp, cancelled_servers=cancelled, reply=reply))
        self._reply.publish(reply)


def read_settings() -> Settings:
    """Read the private parameters.

    Raises:
        ValueError: a parameter is out of its range
    """
    return Settings(
        velocity_topics=rospy.get_param("~velocity_topics", Settings.velocity_topics),
        zero_velocity_duration_s=rospy.get_param("~zero_velocity_duration_s", Settings.zero_velocity_duration_s),
        zero_velocity_rate_hz=rospy.get_param("~zero_velocity_rate_hz", Settings.zero_velocity_rate_hz),
        also_cancel=rospy.get_param("~also_cancel", Settings.also_cancel),
        refresh_period_s=rospy.get_param("~refresh_period_s", Settings.refresh_period_s),
        master_timeout_s=rospy.get_param("~master_timeout_s", Settings.master_timeout_s))


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    rospy.init_node("stop_server")
    try:
        settings = read_settings()
    except ValueError as error:
        rospy.logfatal("%s", error)
        raise SystemExit(f"stop_server: {error}") from error
    rospy.loginfo("stop_server: %s", settings)
    StopServerNode(settings).start()
    rospy.spin()
