"""Refuses goals, called frames and standing orders that ``rosbag play`` repeats beside the robot."""

import actionlib
import rospy
from roboframenet_msgs.msg import Command, CommandLexicalUnits, OrderDue, StageEvent

from command_server.open_commands import OWN_STAGE, CommandText, Ending, Outcome
from command_server.ros_messages import ending_of_event
from command_server.ros_replies import Replies
from command_server.settings import Settings
from roboframenet_ros.command_ids import TextIds, TextSource
from roboframenet_ros.replays import AGAIN, OLDEST_NS, Replays
from roboframenet_ros.ros_replays import REPLAYED, GoalsOnce
from roboframenet_ros.ros_robots import own_robot


class Replayed:
    """Takes each goal, each call of a frame and each order that is due once. One thread owns it."""

    def __init__(self, replies: Replies, settings: Settings) -> None:
        """
        Args:
            replies: tells the refusals, each under an id of its own: the command may have had its one reply
            settings: of the node
        """
        #: A goal that took longer comes late, seconds.
        self.longest_delay_s = settings.longest_delay_s if own_robot() else OLDEST_NS / 1e9
        self._replies = replies
        self._goals, self._orders, self._calls = GoalsOnce(), Replays(), Replays()
        self._ids = TextIds(TextSource.REPLAYED)

    def tells(self, event: StageEvent) -> bool:
        """Tell what a stage refuses, if it does so because of a recording; returns whether that is so."""
        is_replayed = bool(event.is_final and event.reply.code == REPLAYED)
        if is_replayed:
            self._replies.tell(ending_of_event(event))
        return is_replayed

    def refuses_goal(self, handle: actionlib.ServerGoalHandle) -> bool:
        """Take a goal, or refuse one that was taken; one that is only old is answered as any other that comes late."""
        is_refused = self._goals.refuses(handle)
        if is_refused:
            self._tell(handle.get_goal().text, handle.get_goal_id().stamp, AGAIN)
        return is_refused

    def refuses_order(self, due: OrderDue) -> bool:
        """Take an order that is due, or refuse it."""
        if due.not_done:
            return False
        return self._refuses(due.command, self._orders)

    def refuses_call(self, call: CommandLexicalUnits) -> bool:
        """Take a call of a frame, or refuse it."""
        return self._refuses(call.command, self._calls)

    def _refuses(self, command: Command, taken: Replays) -> bool:
        why = taken.refusal(command.id, stamp_ns=command.stamp.to_nsec(), now_ns=rospy.Time.now().to_nsec())
        if why:
            self._tell(command.text, command.stamp, why)
        return bool(why)

    def _tell(self, text: str, stamp: rospy.Time, why: str) -> None:
        command = CommandText(self._ids.next_id(), stamp.to_nsec(), text)
        self._replies.tell(Ending(command, Outcome.REFUSED, OWN_STAGE, REPLAYED, why))
