"""Keeps the emergency stop: engages it, writes it down, and releases it for a person."""

import queue
import threading
import time
from typing import Callable, Optional

import rospy
from roboframenet_msgs.msg import EmergencyStop
from std_msgs.msg import Bool
from std_srvs.srv import Trigger, TriggerRequest, TriggerResponse

from robot_stop.emergency import Emergency, engaged, released
from robot_stop.ros_brake import Brake
from robot_stop.ros_emergency import TOPIC, EmergencyWatch, emergency_file, emergency_to_message

#: How long a service may take: the disk may be busy. Seconds.
_ANSWER_TIMEOUT_S = 5.0
#: A file that could not be written is tried again, seconds.
_RETRY_S = 2.0


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
        self._thread = threading.Thread(target=self._work, name="emergency_stop", daemon=True)
        self._is_unwritten = False
        self._watch = EmergencyWatch(self._hear_other)
        self._publisher = rospy.Publisher(TOPIC, EmergencyStop, queue_size=10, latch=True)
        self._holds = rospy.Publisher(f"{TOPIC}/holds", Bool, queue_size=10, latch=True)

    @property
    def state(self) -> Emergency:
        """Whether it holds."""
        return self._watch.state

    @property
    def is_written(self) -> bool:
        """Whether the state is in the file, and survives this process."""
        return not self._is_unwritten

    def start(self) -> None:
        """Hold the robot if the last run did, and offer the topics and services."""
        self._brake.hold(self.state.is_engaged)
        if self.state.is_engaged:
            rospy.logwarn("%s", self.state.sentence)
        self._publish()
        self._thread.start()
        self._lock = rospy.Subscriber(f"{TOPIC}/lock", Bool, self._hear_lock, queue_size=10, tcp_nodelay=True)
        self._services = [
            rospy.Service(f"{TOPIC}/engage", Trigger, self._serve_engage),
            rospy.Service(f"{TOPIC}/release", Trigger, self._serve_release),
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
        self._watch.know(engaged(self.state, by=by, now_s=time.time()))
        self._jobs.put(lambda: self._write(lambda state: engaged(state, by=by, now_s=time.time())))

    def call_when_written(self, call: Callable[[], None]) -> None:
        """Call something from the thread of the file, when everything up to now was written."""
        self._jobs.put(call)

    def _work(self) -> None:
        while True:
            try:
                job = self._jobs.get(timeout=_RETRY_S)
            except queue.Empty:
                if self._is_unwritten:
                    self._write(lambda state: state)
                continue
            if job is None:
                return
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
            rospy.logerr("%s cannot be written, a restart would forget the emergency stop: %s", self._file.path, error)
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

    def _hear_other(self, state: Emergency) -> None:
        """The state has changed, here or at another node."""
        if state.is_engaged:
            self._brake.hold(True)
            self._jobs.put(lambda: self._write(lambda known: known))

    def _hear_lock(self, message: Bool) -> None:
        # A button tells its state again and again.
        if message.data and not self.state.is_engaged:
            caller = (message._connection_header or {}).get("callerid", "somebody")
            self._engage_unsaid(f"emergency_stop/lock of {caller}")

    def _engage_unsaid(self, by: str) -> None:
        self.engage(by)
        self._on_engaged(by)

    def _serve_engage(self, request: TriggerRequest) -> TriggerResponse:
        caller = (request._connection_header or {}).get("callerid", "somebody")
        self._engage_unsaid(f"emergency_stop/engage of {caller}")
        is_done = threading.Event()
        self._jobs.put(is_done.set)
        if not is_done.wait(_ANSWER_TIMEOUT_S) or self._is_unwritten:
            return TriggerResponse(False, f"The robot is held, but {self._file.path} could not be written.")
        return TriggerResponse(True, self.state.sentence)

    def _serve_release(self, request: TriggerRequest) -> TriggerResponse:
        caller = (request._connection_header or {}).get("callerid", "somebody")
        answers: queue.SimpleQueue[TriggerResponse] = queue.SimpleQueue()
        self._jobs.put(lambda: answers.put(self._release(caller)))
        try:
            return answers.get(timeout=_ANSWER_TIMEOUT_S)
        except queue.Empty:
            return TriggerResponse(False, "The emergency stop holds: the disk does not answer.")

    def _release(self, by: str) -> TriggerResponse:
        """Release it, unless that would set the robot in motion."""
        if not self.state.is_engaged:
            return TriggerResponse(True, "The emergency stop does not hold.")
        drivers = self._brake.drivers()
        if drivers:
            sentence = f"The emergency stop holds: {', '.join(drivers)} would drive the robot at once. End that first."
            return TriggerResponse(False, sentence)
        if not self._write(lambda state: released(state, by=by, now_s=time.time())):
            return TriggerResponse(False, f"The emergency stop holds: {self._file.path} cannot be written.")
        rospy.logwarn("the emergency stop was released by %s", by)
        return TriggerResponse(True, "The emergency stop is released.")
