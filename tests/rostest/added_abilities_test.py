#!/usr/bin/python3
"""A frame without a server is refused by name; when a server registers, the frame runs."""

import unittest
from typing import Dict, List

import rospy
from roboframenet_msgs.msg import Reply
from std_msgs.msg import String

from rfnserver import RFNServer
from roboframenet_demo.ros_pipeline import is_pipeline_complete
from roboframenet_testing import wait_until

SENTENCES = (
    ("Chop the cucumber.", "chopping", {"item": "the cucumber"}),
    ("Scrub the pot.", "scrubbing", {"object": "the pot"}),
    ("Fold the towel.", "folding", {"item": "the towel"}),
    ("Move the cup to the sink.", "placing", {"theme": "the cup", "goal": "the sink"}),
)


class AddedAbilitiesTest(unittest.TestCase):
    """The pipeline, and servers that are added one after the other."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.replies: List[Reply] = []
        cls.subscriber = rospy.Subscriber("reply", Reply, cls.replies.append, queue_size=100)
        cls.text = rospy.Publisher("text", String, queue_size=100)
        wait_until(lambda: cls.text.get_num_connections() >= 2, message="nobody listens to 'text'")
        wait_until(is_pipeline_complete, 120.0, "the pipeline did not come up")
        rospy.wait_for_service("register_with_frame", timeout=60.0)
        rospy.wait_for_service("add_lexical_unit", timeout=60.0)

    def say(self, text: str) -> Reply:
        since = len(self.replies)
        self.text.publish(String(data=text))
        wait_until(lambda: any(reply.command.text == text for reply in self.replies[since:]), message=text)
        return next(reply for reply in self.replies[since:] if reply.command.text == text)

    def test_each_runs_as_soon_as_a_server_registers(self) -> None:
        for text, frame_name, arguments in SENTENCES:
            refused = self.say(text)
            self.assertEqual((refused.outcome, refused.code), (Reply.REFUSED, "NO_SERVER"), refused.sentence)
            self.assertIn(frame_name, refused.sentence)
            seen: List[Dict[str, str]] = []
            server = RFNServer(
                f"test_{frame_name}",
                lambda frame, seen=seen: seen.append(
                    {element.name: element.argument for element in frame.frame_elements}
                ),
            )
            self.assertTrue(server.register_with_frame(frame_name))
            server.start()
            done = self.say(text)
            self.assertEqual(done.outcome, Reply.DONE, done.sentence)
            self.assertEqual(seen, [arguments])


if __name__ == "__main__":
    import rostest

    rospy.init_node("added_abilities_test")
    rostest.rosrun("roboframenet_tests", "added_abilities", AddedAbilitiesTest)
