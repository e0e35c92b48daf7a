"""RFNServers for the props: high five, low five, pound, hug, and an arm that is stretched out or taken back."""

import threading
from dataclasses import dataclass
from typing import Any, Callable, List, Mapping, Tuple

import rospkg
import rospy
import yaml

from pr2_props.named_arms import ARM_NOUNS, UnknownArm, named_arms
from pr2_props.props import PropError, read_limits, read_props
from pr2_props.ros_arms import ArmError, Arms
from rfnserver import RFNServer, TypedFrame
from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_node import StartError, read_parameters, run_node

#: Action names and frames; "high_five" is the action name of 2012.
SERVERS: Tuple[Tuple[str, str], ...] = (
    ("high_five", "high_fiving"),
    ("low_five", "low_fiving"),
    ("pound", "pounding"),
    ("hug", "hugging"),
    ("extend_arm", "extending_arm"),
    ("retract_arm", "retracting_arm"),
    ("wave", "waving"),
)
#: The arms do not see whom they greet, so they greet the speaker.
PARTNERS = ["me", "us"]
#: What the server of each frame heeds: "with your left hand".
_GREETING: Mapping[str, Any] = {"heeds": {"Instrument": ARM_NOUNS, "partner": PARTNERS}}
_LIMB: Mapping[str, Any] = {"heeds": {"limb": {"values": ARM_NOUNS, "most": 2}}}
STATEMENTS: Mapping[str, Mapping[str, Any]] = {
    "high_fiving": _GREETING,
    "low_fiving": _GREETING,
    "pounding": _GREETING,
    "hugging": {"heeds": {"partner": PARTNERS}},
    "extending_arm": {**_LIMB, "unheeded": ["goal"]},
    "retracting_arm": _LIMB,
    "waving": {"heeds": {"body_part": {"values": ARM_NOUNS, "most": 2}, "addressee": PARTNERS}},
}
#: Elements that name an arm; the extra-thematic one is in every frame.
_NAMING = ("limb", "body_part", "instrument")


@dataclass(frozen=True)
class Settings(Parameters):
    """Private parameters, checked.

    Attributes:
        props_file: trajectories; empty for ``config/props.yaml`` of the package
        limits_file: limits of the joints; empty for ``config/joint_limits.yaml`` of the package
        controller_timeout_s: how long to wait for a controller

    Raises:
        ParameterError: a value of another type
    """

    props_file: str = parameter("")
    limits_file: str = parameter("")
    controller_timeout_s: float = parameter(5.0)


class PropsServer:
    """One RFNServer for each prop, with one pair of arms for all.

    Actions:
        high_five, low_five, pound, hug, extend_arm, retract_arm, wave (roboframenet_msgs/FilledSemanticFrameAction)
    Parameters: see :class:`Settings`.
    """

    def __init__(self) -> None:
        """
        Raises:
            ParameterError: a parameter is wrong
            PropError, OSError: a file is wrong or cannot be read
        """
        settings = read_parameters(Settings)
        config = rospkg.RosPack().get_path("pr2_props") + "/config/"
        with open(settings.limits_file or config + "joint_limits.yaml", encoding="utf-8") as file:
            limits = read_limits(yaml.safe_load(file))
        with open(settings.props_file or config + "props.yaml", encoding="utf-8") as file:
            props = read_props(yaml.safe_load(file), limits)
        self._arms = Arms(props, limits, server_timeout_s=settings.controller_timeout_s)
        self._busy = threading.Lock()
        self._servers: List[RFNServer] = [self._serve(action, frame) for action, frame in SERVERS]

    def _serve(self, action: str, frame_name: str) -> RFNServer:
        def is_wanted() -> bool:
            return not (server.is_preempt_requested() or rospy.is_shutdown())

        def callback(frame: TypedFrame) -> None:
            try:
                arms = tuple(arm for name in _NAMING for arm in named_arms(frame[name]))
            except UnknownArm as error:
                server.set_aborted(None, str(error))
                return
            if not self._take_arms(is_wanted):
                server.set_preempted(None, "I had not begun.")
                return
            try:
                if not self._arms.perform(frame_name, arms, is_wanted=is_wanted):
                    server.set_preempted(None, "The arms are back.")
            except ArmError as error:
                server.set_aborted(None, f"My arms failed: {error}.")
            finally:
                self._busy.release()

        server = RFNServer(action, callback, occupies=["arms"], **STATEMENTS[frame_name])
        server.register_with_frame(frame_name)
        server.start()
        return server

    def _take_arms(self, is_wanted: Callable[[], bool]) -> bool:
        """Wait until another prop has moved the arms back; return whether the arms are free."""
        while is_wanted():
            if self._busy.acquire(timeout=0.1):
                return True
        return False


def _start() -> PropsServer:
    try:
        return PropsServer()
    except (PropError, OSError, KeyError) as error:
        raise StartError(str(error)) from error


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when it cannot start."""
    run_node("pr2_props", _start)
