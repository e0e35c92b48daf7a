"""Commands and endings between messages and values."""

from dataclasses import replace

import rospy
from roboframenet_msgs.msg import Command, Reply, StageEvent

from command_server.open_commands import STOP_STAGE, CommandText, Ending, Outcome


def time_from_ns(stamp_ns: int) -> rospy.Time:
    """ROS time from nanoseconds."""
    return rospy.Time(secs=stamp_ns // 1_000_000_000, nsecs=stamp_ns % 1_000_000_000)


def command_from_message(message: Command) -> CommandText:
    """Turn a message into a value."""
    return CommandText(command_id=message.id, stamp_ns=message.stamp.to_nsec(), text=message.text)


def command_to_message(command: CommandText) -> Command:
    """Turn a value into a message."""
    return Command(id=command.command_id, stamp=time_from_ns(command.stamp_ns), text=command.text)


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
    """How a stage ended a command, by its final event; a reply that nobody can read ends it as well."""
    # The event says which command it is about; a reply that was filled in carelessly must not end another.
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


def ending_to_message(ending: Ending) -> Reply:
    """Turn a value into a message, stamped now."""
    return Reply(
        command=command_to_message(ending.command),
        outcome=int(ending.outcome),
        stage=ending.stage,
        code=ending.code,
        sentence=ending.sentence,
        stamp=rospy.Time.now(),
    )


def reply_of_stopped(command_id: str) -> Reply:
    """The reply to a stop that was answered before it was heard here."""
    return Reply(
        command=Command(id=command_id),
        outcome=Reply.DONE,
        stage=STOP_STAGE,
        code="DONE",
        sentence="Stopped.",
        stamp=rospy.Time.now(),
    )
