"""Open commands on the parameter server, for the command server that is started again."""
import json
import threading
import time
from typing import Optional, Tuple

import rospy

from command_server.command_book import CommandText


def _to_text(commands: Tuple[CommandText, ...]) -> str:
    # JSON in ASCII: XML-RPC carries neither control characters nor integers of 64 bits.
    return json.dumps([
        {"id": command.command_id, "stamp_ns": command.stamp_ns, "text": command.text} for command in commands])


def _from_text(text: object) -> Tuple[CommandText, ...]:
    entries = json.loads(str(text))
    return tuple(
        CommandText(command_id=str(entry["id"]), stamp_ns=int(entry["stamp_ns"]), text=str(entry["text"]))
        for entry in entries)


class OpenCommandStore:
    """Writes the open commands from a thread of its own, so that a hung master holds up nobody for long."""

    def __init__(self, parameter: str = "~open_commands") -> None:
        self._parameter = parameter
        self._changed = threading.Condition()
        self._wanted: Optional[Tuple[CommandText, ...]] = None
        self._written: Optional[Tuple[CommandText, ...]] = None
        self._is_closing = False
        self._thread = threading.Thread(target=self._write_on, name="open_command_store", daemon=True)
        self._thread.start()

    def load(self) -> Tuple[CommandText, ...]:
        """The commands that were open when the last command server ended; empty, with a warning, if unreadable."""
        try:
            return _from_text(rospy.get_param(self._parameter, "[]"))
        except (ValueError, KeyError, TypeError) as error:
            rospy.logwarn("the open commands of the last run cannot be read: %s", error)
            return ()

    def save(self, commands: Tuple[CommandText, ...], *, timeout_s: float) -> bool:
        """Have the commands written; returns whether they were, within the time."""
        end_s = time.monotonic() + timeout_s
        with self._changed:
            self._wanted = commands
            self._changed.notify_all()
            while self._written != commands:
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
        retry_s = 0.5
        while True:
            with self._changed:
                while self._wanted == self._written and not self._is_closing:
                    self._changed.wait(retry_s)
                if self._is_closing:
                    return
                wanted = self._wanted or ()
            try:
                rospy.set_param(self._parameter, _to_text(wanted))
            except Exception as error:  # boundary: the master may be away in any way that XML-RPC knows
                rospy.logwarn_throttle(10.0, "the open commands cannot be kept: %s" % error)
                with self._changed:
                    self._changed.wait(retry_s)
                continue
            with self._changed:
                self._written = wanted
                self._changed.notify_all()
