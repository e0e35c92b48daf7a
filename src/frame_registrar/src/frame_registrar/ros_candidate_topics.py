"""The topics on which plans go on: questions are answered beside what the robot does, and preempt nothing."""

from typing import Callable

from roboframenet_msgs.msg import CommandPlan, CommandSemanticFrames

from roboframenet_ros.ros_robots import PublisherOfEachRobot


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
        self._candidates = PublisherOfEachRobot("command_semantic_frames", CommandSemanticFrames, queue_size=100)
        self._questions = PublisherOfEachRobot("command_question", CommandPlan, queue_size=100)

    def prepare(self, robot: str) -> None:
        """Advertise the topics of a robot that has registered a server."""
        self._candidates.prepare(robot)
        self._questions.prepare(robot)

    def publish(self, message: CommandSemanticFrames) -> None:
        """Publish a plan: as a question if all of its frames are questions."""
        names = {
            frame.name for node in message.plan.nodes for candidate in node.candidates for frame in candidate.frames
        }
        if names and all(map(self._is_question, names)):
            self._questions.publish(message.command.robot, CommandPlan(command=message.command, plan=message.plan))
        else:
            self._candidates.publish(message.command.robot, message)
