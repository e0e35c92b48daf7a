"""Hears where the robot is and what lies around it."""

import threading
import time
from typing import Any, Callable, Dict, FrozenSet, List, Optional, Sequence, Tuple

import rospy
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped
from nav_msgs.msg import OccupancyGrid, Odometry, Path
from roboframenet_msgs.msg import Locations, World

from web_console.board import Board
from web_console.ground import Localization, thinned
from web_console.ros_hearing import show, show_raw
from web_console.ros_values import landmarks_of, map_of, pose_value, present_objects, world_view
from web_console.suggestions import Present
from web_console.views import GroundView, LandmarkView, MapView

_MOST_LANDMARKS = 300
#: The pose and the twist of an Odometry, each with its covariance: the end of the message.
_POSE_AND_TWIST_BYTES = (7 + 36 + 6 + 36) * 8
#: The pose of a PoseStamped: its end.
_POSE_BYTES = 7 * 8
#: After a frequent message its connection rests, longer while the messages say the same. What has come meanwhile is
#: read at once, and the last of it is kept.
_REST_S, _LONG_REST_S = 0.05, 0.2


class GroundTap:
    """Subscribers of poses, maps, paths and places; each is shown when its topic is there.

    What comes is read by `look`, the newest of each topic: nothing is read while nobody looks.

    Subscribes: ``odom`` and ``person/pose`` (while a page is open), ``amcl_pose``, ``map``, ``locations``, ``world``,
    ``move_base/current_goal``, and the topics of paths.
    """

    def __init__(
        self,
        board: Board,
        *,
        path_topics: Sequence[str],
        call_soon: Callable[..., None],
        on_change: Callable[[], None],
        on_picture: Callable[[str, bytes], None],
        on_names: Callable[[Tuple[str, ...]], None],
        on_world: Callable[[Tuple[Present, ...]], None],
    ) -> None:
        """Prepare; `start` subscribes.

        Args:
            board: receives the views
            path_topics: of nav_msgs/Path
            call_soon: calls a function in the thread of the event loop, from any thread
            on_change: called in that thread after each change of the board
            on_picture: called with the name and the data of the picture of the map
            on_names: called with the names of the places
            on_world: called with what the world has
        """
        self._board = board
        self._path_topics = path_topics
        self._call_soon = call_soon
        self._on_change = on_change
        self._on_picture = on_picture
        self._on_names = on_names
        self._on_world_change = on_world
        self._localization = Localization()
        self._last_odometry: Optional[rospy.AnyMsg] = None
        self._last_person: Optional[rospy.AnyMsg] = None
        self._seen = self._seen_person = b""
        self._heard = self._heard_person = b""
        self._ground = GroundView()
        self._maps = 0
        self._places: Tuple[LandmarkView, ...] = ()
        self._known: Tuple[LandmarkView, ...] = ()
        self._named: FrozenSet[str] = frozenset()
        self._others: Dict[str, LandmarkView] = {}
        self._subscribers: List[rospy.Subscriber] = []
        self._frequent: List[rospy.Subscriber] = []
        self._lock = threading.Lock()
        self._unread: Dict[str, Tuple[Any, Callable[[Any], None], rospy.AnyMsg]] = {}

    def start(self) -> None:
        """Subscribe to all that is seldom published."""
        self._hear("amcl_pose", PoseWithCovarianceStamped, self._on_pose)
        self._hear("map", OccupancyGrid, self._on_map)
        self._hear("world", World, self._on_world)
        self._hear("move_base/current_goal", PoseStamped, lambda message: self._on_other("goal", message))
        for topic in self._path_topics:
            self._hear(topic, Path, self._on_path)
        # A question offers the names of places; it may be asked before somebody looks.
        self._subscribers.append(
            rospy.Subscriber(
                "locations",
                Locations,
                lambda message: self._call_soon(show, self._on_locations, message),
                queue_size=1,
            )
        )

    def _hear(self, topic: str, kind: Any, callback: Callable[[Any], None]) -> None:
        self._subscribers.append(
            rospy.Subscriber(
                topic, rospy.AnyMsg, lambda message: self._arrived(topic, kind, callback, message), queue_size=1
            )
        )

    def _arrived(self, topic: str, kind: Any, callback: Callable[[Any], None], message: rospy.AnyMsg) -> None:
        with self._lock:
            self._unread[topic] = (kind, callback, message)

    def watch(self, is_watched: bool) -> None:
        """Follow what is frequent, or leave it alone while nobody looks. May wait for the master."""
        if is_watched and not self._frequent:
            # Most messages are never read.
            self._frequent = [
                rospy.Subscriber("odom", rospy.AnyMsg, self._on_odometry, queue_size=1),
                rospy.Subscriber("person/pose", rospy.AnyMsg, self._on_person, queue_size=1),
            ]
        elif not is_watched and self._frequent:
            for subscriber in self._frequent:
                subscriber.unregister()
            self._frequent = []

    def _on_odometry(self, message: rospy.AnyMsg) -> None:
        self._last_odometry = message
        self._heard = _rest(message._buff[-_POSE_AND_TWIST_BYTES:], self._heard)

    def _on_person(self, message: rospy.AnyMsg) -> None:
        self._last_person = message
        self._heard_person = _rest(message._buff[-_POSE_BYTES:], self._heard_person)

    def look(self) -> None:
        """Show what has come since the last look, and where the robot and the person are now."""
        with self._lock:
            unread, self._unread = self._unread, {}
        for kind, callback, message in unread.values():
            show_raw(kind, callback, message)
        person, self._last_person = self._last_person, None
        if person is not None and person._buff[-_POSE_BYTES:] != self._seen_person:
            self._seen_person = person._buff[-_POSE_BYTES:]
            self._on_other("person", PoseStamped().deserialize(person._buff))
        message, self._last_odometry = self._last_odometry, None
        # A robot that stands says the same again and again.
        if message is not None and message._buff[-_POSE_AND_TWIST_BYTES:] != self._seen:
            self._seen = message._buff[-_POSE_AND_TWIST_BYTES:]
            odometry = Odometry().deserialize(message._buff)
            self._localization.moved(pose_value(odometry.pose.pose), odometry.header.frame_id or "odom")
        news = self._localization.news()
        if news is not None:
            self._board.show("pose", news)
            self._on_change()

    def _on_pose(self, message: PoseWithCovarianceStamped) -> None:
        self._localization.localized(pose_value(message.pose.pose), message.header.frame_id or "map")

    def _on_map(self, message: OccupancyGrid) -> None:
        self._maps += 1
        name = f"map-{self._maps}.png"
        view, picture = map_of(message, name)
        self._on_picture(name, picture)
        self._show(map_view=view)

    def _on_path(self, message: Path) -> None:
        points = thinned([(pose.pose.position.x, pose.pose.position.y) for pose in message.poses])
        self._ground = GroundView(self._ground.map, points, self._ground.landmarks)
        self._show()

    def _on_locations(self, message: Locations) -> None:
        self._places = tuple(
            LandmarkView(name, "place", round(pose.pose.position.x, 3), round(pose.pose.position.y, 3))
            for name, pose in zip(message.names, message.poses)
        )[:_MOST_LANDMARKS]
        self._on_names(tuple(message.names))
        self._show()

    def _on_world(self, message: World) -> None:
        self._known = landmarks_of(message)[:_MOST_LANDMARKS]
        wide = [one for one in message.objects if one.size.x > 0 and one.size.y > 0]
        self._named = frozenset(name for one in wide for name in (one.name, *one.other_names))
        self._on_world_change(present_objects(message))
        self._board.show("world", world_view(message))
        self._show()
        self._on_change()

    def _on_other(self, kind: str, message: PoseStamped) -> None:
        position = message.pose.position
        self._others[kind] = LandmarkView(kind, kind, round(position.x, 2), round(position.y, 2))
        self._show()

    def _show(self, *, map_view: Optional[MapView] = None) -> None:
        # What the world knows has walls and edges; a place of the same name is only a point.
        places = {place.name: place for place in self._places if place.name not in self._named}
        known = tuple(one for one in self._known if one.name not in places)
        self._ground = GroundView(
            map_view or self._ground.map, self._ground.path, (*places.values(), *known, *self._others.values())
        )
        if self._board.show("ground", self._ground):
            self._on_change()


def _rest(said: bytes, before: bytes) -> bytes:
    """Let a connection rest after what was said, given what was said before; returns the former."""
    time.sleep(_LONG_REST_S if said == before else _REST_S)
    return said
