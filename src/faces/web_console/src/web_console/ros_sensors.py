"""Hears cameras and numbers while a page shows them, and no longer."""

import json
import threading
import time
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any, Dict, FrozenSet, List, Optional, Sequence, Tuple

import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from sensor_msgs.msg import BatteryState, CompressedImage, Image, Range, Temperature
from std_msgs.msg import Bool, Float32, Float64, Int32

from roboframenet_ros.ros_master import NO_ANSWER, TimedMaster
from web_console.sensing import CAMERAS, NoPicture, Source, compressed_picture, number_of, picture_of, sources_of

#: What a page has not asked for during this time is heard no longer.
_FORGET_S = 5.0
_LIST_S = 5.0
#: After each message its connection rests: a page shows few pictures in a second.
_REST_S = 0.1
_MOST_HEARD = 8
_MOST_OFFERED = 200
_TYPES = {one._type: one for one in (Twist, Odometry, BatteryState, Range, Temperature, Bool, Float32, Float64, Int32)}
_PICTURE_BYTES = 8 * 1024 * 1024


class SensorTap:
    """Subscribers of what pages look at: cameras and numbers, by their places in the list that was offered.

    `turn` is called from a thread that may wait for the master; the other methods are for the event loop.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._sources: Tuple[Source, ...] = ()
        self._wanted: Dict[str, float] = {}
        self._asked_s = float("-inf")
        self._listed_s = float("-inf")
        self._newest: Dict[str, rospy.AnyMsg] = {}
        self._subscribers: Dict[str, rospy.Subscriber] = {}
        self._master = TimedMaster(timeout_s=2.0)
        self._thread = ThreadPoolExecutor(max_workers=1, thread_name_prefix="pictures")

    def close(self) -> None:
        """End the thread that makes pictures."""
        self._thread.shutdown(wait=False)

    def turn(self, is_watched: bool) -> None:
        """List what can be looked at, and subscribe to what is looked at. May wait for the master.

        Args:
            is_watched: whether a page is open
        """
        now_s = time.monotonic()
        with self._lock:
            is_asked = now_s - self._asked_s < _FORGET_S
            self._wanted = {
                topic: at_s for topic, at_s in self._wanted.items() if is_watched and now_s - at_s < _FORGET_S
            }
            wanted: FrozenSet[str] = frozenset(self._wanted)
        if is_asked and now_s - self._listed_s >= _LIST_S:
            self._listed_s = now_s
            try:
                state, types = self._master.graph()
            except NO_ANSWER:
                return
            found = sources_of(types, [topic for topic, nodes in state.publishers.items() if nodes])
            with self._lock:
                # A place in the list stays what it is: what is new comes behind.
                new = (source for source in found if source not in self._sources)
                self._sources = (*self._sources, *new)[:_MOST_OFFERED]
        for topic in set(self._subscribers) - wanted:
            self._subscribers.pop(topic).unregister()
            with self._lock:
                self._newest.pop(topic, None)
        for topic in wanted - set(self._subscribers):
            self._subscribers[topic] = rospy.Subscriber(
                topic, rospy.AnyMsg, self._hear, topic, queue_size=1, buff_size=_PICTURE_BYTES
            )

    def _hear(self, message: rospy.AnyMsg, topic: str) -> None:
        with self._lock:
            self._newest[topic] = message
        time.sleep(_REST_S)

    def offered(self) -> str:
        """Return the names of cameras and numbers as JSON, and look for more for a while."""
        with self._lock:
            self._asked_s = time.monotonic()
            sources = self._sources
        kinds: Dict[str, Dict[int, str]] = {"cameras": {}, "numbers": {}}
        for place, source in enumerate(sources):
            kinds["cameras" if source.kind in CAMERAS else "numbers"][place] = source.label
        return json.dumps(kinds)

    def _want(self, place: int) -> Source:
        """Note that a page looks at a source; returns it.

        Raises:
            NoPicture: nothing is offered there, or too much is looked at
        """
        with self._lock:
            if not 0 <= place < len(self._sources):
                raise NoPicture("there is no such camera or number")
            source = self._sources[place]
            if source.topic not in self._wanted and len(self._wanted) >= _MOST_HEARD:
                raise NoPicture(f"{_MOST_HEARD} cameras and numbers are looked at already")
            self._wanted[source.topic] = time.monotonic()
            return source

    def numbers(self, places: Sequence[int]) -> str:
        """Return the newest values of numbers as JSON; null for what nobody has told yet.

        Raises:
            NoPicture: nothing is offered there, or too much is looked at
        """
        values: List[Optional[float]] = []
        for place in places:
            source = self._want(place)
            message = self._newest.get(source.topic)
            values.append(None if message is None else number_of(_read(_TYPES[source.kind], message), source.path))
        return json.dumps(values)

    def picture(self, place: int) -> "Future[Tuple[str, bytes]]":
        """Return the media type and the data of the newest picture of a camera; empty before the first.

        Raises:
            NoPicture: nothing is offered there, or too much is looked at
        """
        source = self._want(place)
        return self._thread.submit(_picture, source.kind, self._newest.get(source.topic))


def _read(kind: Any, message: rospy.AnyMsg) -> Any:
    return kind().deserialize(message._buff)


def _picture(kind: str, message: Optional[rospy.AnyMsg]) -> Tuple[str, bytes]:
    if message is None:
        return "image/png", b""
    if kind == CompressedImage._type:
        return compressed_picture(_read(CompressedImage, message).data)
    image = _read(Image, message)
    data = picture_of(
        encoding=image.encoding, width=image.width, height=image.height, step=image.step, data=bytes(image.data)
    )
    return "image/png", data
