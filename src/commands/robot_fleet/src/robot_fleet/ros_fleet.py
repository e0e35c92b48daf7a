"""The node ``fleet``: knows the robots, and passes on what is said to all of them."""

import threading
import time
from dataclasses import dataclass
from typing import Dict, FrozenSet, Optional, Set, Tuple, Union

import rospy
from roboframenet_msgs.msg import CommandStatus, Fleet, FleetMember, FleetRobot, FleetService, Lexicon, Reply, World
from std_msgs.msg import String

from command_server.emergency_words import NOT_A_PERSON, may_release
from command_server.inbox import Inbox
from command_server.open_commands import refusal_of_delay
from command_server.ros_command_action import CommandActionServer
from command_server.ros_events import Said, said_by_goal, said_by_text
from command_server.stop_words import find_cry
from roboframenet_ros.command_ids import TextIds, TextSource
from roboframenet_ros.health import Health, Level
from roboframenet_ros.replays import AGAIN, OLDEST_NS
from roboframenet_ros.ros_kept_value import KeptValue
from roboframenet_ros.ros_node import read_parameters, run_node
from roboframenet_ros.ros_replays import REPLAYED, GoalsOnce
from roboframenet_ros.ros_robots import is_robot_name
from roboframenet_ros.ros_taken_texts import TakenOut
from robot_fleet.addressing import Company, Robot
from robot_fleet.places import Place, place_in
from robot_fleet.ros_out import RepliesOut
from robot_fleet.ros_robots import RobotLinks, ServiceWatch
from robot_fleet.ros_utterances import Utterances
from robot_fleet.roster import Roster
from robot_fleet.settings import FleetSettings
from robot_stop.emergency import CODE as EMERGENCY_STOP
from semantic_frames import FileRefused, load_lexical_units

_TURN_S = 0.1
_SIGN_OF_LIFE_S = 1.0
#: Robots that start together make one list of several, because each robot gets each list.
_LIST_PERIOD_S = 0.2
_JOIN_TIMEOUT_S = 2.0


@dataclass(frozen=True)
class _Said:
    said: Said
    command_id: str


@dataclass(frozen=True)
class _Cancelled:
    command_id: str


@dataclass(frozen=True)
class _Begun:
    command_id: str


@dataclass(frozen=True)
class _Status:
    robot: str
    status: CommandStatus


@dataclass(frozen=True)
class _Answered:
    command_id: str
    reply: Reply


#: The robots with what they are called, and those that have left.
_List = Tuple[Tuple[Tuple[str, Tuple[str, ...]], ...], Tuple[str, ...]]
_Event = Union[_Said, _Cancelled, _Begun, _Answered, _Status, FleetMember, None]


