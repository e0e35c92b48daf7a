"""Parameters of the node."""

from dataclasses import dataclass
from typing import Tuple

from roboframenet_ros.parameters import Parameters, parameter


@dataclass(frozen=True)
class Settings(Parameters):
    """Private parameters, checked.

    Attributes:
        address: where the page is offered
        port: its port; when it is taken, one of the next nine
        token_file: file with a secret that a browser must know; empty for none
        host_names: names by which other machines call this one
        max_text_length: longest sentence, characters
        niceness: how much less processor time than the stages the node gets when it is scarce, as of nice(1)
        path_topics: topics of nav_msgs/Path that are drawn
        conversations_file: where past conversations are kept; empty for ``conversations.sqlite`` in the ROS home folder

    Raises:
        ParameterError: a value out of its range
    """

    address: str = parameter("127.0.0.1", may_be_empty=False)
    port: int = parameter(8080, least=0, most=65535)
    token_file: str = parameter("")
    host_names: Tuple[str, ...] = parameter((), may_be_single=True)
    max_text_length: int = parameter(1000, least=1, most=4000)
    niceness: int = parameter(5, least=0, most=19)
    conversations_file: str = parameter("")
    path_topics: Tuple[str, ...] = parameter(
        ("move_base/plan", "move_base/NavfnROS/plan", "move_base/GlobalPlanner/plan"), may_be_single=True
    )
