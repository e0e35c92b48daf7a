"""Goes to places: an RFNServer in front of ``move_base``."""
import queue
import threading
import time
from typing import Dict

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped
from location_memorizer.msg import Locations
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from rfnserver import RFNServer
from roboframenet_msgs.msg import FilledSemanticFrame, FilledSemanticFrameFeedback

from move_base_rfn.destination import UnknownPlace, destination_name

#: How often a running goal looks whether it is to end, seconds.
POLL_S = 0.1


class NavigationServer:
    """Forwards a place to move_base.

    Actions:
        navigation (roboframenet_msgs/FilledSemanticFrameAction): frame navigating_to_location
        move_base (move_base_msgs/MoveBaseAction): client
    Subscribes:
        locations (location_memorizer/Locations)
    Parameters:
        ~move_base_timeout_s (float, default 5, seconds): how long to wait for move_base to be there
        ~goal_timeout_s (float, default 300, seconds): how long a drive may take
        ~preempt_timeout_s (float, default 5, seconds): how long move_base may take to stop
    """

    def __init__(self) -> None:
        self._move_base_timeout_s = float(rospy.get_param("~move_base_timeout_s", 5.0))
        self._goal_timeout_s = float(rospy.get_param("~goal_timeout_s", 300.0))
        self._preempt_timeout_s = float(rospy.get_param("~preempt_timeout_s", 5.0))
        self._lock = threading.Lock()
        self._places: Dict[str, PoseStamped] = {}
        self._subscriber = rospy.Subscriber("locations", Locations, self._on_locations, queue_size=1)
        self._client = actionlib.ActionClient("move_base", MoveBaseAction)
        self._server = RFNServer("navigation", self._on_frame)
        self._server.register_with_frame("navigating_to_location")
        self._server.start()

    def _on_locations(self, message: Locations) -> None:
        with self._lock:
            self._places = dict(zip(message.names, message.poses))

    def _on_frame(self, frame: FilledSemanticFrame) -> None:
        words = next((element.argument for element in frame.frame_elements if element.name == "goal"), "")
        with self._lock:
            places = dict(self._places)
        try:
            name = destination_name(words, places)
        except UnknownPlace as reason:
            self._server.set_aborted(None, str(reason))
            return
        if not self._client.wait_for_server(rospy.Duration(self._move_base_timeout_s)):
            self._server.set_aborted(None, f"move_base is not there (waited {self._move_base_timeout_s:g} s).")
            return
        pose = places[name]
        pose.header.stamp = rospy.Time.now()
        self._drive(name, pose)

    def _drive(self, name: str, pose: PoseStamped) -> None:
        ended: "queue.Queue[actionlib.ClientGoalHandle]" = queue.Queue()

        def on_transition(handle: actionlib.ClientGoalHandle) -> None:
            if handle.get_comm_state() == actionlib.CommState.DONE:
                ended.put(handle)

        def on_feedback(_handle: actionlib.ClientGoalHandle, _feedback: object) -> None:
            self._server.publish_feedback(FilledSemanticFrameFeedback(is_succeeding=True))

        # actionlib keeps a weak reference to the handle only.
        handle = self._client.send_goal(MoveBaseGoal(target_pose=pose), on_transition, on_feedback)
        end = time.monotonic() + self._goal_timeout_s
        while not rospy.is_shutdown():
            try:
                ended.get(timeout=POLL_S)
            except queue.Empty:
                if self._server.is_preempt_requested():
                    self._cancel(handle, ended)
                    self._server.set_preempted(None, f"I was interrupted on my way to {name}.")
                    return
                if time.monotonic() >= end:
                    self._cancel(handle, ended)
                    self._server.set_aborted(None, f"I did not reach {name} within {self._goal_timeout_s:g} s.")
                    return
                continue
            if handle.get_goal_status() != GoalStatus.SUCCEEDED:
                reason = handle.get_goal_status_text() or actionlib.TerminalState.to_string(handle.get_terminal_state())
                self._server.set_aborted(None, f"I could not reach {name}: {reason}")
            return
        self._cancel(handle, ended)

    def _cancel(self, handle: actionlib.ClientGoalHandle, ended: "queue.Queue[actionlib.ClientGoalHandle]") -> None:
        """Stop move_base and wait until it says so: only then the base stands still."""
        handle.cancel()
        try:
            ended.get(timeout=self._preempt_timeout_s)
        except queue.Empty:
            rospy.logerr("move_base did not stop within %g s", self._preempt_timeout_s)


def main() -> None:
    """Run the node."""
    rospy.init_node("move_base_rfn")
    NavigationServer()
    rospy.spin()
