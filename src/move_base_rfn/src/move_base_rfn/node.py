"""Goes to places: an RFNServer in front of ``move_base``."""

import rospy
from actionlib_msgs.msg import GoalStatus
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from rfnserver import RFNServer
from rfnserver.arguments import argument
from rfnserver.ros_goal_forwarding import ForwardingDeadlines, GoalForwarder
from rfnserver.ros_places import Places, UnknownPlace
from roboframenet_msgs.msg import FilledSemanticFrame, FilledSemanticFrameFeedback


class NavigationServer:
    """Forwards a place to move_base.

    Actions:
        navigation (roboframenet_msgs/FilledSemanticFrameAction): frame navigating_to_location
        move_base (move_base_msgs/MoveBaseAction): client
    Subscribes:
        locations (roboframenet_msgs/Locations)
    Parameters:
        ~move_base_timeout_s (float, default 5, seconds): how long to wait for move_base to be there
        ~goal_timeout_s (float, default 300, seconds): how long a drive may take
        ~preempt_timeout_s (float, default 5, seconds): how long move_base may take to stop
    """

    def __init__(self, parameters: str = "~") -> None:
        """
        Args:
            parameters: what stands before the names of its parameters
        """
        deadlines = ForwardingDeadlines(
            server_s=float(rospy.get_param(parameters + "move_base_timeout_s", 5.0)),
            goal_s=float(rospy.get_param(parameters + "goal_timeout_s", 300.0)),
            preempt_s=float(rospy.get_param(parameters + "preempt_timeout_s", 5.0)),
        )
        self._places = Places()
        self._forwarder = GoalForwarder("move_base", MoveBaseAction, deadlines)
        self._server = RFNServer("navigation", self._on_frame)
        self._server.register_with_frame("navigating_to_location")
        self._server.start()

    def _on_frame(self, frame: FilledSemanticFrame) -> None:
        words = argument(frame, "goal")
        try:
            pose = self._places.locate(words)
        except UnknownPlace as reason:
            self._server.set_aborted(None, str(reason))
            return
        end = self._forwarder.carry_out(
            MoveBaseGoal(target_pose=pose),
            is_to_end=self._server.is_preempt_requested,
            on_feedback=lambda _: self._server.publish_feedback(FilledSemanticFrameFeedback(is_succeeding=True)),
        )
        if end.status == GoalStatus.PREEMPTED:
            self._server.set_preempted(None, f"I was interrupted on my way to {words}.")
        elif end.status != GoalStatus.SUCCEEDED:
            self._server.set_aborted(None, f"I could not reach {words}: {end.text}")


def main() -> None:
    """Run the node."""
    rospy.init_node("move_base_rfn")
    NavigationServer()
    rospy.spin()
