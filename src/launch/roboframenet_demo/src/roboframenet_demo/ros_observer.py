"""Measures what a robot does, by its odometry and joints and by the texts that its servers publish."""

import json
import math
import threading
from typing import Any, Dict, List, Optional, Tuple

import rospy
from nav_msgs.msg import Odometry
from sensor_msgs.msg import JointState
from std_msgs.msg import String

from roboframenet_demo.script import Observation
from roboframenet_sim.home_truth import describe_changes

#: Below this speed the base stands still, in m/s and rad/s.
STILL = 0.01


class RobotObserver:
    """Measures what a robot did since the last ``begin()``.

    Subscribes:
        odom (nav_msgs/Odometry), joint_states (sensor_msgs/JointState), said, home/truth (std_msgs/String)
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._pose: Optional[Tuple[float, float, float]] = None
        self._start: Optional[Tuple[float, float, float]] = None
        self._turned_rad = 0.0
        self._driven_m = 0.0
        self._speed = 0.0
        self._joint_speed = 0.0
        self._joints: Dict[str, float] = {}
        self._start_joints: Dict[str, float] = {}
        self._arm_moved_rad = 0.0
        self._said: List[str] = []
        self._truth: Dict[str, Any] = {}
        self._start_truth: Dict[str, Any] = {}
        self._subscribers = [
            rospy.Subscriber("odom", Odometry, self._on_odometry, queue_size=200),
            rospy.Subscriber("joint_states", JointState, self._on_joints, queue_size=50),
            rospy.Subscriber("home/truth", String, self._on_truth, queue_size=1),
            rospy.Subscriber("said", String, self._on_said, queue_size=50),
        ]

    def close(self) -> None:
        """Unsubscribe from all topics."""
        for subscriber in self._subscribers:
            subscriber.unregister()

    def begin(self) -> None:
        """Start a new measurement."""
        with self._lock:
            self._start = self._pose
            self._start_joints = dict(self._joints)
            self._turned_rad = self._driven_m = self._arm_moved_rad = 0.0
            self._said = []
            self._start_truth = self._truth

    def is_moving(self) -> bool:
        """Whether the base moves now, or an arm has moved since ``begin()``."""
        with self._lock:
            return self._speed > STILL or self._arm_moved_rad > 0.05

    def observe(self) -> Observation:
        """Return the observation since ``begin()``."""
        with self._lock:
            start = self._start or (0.0, 0.0, 0.0)
            pose = self._pose or start
            moved_m = (pose[0] - start[0]) * math.cos(start[2]) + (pose[1] - start[1]) * math.sin(start[2])
            return Observation(
                turned_rad=self._turned_rad,
                moved_m=moved_m,
                driven_m=self._driven_m,
                position_m=pose[:2],
                arm_moved_rad=self._arm_moved_rad,
                arm_offset_rad=self._arm_offset_rad(),
                said=tuple(self._said),
                truth=self._truth,
                changed=describe_changes(self._start_truth, self._truth) if self._start_truth else "",
                is_still=max(self._speed, self._joint_speed) <= STILL,
            )

    def _arm_offset_rad(self) -> float:
        offsets = [
            abs(self._joints[name] - start) for name, start in self._start_joints.items() if name in self._joints
        ]
        return max(offsets, default=0.0)

    def _on_odometry(self, message: Odometry) -> None:
        orientation = message.pose.pose.orientation
        heading = 2.0 * math.atan2(orientation.z, orientation.w)
        pose = (message.pose.pose.position.x, message.pose.pose.position.y, heading)
        with self._lock:
            if self._pose is not None:
                turn = heading - self._pose[2]
                self._turned_rad += math.atan2(math.sin(turn), math.cos(turn))
                self._driven_m += math.hypot(pose[0] - self._pose[0], pose[1] - self._pose[1])
            self._pose = pose
            self._start = self._start or pose
            self._speed = max(abs(message.twist.twist.linear.x), abs(message.twist.twist.angular.z))

    def _on_joints(self, message: JointState) -> None:
        with self._lock:
            self._joint_speed = max((abs(speed) for speed in message.velocity), default=0.0)
            for name, position in zip(message.name, message.position):
                self._joints[name] = position
                start = self._start_joints.setdefault(name, position)
                self._arm_moved_rad = max(self._arm_moved_rad, abs(position - start))

    def _on_truth(self, message: String) -> None:
        truth = json.loads(message.data)["truth"]
        with self._lock:
            self._truth = truth

    def _on_said(self, message: String) -> None:
        with self._lock:
            self._said.append(message.data)
