#!/usr/bin/python3
"""``rfn doctor --robot`` beside a robot that has what it needs, and beside one on which much is wrong."""

import os
import subprocess
import sys
import tempfile
import time
import unittest
from typing import Dict, List, Tuple

import rospy
import rostest
from std_srvs.srv import Trigger

from location_memorizer.locations import read_locations

#: Subject, what is found, and how to mend it, for each thing that is wrong.
WRONG = (
    ("network", "nodes on camera.invalid do not answer: /lost_camera", "rosnode cleanup"),
    ("time", "/planner publishes /clock", "rosparam set /use_sim_time true"),
    ("simulator", "/turtlebot_sim runs beside /wrong_base", "sim:=false"),
    ("base", "/wrong_base listens to /cmd_vel, and gets nothing", "convert geometry_msgs/Twist"),
    ("stop", "/planner drives /wheels on /nav_vel", "~velocity_topics of stop_server"),
    ("stop", "does not cancel the goals of /arm_controller", "~also_cancel of stop_server"),
    ("stop", "the emergency stop holds", "Release the emergency stop."),
    ("odometry", "/odom: the stamps are 60", "chrony"),
    ("localisation", "no pose on /amcl_pose yet", "initialpose"),
    ("tf", "base_link has 2 parents", "let one node publish it"),
    ("tf", "no way from map to base_link", "localisation"),
    ("places", "the robot knows none", "This is the kitchen."),
    ("binding", "there is no action /move_base", "move_base.yaml:"),
    ("limits", "spoken motions reach 0.45 m/s, and /planner/DWAPlannerROS/max_vel_x is 0.2 m/s", "~quick_share"),
)
SUBJECTS = {subject for subject, _, _ in WRONG}


def doctor() -> Tuple[List[str], int]:
    """Return the findings, each with its advice, and the exit status."""
    ended = subprocess.run(
        ["rfn", "doctor", "--robot"], capture_output=True, text=True, timeout=120, check=False, stdin=subprocess.DEVNULL
    )
    sys.stderr.write(ended.stdout + ended.stderr)
    return ended.stdout.replace("\n" + " " * 24, " ").splitlines(), ended.returncode


def place(*words: str) -> "subprocess.CompletedProcess[str]":
    return subprocess.run(["rfn", "place", *words], capture_output=True, text=True, timeout=120, check=False)


def wait_for_nodes(*topics: str) -> None:
    """Wait until every topic is published, and a moment for the connections."""
    end_s = time.monotonic() + 60.0
    while time.monotonic() < end_s:
        if set(topics) <= {name for name, _ in rospy.get_published_topics()}:
            break
        time.sleep(0.1)
    time.sleep(2.0)


class Wrong(unittest.TestCase):
    def test_each_thing_is_named_with_the_way_to_mend_it(self) -> None:
        wait_for_nodes("/odom", "/nav_vel", "/locations", "/arm_controller/status", "/image")
        rospy.wait_for_service("emergency_stop/engage", 60.0)
        self.assertTrue(rospy.ServiceProxy("emergency_stop/engage", Trigger)().success)
        lines, status = doctor()
        self.assertEqual(1, status)
        for subject, found, mend in WRONG:
            (line,) = [one for one in lines if one.startswith(f"problem  {subject} ") and found in one]
            self.assertIn(mend, line.split("->")[1])
        others = [one for one in lines if one.startswith("problem") and one.split()[1] in SUBJECTS]
        self.assertEqual(len(WRONG), len(others), others)


class Sound(unittest.TestCase):
    def test_nothing_is_found(self) -> None:
        wait_for_nodes("/odom", "/amcl_pose", "/locations", "/move_base/status")
        lines, _ = doctor()
        of_robot: Dict[str, str] = {one.split()[1]: one for one in lines if one.split()[1] in SUBJECTS}
        self.assertEqual(
            {"network", "time", "base", "stop", "odometry", "localisation", "tf", "places", "binding", "limits"},
            set(of_robot),
        )
        self.assertEqual([], [one for one in of_robot.values() if one.startswith("problem")])

    def test_places_are_remembered_listed_and_written(self) -> None:
        wait_for_nodes("/amcl_pose", "/locations")
        self.assertEqual("This is the coffee corner.\n", place("coffee", "corner").stdout)
        self.assertEqual(["coffee corner", "kitchen"], [line[:20].strip() for line in place().stdout.splitlines()])
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "places.yaml")
            self.assertEqual(f"2 places in {path}\n", place("--out", path).stdout)
            places = read_locations(path)
        self.assertEqual({"coffee corner", "kitchen"}, set(places))
        kitchen = places["kitchen"]
        for found, expected in ((kitchen.x_m, 3.0), (kitchen.y_m, 1.5), (kitchen.heading_rad, 1.57)):
            self.assertAlmostEqual(expected, found, places=6)
        self.assertEqual(2, place("--out", "/proc/no/places.yaml").returncode)


if __name__ == "__main__":
    rospy.init_node("doctor_robot_test")
    rostest.rosrun("roboframenet_tools", "doctor_robot", {"Wrong": Wrong, "Sound": Sound}[sys.argv[1]], sys.argv)
