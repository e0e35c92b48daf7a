"""Keeps the emergency stop: engages it, writes it down, and releases it for a person."""

import queue
import threading
import time
from typing import Callable, Optional

import rospy
from roboframenet_msgs.msg import EmergencyStop
from std_msgs.msg import Bool
from std_srvs.srv import Trigger, TriggerRequest, TriggerResponse

from roboframenet_ros.suspension import SuspensionWatch
from robot_stop.emergency import Emergency, engaged, released
from robot_stop.ros_brake import Brake
from robot_stop.ros_emergency import RELEASE, TOPIC, EmergencyWatch, emergency_file, emergency_to_message

#: How long a service may take: the disk may be busy. Seconds.
_ANSWER_TIMEOUT_S = 5.0
_WAIT_S = 0.5
#: A longer turn of the thread means that the process was suspended: who asked for something has given it up.
_LONGEST_TURN_S = _WAIT_S + 1.0
_JUST_AWAKE_S = 0.5
#: How long a release may wait until it is known who would drive, seconds.
_LOOK_S, _POLL_S = 3.0, 0.05


class EmergencyKeeper:
    """Keeps the emergency stop. Its thread writes the file; the robot is held before.

    Subscribes: ``emergency_stop`` (of the command server, which engages it while this node hangs),
    ``emergency_stop/lock`` (std_msgs/Bool: true engages it, false does nothing). Publishes: ``emergency_stop`` and
    ``emergency_stop/holds`` (std_msgs/Bool), both latched. Services: ``emergency_stop/engage``,
    ``emergency_stop/release``.
    """

    def __init__(self, brake: Brake, *, on_engaged: Callable[[str], None]) -> None:
        """
        Args:
            brake: holds the robot
            on_engaged: called with what has engaged it, if that was no utterance; from any thread, must not block
        """
        self._brake = brake
        self._on_engaged = on_engaged
        self._file = emergency_file()
        self._jobs: queue.SimpleQueue[Optional[Callable[[], None]]] = queue.SimpleQueue()
        self._suspension = SuspensionWatch(longest_turn_s=_LONGEST_TURN_S)
        self._thread = threading.Thread(target=self._work, name="emergency_stop", daemon=True)
        self._is_unwritten = False
        # Counts also those that found it engaged: a release that was asked for before them does not count.
        self._engage_count = 0
        self._publisher = rospy.Publisher(TOPIC, EmergencyStop, queue_size=10, latch=True)
        self._holds = rospy.Publisher(f"{TOPIC}/holds", Bool, queue_size=10, latch=True)
        self._watch = EmergencyWatch(self._hear_change)

    @property
    def state(self) -> Emergency:
        """Whether it holds."""
        return self._watch.state

    @property
    def is_written(self) -> bool:
        """Whether the state is in the file, and survives this process."""
        return not self._is_unwritten

    @property
    def sentence(self) -> str:
        """Why nothing moves, and whether that survives this process; empty when it does not hold."""
        unwritten = " I could not write it down: it does not survive a restart."
        return self.state.sentence + (unwritten if self.state.is_engaged and self._is_unwritten else "")

    def start(self) -> None:
        """Hold the robot if the last run did, and offer the topics and services."""
        self._brake.hold(self.state.is_engaged)
        if self.state.is_engaged:
            rospy.logwarn("%s", self.state.sentence)
            # It may come from a file that is damaged.
            self._hear_change(self.state)
        self._publish()
        self._thread.start()
        self._lock = rospy.Subscriber(f"{TOPIC}/lock", Bool, self._hear_lock, queue_size=10, tcp_nodelay=True)
        self._services = [
            rospy.Service(f"{TOPIC}/engage", Trigger, self._serve_engage),
            rospy.Service(RELEASE, Trigger, self._serve_release),
        ]

    def close(self, *, timeout_s: float) -> None:
        """End the thread."""
        self._jobs.put(None)
        self._thread.join(timeout_s)

    def engage(self, by: str) -> None:
        """Hold the robot from now on, and write it down soon; returns at once.

        Args:
            by: what engages it, for a person
        """
        self._brake.hold(True)
        self._engage_count += 1
        self._watch.know(engaged(self.state, by=by, now_s=time.time()))

    def call_when_written(self, call: Callable[[], None]) -> None:
        """Call something from the thread of the file, when everything up to now was written."""
        self._jobs.put(call)

    def _hear_change(self, state: Emergency) -> None:
        """The state has changed, here or at another node."""
        if state.is_engaged:
            self._brake.hold(True)
            # Not the state itself: in the file, or here meanwhile, may be a newer one that lets the robot go.
            self._jobs.put(lambda: self._write(lambda known: engaged(known, by=state.by, now_s=state.since_s)))

    def _work(self) -> None:
        while True:
            try:
                job = self._jobs.get(timeout=_WAIT_S)
            except queue.Empty:
                self._suspension.turn()
                if self._is_unwritten:
                    self._write(lambda state: state)
                continue
            if job is None:
                return
            self._suspension.turn()
            try:
                job()
            except Exception as error:  # boundary: the next call must not go unheard
                rospy.logerr("the emergency stop: %s: %s", type(error).__name__, error)

    def _write(self, change: Callable[[Emergency], Emergency]) -> bool:
        """Change the state, write it down, and tell of it; returns whether it was written."""
        try:
            state = self._file.update(self.state, change)
        except OSError as error:
            self._is_unwritten = True
            rospy.logerr_throttle(
                10.0, f"{self._file.path} cannot be written, a restart would forget the emergency stop: {error}"
            )
            self._publish()
            return False
        self._is_unwritten = False
        self._watch.know(state)
        self._brake.hold(self.state.is_engaged)
        self._publish()
        return True

    def _publish(self) -> None:
        state = self.state
        self._publisher.publish(emergency_to_message(state))
        self._holds.publish(Bool(data=state.is_engaged))

    def _hear_lock(self, message: Bool) -> None:
        # A button tells its state again and again.
        if message.data and not self.state.is_engaged:
            self._engage_unsaid(f"emergency_stop/lock of {_caller_of(message)}")

    def _engage_unsaid(self, by: str) -> None:
        self.engage(by)
        self._on_engaged(by)

    def _serve_engage(self, request: TriggerRequest) -> TriggerResponse:
        self._engage_unsaid(f"emergency_stop/engage of {_caller_of(request)}")
        is_done = threading.Event()
        self._jobs.put(is_done.set)
        if not is_done.wait(_ANSWER_TIMEOUT_S) or self._is_unwritten:
            return TriggerResponse(False, f"The robot is held, but {self._file.path} could not be written.")
        return TriggerResponse(True, self.state.sentence)

    def _serve_release(self, request: TriggerRequest) -> TriggerResponse:
        caller, count = _caller_of(request), self._engage_count
        answers: queue.SimpleQueue[TriggerResponse] = queue.SimpleQueue()
        until_s = time.monotonic() + _ANSWER_TIMEOUT_S
        self._jobs.put(lambda: answers.put(self._release(caller, engage_count=count, until_s=until_s)))
        try:
            return answers.get(timeout=_ANSWER_TIMEOUT_S)
        except queue.Empty:
            return TriggerResponse(False, "The emergency stop holds: the disk does not answer.")

    def _release(self, by: str, *, engage_count: int, until_s: float) -> TriggerResponse:
        """Release it, unless that would set the robot in motion."""
        if not self.state.is_engaged:
            return TriggerResponse(True, "The emergency stop does not hold.")
        reason = self._reason_to_hold(until_s) or self._let_go(by, engage_count)
        if reason:
            return TriggerResponse(False, f"The emergency stop holds: {reason}.")
        rospy.logwarn("the emergency stop was released by %s", by)
        return TriggerResponse(True, "The emergency stop is released.")

    def _reason_to_hold(self, until_s: float) -> str:
        if time.monotonic() >= until_s or self._suspension.is_just_awake(within_s=_JUST_AWAKE_S):
            return "this was asked for some time ago. Ask again"
        end_s = min(until_s, time.monotonic() + _LOOK_S)
        while not self._brake.held_obedience.is_known and time.monotonic() < end_s:
            # This node has just started.
            time.sleep(_POLL_S)
            self._suspension.turn()
        obedience = self._brake.held_obedience
        if obedience.is_complete:
            return ""
        return f"{obedience.describe()}. {'End that first' if obedience.names else 'Ask again'}"

    def _let_go(self, by: str, engage_count: int) -> str:
        """Release what was engaged when somebody asked for it, and nothing later; returns why not."""
        number = self.state.number
        if not self._write(
            lambda known: released(known, by=by, now_s=time.time()) if known.number == number else known
        ):
            return f"{self._file.path} cannot be written"
        if engage_count != self._engage_count:
            # Behind the release, for who engages it may have found it engaged, right before.
            self.engage("it was engaged again while it was released")
        return "it was engaged again meanwhile" if self.state.is_engaged else ""


def _caller_of(message: object) -> str:
    header = getattr(message, "_connection_header", None) or {}
    return str(header.get("callerid", "somebody"))
