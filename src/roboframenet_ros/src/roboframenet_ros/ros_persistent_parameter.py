"""A value on the parameter server that outlives its node."""

import json
import threading
import time
from typing import Optional

import rospy

_RETRY_S = 0.5


class PersistentParameter:
    """Writes a value to a parameter, in a thread of its own, so that callers do not wait for a master that hangs.

    The value is JSON in ASCII, because XML-RPC has neither control characters nor integers of 64 bits.
    """

    def __init__(self, parameter: str) -> None:
        """Start the thread; nothing is written before the first `save`.

        Args:
            parameter: name of the parameter
        """
        self._parameter = parameter
        self._changed = threading.Condition()
        self._wanted: Optional[str] = None
        self._written: Optional[str] = None
        self._is_closing = False
        self._thread = threading.Thread(target=self._write_on, name=f"save {parameter}", daemon=True)
        self._thread.start()

    def load(self) -> object:
        """Return the value that the previous run left; None for none.

        Raises:
            ValueError: it is not JSON
        """
        return json.loads(str(rospy.get_param(self._parameter, "null")))

    def save(self, value: object, *, timeout_s: float) -> bool:
        """Set the value; returns whether it was written in time. The thread tries again until it is."""
        text = json.dumps(value)
        end_s = time.monotonic() + timeout_s
        with self._changed:
            self._wanted = text
            self._changed.notify_all()
            while self._written != text:
                remaining_s = end_s - time.monotonic()
                if remaining_s <= 0.0:
                    return False
                self._changed.wait(remaining_s)
        return True

    def close(self, *, timeout_s: float) -> None:
        """End the thread."""
        with self._changed:
            self._is_closing = True
            self._changed.notify_all()
        self._thread.join(timeout_s)

    def _write_on(self) -> None:
        while True:
            with self._changed:
                while self._wanted == self._written and not self._is_closing:
                    self._changed.wait(_RETRY_S)
                if self._is_closing:
                    return
                wanted = self._wanted
            try:
                rospy.set_param(self._parameter, wanted)
            except Exception as error:  # boundary: the master may be away in any way that XML-RPC knows
                rospy.logwarn_throttle(10.0, f"{self._parameter} cannot be saved: {error}")
                with self._changed:
                    self._changed.wait(_RETRY_S)
                continue
            with self._changed:
                self._written = wanted
                self._changed.notify_all()
