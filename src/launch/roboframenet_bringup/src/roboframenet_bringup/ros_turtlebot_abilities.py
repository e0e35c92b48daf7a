"""The abilities of a Turtlebot in one process, for computers with little memory."""

from typing import Callable, Tuple

import condition_watchers.node
import move_action_server.node
import turtlebot_follower.node
from moo.node import MooServer
from rfnserver.node import PingServer
from roboframenet_ros.ros_node import HostedStage, run_stages
from roboframenet_ros.ros_place import Place
from utter.node import UtterServer


def _hosted(name: str, make: Callable[[str], object]) -> HostedStage:
    """Return a stage of a server that is made with the prefix of its parameters."""

    def start(place: Place) -> object:
        return make(place.private)

    return HostedStage(name, start)


#: What moves the robot starts first: it is what a person waits for.
ABILITIES: Tuple[HostedStage, ...] = (
    HostedStage("move_action_server", move_action_server.node.start),
    HostedStage("turtlebot_follower", turtlebot_follower.node.start),
    HostedStage("condition_watchers", condition_watchers.node.ConditionWatchers),
    _hosted("ping", lambda _: PingServer()),
    _hosted("utter", UtterServer),
    _hosted("moo", MooServer),
)


def main() -> None:
    """Run the abilities until ROS shuts down; exits with a sentence when one cannot start."""
    run_stages("turtlebot_abilities", ABILITIES)
