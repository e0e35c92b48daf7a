"""Commands and endings between messages and values."""
import rospy
from roboframenet_msgs.msg import Command, Reply

from command_server.command_book import CommandText, Ending, Outcome


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
    return Ending(command=command_from_message(message.command), outcome=Outcome(message.outcome),
                  stage=message.stage, code=message.code, sentence=message.sentence)


def ending_to_message(ending: Ending) -> Reply:
    """Turn a value into a message, stamped now."""
    return Reply(command=command_to_message(ending.command), outcome=int(ending.outcome), stage=ending.stage,
                 code=ending.code, sentence=ending.sentence, stamp=rospy.Time.now())
