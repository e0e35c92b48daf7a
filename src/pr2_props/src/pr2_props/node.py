"""RFNServers for the props: high five, low five, pound and hug."""

import threading
from typing import Callable, List, Tuple

import rospkg
import rospy
import yaml
from roboframenet_msgs.msg import FilledSemanticFrame

from pr2_props.props import PropError, read_limits, read_props
from pr2_props.ros_arms import ArmError, Arms
from rfnserver import RFNServer

#: Action names and frames; "high_five" is the action name of 2012.
SERVERS: Tuple[Tuple[str, str], ...] = (
    ("high_five", "high_fiving"),
    ("low_five", "low_fiving"),
    ("pound", "pounding"),
    ("hug", "hugging"),
)


class PropsServer:
    """One RFNServer for each prop, with one pair of arms for all.

    Actions:
        high_five, low_five, pound, hug (roboframenet_msgs/FilledSemanticFrameAction)
    Parameters:
        ~props_file (string, default config/props.yaml of the package): trajectories
        ~limits_file (string, default config/joint_limits.yaml of the package): limits of the joints
        ~controller_timeout_s (float, default 5, seconds): how long to wait for a controller
    """

    def __init__(self) -> None:
        """
        Raises:
            PropError, OSError: a file is wrong or cannot be read
        """
        config = rospkg.RosPack().get_path("pr2_props") + "/config/"
        with open(rospy.get_param("~limits_file", config + "joint_limits.yaml"), encoding="utf-8") as file:
            limits = read_limits(yaml.safe_load(file))
        with open(rospy.get_param("~props_file", config + "props.yaml"), encoding="utf-8") as file:
            props = read_props(yaml.safe_load(file), limits)
        self._arms = Arms(props, limits, server_timeout_s=float(rospy.get_param("~controller_timeout_s", 5.0)))
        self._busy = threading.Lock()
        self._servers: List[RFNServer] = [self._serve(action, frame) for action, frame in SERVERS]

    def _serve(self, action: str, frame_name: str) -> RFNServer:
        def is_wanted() -> bool:
            return not (server.is_preempt_requested() or rospy.is_shutdown())

        def callback(_frame: FilledSemanticFrame) -> None:
            if not self._take_arms(is_wanted):
                server.set_preempted(None, "I was interrupted before I began.")
                return
            try:
                if not self._arms.perform(frame_name, is_wanted=is_wanted):
                    server.set_preempted(None, "I was interrupted; the arms are back.")
            except ArmError as error:
                server.set_aborted(None, f"My arms failed: {error}.")
            finally:
                self._busy.release()

        server = RFNServer(action, callback)
        server.register_with_frame(frame_name)
        server.start()
        return server

    def _take_arms(self, is_wanted: Callable[[], bool]) -> bool:
        """Wait until another prop has moved the arms back; return whether the arms are free."""
        while is_wanted():
            if self._busy.acquire(timeout=0.1):
                return True
        return False


def main() -> None:
    """Run the node."""
    rospy.init_node("pr2_props")
    try:
        PropsServer()
    except (PropError, OSError, KeyError) as error:
        rospy.logfatal("pr2_props cannot start: %s", error)
        raise SystemExit(1) from error
    rospy.spin()
