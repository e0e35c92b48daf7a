"""The node condition_watchers: servers that watch what every robot with a laser, ears or a clock can tell."""

import enum
import threading
import time
from dataclasses import dataclass
from datetime import datetime
from typing import Any, Callable, Dict, List, Mapping, Optional, Tuple

import rospy
from geometry_msgs.msg import PoseWithCovarianceStamped
from roboframenet_msgs.msg import Reply
from sensor_msgs.msg import LaserScan
from std_msgs.msg import String

from condition_watchers import surroundings
from condition_watchers.hearing import MOMENT_S, Saying, Sayings, clock_shows
from condition_watchers.laser import Scan
from condition_watchers.places import HEREABOUTS_M, is_near
from condition_watchers.surroundings import Reach, Surroundings
from condition_watchers.words import robots, words
from frame_bindings.node import Bound, bound_servers
from rfnserver import ConditionServer, ConditionUnknown, Observed
from rfnserver.places import UnknownPlace
from rfnserver.ros_places import Places
from rfnserver.ros_typed_frame import TypedFrame
from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_node import StartError, read_parameters, run_node
from roboframenet_ros.ros_place import Place

#: Frames, with what a server states about each.
Statements = Mapping[str, Mapping[str, Any]]


class Watcher(enum.Enum):
    """What the node can watch."""

    SURROUNDINGS = "surroundings"
    PLACES = "places"
    SPEECH = "speech"
    COMMANDS = "commands"
    CLOCK = "clock"


@dataclass(frozen=True)
class Settings(Parameters):
    """Private parameters, checked.

    Attributes:
        watch: what is watched
        files: binding files with more conditions
        sight_m, person_m, blocked_m, contact_m: see :class:`condition_watchers.surroundings.Reach`
        tells_persons: whether what is as wide as a person counts as one
        scan_timeout_s: silence after which the laser is dead
        knows_names: whether `heard` says who speaks

    Raises:
        ParameterError: a value out of its range
    """

    watch: Tuple[str, ...] = parameter(tuple(one.value for one in Watcher), may_be_single=True)
    files: Tuple[str, ...] = parameter((), may_be_single=True)
    sight_m: float = parameter(Reach.sight_m, above=0.0)
    person_m: float = parameter(Reach.person_m, above=0.0)
    blocked_m: float = parameter(Reach.blocked_m, above=0.0)
    contact_m: float = parameter(Reach.contact_m, above=0.0)
    tells_persons: bool = parameter(True)
    scan_timeout_s: float = parameter(1.0, least=0.1, most=60.0)
    knows_names: bool = parameter(False)

    @property
    def reach(self) -> Reach:
        """Distances from the laser."""
        return Reach(self.sight_m, self.person_m, self.blocked_m, self.contact_m)


def _serve(name: str, holds: Callable[[TypedFrame], Any], statements: Statements, **options: Any) -> ConditionServer:
    server = ConditionServer(name, holds, **options)
    server.start()
    for frame, statement in statements.items():
        server.register_with_frame(frame, **statement)
    return server


def _me() -> Dict[str, List[str]]:
    return {"values": sorted(robots())}


class SurroundingsWatch:
    """Watches what a laser shows.

    Subscribes:
        scan (sensor_msgs/LaserScan), while somebody watches
    Actions:
        surroundings_watch
    """

    def __init__(self, settings: Settings) -> None:
        self._settings = settings
        self._lock = threading.Lock()
        self._seen: Optional[Tuple[Surroundings, rospy.Time]] = None
        self._heard_s = 0.0
        statements = surroundings.frames(tells_persons=settings.tells_persons)
        self.server = _serve("surroundings_watch", self._holds, statements, while_watched=self._while_watched)

    def _while_watched(self) -> Callable[[], None]:
        with self._lock:
            self._seen, self._heard_s = None, time.monotonic()
        return rospy.Subscriber("scan", LaserScan, self._on_scan, queue_size=1, tcp_nodelay=True).unregister

    def _on_scan(self, message: LaserScan) -> None:
        scan = Scan(
            message.ranges,
            first_rad=message.angle_min,
            step_rad=message.angle_increment,
            least_m=message.range_min,
            most_m=message.range_max,
        )
        with self._lock:
            self._seen = Surroundings(scan, self._settings.reach), message.header.stamp or rospy.Time.now()
            self._heard_s = time.monotonic()
        self.server.changed()

    def _holds(self, frame: TypedFrame) -> Optional[Observed]:
        with self._lock:
            seen, silent_s = self._seen, time.monotonic() - self._heard_s
        if silent_s > self._settings.scan_timeout_s:
            raise ConditionUnknown(f"the laser has said nothing for {self._settings.scan_timeout_s:g} s")
        if seen is None:
            return None
        around, stamp = seen
        try:
            arguments = {argument.name: argument for argument in frame.arguments}
            return Observed(around.holds(frame.name, arguments), stamp)
        except (KeyError, ValueError) as error:
            raise ConditionUnknown(str(error)) from error


