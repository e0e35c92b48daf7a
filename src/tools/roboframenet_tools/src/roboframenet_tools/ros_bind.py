"""``rfn bind``: writes a binding for a live action server, service or topic."""

import argparse
import difflib
import os
import sys
from dataclasses import dataclass
from typing import Any, Dict, List, Set, Tuple

import rosgraph
import roslib.message
import rosservice

from offline_pipeline.knowledge import Knowledge, load_knowledge, shipped_domains
from rfnserver.goal_binding import BoundElement
from rfnserver.ros_goal_messages import fields_of, goal_type_of
from roboframenet_tools.binding_text import binding_text, frames_that_fit, words_of
from roboframenet_tools.ros_graph import is_master_up, live_knowledge

EXAMPLES = """examples:
  rfn bind move_base --frame navigating_to_location
  rfn bind move_base --frame navigating_to_location --out my_robot/config/bindings.yaml
  rfn bind set_light        without --frame: lists five frames that may fit

The type is that of the running server. The frames are those of the running pipeline, or those shipped.
A field is filled by the element of its name; what else may fit is a comment.
Exit status: 0 written, 1 the text needs your hand (it says where), 2 wrong usage, 6 no master or no such name
"""
_NOT_THERE = 6


class NotThere(LookupError):
    """Nothing of that name is in the running graph."""


@dataclass(frozen=True)
class Target:
    """A live action server, service or topic.

    Attributes:
        kind: "action", "service" or "topic"
        type_name: "move_base_msgs/MoveBaseAction"
        message_type: class of its goals, requests or messages
        response: names of the fields of a service's response
    """

    kind: str
    type_name: str
    message_type: Any
    response: Tuple[str, ...] = ()


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn bind``."""
    parser.epilog = EXAMPLES
    parser.add_argument("name", help="name of the action server, service or topic")
    parser.add_argument("--frame", help="the frame that it carries out")
    parser.add_argument("--out", metavar="FILE", help="write a file instead of the standard output")


def run(arguments: argparse.Namespace) -> int:
    """Write the binding; return the exit status."""
    if not is_master_up():
        return _complain(f"no ROS master at {rosgraph.get_master_uri()}: start the server first", _NOT_THERE)
    if arguments.out and os.path.lexists(arguments.out):
        return _complain(f"{arguments.out} exists already; nothing was written", 2)
    try:
        target = find_target(arguments.name)
    except NotThere as error:
        return _complain(str(error), _NOT_THERE)
    fields = fields_of(target.message_type)
    knowledge = _knowledge()
    frames = _elements(knowledge)
    if arguments.frame not in frames:
        words = words_of(arguments.name, target.type_name, *(field.name for field in fields))
        fitting = frames_that_fit(fields, frames, words=words, verbs=_verbs(knowledge))
        return _complain(_which_frame(arguments.frame, frames, fitting), 2)
    text, fault = binding_text(
        frame_name=arguments.frame,
        elements=frames[arguments.frame],
        kind=target.kind,
        target=arguments.name,
        type_name=target.type_name,
        fields=fields,
        response=target.response,
    )
    if not arguments.out:
        print(text, end="")
    else:
        with open(arguments.out, "x", encoding="utf-8") as file:
            file.write(text)
        print(
            f"{arguments.out}\nNext: rosrun frame_bindings frame_bindings _files:={os.path.abspath(arguments.out)}\n"
            "and in a launch file as the README of frame_bindings shows."
        )
    return _complain(f"this needs your hand: {fault}", 1) if fault else 0


def find_target(name: str) -> Target:
    """Find an action server, a service or a topic in the running graph.

    Raises:
        NotThere: nothing has that name, or its type is not built here
    """
    master = rosgraph.Master("/rfn_bind")
    wanted = rosgraph.names.resolve_name(name, "/rfn_bind")
    published, subscribed, services = master.getSystemState()
    types: Dict[str, str] = dict(master.getTopicTypes())
    # The result is published by the server; a client alone has the type that it believes in.
    results = {topic: types.get(topic, "") for topic, nodes in published if nodes and topic.endswith("/result")}
    result_type = results.get(wanted + "/result", "")
    if result_type.endswith("ActionResult"):
        type_name = result_type[: -len("Result")]
        return Target("action", type_name, goal_type_of(_message_class(type_name)))
    if wanted in [service for service, _ in services]:
        type_name = rosservice.get_service_type(wanted) or ""
        kind = roslib.message.get_service_class(type_name) if type_name else None
        if kind is None:
            raise NotThere(f"the type '{type_name}' of the service {wanted} is not built here")
        return Target("service", type_name, kind._request_class, tuple(kind._response_class.__slots__))
    if wanted in [topic for topic, nodes in subscribed if nodes]:
        return Target("topic", types[wanted], _message_class(types[wanted]))
    servers = sorted(topic[: -len("/result")] for topic, kind in results.items() if kind.endswith("ActionResult"))
    alike = difflib.get_close_matches(wanted, servers, n=1)
    raise NotThere(
        f"no action server, service or subscribed topic {wanted}"
        + (f"; did you mean {alike[0]}?" if alike else f"; action servers: {', '.join(servers) or 'none'}")
    )


def _message_class(type_name: str) -> Any:
    found = roslib.message.get_message_class(type_name)
    if found is None:
        raise NotThere(f"the type {type_name} is not built here; is the workspace of its package sourced?")
    return found


def _knowledge() -> Knowledge:
    """Return the frames of the running pipeline; without one, those shipped."""
    published, _, _ = rosgraph.Master("/rfn_bind").getSystemState()
    if any(nodes and topic.endswith("/frame_catalogue") for topic, nodes in published):
        try:
            return live_knowledge(timeout_s=5.0)
        except LookupError as error:
            print(f"rfn bind: the shipped frames are used: {error}", file=sys.stderr)
    return load_knowledge([shipped_domains()])


def _elements(knowledge: Knowledge) -> Dict[str, List[BoundElement]]:
    return {
        name: [BoundElement(element.name, is_core=element.is_core) for element in frame.frame_elements]
        for name, frame in knowledge.frames.items()
    }


def _verbs(knowledge: Knowledge) -> Dict[str, Set[str]]:
    """Return the verbs that evoke each frame."""
    verbs: Dict[str, Set[str]] = {}
    for unit in knowledge.lexicon.units:
        verbs.setdefault(unit.frame_name, set()).update(unit.verbs)
    return verbs


def _which_frame(name: str, frames: Dict[str, List[BoundElement]], fitting: Tuple[str, ...]) -> str:
    if name:
        alike = difflib.get_close_matches(name, list(frames), n=1)
        hint = f"did you mean {alike[0]}?" if alike else f"'rfn new {name} --from-action TYPE' makes one"
        return f"there is no frame '{name}'; {hint}"
    offered = f"these may fit: {', '.join(fitting)}" if fitting else "'rfn explain SENTENCE' names that of a sentence"
    return f"which frame? Give --frame; {offered}"


def _complain(sentence: str, status: int) -> int:
    print(f"rfn bind: {sentence}", file=sys.stderr)
    return status
