"""The node home_servers: RFNServers for a robot in a home, one for each domain."""

from dataclasses import dataclass
from typing import List, Mapping

import rospy
from roboframenet_msgs.msg import FilledSemanticFrameResult
from std_msgs.msg import String

from home_servers.body import CannotDo, Interrupted
from home_servers.conditions import FRAMES as CONDITIONS
from home_servers.conditions import STATEMENTS as WATCHED
from home_servers.conditions import CannotTell, Conditions
from home_servers.frames import DOMAINS, STATEMENTS, WITHOUT_HANDS
from home_servers.ros_body import RosBody
from home_servers.skills import Skill, Skills
from rfnserver import ConditionServer, ConditionUnknown, Observed, RFNServer
from rfnserver.ros_typed_frame import TypedFrame
from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_node import read_parameters, run_node
from typed_arguments import FilledFrame

#: The robot perceives so often at least, seconds; what it has perceived for longer may be over.
_SIGHT_S = 4.0


@dataclass(frozen=True)
class Settings(Parameters):
    """Private parameters, checked.

    Attributes:
        speaker: id of the person who speaks to the robot ("me"), until the topic says another; empty: whom it has seen
            nearest
        has_hands: whether the robot has grippers; without them, frames that need them have no server
        left_out: frames that other servers of this robot carry out

    Raises:
        ParameterError: a value of another type
    """

    speaker: str = parameter("")
    has_hands: bool = parameter(True)
    left_out: str = parameter("")


class HomeServers:
    """One RFNServer for each domain, and one server that watches conditions, with one body for all.

    Actions:
        home_DOMAIN (roboframenet_msgs/FilledSemanticFrameAction), such as home_navigation; home_conditions
    Subscribes:
        speaker (std_msgs/String): the id of the person who speaks
    Parameters: see :class:`Settings`.
    """

    def __init__(self) -> None:
        """
        Raises:
            ParameterError: a parameter is wrong
        """
        self._settings = read_parameters(Settings)
        self._speaker = self._settings.speaker
        self._subscriber = rospy.Subscriber("speaker", String, self._on_speaker, queue_size=1)
        self._body = RosBody()
        left_out = set(self._settings.left_out.split())
        self._servers: List[RFNServer] = []
        for domain, skills in DOMAINS.items():
            mine = {
                frame: skill
                for frame, skill in skills.items()
                if frame not in left_out and (self._settings.has_hands or frame in WITHOUT_HANDS)
            }
            if mine:
                self._servers.append(self._serve(f"home_{domain}", mine))
        self._watch = ConditionServer("home_conditions", self._holds)
        self._body.listen(self._watch.changed)
        self._watch.start()
        for condition in CONDITIONS:
            self._watch.register_with_frame(condition, **WATCHED.get(condition, {}))

    def _on_speaker(self, message: String) -> None:
        self._speaker = message.data or self._settings.speaker

    def _holds(self, frame: TypedFrame) -> Observed:
        sight, stamp, age_s = self._body.sight()
        if age_s > _SIGHT_S:
            raise ConditionUnknown("my eyes tell nothing")
        try:
            holds = Conditions(self._body.memory, sight, speaker=self._speaker).holds(frame)
        except CannotTell as reason:
            raise ConditionUnknown(str(reason)) from reason
        return Observed.still(holds, stamp)

    def _serve(self, name: str, skills: Mapping[str, Skill]) -> RFNServer:
        def is_wanted() -> bool:
            return not (server.is_preempt_requested() or rospy.is_shutdown())

        def callback(frame: FilledFrame) -> None:
            mind = Skills(self._body, speaker=self._speaker)
            self._body.begin(is_wanted)
            filled = FilledFrame(frame.name, tuple(frame.arguments))
            try:
                skills[frame.name](mind, filled)
                mind.tidy()
                if mind.answers and is_wanted():
                    server.set_succeeded(FilledSemanticFrameResult(success=True), " ".join(mind.answers))
            except CannotDo as reason:
                server.set_aborted(FilledSemanticFrameResult(success=False), str(reason))
            except Interrupted:
                server.set_preempted(FilledSemanticFrameResult(success=False))
            finally:
                self._body.show_doing("")

        server = RFNServer(name, callback)
        for frame in skills:
            server.register_with_frame(frame, **STATEMENTS.get(frame, {}))
        server.start()
        return server


def main() -> None:
    """Run the node until ROS shuts down."""
    run_node("home_servers", HomeServers)
