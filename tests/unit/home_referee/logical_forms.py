"""Logical forms of commands, as the GPSR generators publish them, with the ids of the home in their slots.

A form is a tree: ``("bring", Description(...), Description(...))``. Forms are read from text such as
``(put (λ$1:e (is_a $1 apple) (at $1 kitchen_table)) desk)``.
"""

import re
from dataclasses import dataclass
from typing import List, Tuple, Union

_TOKEN = re.compile(r"\(|\)|\{[^}]*\}|\"[^\"]*\"|λ\$\d+:e|[^\s(){}\"]+")
#: Predicates of a description that have a value, and those that have none.
_WITH_VALUE = ("is_a", "at", "name")
_POSTURES = ("sitting", "standing")


class NotInThisHome(ValueError):
    """A form says something that no home of ours has: gestures, genders, the left most object."""


@dataclass(frozen=True)
class Description:
    """What a form says of a thing or a person.

    Attributes:
        is_a: ids or category of the home; empty for anything
        at: id of a room or of furniture; empty for anywhere
        name: id of a person
        posture: sitting, standing; empty for any
        is_person: whether it describes a person
    """

    is_a: str = ""
    at: str = ""
    name: str = ""
    posture: str = ""
    is_person: bool = False


@dataclass(frozen=True)
class Form:
    """A predicate with its arguments: forms, descriptions, words."""

    predicate: str
    arguments: Tuple[Union["Form", Description, str], ...] = ()

    @property
    def things(self) -> Tuple[Description, ...]:
        """Its descriptions of things."""
        return tuple(one for one in self.arguments if isinstance(one, Description) and not one.is_person)

    @property
    def persons(self) -> Tuple[Description, ...]:
        """Its descriptions of persons."""
        return tuple(one for one in self.arguments if isinstance(one, Description) and one.is_person)


_Node = Union[str, List["_Node"]]


def read_form(text: str) -> Form:
    """Read a form.

    Raises:
        NotInThisHome: it has a predicate that the home has nothing for
        ValueError: it is no form
    """
    tokens = _TOKEN.findall(text)
    node, end = _node(tokens, 0)
    if end != len(tokens):
        raise ValueError(f"more than one form: {text}")
    return _form(node)


def _node(tokens: List[str], start: int) -> "Tuple[_Node, int]":
    if start >= len(tokens) or tokens[start] == ")":
        raise ValueError("a form ends too early")
    if tokens[start] != "(":
        return tokens[start].strip('"'), start + 1
    inside: List[_Node] = []
    start += 1
    while start < len(tokens) and tokens[start] != ")":
        node, start = _node(tokens, start)
        inside.append(node)
    if start >= len(tokens):
        raise ValueError("a bracket is not closed")
    return inside, start + 1


def _form(node: "_Node") -> Form:
    if isinstance(node, str):
        return Form(node)
    head = node[0]
    if not isinstance(head, str) or head.startswith("λ"):
        raise NotInThisHome("a description without a predicate")
    arguments: List[Union[Form, Description, str]] = []
    for one in node[1:]:
        if isinstance(one, str):
            arguments.append(one)
        elif isinstance(one[0], str) and one[0].startswith("λ"):
            arguments += _described(one)
        else:
            arguments.append(_form(one))
    return Form(head, tuple(arguments))


def _described(node: "_Node") -> "List[Union[Form, Description, str]]":
    """Read ``λ$1:e`` and its predicates. What a second variable has is asked for: (name $2 $1)."""
    values = {}
    asked: List[Union[Form, Description, str]] = []
    for predicate in _predicates(node):
        if isinstance(predicate, str):
            raise NotInThisHome(predicate)
        name, *rest = predicate
        words = [str(one) for one in rest]
        if name == "person":
            values["is_person"] = True
        elif name in _POSTURES:
            values["posture"] = str(name)
        elif name in ("name", "pose") and words[-1].startswith("$"):
            asked.append(str(name))
        elif name in _WITH_VALUE and not words[-1].startswith("$"):
            values[str(name)] = words[-1]
        else:
            raise NotInThisHome(str(name))
    return [*asked, Description(**values)]


def _predicates(node: "_Node") -> "List[_Node]":
    found: List[_Node] = []
    for one in node[1:]:
        if not isinstance(one, str) and (one[0] == "and" or str(one[0]).startswith("λ")):
            found += _predicates(one)
        else:
            found.append(one)
    return found
