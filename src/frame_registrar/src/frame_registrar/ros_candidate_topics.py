"""The topics on which plans go on: questions are answered beside what the robot does, and preempt nothing."""

import copy
from typing import Any, Callable, Optional

from roboframenet_msgs.msg import CommandPlan, CommandSemanticFrames, Plan, PlanCandidate

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

    def publish(self, message: CommandSemanticFrames) -> bool:
        """Publish a plan: as a question if all that it most likely means are questions.

        Returns:
            False, and nothing is published, when it is a question and no node answers questions
        """
        question = question_of(message.plan, self._is_question)
        if question is not None:
            topic = self._questions.get(message.command.robot)
            if topic is not None and not topic.is_read:
                return False
            _publish(self._questions, message.command.robot, CommandPlan(command=message.command, plan=question))
        else:
            _publish(self._candidates, message.command.robot, message)
        return True


def question_of(plan: Plan, is_question: Callable[[str], bool]) -> Optional[Plan]:
    """Return a plan without what is no question; None if the likeliest reading of a clause is none.

    "I am Anna" says who speaks, and less likely of what kind somebody is.
    """
    clauses = [node for node in plan.nodes if node.candidates]
    for node in clauses:
        best = min(candidate.preference for candidate in node.candidates)
        likeliest = [candidate for candidate in node.candidates if candidate.preference == best]
        if not all(_asks(candidate, is_question) for candidate in likeliest):
            return None
    if not clauses:
        return None
    question = copy.deepcopy(plan)
    for node in question.nodes:
        node.candidates = [candidate for candidate in node.candidates if _asks(candidate, is_question)]
    return question


def _asks(candidate: PlanCandidate, is_question: Callable[[str], bool]) -> bool:
    return all(is_question(frame.name) for frame in candidate.frames)


def _publish(topics: OfEachRobot[HandOver], robot: str, message: Any) -> None:
    topic = topics.get(robot)
    if topic is not None:
        topic.publish(message)
