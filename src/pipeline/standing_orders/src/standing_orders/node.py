"""The node of the standing orders: keeps them, and sends what is due.

Callbacks only enqueue; one worker thread owns the orders and their file.
"""

import math
import os
import queue
import threading
import time
import uuid
from collections import deque
from dataclasses import dataclass, replace
from typing import Deque, Dict, Optional, Union

import rospy
from roboframenet_msgs.msg import (
    Command,
    CommandPlan,
    CommandStatus,
    FilledSemanticFrameResult,
    OrderDue,
    Reply,
    StandingOrders,
    StopReport,
)

from arbitrator.plan import AnyCondition
from arbitrator.standing import Whenever
from rfnserver import RFNServer, TypedFrame
from roboframenet_ros.health import Health, Level
from roboframenet_ros.home_folder import file_in_ros_home
from roboframenet_ros.parameters import ParameterError
from roboframenet_ros.ros_hand_over import HandOver
from roboframenet_ros.ros_node import StartError, read_parameters, run_node
from roboframenet_ros.ros_place import Place
from roboframenet_ros.ros_publishing import publish
from roboframenet_ros.ros_replays import ReplayWatch
from roboframenet_ros.ros_robots import own_robot
from roboframenet_ros.ros_stage import Stage
from roboframenet_ros.sqlite_file import StoreError
from standing_orders.book import Book, Change
from standing_orders.matching import orders_meant
from standing_orders.order import Firing
from standing_orders.ros_messages import due_to_message, order_from_message, order_to_message, part_of, said_s
from standing_orders.ros_watches import Watches
from standing_orders.schedule import NoSchedule, zone_of
from standing_orders.sentences import listing
from standing_orders.settings import Settings
from standing_orders.store import Store

#: The frames of the server, which answers beside what runs.
LISTING, FORGETTING, RESUMING = "question_of_standing_orders", "forgetting_an_order", "resuming_orders"
_TURN_S = 0.5
#: While nothing is due: the clock may be set at any time.
_LONGEST_TURN_S = 2.0
#: How long a command that was sent may take to be open or to be answered; it has been lost after that.
_SENT_S = 10.0
_ANSWER_S = 4.0
_MAX_CLIENTS = 32
_MOST_MISSED = 100


@dataclass(frozen=True)
class _Happened:
    order_id: str


@dataclass(frozen=True)
class _Seen:
    """What is known of a condition has changed."""


@dataclass
class _Request:
    """What a person asks of the server; the worker sets the answer."""

    frame: TypedFrame
    is_answered: threading.Event
    answer: str = ""


_Event = Union[CommandPlan, CommandStatus, Reply, StopReport, _Happened, _Seen, _Request, None]


