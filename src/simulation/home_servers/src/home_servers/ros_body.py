"""The body of a robot in a home, over ROS: the actions of the home, and what the robot perceives."""

import datetime
import json
import math
import threading
import time
from dataclasses import fields
from typing import Any, Callable, Dict, FrozenSet, List, Optional, Sequence, Set, Tuple

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseWithCovarianceStamped
from roboframenet_msgs.msg import (
    FilledFrameElement,
    FilledSemanticFrame,
    FilledSemanticFrameAction,
    FilledSemanticFrameGoal,
    WorldObject,
    WorldRelation,
    WorldUpdate,
)
from std_msgs.msg import String

from home_servers.body import Interrupted
from home_servers.conditions import Sight
from home_servers.memory import Known, Memory
from roboframenet_sim.home_actions import Action, Failure

#: The home answers an action at once when it is there; seconds of the monotonic clock.
_ANSWER_S = 10.0
#: Longest action, in ROS time and on the monotonic clock.
_LONGEST_S = 600.0
#: Persons answer within this time, ROS time.
_REPLY_S = 1.0
_POLL_S = 0.01
_ROBOT = "robot"
#: Sorts of the world, and what this package calls them; the rest is furniture or a thing.
_SORTS = {"place": "room", "door": "door", "person": "person"}


def known_of(one: WorldObject, rooms: Set[str], furniture: Set[str]) -> Known:
    """Read what a message says of an object.

    Args:
        one: the object
        rooms: ids of rooms
        furniture: ids of what the map calls furniture
    """
    relation = holder = room = ""
    joined: List[str] = []
    for each in one.relations:
        if each.relation == "to":
            joined.append(each.reference)
        elif each.relation == "in" and each.reference in rooms:
            room = each.reference
        if each.relation not in ("to", "of") and not relation:
            relation, holder = ("held" if each.relation == "held_by" else each.relation), each.reference
            room = holder if holder in rooms else room
    sort = _SORTS.get(one.sort, "furniture" if one.id in furniture else "thing")
    names = tuple(name for name in (one.name or one.category, *one.other_names) if name)
    return Known(
        one.id,
        sort,
        names or (one.id,),
        one.category,
        tuple(joined) if sort == "door" else tuple(one.attributes),
        relation,
        holder,
        one.id if sort == "room" else room,
        tuple(one.states),
        one.pose.pose.position.x,
        one.pose.pose.position.y,
        one.stamp.to_sec() or -1.0,
    )


