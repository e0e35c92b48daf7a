#!/usr/bin/python3
"""A question that comes before the world: the answer waits for what is known."""

import unittest
from typing import List

import rospy
from roboframenet_msgs.msg import (
    Command,
    CommandPlan,
    FilledSemanticFrame,
    Plan,
    PlanCandidate,
    PlanNode,
    StageEvent,
    World,
    WorldObject,
    WorldRelation,
)

from roboframenet_testing import wait_until


def question(command_id: str) -> CommandPlan:
    """ "Where are you?" """
    frame = FilledSemanticFrame(name="question_of_own_place", action_server_topics=["question_answering"])
    node = PlanNode(kind=PlanNode.DO, label="where are you", candidates=[PlanCandidate(frames=[frame], coverage=1.0)])
    return CommandPlan(
        command=Command(id=command_id, text="Where are you?", stamp=rospy.Time.now()), plan=Plan(nodes=[node])
    )


class LateWorldTest(unittest.TestCase):
    def test_answer_waits_for_the_world(self) -> None:
        events: List[StageEvent] = []
        subscriber = rospy.Subscriber("stage_events", StageEvent, events.append)
        questions = rospy.Publisher("command_question", CommandPlan, queue_size=5)
        worlds = rospy.Publisher("world", World, queue_size=1)
        wait_until(
            lambda: all(one.get_num_connections() for one in (subscriber, questions, worlds)),
            message=lambda: "question_answering is not connected",
        )
        questions.publish(question("first"))
        # Longer than the wait for the status, which never comes here.
        rospy.sleep(0.7)
        self.assertEqual(events, [])
        worlds.publish(
            World(
                version="test-1",
                objects=[
                    WorldObject(id="kitchen", sort=WorldObject.PLACE, name="kitchen"),
                    WorldObject(id="robot", sort=WorldObject.ROBOT, relations=[WorldRelation("in", "kitchen")]),
                ],
            )
        )
        wait_until(lambda: events)
        self.assertEqual(events[0].reply.sentence, "I am in the kitchen.")


if __name__ == "__main__":
    import rostest

    rospy.init_node("late_world_test")
    rostest.rosrun("question_answering", "late_world_test", LateWorldTest)