class PlacesWatch:
    """Watches where the robot is.

    Subscribes:
        amcl_pose (geometry_msgs/PoseWithCovarianceStamped), locations (roboframenet_msgs/Locations)
    Actions:
        places_watch
    """

    def __init__(self) -> None:
        self._places = Places()
        self._pose: Optional[PoseWithCovarianceStamped] = None
        # Poses arrive while the server registers.
        self._on_change: Callable[[], None] = lambda: None
        self._subscriber = rospy.Subscriber("amcl_pose", PoseWithCovarianceStamped, self._on_pose, queue_size=1)
        me = {"theme": _me()}
        self.server = _serve(
            "places_watch",
            self._holds,
            {
                "condition_of_place": {"heeds": {**me, "location": {"relations": ["at", "in", "near"]}}},
                "condition_of_arriving": {"heeds": me},
                "condition_of_departing": {"heeds": me},
            },
        )
        self._on_change = self.server.changed

    def _on_pose(self, message: PoseWithCovarianceStamped) -> None:
        self._pose = message
        self._on_change()

    def _holds(self, frame: TypedFrame) -> Optional[Observed]:
        if not self._subscriber.get_num_connections():
            raise ConditionUnknown("nobody says where I am")
        if self._pose is None:
            return None
        element = {"condition_of_arriving": "goal", "condition_of_departing": "source"}.get(frame.name, "location")
        if not frame[element].text:
            raise ConditionUnknown(f"I was not told the {element}")
        try:
            place = self._places.locate(frame[element].text).pose.position
        except UnknownPlace as reason:
            raise ConditionUnknown(str(reason).rstrip(".?")) from reason
        here = self._pose.pose.pose.position
        is_there = is_near((here.x, here.y), (place.x, place.y), HEREABOUTS_M)
        return Observed.still(is_there is not (frame.name == "condition_of_departing"), self._pose.header.stamp)


class SpeechWatch:
    """Watches what is said to the robot.

    Subscribes:
        text (std_msgs/String), heard (std_msgs/String): "Alice: hello"
    Actions:
        speech_watch
    """

    def __init__(self, *, knows_names: bool) -> None:
        """
        Args:
            knows_names: whether `heard` says who speaks
        """
        self._sayings = Sayings()
        speaker: Dict[str, Any] = {} if knows_names else {"values": sorted(words("speakers"))}
        self.server = _serve(
            "speech_watch", self._holds, {"condition_of_speech": {"heeds": {"speaker": speaker, "addressee": _me()}}}
        )
        self._subscribers = [
            rospy.Subscriber("text", String, lambda message: self._hear("", message.data), queue_size=10),
            rospy.Subscriber("heard", String, self._on_heard, queue_size=10),
        ]

    def _on_heard(self, message: String) -> None:
        speaker, separator, text = message.data.partition(": ")
        self._hear(speaker if separator else "", text if separator else message.data)

    def _hear(self, speaker: str, text: str) -> None:
        self._sayings.hear(Saying(speaker, text, time.monotonic(), rospy.get_time()))
        self.server.changed()

    def _holds(self, frame: TypedFrame) -> Observed:
        found = self._sayings.match(frame["speaker"], frame["message"], now_s=time.monotonic())
        if found is None:
            return Observed(False, rospy.Time.now())
        return Observed.still(True, rospy.Time.from_sec(found.stamp_s))


class CommandsWatch:
    """Watches for the end of commands.

    Subscribes:
        reply (roboframenet_msgs/Reply)
    Actions:
        commands_watch
    """

    def __init__(self) -> None:
        self._ended: Optional[Tuple[float, rospy.Time]] = None
        self.server = _serve("commands_watch", self._holds, {"condition_of_ending": {"unheeded": ["activity"]}})
        self._subscriber = rospy.Subscriber("reply", Reply, self._on_reply, queue_size=10)

    def _on_reply(self, _message: Reply) -> None:
        self._ended = time.monotonic(), rospy.Time.now()
        self.server.changed()

    def _holds(self, _frame: TypedFrame) -> Observed:
        if not self._subscriber.get_num_connections():
            raise ConditionUnknown("nobody replies to commands")
        if self._ended is None or time.monotonic() - self._ended[0] > MOMENT_S:
            return Observed(False, rospy.Time.now())
        return Observed.still(True, self._ended[1])


class ClockWatch:
    """Watches the clock.

    Actions:
        clock_watch
    """

    def __init__(self) -> None:
        self.server = _serve("clock_watch", self._holds, {"condition_of_time": {}})

    def _holds(self, frame: TypedFrame) -> Observed:
        try:
            now = datetime.fromtimestamp(rospy.get_time())
            is_shown = clock_shows(frame["time"], now, side=frame["side"].text)
        except ValueError as reason:
            raise ConditionUnknown(str(reason)) from reason
        return Observed(is_shown, rospy.Time.now())


class ConditionWatchers:
    """The watchers that the parameters name.

    Parameters: see :class:`Settings`.
    """

    def __init__(self, place: Place) -> None:
        """
        Args:
            place: where the node runs

        Raises:
            ParameterError: a parameter is wrong
            StartError: it names a watcher that does not exist, or nothing is watched
        """
        settings = read_parameters(Settings, prefix=place.private)
        rospy.loginfo("%s", settings)
        made: Dict[Watcher, Callable[[], Any]] = {
            Watcher.SURROUNDINGS: lambda: SurroundingsWatch(settings),
            Watcher.PLACES: PlacesWatch,
            Watcher.SPEECH: lambda: SpeechWatch(knows_names=settings.knows_names),
            Watcher.COMMANDS: CommandsWatch,
            Watcher.CLOCK: ClockWatch,
        }
        known = [one.value for one in Watcher]
        unknown = [name for name in settings.watch if name not in known]
        if unknown:
            raise StartError(f"~watch: {', '.join(unknown)}; expected some of {', '.join(known)}")
        self._watchers = [made[Watcher(name)]() for name in settings.watch]
        self._bound: List[Bound] = bound_servers(settings.files)
        for bound in self._bound:
            bound.register()
        if not self._watchers and not self._bound:
            raise StartError("nothing is watched: ~watch and ~files are empty")


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("condition_watchers", lambda: ConditionWatchers(Place()))
