"""Watches the conditions of binding files: each is a server with a subscriber."""

import threading
import time
from typing import Any, Callable, Dict, List, Mapping, Optional

import genmsg.msgs
import roslib.message
import rospy

from checked_files.problem import FileRefused, Problem
from frame_bindings.condition_file import ConditionBinding, fields_below, path_problem
from frame_bindings.field_conditions import NotComparable
from rfnserver import ConditionServer, ConditionUnknown, Observed
from rfnserver.ros_typed_frame import TypedFrame

#: A topic that speaks only of changes, and that nobody publishes, is dead after this time, seconds.
_WITHOUT_PUBLISHER_S = 2.0


class BoundCondition:
    """A server that watches one topic.

    Subscribes:
        the topic of the binding; one with ``timeout_s`` only while somebody watches
    Actions:
        the binding's name (roboframenet_msgs/FilledSemanticFrameAction)
    """

    def __init__(self, binding: ConditionBinding) -> None:
        """
        Raises:
            FileRefused: the type of the topic is not built here, or has no such fields
        """
        self._binding = binding
        self._type = _message_class(binding)
        self._lock = threading.Lock()
        self._message: Any = None
        self._arrived_s = self._began_s = self._connected_s = time.monotonic()
        self._stamp = rospy.Time()
        self._subscriber: Optional[rospy.Subscriber] = None
        self._server = ConditionServer(
            binding.name, self._holds, while_watched=self._while_watched, **binding.statement
        )
        self._server.start()
        if not binding.timeout_s:
            self._subscribe()

    def register(self) -> None:
        """Register for the frame. Without a registrar this takes seconds, and is repeated when a registrar starts."""
        self._server.register_with_frame(self._binding.frame_name)

    def _subscribe(self) -> rospy.Subscriber:
        self._subscriber = rospy.Subscriber(
            self._binding.topic, self._type, self._on_message, queue_size=10, tcp_nodelay=True
        )
        return self._subscriber

    def _while_watched(self) -> Callable[[], None]:
        self._began_s = self._connected_s = time.monotonic()
        if not self._binding.timeout_s:
            return lambda: None
        with self._lock:
            self._message = None
        return self._subscribe().unregister

    def _on_message(self, message: Any) -> None:
        # A std_msgs/Header is its own header.
        stamp = getattr(getattr(message, "header", message), "stamp", None)
        with self._lock:
            self._message, self._arrived_s = message, time.monotonic()
            self._stamp = stamp or rospy.Time.now()
        self._server.changed()

    def _holds(self, frame: TypedFrame) -> Optional[Observed]:
        with self._lock:
            message, arrived_s, stamp = self._message, self._arrived_s, self._stamp
        binding, now_s = self._binding, time.monotonic()
        self._check_alive(now_s, since_s=self._began_s if message is None else arrived_s)
        arguments = {argument.name: argument for argument in frame.arguments}
        if message is None:
            return Observed(False, rospy.Time.now()) if binding.event_s else None
        try:
            holds = binding.condition.holds(message, arguments)
        except NotComparable as reason:
            raise ConditionUnknown(f"{binding.topic}: {reason}") from reason
        if binding.event_s and now_s - arrived_s > binding.event_s:
            return Observed(False, rospy.Time.now())
        return Observed(holds, stamp) if binding.timeout_s else Observed.still(holds, stamp)

    def _check_alive(self, now_s: float, *, since_s: float) -> None:
        """
        Raises:
            ConditionUnknown: the topic is dead
        """
        topic, timeout_s = self._binding.topic, self._binding.timeout_s
        if timeout_s:
            if now_s - since_s > timeout_s:
                raise ConditionUnknown(f"{topic} has said nothing for {timeout_s:g} s")
            return
        if self._subscriber is not None and self._subscriber.get_num_connections():
            self._connected_s = now_s
        elif now_s - self._connected_s > _WITHOUT_PUBLISHER_S:
            raise ConditionUnknown(f"nobody publishes {topic}")


def _message_class(binding: ConditionBinding) -> Any:
    message_class = roslib.message.get_message_class(binding.type_name)
    if message_class is None:
        raise FileRefused(
            [
                binding.problem(
                    "UNKNOWN_TYPE",
                    "type",
                    f"'{binding.type_name}'",
                    "the type of a message",
                    "is its package built and sourced?",
                )
            ]
        )
    condition, fields = binding.condition, _fields_of(message_class)
    problems: List[Optional[Problem]] = []
    if condition.entries:
        problems.append(path_problem(binding, "entries", condition.entries, fields))
        fields = fields_below(fields, condition.entries) if problems[0] is None else {}
    if not any(problems):
        problems += [path_problem(binding, f"where.{path}", path, fields) for path, _ in condition.where]
        if condition.field:
            problems.append(path_problem(binding, "field", condition.field, fields))
    found = [problem for problem in problems if problem is not None]
    if found:
        raise FileRefused(found)
    return message_class


def _fields_of(message_class: Any) -> Dict[str, Optional[Mapping[str, Any]]]:
    """Return the names of the fields of a message, with the fields of each that is a message, or a list of them."""
    found: Dict[str, Optional[Mapping[str, Any]]] = {}
    for name, type_name in zip(message_class.__slots__, message_class._slot_types):
        plain = genmsg.msgs.parse_type(type_name)[0]
        inner = roslib.message.get_message_class(plain) if "/" in plain else None
        found[name] = _fields_of(inner) if inner is not None else _fields_of_time(plain)
    return found


def _fields_of_time(type_name: str) -> Optional[Mapping[str, Any]]:
    return {"secs": None, "nsecs": None} if type_name in ("time", "duration") else None
