"""Frames that a program has filled itself: commands without words, which begin at the frame registrar."""

from dataclasses import replace
from typing import Any, Callable, List, Optional, Union

import rospy
from actionlib_msgs.msg import GoalID
from roboframenet_msgs.msg import CommandLexicalUnits

from command_server.open_commands import (
    OWN_STAGE,
    CommandText,
    Ending,
    OpenCommands,
    Outcome,
    ending_if_stopped,
)
from command_server.ros_events import GoalCancelled
from command_server.ros_messages import command_from_message, command_to_message
from command_server.settings import Settings
from roboframenet_ros.command_ids import came_by_action
from roboframenet_ros.ros_hand_over import HandOver
from roboframenet_ros.ros_robots import own_robot

#: The stage that checks values, limits and servers. What a sentence passes before it is about words.
FIRST_STAGE = "frame_registrar"
#: Where programs publish the frames that they have filled, and cancel them.
CALLS, CANCELS = "called_frames", "called_frames/cancel"
#: A call is one command: so many frames, one after the other, at most.
_MOST_FRAMES = 20

_Put = Callable[[Union[CommandLexicalUnits, GoalCancelled]], None]


class CalledFrames:
    """Opens the commands of frames that were called. One thread owns it.

    Publishes: ``command_lexical_units``.
    """

    def __init__(
        self,
        commands: OpenCommands,
        settings: Settings,
        refusal: Callable[[CommandText], Optional[Ending]],
        *,
        on_not_begun: Callable[[Ending], None],
    ) -> None:
        """
        Args:
            commands: that are open
            settings: of the node
            refusal: returns how a command is refused now; None if it is not
            on_not_begun: called with the ending of a call that is refused, or was stopped before it arrived
        """
        self._commands = commands
        self._settings = settings
        self._refusal = refusal
        self._on_not_begun = on_not_begun
        # Asked once: a call must not wait for the master.
        self._is_of_fleet = bool(own_robot())
        self._units = HandOver("command_lexical_units", CommandLexicalUnits)

    def subscribe(self, put: _Put) -> List[rospy.Subscriber]:
        """Hear calls and their cancels; each is put into the queue of the owner."""

        def on_cancel(message: Any) -> None:
            put(GoalCancelled(message.id))

        return [
            rospy.Subscriber(CALLS, CommandLexicalUnits, put, queue_size=100),
            rospy.Subscriber(CANCELS, GoalID, on_cancel, queue_size=100),
        ]

    def begin(self, call: CommandLexicalUnits, *, stop_stamp_ns: int) -> None:
        """Open the command of a call, and send its frames to the registrar.

        Args:
            call: the filled frames; the text of its command describes them, and nobody reads it as words
            stop_stamp_ns: stamp of the last stop, nanoseconds of ROS time; what was called before it does not begin
        """
        now_ns = rospy.Time.now().to_nsec()
        command = command_from_message(call.command)
        # A stop ends what was called before it: no stamp may be later than that.
        command = replace(command, stamp_ns=min(command.stamp_ns or now_ns, now_ns))
        if not command.command_id or self._commands.get(command.command_id) is not None:
            return
        is_full = len(self._commands.open_commands) >= self._settings.max_open_commands
        self._commands.open(command, stage=FIRST_STAGE)
        ending = (
            self._refusal(command)
            or self._reason_against(call, command, is_full=is_full)
            or ending_if_stopped(command, stop_stamp_ns=stop_stamp_ns)
        )
        if ending is not None:
            self._on_not_begun(ending)
        else:
            call.command = command_to_message(command)
            self._units.publish(call)

    def _reason_against(self, call: CommandLexicalUnits, command: CommandText, *, is_full: bool) -> Optional[Ending]:
        """Return why a call does not begin; None if it does."""
        outcome, code = Outcome.REFUSED, "MALFORMED_CALL"
        if is_full:
            outcome, code, why = Outcome.FAILED, "BUSY", "Too many commands are waiting already."
        elif self._is_of_fleet:
            code, why = "NOT_ALONE", "The robots of a fleet take sentences, and no frames."
        elif not came_by_action(command.command_id):
            why = "The id of a called frame must not begin like that of a text."
        elif not 1 <= len(call.clauses) <= _MOST_FRAMES:
            why = f"A call has 1 to {_MOST_FRAMES} frames; this one has {len(call.clauses)}."
        elif call.plan.nodes:
            why = "Called frames are carried out one after the other; a call has no plan of its own."
        elif len(command.text) > self._settings.max_text_length:
            why = f"The text of a call has at most {self._settings.max_text_length} characters."
        else:
            return None
        return Ending(command, outcome, OWN_STAGE, code, why)
