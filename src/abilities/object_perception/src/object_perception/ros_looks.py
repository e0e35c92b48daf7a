"""What the perceivers share: transforms of the time of a look, what the world knows, and what it is told."""

import threading
import time
from dataclasses import dataclass
from typing import Any, Callable, List, Sequence, Tuple

import rospy
import tf2_ros
from roboframenet_msgs.msg import World, WorldUpdate

from object_perception.beliefs import Beliefs, BeliefSettings, Sighting
from object_perception.camera import View
from object_perception.geometry import Transform
from object_perception.pending import Pending
from roboframenet_ros.health import Health
from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_node import StartError, read_parameters
from roboframenet_ros.ros_publishing import publish
from world_model.knowledge import Update
from world_model.ros_messages import object_to_message, world_from_message

#: How often a transform that is not there yet is asked for, seconds.
_AGAIN_S = 0.02
#: How often the worker looks for what is old, and whether ROS shuts down, seconds.
_PERIOD_S = 0.5
_MOST_PENDING = 100
#: What one look shows, once it is known where the frame of the message and the sensor were.
Reading = Callable[[Transform, Transform], Tuple[List[Sighting], View]]


@dataclass(frozen=True)
class LookSettings(Parameters):
    """Parameters of all perceivers that concern ROS, after validation.

    Attributes:
        transform_wait_s: a look waits so long for the transform of its time, seconds

    Raises:
        ParameterError: the value is not allowed
    """

    transform_wait_s: float = parameter(2.0, least=0.0, most=60.0)


@dataclass(frozen=True)
class _Look:
    frame_id: str
    sensor_frame: str
    stamp: rospy.Time
    reading: Reading


class Looks:
    """Turns looks of a sensor into updates of the world, in a thread of its own.

    Subscribes:
        world (World), /tf, /tf_static
    Publishes:
        world_updates (WorldUpdate)
    """

    def __init__(self) -> None:
        """
        Raises:
            ParameterError: a parameter is wrong
        """
        settings = read_parameters(LookSettings)
        self._beliefs_settings = read_parameters(BeliefSettings)
        self._beliefs = Beliefs(self._beliefs_settings, rospy.get_name().strip("/"))
        self._pending: Pending[_Look] = Pending(most=_MOST_PENDING, wait_s=settings.transform_wait_s)
        self._changed = threading.Condition()
        self._taken, self._late = 0, 0
        self._transforms = tf2_ros.Buffer()
        self._listener = tf2_ros.TransformListener(self._transforms)
        self._updates = rospy.Publisher("world_updates", WorldUpdate, queue_size=100)
        self._thread = threading.Thread(target=self._run, name="looks", daemon=True)
        rospy.on_shutdown(self._close)

    @property
    def world_frame(self) -> str:
        """The frame in which things are told."""
        return self._beliefs_settings.world_frame

    def start(self) -> None:
        """Begin; what the world knows is taken first."""
        self._subscriber = rospy.Subscriber("world", World, self._on_world, queue_size=1)
        self._thread.start()

    def add(self, header: Any, reading: Reading, *, frame_id: str = "", sensor_frame: str = "") -> None:
        """Take a look.

        Args:
            header: of its message
            reading: what it shows
            frame_id: the frame of what it shows, if it is not that of the header
            sensor_frame: that of the sensor, if it is another one
        """
        frame_id = (frame_id or header.frame_id).lstrip("/")
        look = _Look(frame_id, sensor_frame.lstrip("/") or frame_id, header.stamp, reading)
        with self._changed:
            self._pending.put(look, time.monotonic())
            self._changed.notify_all()

    def health(self) -> Health:
        """How the node is."""
        with self._changed:
            values = {"looks": self._taken, "without a transform": self._late, "dropped": self._pending.dropped}
        return Health(values=values)

    def _on_world(self, message: World) -> None:
        known = world_from_message(message)
        with self._changed:
            self._tell(self._beliefs.know(known.objects))

    def _run(self) -> None:
        while not rospy.is_shutdown():
            with self._changed:
                look = self._pending.first()
                if look is None:
                    self._changed.wait(_PERIOD_S)
                    self._tell(self._beliefs.pass_time(rospy.Time.now().to_sec()))
                    continue
                is_done = self._take(look)
                if is_done:
                    self._pending.done()
                else:
                    self._changed.wait(_AGAIN_S)

    def _take(self, look: _Look) -> bool:
        """Take the oldest look; returns whether it is done with. Called with the lock."""
        try:
            place = self._place_of(look.frame_id, look.stamp)
            sensor = place if look.sensor_frame == look.frame_id else self._place_of(look.sensor_frame, look.stamp)
        except tf2_ros.TransformException as error:
            if not self._pending.is_late(time.monotonic()):
                return False
            self._late += 1
            rospy.logwarn_throttle(5.0, f"a look from {look.frame_id!r} is left out: {error}")
            return True
        sightings, view = look.reading(place, sensor)
        self._taken += 1
        self._tell(self._beliefs.see(sightings, view, (look.stamp or rospy.Time.now()).to_sec()))
        return True

    def _place_of(self, frame_id: str, stamp: rospy.Time) -> Transform:
        """Return where a frame was in the world; tf itself is not asked to wait, as ROS time may stand still.

        Raises:
            TransformException: it is not known, or not yet
        """
        if frame_id == self.world_frame:
            return Transform()
        found = self._transforms.lookup_transform_core(self.world_frame, frame_id, stamp).transform
        position, turn = found.translation, found.rotation
        return Transform((position.x, position.y, position.z), (turn.x, turn.y, turn.z, turn.w))

    def _tell(self, update: Update) -> None:
        if update.objects or update.missing or update.gone:
            objects = [object_to_message(one) for one in update.objects]
            publish(self._updates, WorldUpdate(objects, False, list(update.missing), list(update.gone)))

    def _close(self) -> None:
        with self._changed:
            self._changed.notify_all()
        if self._thread.is_alive():
            self._thread.join(2.0)


class Perceiver:
    """What the nodes have in common: their looks, and how they are."""

    def __init__(self) -> None:
        """
        Raises:
            ParameterError: a parameter is wrong
        """
        self._looks = Looks()

    def health(self) -> Health:
        """How the node is."""
        return self._looks.health()


def check_labels(labels: Sequence[str]) -> None:
    """Check that the classes of a detector have names.

    Raises:
        StartError: there are no labels
    """
    if not labels:
        raise StartError("~labels is empty: it lists the names of the classes of the detector")


def transform_of(pose: Any) -> Transform:
    """Convert a geometry_msgs/Pose."""
    position, turn = pose.position, pose.orientation
    return Transform((position.x, position.y, position.z), (turn.x, turn.y, turn.z, turn.w))
