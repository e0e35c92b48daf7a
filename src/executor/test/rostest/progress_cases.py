"""What is seen of a command while it runs: its events, and its machine in a viewer."""

import rospy
from executor_case import ExecutorCase, frame
from smach_msgs.msg import SmachContainerStructure

from roboframenet_testing import wait_until


class ProgressCases(ExecutorCase):
    """What others see."""

    def test_events_come_while_it_runs(self):
        command = self.send([[frame("run", "one")]])
        wait_until(
            lambda: len([event for event in self.events_of(command, False) if event.sentence.startswith("Doing ")]) >= 4
        )
        stamps = [event.stamp.to_sec() for event in self.events_of(command, False)]
        self.assertEqual(sorted(stamps), stamps)
        self.cancels.publish(command)
        self.wait_for_reply(command)

    def test_viewer_sees_the_words_of_the_clauses(self):
        seen = {}
        viewer = rospy.Subscriber(
            "executor/smach/container_structure",
            SmachContainerStructure,
            lambda structure: seen.update({structure.path: structure.children}),
        )
        command = self.send_clauses(("Ping", [[frame("run", "one")]]), ("wave at Alice", [[frame("succeed", "two")]]))
        wait_until(lambda: "/do it all/2 wave at Alice/candidate_1" in seen, message=lambda: seen)
        self.assertEqual(["1 Ping", "2 wave at Alice"], seen["/do it all"])
        self.assertEqual(["1_succeed_by_two"], seen["/do it all/2 wave at Alice/candidate_1"])
        self.cancels.publish(command)
        self.wait_for_reply(command)
        viewer.unregister()

    def test_viewer_stays_connected_from_one_machine_to_the_next(self):
        seen = set()
        viewer = rospy.Subscriber(
            "executor/smach/container_structure", SmachContainerStructure, lambda structure: seen.add(structure.path)
        )
        # Nothing runs yet.
        wait_until(lambda: viewer.get_num_connections() > 0)
        for words in ("Ping", "wave at Alice"):
            command = self.send_clauses((words, [[frame("run", "one")]]), ("go home", [[frame("succeed", "two")]]))
            wait_until(lambda words=words: f"/do it all/1 {words}/candidate_1" in seen, message=lambda: seen)
            self.cancels.publish(command)
            self.wait_for_reply(command)
            self.assertGreater(viewer.get_num_connections(), 0)
        viewer.unregister()
