"""Reads binding files, which map frames to action servers, services and topics, and to conditions on topics."""

from dataclasses import dataclass, field
from enum import Enum
from typing import Any, Dict, List, Mapping, Optional, Set, Tuple

import yaml

from checked_files.marked_yaml import Reader, describe, is_empty
from checked_files.problem import FileRefused
from frame_bindings.condition_file import ConditionBinding, read_condition
from frame_bindings.statements import read_statement
from rfnserver.goal_binding import SOURCE_KEYS
from rfnserver.results import BY_CONVENTION, ERROR_KEYS, ResultNames
from semantic_frames.server_statement import STATEMENT_KEYS


class Kind(Enum):
    """Kinds of targets."""

    ACTION = "action"
    SERVICE = "service"
    TOPIC = "topic"


#: Keys that name fields of a result or a response.
RESULT_KEYS = ("success_field", "text_field", "error_field")
BINDING_KEYS = (
    "frame",
    "name",
    "action",
    "service",
    "topic",
    "type",
    "fields",
    "constants",
    "ignored_elements",
    *RESULT_KEYS,
    "goal_timeout_s",
    "server_timeout_s",
    "preempt_timeout_s",
    *STATEMENT_KEYS,
)


@dataclass(frozen=True)
class Binding:
    """The binding of a frame.

    Attributes:
        frame_name: the frame
        name: action that takes the frame; by default the name of the frame
        kind: kind of the target
        target: name of the action server, service or topic
        type_name: "move_base_msgs/MoveBaseAction", "std_srvs/SetBool", "std_msgs/String"
        fields: by path of a field; see :mod:`rfnserver.goal_binding`
        constants: what each message holds before elements fill it, as YAML has it
        ignored_elements: elements that need not fill a field
        result_names: fields of the result of an action, or the response of a service, that say whether it worked
        server_timeout_s: how long to wait for the server, the service or a subscriber
        goal_timeout_s: how long an action or a service call may take
        preempt_timeout_s: how long an action may take to end after a cancel
        statement: what the server states about itself, see :mod:`semantic_frames.server_statement`
        line: line of the file
    """

    frame_name: str
    name: str
    kind: Kind
    target: str
    type_name: str
    fields: Mapping[str, Any] = field(default_factory=dict)
    constants: Mapping[str, Any] = field(default_factory=dict)
    ignored_elements: Tuple[str, ...] = ()
    result_names: ResultNames = BY_CONVENTION
    server_timeout_s: float = 5.0
    goal_timeout_s: float = 300.0
    preempt_timeout_s: float = 5.0
    statement: Mapping[str, Any] = field(default_factory=dict)
    line: int = 0


@dataclass(frozen=True)
class BindingFile:
    """What a file binds.

    Attributes:
        bindings: frames that are carried out
        conditions: frames that are watched
    """

    bindings: Tuple[Binding, ...] = ()
    conditions: Tuple[ConditionBinding, ...] = ()


def load_bindings(text: str, path: str) -> BindingFile:
    """Read a binding file: a mapping with the keys ``bindings`` and ``conditions``, or one of them, both lists.

    Args:
        text: content of the file
        path: where it came from, for problems
    Raises:
        FileRefused: the file has mistakes; the exception carries all of them
    """
    reader = Reader(path)
    root = reader.compose(text, "a mapping with bindings")
    entries = reader.mapping(root, "", ("bindings", "conditions"))
    if not entries and not reader.problems:
        reader.report("EMPTY", root, "file", "nothing", "bindings or conditions")
    bindings: List[Binding] = []
    conditions: List[ConditionBinding] = []
    names: Set[str] = set()

    def take(name: str, item: yaml.Node, key: str) -> None:
        if name in names:
            reader.report("DUPLICATE_NAME", item, f"{key}.name", f"a second '{name}'", "names that differ")
        names.add(name)

    for key, item in reader.sequence(entries.get("bindings"), "bindings"):
        binding = _binding(reader, item, key)
        if binding is not None:
            take(binding.name, item, key)
            bindings.append(binding)
    for key, item in reader.sequence(entries.get("conditions"), "conditions"):
        condition = read_condition(reader, item, key)
        take(condition.name, item, key)
        conditions.append(condition)
    reader.refuse_if_wrong()
    return BindingFile(tuple(bindings), tuple(conditions))


