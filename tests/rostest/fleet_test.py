#!/usr/bin/python3
"""Three robots with one language service: who acts, who stops, who is there, and what a robot does alone."""

import unittest
from typing import List

import rospy
from roboframenet_msgs.msg import Reply
from std_msgs.msg import Header

from fleet_robots import ROBOTS, Poses, Robots, kill
from roboframenet_testing import comes_true, wait_until


class FleetTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        rospy.init_node("fleet_test")
        cls.robots = Robots()
        cls.robots.wait_until_ready()

    def poses_at_rest(self) -> Poses:
        self.assertTrue(self.robots.stand(ROBOTS))
        return self.robots.turned()

    def assert_moves(self, text: str, *robots: str, to: str = "") -> Reply:
        before = self.poses_at_rest()
        reply = self.robots.ask(text, to=to)
        self.assertEqual((reply.outcome, reply.code), (Reply.DONE, "DONE"), reply.sentence)
        wait_until(lambda: self.robots.who_moved(before) == robots)
        return reply

    def test_1_who_is_addressed_acts(self) -> None:
        asked = self.robots.ask("Turn left 20 degrees.")
        self.assertEqual((asked.outcome, asked.code), (Reply.NEEDS_INFORMATION, "WHO"), asked.sentence)
        self.assert_moves("Beta.", "beta")
        self.assert_moves("Turn right 20 degrees.", "beta")
        reply = self.assert_moves("Alpha, turn left 20 degrees, and Gamma, turn right 20 degrees.", "alpha", "gamma")
        self.assertRegex(reply.sentence, r"^Alpha( and|: Done.*) Gamma: Done\.")
        self.assert_moves("Everybody but Gamma, turn left 20 degrees.", "alpha", "beta")
        self.assert_moves("Beta, turn left 20 degrees.", "beta")
        # What is said to a robot that is not here is done by none; the whole table is an acceptance test.
        for text, who in (
            ("Robot four, turn left 20 degrees.", "no robot four here"),
            ("Could you turn left 20 degrees, Luna?", "no robot called Luna here"),
            ("Alpha, turn left 20 degrees, and the fifth robot, turn right 20 degrees.", "no fifth robot here"),
        ):
            before = self.poses_at_rest()
            reply = self.robots.ask(text)
            self.assertEqual((reply.outcome, reply.code), (Reply.REFUSED, "UNKNOWN_ROBOT"), reply.sentence)
            self.assertIn(who, reply.sentence)
            self.assertTrue(self.robots.stand(ROBOTS))
            self.assertEqual(self.robots.who_moved(before), (), text)

    def test_2_the_topic_of_a_robot_speaks_to_it_alone(self) -> None:
        self.assert_moves("Turn left 20 degrees.", "gamma", to="gamma")
        before = self.poses_at_rest()
        reply = self.robots.ask("Beta, turn left 20 degrees.", to="gamma")
        self.assertEqual((reply.outcome, reply.code), (Reply.REFUSED, "NOT_ADDRESSED"), reply.sentence)
        self.assertEqual(self.robots.who_moved(before), ())

    def test_3_a_stop_stops_whom_it_is_for(self) -> None:
        for text, to, stopped, told in (
            ("Stop.", "alpha", ("alpha",), "Stopped"),
            ("Beta, stop.", "", ("beta",), "Beta: Stopped"),
            ("Stop gamma.", "", ("gamma",), "Gamma: Stopped"),
            ("Alpha has to stop now.", "", ("alpha",), "Alpha: Stopped"),
            ("Alpha, stop Gamma.", "", ("alpha", "gamma"), "Alpha and Gamma: Stopped"),
            ("Robot four, stop.", "", ROBOTS, "There is no robot four here"),
            ("Stop.", "", ROBOTS, "Alpha, Beta and Gamma: Stopped"),
        ):
            self.robots.all_move()
            reply = self.robots.ask(text, to=to)
            self.assertEqual(reply.code, "DONE", reply.sentence)
            self.assertIn(told, reply.sentence)
            self.assertTrue(self.robots.stand(stopped), text)
            others = [robot for robot in ROBOTS if robot not in stopped]
            for robot in others:
                # A machine under load may hold a robot up for a moment, and it goes on; what was stopped stands.
                wait_until(lambda robot=robot: self.robots.seen[robot].speed > 0.1, 10.0, f"{text} stopped {robot}")

    def test_3b_an_emergency_stop_holds_whom_it_is_for(self) -> None:
        self.robots.all_move()
        reply = self.robots.ask("Alpha, emergency stop.")
        self.assertIn("has held since", reply.sentence)
        self.assertTrue(self.robots.stand(("alpha",)))
        self.robots.ask("Beta and Gamma, stop.")
        before = self.poses_at_rest()
        for text, to in (("Alpha, turn left 20 degrees.", ""), ("Turn left 20 degrees.", "alpha")):
            reply = self.robots.ask(text, to=to)
            self.assertEqual((reply.outcome, reply.code), (Reply.REFUSED, "EMERGENCY_STOP"), reply.sentence)
        self.assertEqual(self.robots.who_moved(before), ())
        self.assert_moves("Beta and Gamma, turn left 20 degrees.", "beta", "gamma")
        reply = self.robots.ask("Emergency stop.")
        self.assertEqual(reply.code, "DONE", reply.sentence)
        before = self.poses_at_rest()
        self.robots.ask("Everybody, turn left 20 degrees.")
        self.assertEqual(self.robots.who_moved(before), ())
        # It was refused once by one of three robots; the sentences say why, should it never be taken.
        said = []
        wait_until(lambda: self.is_released(said), 30.0, lambda: str(said))
        self.assert_moves("Everybody, turn left 20 degrees.", *ROBOTS)

    def is_released(self, said: List[str]) -> bool:
        reply = self.robots.ask("Everybody, release the emergency stop.")
        said.append(reply.sentence)
        return reply.code == "DONE"

    def test_4_each_robot_keeps_its_standing_orders(self) -> None:
        def waits_for(text: str) -> str:
            return self.robots.ask(text).sentence

        bell = rospy.Publisher("bell", Header, queue_size=5)
        wait_until(lambda: bell.get_num_connections() >= len(ROBOTS))
        for text in (
            "Alpha, whenever the bell rings, turn left 20 degrees.",
            "Whenever the bell rings, Beta, turn right 20 degrees.",
            "Everybody, turn left 20 degrees at noon.",
        ):
            reply = self.robots.ask(text)
            self.assertEqual(reply.code, "DONE", reply.sentence)
        self.assertEqual(waits_for("Gamma, what are you waiting for?").count("I will"), 1)
        self.assertIn("turn right 20 degrees whenever the bell rings", waits_for("Beta, what are you waiting for?"))
        for text, robots in ((None, ("alpha", "beta")), ("Alpha, forget the bell.", ("beta",))):
            if text is not None:
                self.assertIn("Alpha: I forget", self.robots.ask(text).sentence)
            before = self.robots.turned()
            bell.publish(Header(stamp=rospy.Time.now()))
            wait_until(lambda before=before, robots=robots: self.robots.who_moved(before) == robots)
            wait_until(lambda: self.robots.stand(ROBOTS))
        self.robots.ask("Everybody, forget noon.")
        self.robots.ask("Beta, forget the bell.")
        answer = waits_for("Everybody, what are you waiting for?")
        self.assertEqual(answer, "Alpha, Beta and Gamma: I have no standing order.")
        for turn in range(5):
            self.robots.ask("Everybody, turn left 20 degrees at noon.")
            self.robots.ask("Everybody, forget everything.")
            answer = waits_for("Everybody, what are you waiting for?")
            self.assertEqual(answer, "Alpha, Beta and Gamma: I have no standing order.", f"turn {turn}")
        # What Alpha is to pass on waits for the bell with Beta, and is answered when it is done.
        text = "Alpha, when the bell rings, tell Beta to turn left 20 degrees."
        before, replies = self.robots.turned(), len(self.robots.replies)
        self.robots.say(text)

        def has_turned() -> bool:
            bell.publish(Header(stamp=rospy.Time.now()))
            return self.robots.who_moved(before) == ("beta",)

        wait_until(has_turned)
        wait_until(lambda: [reply.code for reply in self.robots.replies[replies:]] == ["DONE"])

    def test_5_a_robot_that_dies_has_left(self) -> None:
        kill("gamma/robot")
        wait_until(lambda: self.robots.members() == ("alpha", "beta"))
        reply = self.robots.ask("Gamma, turn left.")
        self.assertEqual((reply.outcome, reply.sentence), (Reply.REFUSED, "Gamma is not here."))
        self.assert_moves("Both of you, turn left 20 degrees.", "alpha", "beta")
        self.assert_moves("Everybody but Gamma, turn right 20 degrees.", "alpha", "beta")

    def test_6_without_the_service_each_robot_follows_its_policy(self) -> None:
        """Alpha is to stop and go home, beta to finish: see fleet.test."""
        self.robots.say("Everybody, turn left 3600 degrees.")
        wait_until(lambda: all(self.robots.seen[robot].speed > 0.1 for robot in ("alpha", "beta")))
        kill("fleet")
        self.assertTrue(self.robots.stand(("alpha",), 30.0))
        stood = self.robots.turned()
        wait_until(lambda: "alpha" in self.robots.who_moved(stood))
        self.assertTrue(self.robots.stand(("alpha",), 30.0))
        self.assertGreater(self.robots.seen["beta"].speed, 0.1)
        self.robots.say("Stop.")
        self.assertTrue(comes_true(lambda: self.robots.stand(("beta",), 1.0), 20.0))


if __name__ == "__main__":
    import rostest

    rostest.rosrun("roboframenet_tests", "fleet_test", FleetTest)