class FleetNode:
    """Knows who is there, decides who is meant, and answers once.

    Subscribes: ``text``, ``fleet_member``, ``lexicon``, ``frame_catalogue``, ``parse``, ``world``,
    ``<robot>/command/result``, ``<robot>/command/feedback``, ``<robot>/status``. Publishes: ``reply``, ``text_taken``,
    ``fleet`` (latched), ``fleet_started``, ``fleet_service``, ``<robot>/command/goal``, ``<robot>/command/cancel``.
    Actions: ``command``.
    """

    def __init__(self, settings: FleetSettings) -> None:
        self._settings = settings
        self._events: Inbox[_Event] = Inbox()
        self._roster: Roster[FleetMember] = Roster(silence_s=settings.member_silence_s)
        self._links = RobotLinks(
            lambda command_id, reply: self._events.put(_Answered(command_id, reply)),
            lambda command_id: self._events.put(_Begun(command_id)),
            lambda robot, status: self._events.put(_Status(robot, status)),
        )
        self._utterances = Utterances(settings, self._links, self._reply_to, KeptValue("~open_utterances"))
        self._verbs: FrozenSet[str] = frozenset()
        self._places: Tuple[Tuple[str, Place], ...] = ()
        self._told_s = self._listed_s = 0.0
        self._was_up = False
        self._listed: Optional[_List] = None
        self._text_ids, self._replayed_ids = TextIds(TextSource.TEXT), TextIds(TextSource.REPLAYED)
        self._goals = GoalsOnce()
        self._replies = RepliesOut()
        self._taken = TakenOut("fleet_started")
        self._fleet = rospy.Publisher("fleet", Fleet, queue_size=1, latch=True)
        self._life = rospy.Publisher("fleet_service", FleetService, queue_size=5)
        self._service = ServiceWatch(self._hear_verbs, _verbs_of)
        self._action = CommandActionServer(
            on_goal=lambda handle: self._events.put(_Said(said_by_goal(handle), handle.get_goal_id().id)),
            on_cancel=lambda command_id: self._events.put(_Cancelled(command_id)),
        )
        self._worker = threading.Thread(target=self._work, name="fleet")

    def start(self) -> None:
        """Take part."""
        rospy.on_shutdown(self._shutdown)
        for command in self._utterances.take_over():
            rospy.loginfo("cmd=%s was open when this node ended", command.id)
            age_s = (rospy.Time.now() - command.stamp).to_sec()
            self._taken.tell(command.id, command.text, heard_s=time.monotonic() - age_s)
        self._worker.start()
        self._subscribers = [
            rospy.Subscriber("fleet_member", FleetMember, self._events.put, queue_size=1000),
            rospy.Subscriber("world", World, self._hear_world, queue_size=1),
            rospy.Subscriber("text", String, self._hear_text, queue_size=100),
        ]
        self._action.start()
        self._taken.tell_start()

    def health(self) -> Health:
        """How the node is."""
        missing = self._service.missing()
        values = {"robots": len(self._roster.members), "gone": len(self._roster.absent)}
        return Health(Level.WARN, f"{missing} is not running.", values) if missing else Health(values=values)

    def _shutdown(self) -> None:
        self._events.put(None)
        self._worker.join(_JOIN_TIMEOUT_S)
        self._utterances.close()

    def _hear_text(self, message: String) -> None:
        self._events.put(_Said(said_by_text(message), self._text_ids.next_id()))

    def _hear_verbs(self, verbs: Set[str]) -> None:
        self._verbs = frozenset(verbs)

    def _hear_world(self, message: World) -> None:
        self._places = tuple(
            (name.lower(), (one.pose.pose.position.x, one.pose.pose.position.y))
            for one in message.objects
            if one.pose.header.frame_id
            for name in (one.name, *one.other_names, one.category)
            if name
        )

    def _work(self) -> None:
        while True:
            for event in self._events.take(longest_wait_s=_TURN_S, deadlines_s=()):
                if event is None:
                    return
                try:
                    self._handle(event)
                except Exception as error:  # boundary: one event must not keep the others from being handled
                    rospy.logerr("fleet could not handle a %s: %s", type(event).__name__, error, exc_info=True)
            for robot in self._roster.turn(now_s=time.monotonic()).left:
                rospy.loginfo("%s has left", robot)
                self._utterances.lose(robot)
            self._utterances.end_undelivered(self._roster.absent)
            self._utterances.send()
            self._utterances.save()
            self._replies.turn()
            self._taken.turn()
            self._tell()
            self._list()

    def _handle(self, event: _Event) -> None:
        if isinstance(event, _Said):
            self._hear(event.said, event.command_id)
        elif isinstance(event, _Cancelled):
            self._utterances.cancel(event.command_id)
        elif isinstance(event, _Begun):
            self._utterances.hear_begun(event.command_id)
        elif isinstance(event, _Answered):
            self._utterances.hear(event.command_id, event.reply)
        elif isinstance(event, _Status):
            self._utterances.hear_status(event.robot, event.status)
        elif isinstance(event, FleetMember) and is_robot_name(event.name):
            if self._roster.hear(event.name, event, now_s=time.monotonic()):
                rospy.loginfo("%s has joined", event.name)
                self._links.prepare(event.name)

    def _hear(self, said: Said, command_id: str) -> None:
        # The robots have heard a stop, whoever repeats it.
        if said.handle is not None and find_cry(said.text) is None and self._goals.refuses(said.handle):
            self._utterances.refuse(said.text, AGAIN, code=REPLAYED, command_id=self._replayed_ids.next_id())
            return
        if said.handle is not None:
            self._action.accept(said.handle)
        late = refusal_of_delay(said.delay_s, longest_s=OLDEST_NS / 1e9)
        if said.is_played and may_release(said.text):
            # The robots hear this node, and not the bag.
            self._utterances.refuse(said.text, NOT_A_PERSON, code=EMERGENCY_STOP, command_id=command_id)
        elif late is not None and find_cry(said.text) is None:
            code, sentence = late
            self._utterances.refuse(said.text, sentence, code=code, command_id=command_id)
        else:
            near = place_in(said.text, self._places)
            self._utterances.say(said.text, self._company(), command_id=command_id, near=near)
        # Whatever ends this node from now on, it is answered.
        self._utterances.save()
        self._taken.tell(command_id, said.text, heard_s=said.arrival_s)

    def _company(self) -> Company:
        busy = self._utterances.busy
        return Company(
            robots=tuple(
                Robot(
                    name=member.name,
                    spoken=tuple(member.spoken_names),
                    is_free=not member.open_commands and member.name not in busy,
                    place=_place_of(member),
                )
                for member in self._roster.members
            ),
            absent=self._roster.absent,
            verbs=self._verbs,
        )

    def _reply_to(self, reply: Reply) -> None:
        rospy.loginfo("cmd=%s %s: %s", reply.command.id, reply.code, reply.sentence)
        self._replies.publish(reply)
        self._action.finish(reply, command_id=reply.command.id)

    def _tell(self) -> None:
        """Give the sign of life of the service when it is due, or when the service has gone or come."""
        is_up = self._service.missing() is None
        if is_up != self._was_up or time.monotonic() - self._told_s >= _SIGN_OF_LIFE_S:
            self._told_s, self._was_up = time.monotonic(), is_up
            self._life.publish(FleetService(stamp=rospy.Time.now(), is_up=is_up))

    def _list(self) -> None:
        """Publish the list of robots, if it is another one."""
        members = tuple((member.name, tuple(member.spoken_names)) for member in self._roster.members)
        found = members, self._roster.absent
        if found == self._listed or time.monotonic() - self._listed_s < _LIST_PERIOD_S:
            return
        self._listed, self._listed_s = found, time.monotonic()
        robots = [FleetRobot(name=name, spoken_names=list(spoken)) for name, spoken in members]
        self._fleet.publish(Fleet(stamp=rospy.Time.now(), robots=robots, absent=list(self._roster.absent)))


def _place_of(member: FleetMember) -> Union[Place, None]:
    position = member.pose.pose.position
    return (position.x, position.y) if member.pose.header.frame_id else None


def _verbs_of(message: Lexicon) -> Set[str]:
    found: Dict[str, None] = {}
    for file in message.files:
        try:
            units = load_lexical_units(file.text, file.path)
        except FileRefused:
            continue
        found.update({verb.split()[0]: None for unit in units for verb in unit.verbs})
    return set(found)


def _start() -> FleetNode:
    settings = read_parameters(FleetSettings)
    rospy.loginfo("fleet: %s", settings)
    node = FleetNode(settings)
    node.start()
    return node


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("fleet", _start)
