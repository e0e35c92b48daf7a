"""Parameters of the two nodes."""

from dataclasses import dataclass
from typing import Mapping, Tuple

from roboframenet_ros.parameters import Parameters, parameter
from robot_fleet.loss import Policy


@dataclass(frozen=True)
class FleetSettings(Parameters):
    """Private parameters of the node ``fleet``, checked.

    Attributes:
        member_silence_s: a robot that is silent for longer has left
        dialogue_timeout_s: how long the robot that was last spoken to is meant
        answer_timeout_s: how long the answer to "Who should do that?" is waited for
        connection_timeout_s: how long a robot may take to be connected before it counts as gone
        delivery_timeout_s: what a robot that is gone has not begun after this time is answered as lost, and after twice
            the time if it is there; longer than `longest_delay_s` of the robots, which refuse what reaches them later

    Raises:
        ParameterError: a value out of its range
    """

    member_silence_s: float = parameter(1.5, least=0.2, most=60.0)
    dialogue_timeout_s: float = parameter(600.0, least=1.0, most=86_400.0)
    answer_timeout_s: float = parameter(60.0, least=1.0, most=3600.0)
    connection_timeout_s: float = parameter(3.0, least=0.1, most=60.0)
    delivery_timeout_s: float = parameter(3.5, least=0.1, most=60.0)


@dataclass(frozen=True)
class MemberSettings(Parameters):
    """Private parameters of the node ``fleet_member``, checked.

    Attributes:
        spoken_names: what people call the robot, beside its name
        period_s: from one sign of life to the next
        on_loss: what the robot does when it no longer hears the language service
        silence_s: after this time without the service it is lost
        home_server: action server of frames that brings the robot home, for on_loss go_home
        home_frame: the frame that it is sent
        home_elements: "name: words" of the elements of that frame
        home_delay_s: from the stop to the way home

    Raises:
        ParameterError: a value out of its range
    """

    spoken_names: Tuple[str, ...] = parameter((), may_be_single=True)
    period_s: float = parameter(0.5, least=0.05, most=10.0)
    on_loss: Policy = parameter(Policy.FINISH)
    silence_s: float = parameter(5.0, least=0.5, most=3600.0)
    home_server: str = parameter("")
    home_frame: str = parameter("")
    home_elements: Tuple[str, ...] = parameter((), may_be_single=True)
    home_delay_s: float = parameter(1.5, least=0.0, most=60.0)

    @property
    def elements(self) -> Mapping[str, str]:
        """The elements of the frame, by name."""
        pairs = (element.partition(":") for element in self.home_elements)
        return {name.strip(): words.strip() for name, _, words in pairs}
