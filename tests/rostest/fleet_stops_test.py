#!/usr/bin/python3
"""Stop isolation: one of three moving robots is stopped, the others go on; and stops of all. Prints the figures."""

import time
import unittest
from typing import List

import rospy

from fleet_robots import ROBOTS, Robots


def share(values: List[float], part: float) -> float:
    """Return the value below which a share of the values lies."""
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(part * len(ordered)))]


class FleetStopsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        rospy.init_node("fleet_stops_test")
        cls.robots = Robots()
        cls.robots.wait_until_ready()

    def stop(self, text: str, stopped: List[str], *, to: str = "") -> float:
        """Stop robots; return how long the last of them moved on, seconds."""
        self.robots.all_move()
        said_s = time.monotonic()
        self.robots.say(text, to=to)
        self.assertTrue(self.robots.stand(tuple(stopped), 20.0), f"{text!r} {to}")
        others = [robot for robot in ROBOTS if robot not in stopped]
        for robot in others:
            self.assertGreater(self.robots.seen[robot].speed, 0.1, f"{text!r} stopped {robot} too")
        return max(self.robots.seen[robot].moved_s for robot in stopped) - said_s

    def test_1_stops_of_one(self) -> None:
        took_s: List[float] = []
        for number in range(int(rospy.get_param("~to_one", 2))):
            robot = ROBOTS[number % len(ROBOTS)]
            if number % 2:
                took_s.append(self.stop("Stop.", [robot], to=robot))
            else:
                took_s.append(self.stop(f"{robot.capitalize()}, stop.", [robot]))
        rospy.loginfo(
            "stops of one robot: %d of %d; it stood after %.2f s (median), %.2f s (99 %%), %.2f s (longest)",
            len(took_s),
            len(took_s),
            share(took_s, 0.5),
            share(took_s, 0.99),
            max(took_s),
        )

    def test_2_stops_of_all(self) -> None:
        took_s = [self.stop("Stop.", list(ROBOTS)) for _ in range(int(rospy.get_param("~to_all", 1)))]
        rospy.loginfo(
            "stops of all robots: %d of %d; the last stood after %.2f s (median), %.2f s (longest)",
            len(took_s),
            len(took_s),
            share(took_s, 0.5),
            max(took_s),
        )


if __name__ == "__main__":
    import rostest

    rostest.rosrun("roboframenet_tests", "fleet_stops_test", FleetStopsTest)