class StandingOrdersNode:
    """Keeps standing orders.

    Subscribes: ``command_standing_order``, ``status``, ``reply``, ``stop_report``, ``frame_servers``.
    Publishes: ``order_due``, ``standing_orders`` (latched), ``command_cancel``, ``stage_events``.
    Actions: ``standing_orders_server``. Parameters: see :class:`standing_orders.settings.Settings`.
    """

    def __init__(self, settings: Settings, *, robot: str = "", private: str = "~") -> None:
        """
        Args:
            settings: of the node
            robot: whose orders these are; empty for the only robot
            private: prefix of its private names

        Raises:
            ParameterError: there is no such time zone
            StartError: there is no file, not even a new one
        """
        try:
            self._zone = zone_of(settings.time_zone)
        except ValueError as error:
            raise ParameterError(f"~time_zone: {error}") from error
        own_file = f"standing_orders.{robot}.sqlite" if robot else "standing_orders.sqlite"
        path = os.path.expanduser(settings.file or file_in_ros_home(own_file))
        try:
            self._store = Store(path)
            orders = self._store.load()
        except StoreError as error:
            raise StartError(str(error)) from error
        for problem in self._store.problems:
            rospy.logerr("%s", problem)
        self._book = Book(orders, self._zone, settings.rules, tag=uuid.uuid4().hex[:4])
        self._inbox: queue.Queue[_Event] = queue.Queue()
        self._status: Optional[CommandStatus] = None
        self._stop_stamp = rospy.Time()
        self._sent: Dict[str, float] = {}
        self._is_resumed = False
        self._told: Optional[StandingOrders] = None
        self._shown: object = None
        self._stage = Stage("standing_orders")
        self._replays = ReplayWatch(self._stage)
        self._due = HandOver("order_due", OrderDue)
        # What was missed is told, however long the command server takes to start.
        self._missed: Deque[OrderDue] = deque(maxlen=_MOST_MISSED)
        self._cancel = rospy.Publisher("command_cancel", Command, queue_size=100)
        self._orders = rospy.Publisher("standing_orders", StandingOrders, queue_size=1, latch=True)
        self._watches = Watches(
            lambda order_id: self._inbox.put(_Happened(order_id)),
            lambda: self._inbox.put(_Seen()),
            retry_s=settings.retry_s,
            silence_s=settings.silence_s,
            max_clients=_MAX_CLIENTS,
            private=private,
        )
        self._server = RFNServer("standing_orders_server", self._on_request)
        self._worker = threading.Thread(target=self._work, name="standing_orders")

    def start(self) -> None:
        """Start to keep orders."""
        rospy.on_shutdown(self._shutdown)
        self._watches.start()
        self._replays.start()
        self._watch()
        self._tell()
        self._worker.start()
        self._subscribers = [
            rospy.Subscriber(name, kind, self._inbox.put, queue_size=1000)
            for name, kind in (
                ("stop_report", StopReport),
                ("reply", Reply),
                ("status", CommandStatus),
                ("command_standing_order", CommandPlan),
            )
        ]
        # A registrar that is not there yet is waited for; the orders are not.
        self._server.start()
        for name in (LISTING, FORGETTING, RESUMING):
            self._server.register_with_frame(name)
        rospy.loginfo("ready: %d standing orders", len(self._book.orders))

    def health(self) -> Health:
        """How the node is."""
        blind = [one for one in self._watches.conditions().values() if one.holds is None and one.reason]
        values = {"orders": len(self._book.orders)}
        if blind:
            return Health(Level.WARN, f"Nobody can tell whether {len(blind)} conditions hold.", values)
        return Health(values=values)

    def _shutdown(self) -> None:
        self._inbox.put(None)
        # A shutdown may come while the node starts.
        if self._worker.is_alive():
            self._worker.join(5.0)
        self._watches.close()
        self._store.close()

    def _work(self) -> None:
        while True:
            event: Optional[_Event] = None
            try:
                event = self._inbox.get(timeout=self._pause_s())
                if event is None:
                    return
            except queue.Empty:
                pass
            try:
                if event is not None:
                    self._handle(event)
                self._turn()
            except Exception as error:  # boundary: one message must not end the work on all others
                rospy.logerr("standing_orders: %s: %s", type(error).__name__, error)

    def _pause_s(self) -> float:
        """Return how long nothing is to be done, if nothing happens: until the next order is due."""
        orders = self._book.orders
        is_busy = self._sent or self._missed or self._book.due_ids or any(order.begun for order in orders)
        if is_busy or not self._is_resumed or self._watches.is_any_blind:
            return _TURN_S
        next_s = min((order.next_s for order in orders if order.next_s is not None), default=math.inf)
        left_s = next_s - time.time()
        return min(left_s, _LONGEST_TURN_S) if left_s > 0.0 else _TURN_S

    def _handle(self, event: _Event) -> None:
        if isinstance(event, CommandPlan):
            self._give(event)
        elif isinstance(event, CommandStatus):
            self._status = event
        elif isinstance(event, Reply):
            self._sent.pop(event.command.id, None)
            self._apply(self._book.ended(event.command.id))
        elif isinstance(event, StopReport):
            self._stop(event)
        elif isinstance(event, _Happened):
            self._book.happened(event.order_id, _boot_s())
        elif isinstance(event, _Request):
            event.answer = self._answer(event.frame)
            event.is_answered.set()

    def _give(self, message: CommandPlan) -> None:
        command = message.command
        if self._replays.refuses(command):
            return
        if command.stamp <= self._stop_stamp:
            return  # the command server has answered it: it was stopped
        try:
            order = order_from_message(message, said_s(command), self._zone)
        except NoSchedule as reason:
            self._stage.ends(command, outcome=Reply.REFUSED, code="CONDITION", sentence=str(reason))
            return
        except ValueError as error:
            sentence = f"The standing order cannot be kept: {error}."
            self._stage.ends(command, outcome=Reply.FAILED, code="STAGE_ERROR", sentence=sentence)
            return
        same = self._book.same_as(order)
        if same is not None:
            order = same
        elif self._book.is_full:
            count = len(self._book.orders)
            sentence = f"I have {count} standing orders already. Take one back first."
            self._stage.ends(command, outcome=Reply.REFUSED, code="LIMIT", sentence=sentence)
            return
        elif not self._apply(self._book.give(order)):
            self._apply(self._book.drop((order.order_id,)), must_be_stored=False)
            sentence = "I could not save the standing order, so I do not keep it."
            self._stage.ends(command, outcome=Reply.FAILED, code="STAGE_ERROR", sentence=sentence)
            return
        rest = ' It is suspended since you stopped me; say "go on".' if order.is_suspended else ""
        rospy.loginfo("cmd=%s is the standing order %s: %s", command.id, order.order_id, order.sentence)
        self._stage.ends(command, outcome=Reply.DONE, code="DONE", sentence=f"{order.sentence}{rest}")

    def _stop(self, report: StopReport) -> None:
        """Somebody said "Stop.": nothing begins until somebody says "go on"."""
        if report.stop_stamp <= self._stop_stamp:
            return
        self._stop_stamp = report.stop_stamp
        for command_id in self._sent:
            # It may have been sent after the stop, which this node heard only now.
            publish(self._cancel, Command(id=command_id, stamp=report.stop_stamp))
        self._apply(self._book.suspend())

    def _turn(self) -> None:
        self._watches.turn()
        now_s = time.monotonic()
        self._sent = {
            name: sent_s for name, sent_s in self._sent.items() if now_s - sent_s < _SENT_S or self._runs(name)
        }
        if self._status is not None and not self._is_resumed:
            self._is_resumed = True
            self._apply(self._book.left_over([command.id for command in self._status.active]))
        for order in self._book.orders:
            if order.begun and order.begun not in self._sent and self._is_resumed and not self._runs(order.begun):
                self._apply(self._book.ended(order.begun))
        change = self._book.turn(
            time.time(), _boot_s(), busy_with=self._busy_with(), conditions=self._watches.conditions()
        )
        self._apply(change)
        self._tell()
        while self._missed and self._due.is_connected:
            self._due.publish(self._missed.popleft())

    def _runs(self, command_id: str) -> bool:
        return self._status is not None and any(command.id == command_id for command in self._status.active)

    def _busy_with(self) -> Optional[str]:
        """Return what runs, a clause; None if nothing does."""
        if self._status is None or not self._due.is_connected:
            return "the command server did not run"
        if self._status.active:
            return f'I was busy with "{self._status.active[0].text.strip(" .!")}"'
        return "I was busy with another standing order" if self._sent else None

    def _apply(self, change: Change, *, must_be_stored: bool = True) -> bool:
        """Write a change, then send what is due; returns whether it was written."""
        if change.is_empty:
            return True
        try:
            self._store.write(change.kept, change.dropped)
        except StoreError as error:
            rospy.logerr_throttle(10.0, str(error))
            if must_be_stored:
                # What is not written down could be done twice.
                for firing in change.due:
                    self._send(replace(firing, not_done=firing.not_done or "I could not write it down"))
                return False
        for firing in change.due:
            self._send(firing)
        self._watch()
        self._tell()
        return True

    def _send(self, firing: Firing) -> None:
        try:
            message = due_to_message(firing)
        except ValueError as error:
            rospy.logerr("the standing order %r is dropped: %s", firing.order.text, error)
            self._apply(self._book.drop((firing.order.order_id,)))
            return
        rospy.loginfo("cmd=%s %r is due %s", firing.command_id, firing.order.text, firing.not_done)
        if firing.not_done:
            self._missed.append(message)
        else:
            self._sent[firing.command_id] = time.monotonic()
            self._due.publish(message)

    def _watch(self) -> None:
        conditions: Dict[str, AnyCondition] = {}
        for order in self._book.orders:
            if order.schedule is not None or order.is_suspended:
                continue
            try:
                part = part_of(order)
            except ValueError as error:
                rospy.logerr("the standing order %r cannot be watched: %s", order.text, error)
                continue
            if isinstance(part, Whenever):
                conditions[order.order_id] = part.condition
        self._watches.set(conditions)

    def _faults(self) -> Dict[str, str]:
        return {name: one.reason for name, one in self._watches.conditions().items() if one.holds is None}

    def _tell(self) -> None:
        faults, due = self._faults(), frozenset(self._book.due_ids)
        shown = (self._book.orders, faults, due)
        if shown == self._shown:
            return  # Messages of all orders, several times a second, would cost most of what the node costs.
        self._shown = shown
        orders = [
            order_to_message(order, fault=faults.get(order.order_id, ""), is_due=order.order_id in due)
            for order in self._book.orders
        ]
        if self._told is None or self._told.orders != orders:
            self._told = StandingOrders(stamp=rospy.Time.now(), orders=orders)
            publish(self._orders, self._told)

    def _on_request(self, frame: TypedFrame) -> None:
        request = _Request(frame, threading.Event())
        self._inbox.put(request)
        if not request.is_answered.wait(_ANSWER_S):
            self._server.set_aborted(FilledSemanticFrameResult(success=False), "is busy")
            return
        self._server.set_succeeded(FilledSemanticFrameResult(success=True), request.answer)

    def _answer(self, frame: TypedFrame) -> str:
        """Carry out what a person asks about the orders; returns the sentence of the reply."""
        orders = self._book.orders
        if frame.name == RESUMING:
            suspended = [order for order in orders if order.is_suspended]
            if not suspended:
                return "No standing order is suspended."
            if not self._apply(self._book.resume(time.time())):
                return "I could not save that, so my standing orders stay suspended."
            return " ".join(["I am waiting again.", *(order.sentence for order in self._book.orders)])
        if frame.name == FORGETTING:
            phrase = frame["theme"].words or frame["theme"].text  # "Every order", and not "order".
            found = orders_meant(phrase, orders)
            if not found:
                return f'I have no standing order with "{phrase}".' if orders else "I have no standing order."
            if len(found) > 1 and len(found) < len(orders):
                return " ".join(["Which one?", *(order.sentence for order in found)])
            if not self._apply(self._book.drop(tuple(order.order_id for order in found))):
                return "I could not save that, so the order stays."
            return (
                f'I forget "{found[0].text.rstrip(" .!")}".'
                if len(found) == 1
                else f"I have forgotten all {len(found)} orders."
            )
        return listing(orders, time.time(), self._zone, blind=self._faults(), due_ids=self._book.due_ids)


def _boot_s() -> float:
    """Return seconds that also count while the machine sleeps."""
    return time.clock_gettime(time.CLOCK_BOOTTIME)


def start(place: Place) -> StandingOrdersNode:
    """Start the node.

    Raises:
        ParameterError: a parameter is wrong
        StartError: there is no file
    """
    settings = read_parameters(Settings, prefix=place.private)
    rospy.loginfo("standing_orders: %s", settings)
    node = StandingOrdersNode(settings, robot=own_robot(), private=place.private)
    node.start()
    return node


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("standing_orders", lambda: start(Place()))
