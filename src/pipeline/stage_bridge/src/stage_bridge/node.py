"""The node that stands where one of our stages would, and asks a program of 2012 in its place."""

import queue
import time
from dataclasses import dataclass
from typing import Any, Tuple

import rospy
from roboframenet_msgs.msg import Command, FrameServers, Reply

from roboframenet_ros.health import Health
from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_hand_over import HandOver
from roboframenet_ros.ros_node import read_parameters, run_node
from roboframenet_ros.ros_stage import Stage
from stage_bridge.ros_bridged import BRIDGED, Outside, command_in
from stage_bridge.ros_conversion import NoAnswer, NotIn2012, Registered, WrongAnswer, registered_in
from stage_bridge.turns import Turns

#: How often the loop looks whether ROS shuts down, seconds.
_LOOK_S = 0.2


@dataclass(frozen=True)
class Settings(Parameters):
    """Private parameters, checked.

    Attributes:
        outside: the stage that is outside
        answer_timeout_s: how long it may take to answer; less than the deadline of a stage in command_server
        most_waiting: commands that may wait for their turn
    """

    outside: Outside = parameter(Outside.FRAMER)
    answer_timeout_s: float = parameter(5.0, least=0.1, most=15.0)
    most_waiting: int = parameter(20, least=1, most=1000)


class StageBridge:
    """Asks the stage outside for one command after the other.

    Subscribes:
        ``outside/...``: what our stage before it publishes, and the answers of the stage outside; ``frame_servers``
    Publishes:
        ``outside/...``: what the stage outside is asked; what our next stage hears; ``stage_events``
    Parameters: see :class:`Settings`.
    """

    def __init__(self, settings: Settings) -> None:
        self._settings = settings
        self._bridged = BRIDGED[settings.outside]
        self._turns: Turns[Any] = Turns(answer_timeout_s=settings.answer_timeout_s, most_waiting=settings.most_waiting)
        self._registered: Registered = frozenset()
        self._inbox: queue.Queue[Tuple[bool, Any]] = queue.Queue()
        self._stage = Stage(self._bridged.stage)
        self._told = HandOver(self._bridged.told, self._bridged.told_type)
        self._asked = rospy.Publisher(f"outside/{self._bridged.asked}", self._bridged.asked_type, queue_size=100)
        self._subscribers = [
            rospy.Subscriber("frame_servers", FrameServers, self._on_servers, queue_size=1),
            rospy.Subscriber(
                f"outside/{self._bridged.answers}",
                self._bridged.answers_type,
                lambda message: self._inbox.put((True, message)),
                queue_size=100,
            ),
            rospy.Subscriber(
                f"outside/{self._bridged.heard}",
                self._bridged.heard_type,
                lambda message: self._inbox.put((False, message)),
                queue_size=100,
            ),
        ]
        rospy.loginfo("ready: %s is outside", settings.outside.value)

    def health(self) -> Health:
        """How the node is."""
        return Health(values={"outside": self._settings.outside.value, "listens": self._asked.get_num_connections()})

    def run(self) -> None:
        """Pass commands and answers on until ROS shuts down."""
        while not rospy.is_shutdown():
            rest_s = self._turns.rest_s(time.monotonic())
            try:
                is_answer, message = self._inbox.get(timeout=_LOOK_S if rest_s is None else min(rest_s, _LOOK_S))
            except queue.Empty:
                pass
            else:
                self._take_answer(message) if is_answer else self._take_command(message)
            for late in self._turns.silent(time.monotonic()):
                self._end(command_in(late), Reply.FAILED, "STAGE_SILENT", self._silence())
            self._ask_next()

    def _on_servers(self, message: FrameServers) -> None:
        self._registered = registered_in(message)

    def _silence(self) -> str:
        name, limit = self._settings.outside.value, f"{self._settings.answer_timeout_s:g} s"
        if self._asked.get_num_connections() == 0:
            return f"Nobody listens to {self._asked.resolved_name}: the {name} outside does not run."
        return f"The {name} outside did not answer within {limit}."

    def _take_command(self, message: Any) -> None:
        if not self._turns.come(message):
            most = self._settings.most_waiting
            self._end(command_in(message), Reply.FAILED, "TOO_MANY", f"{most} commands wait for the stage outside.")

    def _ask_next(self) -> None:
        while True:
            message = self._turns.next(time.monotonic())
            if message is None:
                return
            try:
                question = self._bridged.question(message)
            except NotIn2012 as reason:
                self._turns.answered()
                self._end(command_in(message), Reply.REFUSED, "NOT_IN_2012", str(reason))
                continue
            self._asked.publish(question)
            return

    def _take_answer(self, answer: Any) -> None:
        message = self._turns.answered()
        if message is None:
            rospy.logwarn_throttle(10.0, "an answer that nobody asked for is dropped")
            return
        command = command_in(message)
        try:
            told = self._bridged.outcome(message, answer, self._registered)
        except NoAnswer as reason:
            self._end(command, Reply.REFUSED, "NO_READING", str(reason))
        except WrongAnswer as reason:
            name = self._settings.outside.value
            self._end(command, Reply.FAILED, "STAGE_ERROR", f"The {name} outside gave a wrong answer: {reason}.")
        else:
            self._told.publish(told)
            self._stage.passes_on(command, f"answered by the {self._settings.outside.value} outside")

    def _end(self, command: Command, outcome: int, code: str, sentence: str) -> None:
        rospy.loginfo("cmd=%s ends here: %s", command.id, sentence)
        self._stage.ends(command, outcome=outcome, code=code, sentence=sentence)


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("stage_bridge", lambda: StageBridge(read_parameters(Settings)), work=lambda bridge: bridge.run())
