"""Fields of ROS messages that are goals, and their values."""

import copy
import io
import math
import re
from typing import Any, Dict, Iterator, List, Mapping, Tuple

import genpy
import roslib.message
from geometry_msgs.msg import PoseStamped

from rfnserver.goal_types import FILLING_OF_TYPE, PLACE_TYPES, Constant, Filling, GoalField, base_type

#: A field, or the number of an item, in a path: "place_locations[0].place_pose".
_STEP = re.compile(r"\w+")


def is_action_type(candidate: Any) -> bool:
    """Whether something is the class of an action ("FibonacciAction")."""
    return isinstance(candidate, type) and issubclass(candidate, genpy.Message) and "action_goal" in candidate.__slots__


def goal_type_of(action_type: Any) -> Any:
    """Return the class of the goals of an action type."""
    return type(action_type().action_goal.goal)


def result_type_of(action_type: Any) -> Any:
    """Return the class of the results of an action type."""
    return type(action_type().action_result.result)


def fields_of(message_type: Any) -> Tuple[GoalField, ...]:
    """Return every field of a message type, including those of nested messages."""
    return tuple(_fields(message_type, "", ()))


def with_constants(message_type: Any, constants: Mapping[str, Any]) -> Any:
    """Return a message with the values that it always has: mappings for messages, lists for arrays.

    Raises:
        ValueError: it has no such field, or the field another type; the message says which
    """
    message = message_type()
    try:
        genpy.message.fill_message_args(message, [copy.deepcopy(dict(constants))])
        message.serialize(io.BytesIO())
    except (genpy.MessageException, ValueError) as error:
        raise ValueError(f"constants: {error}") from error
    return message


def fields_in_lists(message: Any) -> Tuple[GoalField, ...]:
    """Return the fields of the messages that stand in lists of a message: "place_locations[0].place_pose"."""
    return tuple(_fields_in_lists(message, ""))


def _fields_in_lists(message: Any, prefix: str) -> Iterator[GoalField]:
    for name in message.__slots__:
        value = getattr(message, name)
        if isinstance(value, genpy.Message):
            yield from _fields_in_lists(value, f"{prefix}{name}.")
        elif isinstance(value, list):
            for index, item in enumerate(value):
                path = f"{prefix}{name}[{index}]"
                if isinstance(item, genpy.Message) and item._type in PLACE_TYPES:
                    yield GoalField(path, item._type, {})
                elif isinstance(item, genpy.Message):
                    yield from _fields(type(item), f"{path}.", (type(message),))
                    yield from _fields_in_lists(item, f"{path}.")


def _fields(message_type: Any, prefix: str, above: Tuple[Any, ...]) -> Iterator[GoalField]:
    constants = _constants(message_type)
    for name, type_name in zip(message_type.__slots__, message_type._slot_types):
        path = prefix + name
        yield GoalField(path=path, type_name=type_name, constants=constants)
        # Words never fill a header, and the fields of an array of messages have no single path.
        if "/" in type_name and "[" not in type_name and type_name not in PLACE_TYPES + ("std_msgs/Header",):
            inner = roslib.message.get_message_class(type_name)
            if inner is not None and inner not in above:
                yield from _fields(inner, path + ".", above + (message_type,))


def _constants(message_type: Any) -> Dict[str, Constant]:
    return {
        name: value
        for name, value in vars(message_type).items()
        if name.isupper() and not name.startswith("_") and isinstance(value, (int, float, str))
    }


def fill(message: Any, values: Mapping[str, Any]) -> Any:
    """Set fields of a message and return it.

    Args:
        message: of the type that ``values`` were made for
        values: by path, from :func:`rfnserver.goal_binding.goal_values`; places as PoseStamped, durations in seconds
    """
    for path, value in values.items():
        *parents, last = _STEP.findall(path)
        holder = message
        for step in parents:
            holder = holder[int(step)] if step.isdecimal() else getattr(holder, step)
        if last.isdecimal():
            holder[int(last)] = _converted(holder[int(last)]._type, value)
        else:
            setattr(holder, last, _converted(holder._slot_types[holder.__slots__.index(last)], value))
    return message


def _converted(type_name: str, value: Any) -> Any:
    if isinstance(value, List):
        return [_converted(base_type(type_name), item) for item in value]
    filling = FILLING_OF_TYPE[type_name]
    if filling is Filling.DURATION:
        return genpy.Duration.from_sec(value)
    if filling is Filling.PLACE:
        return _place(type_name, value)
    return value


def _place(type_name: str, pose: PoseStamped) -> Any:
    if type_name == "geometry_msgs/PoseStamped":
        return pose
    if type_name == "geometry_msgs/Pose":
        return pose.pose
    if type_name == "geometry_msgs/Point":
        return pose.pose.position
    message = roslib.message.get_message_class(type_name)()
    if type_name == "geometry_msgs/PointStamped":
        message.header, message.point = pose.header, pose.pose.position
        return message
    orientation = pose.pose.orientation
    message.x, message.y = pose.pose.position.x, pose.pose.position.y
    message.theta = 2.0 * math.atan2(orientation.z, orientation.w)
    return message
