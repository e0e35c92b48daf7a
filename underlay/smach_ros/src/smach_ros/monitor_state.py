"""MonitorState: watches a topic until a message fails a condition."""

import threading
import traceback
from typing import Any, Callable, Iterable, Optional

import rospy

import smach

# How often a waiting state asks whether the program ends.
SHUTDOWN_POLL_S = 0.2


class MonitorState(smach.State):
    """Ends with invalid at the first message that fails the condition, with valid when so many have passed it.

    Args:
        topic: name of the topic
        msg_type: class of its messages
        cond_cb: called with the userdata and a message, returns whether the message is as it should be
        max_checks: messages after which the state ends; -1 for no limit
        input_keys: userdata that the condition reads
        output_keys: userdata that the condition writes
    """

    def __init__(
        self,
        topic: str,
        msg_type: type,
        cond_cb: Callable[[Any, Any], bool],
        max_checks: int = -1,
        input_keys: Iterable[str] = (),
        output_keys: Iterable[str] = (),
    ) -> None:
        smach.State.__init__(
            self, outcomes=["valid", "invalid", "preempted"], input_keys=input_keys, output_keys=output_keys
        )
        self._topic = topic
        self._msg_type = msg_type
        self._cond_cb = cond_cb
        if smach.has_smach_interface(cond_cb):
            self.register_input_keys(cond_cb.get_registered_input_keys())
            self.register_output_keys(cond_cb.get_registered_output_keys())
        self._max_checks = max_checks
        self._checks = 0
        self._verdict: Optional[str] = None
        self._lock = threading.Lock()
        self._wake = threading.Event()

    def request_preempt(self) -> None:
        """Ask the state to stop watching."""
        super().request_preempt()
        self._wake.set()

    def execute(self, ud: Any) -> str:
        """Watch the topic until the condition, the number of messages, a request or the program ends it."""
        self._wake.clear()
        if self.preempt_requested():
            self.service_preempt()
            return "preempted"
        self._checks, self._verdict = 0, None
        subscriber = rospy.Subscriber(self._topic, self._msg_type, self._check, callback_args=ud)
        try:
            while not self._wake.wait(SHUTDOWN_POLL_S) and not rospy.is_shutdown():
                pass
        finally:
            subscriber.unregister()
        if self.preempt_requested():
            self.service_preempt()
            return "preempted"
        with self._lock:
            return self._verdict or "preempted"

    def _check(self, msg: Any, ud: Any) -> None:
        with self._lock:
            if self._verdict is not None:
                return
            try:
                is_valid = self._cond_cb(ud, msg)
            except Exception:  # boundary: the condition is code of the user, called by a thread of ROS
                rospy.logerr("The condition of the monitor of %s raised:\n%s", self._topic, traceback.format_exc())
                is_valid = False
            self._checks += 1
            if not is_valid:
                self._verdict = "invalid"
            elif 0 < self._max_checks <= self._checks:
                self._verdict = "valid"
            if self._verdict is not None:
                self._wake.set()
