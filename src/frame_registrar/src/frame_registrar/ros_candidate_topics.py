"""The topics on which plans go on: questions are answered beside what the robot does, and preempt nothing."""

from typing import Callable

from roboframenet_msgs.msg import CommandPlan, CommandSemanticFrames

from roboframenet_ros.ros_hand_over import HandOver


class CandidateTopics:
    """Publishes each plan on the topic of what it is about.

    Publishes:
        command_semantic_frames (CommandSemanticFrames), command_question (CommandPlan)
    """

    def __init__(self, is_question: Callable[[str], bool]) -> None:
        """
        Args:
            is_question: whether a frame is a question
        """
        self._is_question = is_question
        self._candidates = HandOver("command_semantic_frames", CommandSemanticFrames)
        self._questions = HandOver("command_question", CommandPlan)

    def publish(self, message: CommandSemanticFrames) -> None:
        """Publish a plan: as a question if all of its frames are questions."""
        names = {
            frame.name for node in message.plan.nodes for candidate in node.candidates for frame in candidate.frames
        }
        if names and all(map(self._is_question, names)):
            self._questions.publish(CommandPlan(command=message.command, plan=message.plan))
        else:
            self._candidates.publish(message)
