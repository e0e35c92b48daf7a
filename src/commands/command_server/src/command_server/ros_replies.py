"""Publishes the one reply to each command, and the status."""

import time
from typing import List, Optional, Sequence, Tuple

import rospy
from roboframenet_msgs.msg import Command, CommandStatus, Reply

from command_server.open_commands import CommandText, Ending, OpenCommand
from command_server.ros_messages import command_to_message, ending_to_message
from roboframenet_ros.bounded_text import one_line
from roboframenet_ros.ros_taken_texts import TakenOut

# Stages pass a command on within milliseconds, and many nodes read the status: not each of them is told to all.
_NOTE_DELAY_S = 0.05
# Nor does whoever reads the status take the processor from the stages while they pass a new command on.
_OPEN_DELAY_S = 0.01
# A stage that is started anew hears the last status: while a command is open, that is no older.
_REPEAT_S = 1.0


class Replies:
    """Publishes ``reply``, ``text_taken``, ``cry_heard``, ``command_server_started`` and ``status`` (latched).

    Attributes:
        publisher: of ``reply``
        last_reply: the reply published last; its command id is empty before the first
    """

    def __init__(self) -> None:
        self.publisher = rospy.Publisher("reply", Reply, queue_size=1000)
        self.last_reply = Reply()
        self._status = rospy.Publisher("status", CommandStatus, queue_size=100, latch=True)
        self._taken = TakenOut("command_server_started")
        self._cries = rospy.Publisher("cry_heard", Command, queue_size=100, tcp_nodelay=True)
        self._untold: List[Tuple[str, str, float]] = []
        self._unlogged: List[CommandText] = []
        self._sentence = "Ready."
        self._told_ids: Optional[Tuple[str, ...]] = None
        self._status_due_s: Optional[float] = None

    def tell_start(self) -> None:
        """Tell that texts are heard from now on: the stop server replies to those that were said before."""
        self._taken.tell_start()

    def tell_cry(self, command: CommandText) -> None:
        """Tell the stop server of a cry at once: a client that has just started may not be connected to it yet."""
        self._cries.publish(command_to_message(command))

    def note_taken(self, command_id: str, text: str, *, heard_s: float) -> None:
        """A text was heard; this is told with the next status, when its command is saved and will be answered."""
        self._untold.append((command_id, text, heard_s))
        self._tell_within(_OPEN_DELAY_S)

    def note_heard(self, command: CommandText) -> None:
        """A command was heard; the log says so before its reply, or when it is sent: a log call takes a while."""
        self._unlogged.append(command)

    def publish(self, ending: Ending) -> Reply:
        """Publish the reply to a command, and return it."""
        self._log_heard()
        reply = ending_to_message(ending)
        rospy.loginfo(
            "cmd=%s -> %s %s (%s) %s",
            ending.command.command_id,
            ending.outcome.name,
            ending.code,
            ending.stage,
            reply.sentence,
        )
        self.publisher.publish(reply)
        self.last_reply = reply
        self.note(reply.sentence)
        self._tell_within(0.0)
        return reply

    def tell(self, ending: Ending) -> None:
        """Tell why something was refused that is no command of anybody; it is not the last reply."""
        rospy.logwarn("%r: %s", ending.command.text, ending.reply)
        self.publisher.publish(ending_to_message(ending))

    def note(self, sentence: str) -> None:
        """Set the sentence of the next status: what the robot is doing."""
        self._sentence = one_line(sentence)
        self._tell_within(_NOTE_DELAY_S)

    def next_status_s(self) -> Optional[float]:
        """When a status is due, monotonic seconds; None for never."""
        return self._status_due_s

    def publish_status(self, open_commands: Sequence[OpenCommand]) -> None:
        """Publish which texts were taken, and the status, if it is due; call it when the commands are saved and sent.

        Which commands are open, and the last reply, are told before a person can speak again: others decide by them
        what "Cancel it." means.

        Args:
            open_commands: oldest first
        """
        self._taken.turn()
        open_ids = tuple(entry.command.command_id for entry in open_commands)
        if open_ids != self._told_ids:
            self._tell_within(_OPEN_DELAY_S)
        if self._status_due_s is None or time.monotonic() < self._status_due_s:
            return
        self._log_heard()
        untold, self._untold = self._untold, []
        for command_id, text, heard_s in untold:
            self._taken.tell(command_id, text, heard_s=heard_s)
        self._told_ids = open_ids
        self._status_due_s = time.monotonic() + _REPEAT_S if open_ids else None
        self._status.publish(
            CommandStatus(
                stamp=rospy.Time.now(),
                active=[command_to_message(entry.command) for entry in open_commands],
                stage=open_commands[-1].awaited_stage if open_commands else self.last_reply.stage,
                sentence=self._sentence,
                last_reply=self.last_reply,
            )
        )

    def _tell_within(self, delay_s: float) -> None:
        due_s = time.monotonic() + delay_s
        self._status_due_s = due_s if self._status_due_s is None else min(self._status_due_s, due_s)

    def _log_heard(self) -> None:
        for command in self._unlogged:
            rospy.loginfo("cmd=%s heard %r", command.command_id, command.text)
        self._unlogged.clear()
