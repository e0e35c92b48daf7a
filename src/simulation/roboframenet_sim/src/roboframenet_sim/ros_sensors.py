"""The laser and the battery of a simulated robot."""

import math
import threading
from typing import Callable, Sequence, Tuple

import numpy as np
import rospy
from sensor_msgs.msg import BatteryState, LaserScan
from std_msgs.msg import Float32, Header

from roboframenet_ros.ros_publishing import publish
from roboframenet_sim.base import Pose
from roboframenet_sim.laser import angles, scan
from roboframenet_sim.point_cloud import Cylinder

_RAYS = 181
_LEAST_M, _MOST_M = 0.05, 8.0
_SCAN_PERIOD_S = 0.1
_BATTERY_PERIOD_S = 0.5

#: Walls, and persons.
Sight = Callable[[], Tuple[np.ndarray, Sequence[Cylinder]]]


class RosLaser:
    """A laser in the middle of the robot, looking ahead.

    Publishes:
        ``scan`` (sensor_msgs/LaserScan), while there are subscribers
    """

    def __init__(self, sight: Sight, *, frame: str = "base_link", topic: str = "scan") -> None:
        """
        Args:
            sight: returns what there is to be seen
            frame: of the laser
            topic: where it publishes
        """
        self._sight = sight
        self._frame = frame
        self._angles = angles(_RAYS)
        self._since_s = math.inf
        self._publisher = rospy.Publisher(topic, LaserScan, queue_size=1)

    def step(self, duration_s: float, stamp: rospy.Time, *, robot: Pose) -> None:
        """Advance the time.

        Args:
            duration_s: duration of the step in seconds
            stamp: stamp of the messages
            robot: present pose of the robot
        """
        self._since_s += duration_s
        if self._since_s + 1e-9 < _SCAN_PERIOD_S:
            return
        self._since_s = 0.0
        if not self._publisher.get_num_connections():
            return
        walls, persons = self._sight()
        ranges = scan(robot, self._angles, walls=walls, cylinders=persons, farthest_m=_MOST_M)
        publish(
            self._publisher,
            LaserScan(
                header=Header(stamp=stamp, frame_id=self._frame),
                angle_min=float(self._angles[0]),
                angle_max=float(self._angles[-1]),
                angle_increment=float(self._angles[1] - self._angles[0]),
                range_min=_LEAST_M,
                range_max=_MOST_M,
                ranges=ranges.tolist(),
            ),
        )


class RosBattery:
    """A battery.

    Subscribes:
        ``battery/charge`` (std_msgs/Float32): the charge from now on, 0 to 1; for tests
    Publishes:
        ``battery_state`` (sensor_msgs/BatteryState)
    """

    def __init__(
        self, charge: float, on_charge: Callable[[float], None] = lambda charge: None, *, space: str = ""
    ) -> None:
        """
        Args:
            charge: the first one, 0 to 1
            on_charge: called when somebody sets it
            space: before the names of its topics
        """
        self._lock = threading.Lock()
        self._charge, self._on_charge = charge, on_charge
        self._since_s = math.inf
        self._publisher = rospy.Publisher(f"{space}battery_state", BatteryState, queue_size=1)
        self._subscriber = rospy.Subscriber(f"{space}battery/charge", Float32, self._set, queue_size=5)

    def _set(self, message: Float32) -> None:
        if not 0.0 <= message.data <= 1.0:
            rospy.logwarn("battery/charge: %g; expected 0 to 1", message.data)
            return
        with self._lock:
            self._charge = message.data
            self._since_s = math.inf
        self._on_charge(message.data)

    def step(self, duration_s: float, stamp: rospy.Time, *, charge: float = math.nan) -> None:
        """Advance the time.

        Args:
            duration_s: duration of the step in seconds
            stamp: stamp of the messages
            charge: the present one; not a number if it is as before
        """
        with self._lock:
            if not math.isnan(charge):
                self._charge = charge
            self._since_s += duration_s
            if self._since_s + 1e-9 < _BATTERY_PERIOD_S:
                return
            self._since_s = 0.0
            now = self._charge
        if self._publisher.get_num_connections():
            message = BatteryState(header=Header(stamp=stamp), percentage=now, present=True)
            message.power_supply_status = BatteryState.POWER_SUPPLY_STATUS_UNKNOWN
            publish(self._publisher, message)
