#!/usr/bin/python3
"""The addressed sentences of robot_fleet, said to three robots: who turns, who stops, and what the reply says.

The parameter ~fleet says of which robots: "names" or "numbers". The table says what must happen.
"""

import math
import re
import unittest
from pathlib import Path
from typing import Dict, List, Tuple

import rospkg
import rospy
from roboframenet_msgs.msg import Reply

from fleet_robots import Poses, Robots
from roboframenet_testing import comes_true

FLEETS = {"names": ("alpha", "beta", "gamma"), "numbers": ("robot_one", "robot_two", "robot_three")}
#: So far may a turn be from what was said, degrees, and a place from where the robot stood, metres.
_DEGREES, _METRES = 4.0, 0.02
_STOP_S, _REPLY_S = 8.0, 4.0
_WANTED = re.compile(r"(\w+) ([+-]\d+)")
Row = Tuple[str, ...]


def rows_of(fleet: str) -> List[Row]:
    """Return the rows of the table for a fleet."""
    table = Path(rospkg.RosPack().get_path("robot_fleet")) / "test/unit/hundred_addressed.tsv"
    rows = [tuple(line.split("\t")) for line in table.read_text().splitlines() if not line.startswith("#")]
    return [row for row in rows if row[0] == fleet]


def turned(before: Poses, after: Poses) -> Dict[str, float]:
    """Return by how many degrees each robot has turned, left is positive; one that has driven has turned by nan."""
    found = {}
    for robot, (x, y, z, w) in after.items():
        x_then, y_then, z_then, w_then = before[robot]
        degrees = math.degrees(2.0 * (math.atan2(z, w) - math.atan2(z_then, w_then)))
        found[robot] = math.nan if math.hypot(x - x_then, y - y_then) > _METRES else (degrees + 180.0) % 360.0 - 180.0
    return found


class FleetHundredTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        rospy.init_node("fleet_hundred_test")
        cls.fleet = str(rospy.get_param("~fleet", "names"))
        cls.robots = Robots(FLEETS[cls.fleet])
        cls.robots.wait_until_ready()

    def speak_to_first(self) -> None:
        if not all(map(self.robots.stands, self.robots.names)):
            # A stop of before may still cancel what begins now.
            self.robots.ask("Stop.")
            self.assertTrue(self.robots.stand(self.robots.names, 20.0))
        first = self.robots.names[0].replace("_", " ")
        reply = self.robots.ask(f"{first}, turn left 5 degrees.")
        self.assertEqual(reply.code, "DONE", reply.sentence)
        self.assertTrue(self.robots.stand(self.robots.names, 20.0))

    def do(self, row: Row) -> Tuple[str, Reply]:
        """Say what is to be done; return what is wrong, empty for nothing, and the reply."""
        _, _, said, who, _ = row
        self.speak_to_first()
        before = self.robots.turned()
        reply = self.robots.ask(said)
        self.robots.stand(self.robots.names, 20.0)
        wanted = dict.fromkeys(self.robots.names, 0.0)
        nobody = dict(wanted)
        wanted.update({robot: float(degrees) for robot, degrees in _WANTED.findall(who)})
        found = turned(before, self.robots.turned())

        def is_near(those: Dict[str, float]) -> bool:
            return all(abs(found[robot] - those[robot]) <= _DEGREES for robot in those)

        is_asked = reply.outcome in (Reply.REFUSED, Reply.NEEDS_INFORMATION) and who.startswith("?")
        is_right = is_near(wanted) or (is_asked and is_near(nobody))
        moved = ", ".join(f"{robot} {degrees:+.0f}" for robot, degrees in found.items() if not abs(degrees) <= _DEGREES)
        return "" if is_right else f"moved: {moved or 'nobody'}", reply

    def stop(self, row: Row) -> Tuple[str, Reply]:
        """Say what stops robots that turn; return what is wrong, and the reply."""
        _, _, said, who, _ = row
        self.speak_to_first()
        self.robots.all_move()
        must = {robot.strip() for robot in who.rstrip("+").split(",")}
        replies = len(self.robots.replies)

        def answers() -> List[Reply]:
            return [reply for reply in self.robots.replies[replies:] if reply.command.text == said]

        self.robots.say(said)
        wrong = "" if self.robots.stand(tuple(must), _STOP_S) else "missed"
        others = [robot for robot in self.robots.names if robot not in must]
        if not who.endswith("+") and not all(self.robots.seen[robot].speed > 0.1 for robot in others):
            wrong = f"{wrong} stopped others".strip()
        if not comes_true(lambda: bool(answers()), _REPLY_S):
            # What else was said goes on.
            self.robots.say("Stop.")
        self.assertTrue(comes_true(lambda: bool(answers()), 20.0), f"no reply: {said}")
        return wrong, answers()[0]

    def test_hundred(self) -> None:
        wrong: List[str] = []
        rows = rows_of(self.fleet)
        for row in rows:
            _, kind, said, _, told = row
            fault, reply = self.stop(row) if kind.startswith("stop") else self.do(row)
            untold = [words for words in told.split("; ") if words.lower() not in reply.sentence.lower()]
            fault = "; ".join(filter(None, [fault, f"not told: {untold}" if untold else ""]))
            rospy.loginfo(
                "%s %s -> %s: %s %s", kind, said, reply.code, reply.sentence, f"WRONG {fault}" if fault else ""
            )
            if fault:
                wrong.append(f"{said}: {fault}: {reply.code} {reply.sentence}")
        stops = [row for row in rows if row[1].startswith("stop")]
        rospy.loginfo("%s: %d of %d right, %d of them stops", self.fleet, len(rows) - len(wrong), len(rows), len(stops))
        self.assertEqual(wrong, [])


if __name__ == "__main__":
    import rostest

    rostest.rosrun("roboframenet_tests", "fleet_hundred_test", FleetHundredTest)
