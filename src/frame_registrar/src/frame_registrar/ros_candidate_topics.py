"""The topics on which plans go on: questions are answered beside what the robot does, and preempt nothing."""

from typing import Any, Callable

from roboframenet_msgs.msg import CommandPlan, CommandSemanticFrames

from roboframenet_ros.ros_hand_over import HandOver
from roboframenet_ros.ros_robots import OfEachRobot, topic_of


class CandidateTopics:
    """Publishes each plan on the topic of what it is about, in the namespace of the robot of its command.

    Publishes:
        command_semantic_frames (CommandSemanticFrames), command_question (CommandPlan)
    """

    def __init__(self, is_question: Callable[[str], bool]) -> None:
        """
        Args:
            is_question: whether a frame is a question
        """
        self._is_question = is_question
        self._candidates: OfEachRobot[HandOver] = OfEachRobot(
            lambda robot: HandOver(topic_of(robot, "command_semantic_frames"), CommandSemanticFrames)
        )
        self._questions: OfEachRobot[HandOver] = OfEachRobot(
            lambda robot: HandOver(topic_of(robot, "command_question"), CommandPlan)
        )
        self.prepare("")

    def prepare(self, robot: str) -> None:
        """Advertise the topics of a robot that takes part."""
        self._candidates.get(robot)
        self._questions.get(robot)

    def publish(self, message: CommandSemanticFrames) -> None:
        """Publish a plan: as a question if all of its frames are questions."""
        names = {
            frame.name for node in message.plan.nodes for candidate in node.candidates for frame in candidate.frames
        }
        if names and all(map(self._is_question, names)):
            _publish(self._questions, message.command.robot, CommandPlan(command=message.command, plan=message.plan))
        else:
            _publish(self._candidates, message.command.robot, message)


def _publish(topics: OfEachRobot[HandOver], robot: str, message: Any) -> None:
    topic = topics.get(robot)
    if topic is not None:
        topic.publish(message)
