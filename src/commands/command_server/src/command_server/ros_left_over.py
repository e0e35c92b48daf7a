"""Commands that the previous run of the node left open."""

import time
from collections import deque
from typing import Deque, List, Tuple

import rospy

from command_server.open_commands import CommandText, Ending
from roboframenet_ros.ros_listeners import has_every_listener

# How long replies wait for subscribers to connect. The stop server replies in place of this node after six seconds.
_LISTENER_TIMEOUT_S = 3.0
# How long the executor may take to connect, and then to end its command, before this node stops the robot.
_EXECUTOR_CONNECT_S = 1.5
_EXECUTOR_CANCEL_S = 0.3
#: Sum of both, seconds.
EXECUTOR_TIMEOUT_S = _EXECUTOR_CONNECT_S + _EXECUTOR_CANCEL_S


class LeftOver:
    """Ends these commands: they are cancelled first, and their replies wait for a subscriber."""

    def __init__(self, commands: Tuple[CommandText, ...], reply: rospy.Publisher) -> None:
        """Start to wait.

        Args:
            commands: that were open
            reply: the topic of the replies
        """
        self._reply = reply
        self._awaited = {command.command_id for command in commands}
        self._held: Deque[Ending] = deque()
        self._listener_end_s = time.monotonic() + _LISTENER_TIMEOUT_S
        self._brake_s = time.monotonic() + EXECUTOR_TIMEOUT_S if commands else float("inf")

    @property
    def commands(self) -> Tuple[CommandText, ...]:
        """The commands whose reply is still held back."""
        return tuple(ending.command for ending in self._held)

    @property
    def is_waiting(self) -> bool:
        """Whether a command is still to be ended, or a reply still held back."""
        return bool(self._awaited or self._held)

    def take_brake(self, *, is_executor_connected: bool) -> bool:
        """Whether the time of the executor is over, so that the robot must be stopped; true once."""
        now_s = time.monotonic()
        if is_executor_connected and self._brake_s != float("inf"):
            self._brake_s = min(self._brake_s, now_s + _EXECUTOR_CANCEL_S)
        if now_s < self._brake_s:
            return False
        self._brake_s = float("inf")
        return bool(self._awaited)

    def hold(self, ending: Ending) -> bool:
        """Hold back the reply to one of these commands; returns whether it is one."""
        if ending.command.command_id not in self._awaited:
            return False
        self._awaited.discard(ending.command.command_id)
        self._held.append(ending)
        return True

    def take_answers(self, *, is_last_chance: bool = False) -> List[Ending]:
        """Remove and return the replies that can be published now."""
        if not self._held or not (
            is_last_chance or time.monotonic() >= self._listener_end_s or has_every_listener(self._reply)
        ):
            return []
        answers = list(self._held)
        self._held.clear()
        return answers