def _binding(reader: Reader, node: yaml.Node, key: str) -> Optional[Binding]:
    entries = reader.mapping(node, key, BINDING_KEYS, required=("frame", "type"))
    kinds = [kind for kind in Kind if kind.value in entries]
    if len(kinds) != 1:
        found = " and ".join(kind.value for kind in kinds) or "none of them"
        reader.report("NO_TARGET", node, key, found, "exactly one of action, service, topic")
        return None
    kind = kinds[0]
    type_name = reader.name(entries.get("type"), f"{key}.type")
    if type_name and type_name.count("/") != 1:
        reader.report("NOT_A_TYPE", entries["type"], f"{key}.type", f"'{type_name}'", "package/Type")
    elif kind is Kind.ACTION and not type_name.endswith("Action"):
        reader.report(
            "NOT_A_TYPE", entries["type"], f"{key}.type", f"'{type_name}'", "the action's type, such as pkg/MoveAction"
        )
    for name in RESULT_KEYS:
        if name in entries and kind is Kind.TOPIC:
            reader.report("UNKNOWN_KEY", entries[name], f"{key}.{name}", name, "only beside 'action' or 'service'")
    frame_name = reader.name(entries.get("frame"), f"{key}.frame")
    return Binding(
        frame_name=frame_name,
        name=reader.text(entries.get("name"), f"{key}.name", frame_name),
        kind=kind,
        target=reader.name(entries.get(kind.value), f"{key}.{kind.value}"),
        type_name=type_name,
        fields=_fields(reader, entries.get("fields"), f"{key}.fields"),
        constants=_constants(reader, entries.get("constants"), f"{key}.constants"),
        ignored_elements=reader.texts(entries.get("ignored_elements"), f"{key}.ignored_elements"),
        result_names=_result_names(reader, entries, key),
        statement=read_statement(reader, node, key, entries, STATEMENT_KEYS),
        line=node.start_mark.line + 1,
        **{
            name: reader.seconds(entries[name], f"{key}.{name}", 1.0)
            for name in ("server_timeout_s", "goal_timeout_s", "preempt_timeout_s")
            if name in entries
        },
    )


def _result_names(reader: Reader, entries: Mapping[str, yaml.Node], key: str) -> ResultNames:
    """Read the names of fields; a key that is missing leaves its field to convention."""
    names: Dict[str, Any] = {}
    for name in (name for name in RESULT_KEYS if name in entries):
        node = entries[name]
        if name == "error_field" and isinstance(node, yaml.MappingNode):
            parts = reader.mapping(node, f"{key}.{name}", ERROR_KEYS, required=("name",))
            names[name] = {part: reader.text(item, f"{key}.{name}.{part}") for part, item in parts.items()}
        else:
            names[name] = reader.text(node, f"{key}.{name}")
    return ResultNames(**names)


def _fields(reader: Reader, node: Optional[yaml.Node], key: str) -> Dict[str, Any]:
    if node is None or is_empty(node):
        return {}
    if not isinstance(node, yaml.MappingNode):
        reader.report("WRONG_TYPE", node, key, describe(node), "a mapping of fields to elements")
        return {}
    fields: Dict[str, Any] = {}
    for name_node, value in node.value:
        name = reader.name(name_node, key)
        if name in fields:
            reader.report("DUPLICATE_KEY", name_node, f"{key}.{name}", f"a second '{name}'", "each field once")
        elif isinstance(value, yaml.ScalarNode):
            fields[name] = reader.name(value, f"{key}.{name}")
        else:
            parts = reader.mapping(value, f"{key}.{name}", SOURCE_KEYS)
            fields[name] = {
                part: _table(reader, item, f"{key}.{name}.{part}")
                if part == "values"
                else reader.text(item, f"{key}.{name}.{part}")
                for part, item in parts.items()
            }
    return fields


def _constants(reader: Reader, node: Optional[yaml.Node], key: str) -> Dict[str, Any]:
    """Read values of any form; whether the message has such fields, its type decides later."""
    if node is None or is_empty(node):
        return {}
    if not isinstance(node, yaml.MappingNode):
        reader.report("WRONG_TYPE", node, key, describe(node), "a mapping of fields to values")
        return {}
    read: Dict[str, Any] = yaml.safe_load(yaml.serialize(node))
    return read


def _table(reader: Reader, node: yaml.Node, key: str) -> Dict[str, str]:
    """Read the words of a person and the words that stand for them in a field."""
    if not isinstance(node, yaml.MappingNode):
        reader.report("WRONG_TYPE", node, key, describe(node), "a mapping of words to values")
        return {}
    return {reader.name(words, key): reader.text(value, key) for words, value in node.value}


__all__ = ["Binding", "BindingFile", "FileRefused", "Kind", "load_bindings"]