class RosBody:
    """The body.

    Subscribes:
        home/map (WorldUpdate), world_updates (WorldUpdate), amcl_pose, home/heard (std_msgs/String)
    Publishes:
        said (std_msgs/String), world_updates (WorldUpdate): what the robot was told
        doing (std_msgs/String): what the robot is doing
    Actions called:
        home/act
    """

    def __init__(self) -> None:
        self.memory = Memory()
        self._lock = threading.Lock()
        self._rooms: Set[str] = set()
        self._furniture: Set[str] = set()
        self._place = (0.0, 0.0)
        self._room = ""
        self._held: List[str] = []
        self._seen: Tuple[FrozenSet[str], rospy.Time, float] = (frozenset(), rospy.Time(), -math.inf)
        self._on_sight: Callable[[], None] = lambda: None
        self._replies: List[Tuple[str, str]] = []
        self._wanted = threading.local()
        self._said = rospy.Publisher("said", String, queue_size=20)
        self._doing = rospy.Publisher("doing", String, queue_size=20, latch=True)
        self._updates = rospy.Publisher("world_updates", WorldUpdate, queue_size=20)
        self._client = actionlib.ActionClient("home/act", FilledSemanticFrameAction)
        self._subscribers = [
            rospy.Subscriber("home/map", WorldUpdate, self._on_map, queue_size=1),
            rospy.Subscriber("world_updates", WorldUpdate, self._on_update, queue_size=50),
            rospy.Subscriber("amcl_pose", PoseWithCovarianceStamped, self._on_pose, queue_size=5),
            rospy.Subscriber("home/heard", String, self._on_heard, queue_size=20),
        ]

    def begin(self, is_wanted: Any) -> None:
        """Begin a goal in this thread; `is_wanted` says whether it still holds."""
        self._wanted.check = is_wanted

    def do(self, action: Action) -> Optional[Failure]:
        """Carry out an action to its end; see :class:`home_servers.body.Body`."""
        elements = [
            FilledFrameElement(field.name, str(getattr(action, field.name)))
            for field in fields(Action)
            if field.name != "kind" and getattr(action, field.name) != "" and not _is_nan(action, field.name)
        ]
        goal = FilledSemanticFrameGoal(frame=FilledSemanticFrame(name=action.kind, frame_elements=elements))
        self._check()
        handle = self._client.send_goal(goal)
        begin_s = time.monotonic()
        while handle.get_comm_state() != actionlib.CommState.DONE:
            state = handle.get_comm_state()
            if state == actionlib.CommState.WAITING_FOR_GOAL_ACK and time.monotonic() - begin_s > _ANSWER_S:
                return Failure("no_home", "The home does not answer.")
            if time.monotonic() - begin_s > _LONGEST_S:
                handle.cancel()
                return Failure("too_long", "It takes too long.")
            try:
                self._check()
            except Interrupted:
                handle.cancel()
                self._wait_for_end(handle)
                raise
            time.sleep(_POLL_S)
        status, text = handle.get_goal_status(), handle.get_goal_status_text()
        if status == GoalStatus.SUCCEEDED:
            self._settle(action)
            return None
        if status in (GoalStatus.PREEMPTED, GoalStatus.RECALLED):
            raise Interrupted("the action was cancelled")
        try:
            found: Dict[str, str] = json.loads(text)
            return Failure(found["code"], found["sentence"], found["entity"])
        except (ValueError, KeyError, TypeError):
            return Failure("unknown", text or "The home gave no reason.")

    def _settle(self, action: Action) -> None:
        """After an action the robot perceives what came of it."""
        end_s = rospy.get_time() + (1.1 if action.kind in ("look", "go") else 0.6)
        limit_s = time.monotonic() + 2.0
        while rospy.get_time() < end_s and time.monotonic() < limit_s:
            self._check()
            time.sleep(_POLL_S)

    def _wait_for_end(self, handle: Any) -> None:
        end_s = time.monotonic() + 2.0
        while handle.get_comm_state() != actionlib.CommState.DONE and time.monotonic() < end_s:
            time.sleep(_POLL_S)

    def _check(self) -> None:
        check = getattr(self._wanted, "check", None)
        if rospy.is_shutdown() or (check is not None and not check()):
            raise Interrupted("the goal was preempted")

    def say(self, text: str) -> List[Tuple[str, str]]:
        """Say something, and listen for a second when it is a question."""
        with self._lock:
            self._replies = []
        self._said.publish(String(data=text))
        if text.endswith("?"):
            end_s = rospy.get_time() + _REPLY_S
            limit_s = time.monotonic() + 2.0
            while rospy.get_time() < end_s and time.monotonic() < limit_s:
                self._check()
                time.sleep(_POLL_S)
        with self._lock:
            return list(self._replies)

    def show_doing(self, words: str) -> None:
        """Publish what the robot is doing; see :class:`home_servers.body.Body`."""
        self._doing.publish(String(data=words))

    def tell(self, told: Known) -> None:
        """Publish what somebody has told; see :class:`home_servers.body.Body`."""
        place = [WorldRelation(told.relation, told.holder)] if told.relation else []
        one = WorldObject(
            id=told.id,
            other_names=list(told.names),
            attributes=list(told.attributes),
            relations=place,
            states=list(told.states),
            source=rospy.get_name().strip("/"),
            stamp=rospy.Time.now(),
        )
        self._updates.publish(WorldUpdate(objects=[one]))

    def sight(self) -> Tuple[Sight, rospy.Time, float]:
        """Return what the robot perceives, the stamp of that, and its age in seconds."""
        with self._lock:
            seen, stamp, heard_s = self._seen
            sight = Sight(seen, frozenset(self._held), self._room, *self._place)
        return sight, stamp, time.monotonic() - heard_s

    def listen(self, on_sight: Callable[[], None]) -> None:
        """Call a function whenever the robot has perceived something."""
        self._on_sight = on_sight

    def now_s(self) -> float:
        """ROS time, in seconds."""
        return float(rospy.get_time())

    def clock(self) -> datetime.datetime:
        """The local time of this machine."""
        return datetime.datetime.now()

    def held(self) -> Sequence[str]:
        """Ids of what the robot holds."""
        with self._lock:
            return tuple(self._held)

    def place(self) -> Tuple[float, float]:
        """Where the robot is, in the map."""
        with self._lock:
            return self._place

    def room(self) -> str:
        """Id of the room where the robot is."""
        with self._lock:
            return self._room

    def _on_map(self, message: WorldUpdate) -> None:
        with self._lock:
            self._rooms = {one.id for one in message.objects if _SORTS.get(one.sort) == "room"}
            self._furniture = {one.id for one in message.objects if one.sort not in _SORTS}
        self.memory.update(known_of(one, self._rooms, self._furniture) for one in message.objects)

    def _on_update(self, message: WorldUpdate) -> None:
        if message._connection_header.get("callerid") == rospy.get_name():
            # What the robot was told is in its memory, and is less than what it has seen.
            return
        with self._lock:
            rooms, furniture = self._rooms, self._furniture
        me = [one for one in message.objects if one.id == _ROBOT]
        with self._lock:
            is_anew = bool(me) and rospy.Time() < me[0].stamp < self._seen[1]
        if is_anew:
            self.memory.begin_anew()
        known = [known_of(one, rooms, furniture) for one in message.objects if one.id != _ROBOT]
        self.memory.update(known)
        for ident in message.missing:
            self.memory.forget_place(ident)
        if me:
            with self._lock:
                self._held = [one.id for one in known if one.relation == "held" and one.holder == _ROBOT]
                self._room = next((each.reference for each in me[0].relations if each.relation == "in"), "")
                seen = frozenset(one.id for one in message.objects if one.id != _ROBOT)
                self._seen = seen, me[0].stamp, time.monotonic()
            self._on_sight()

    def _on_pose(self, message: PoseWithCovarianceStamped) -> None:
        with self._lock:
            self._place = (message.pose.pose.position.x, message.pose.pose.position.y)

    def _on_heard(self, message: String) -> None:
        who, _, what = message.data.partition(": ")
        with self._lock:
            self._replies.append((who, what))


def _is_nan(action: Action, name: str) -> bool:
    value = getattr(action, name)
    return isinstance(value, float) and math.isnan(value)
