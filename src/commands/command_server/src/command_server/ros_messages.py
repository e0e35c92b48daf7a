"""Converts commands and endings between messages and values."""

from dataclasses import replace

import rospy
from roboframenet_msgs.msg import Command, OrderDue, Reply, StageEvent

from command_server.open_commands import STOP_STAGE, CommandText, Ending, Outcome
from roboframenet_ros.bounded_text import one_line


def time_from_ns(stamp_ns: int) -> rospy.Time:
    """Convert nanoseconds to ROS time."""
    return rospy.Time(secs=stamp_ns // 1_000_000_000, nsecs=stamp_ns % 1_000_000_000)


def command_from_message(message: Command) -> CommandText:
    """Turn a message into a value."""
    return CommandText(command_id=message.id, stamp_ns=message.stamp.to_nsec(), text=message.text)


def command_to_message(command: CommandText, *, robot: str = "") -> Command:
    """Turn a value into a message, for a robot of a fleet or for the only one."""
    return Command(id=command.command_id, stamp=time_from_ns(command.stamp_ns), text=command.text, robot=robot)


def ending_from_message(message: Reply) -> Ending:
    """Turn a message into a value.

    Raises:
        ValueError: no such outcome
    """
    return Ending(
        command=command_from_message(message.command),
        outcome=Outcome(message.outcome),
        stage=message.stage,
        code=message.code,
        sentence=message.sentence,
    )


def ending_of_event(event: StageEvent) -> Ending:
    """Return how the final event of a stage ended a command; a malformed reply ends it too."""
    # The event names its command; a reply that names another one by mistake must not end that.
    command = command_from_message(event.command)
    try:
        return replace(ending_from_message(event.reply), command=command)
    except ValueError as error:
        return Ending(
            command=command,
            outcome=Outcome.FAILED,
            stage=event.stage,
            code="STAGE_ERROR",
            sentence=f"{event.stage} ended it with a malformed reply: {error}.",
        )


def due_from_message(message: OrderDue) -> CommandText:
    """Turn the command of a standing order into a value."""
    return replace(command_from_message(message.command), order=message.order)


def ending_to_message(ending: Ending) -> Reply:
    """Turn a value into a message, stamped now."""
    return Reply(
        command=command_to_message(ending.command),
        outcome=int(ending.outcome),
        stage=ending.stage,
        code=ending.code,
        sentence=one_line(ending.reply),
        stamp=rospy.Time.now(),
    )


def reply_of_stopped(command_id: str) -> Reply:
    """Return the reply to a stop that was answered before it arrived here."""
    return Reply(
        command=Command(id=command_id),
        outcome=Reply.DONE,
        stage=STOP_STAGE,
        code="DONE",
        sentence="Stopped.",
        stamp=rospy.Time.now(),
    )
