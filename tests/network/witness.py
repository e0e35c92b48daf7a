"""Tells what a machine of the network hears, a line of JSON for each; says what is written to it.

It writes ``t``, seconds of the monotonic clock that all namespaces share, and one of ``reply``, ``members``, ``tried``
and ``moves``.
"""

import json
import sys
import threading
import time
from typing import List

import rospy
from nav_msgs.msg import Odometry
from roboframenet_msgs.msg import Fleet, FleetService, Reply, TriedFrame
from std_msgs.msg import String

#: Radians a second; slower is standing.
STANDING = 0.01


class Witness:
    """Hears the shared topics and those of one robot."""

    def __init__(self, robot: str) -> None:
        self._lock = threading.Lock()
        self._members: object = None
        self._names: List[str] = []
        self._is_up = False
        self._moves: object = None
        self.text = rospy.Publisher("text", String, queue_size=10)
        self.subscribers = [
            rospy.Subscriber("reply", Reply, self._hear_reply, queue_size=100),
            rospy.Subscriber("fleet", Fleet, self._hear_fleet, queue_size=10),
            rospy.Subscriber("fleet_service", FleetService, self._hear_service, queue_size=10),
            rospy.Subscriber(f"{robot}/tried_frames", TriedFrame, self._hear_tried, queue_size=100),
            rospy.Subscriber(f"{robot}/odom", Odometry, self._hear_odometry, queue_size=1),
        ]

    def tell(self, **what: object) -> None:
        """Write a line."""
        with self._lock:
            print(json.dumps({"t": time.monotonic(), **what}), flush=True)

    def _hear_reply(self, reply: Reply) -> None:
        self.tell(reply=reply.command.text, code=reply.code, sentence=reply.sentence)

    def _hear_fleet(self, fleet: Fleet) -> None:
        self._names = [robot.name for robot in fleet.robots]
        self._tell_members()

    def _hear_service(self, service: FleetService) -> None:
        self._is_up = service.is_up
        self._tell_members()

    def _tell_members(self) -> None:
        members = self._names if self._is_up else []
        if members != self._members:
            self._members = members
            self.tell(members=members)

    def _hear_tried(self, tried: TriedFrame) -> None:
        self.tell(tried=tried.command.text, id=tried.command.id)

    def _hear_odometry(self, odometry: Odometry) -> None:
        moves = abs(odometry.twist.twist.angular.z) > STANDING
        if moves != self._moves:
            self._moves = moves
            self.tell(moves=moves)


def main() -> None:
    """Run until the input ends."""
    rospy.init_node("witness", anonymous=True)
    witness = Witness(sys.argv[1])
    for line in sys.stdin:
        witness.text.publish(String(data=line.strip()))


main()
