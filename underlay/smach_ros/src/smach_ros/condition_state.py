"""ConditionState: calls a function until it returns True."""

import threading
import traceback
from typing import Any, Callable, Iterable, Optional

import rospy

import smach


class ConditionState(smach.State):
    """Ends with true when a condition holds, with false when it did not in so many checks or so much time.

    Args:
        cond_cb: called with the userdata, returns whether the condition holds
        input_keys: userdata that the condition reads
        poll_rate: time between checks
        timeout: time after which the state gives up; None for no limit
        max_checks: checks after which the state gives up; -1 for no limit
    """

    def __init__(
        self,
        cond_cb: Callable[[Any], bool],
        input_keys: Iterable[str] = (),
        poll_rate: rospy.Duration = rospy.Duration(0.05),
        timeout: Optional[rospy.Duration] = None,
        max_checks: int = 1,
    ) -> None:
        smach.State.__init__(self, outcomes=["true", "false", "preempted"], input_keys=input_keys)
        self._cond_cb = cond_cb
        if smach.has_smach_interface(cond_cb):
            self.register_input_keys(cond_cb.get_registered_input_keys())
            self.register_output_keys(cond_cb.get_registered_output_keys())
        self._poll_s = poll_rate.to_sec()
        self._timeout = timeout
        self._max_checks = max_checks
        self._asked_to_stop = threading.Event()

    def request_preempt(self) -> None:
        """Ask the state to stop; it does not wait for its next check."""
        super().request_preempt()
        self._asked_to_stop.set()

    def execute(self, ud: Any) -> str:
        """Check until the condition holds, or the checks, the time or the program end."""
        # If a recalled request had left it set, the checks would follow each other without a pause.
        self._asked_to_stop.clear()
        start = rospy.Time.now()
        checks = 0
        while self._max_checks == -1 or checks < self._max_checks:
            if self.preempt_requested():
                self.service_preempt()
                return "preempted"
            if rospy.is_shutdown() or (self._timeout and rospy.Time.now() - start > self._timeout):
                break
            try:
                if self._cond_cb(ud):
                    return "true"
            except Exception as error:  # boundary: the condition is code of the user
                raise smach.InvalidUserCodeError(
                    f"The condition of the state raised:\n{traceback.format_exc()}"
                ) from error
            checks += 1
            if checks != self._max_checks:
                self._asked_to_stop.wait(self._poll_s)
        return "false"
