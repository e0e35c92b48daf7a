"""Parameters that dynamic_reconfigure changes while a node runs; made from the class that declares them."""

import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any, Callable, Dict, Generic, List, TypeVar

import rospy
from dynamic_reconfigure.server import Server

from roboframenet_ros.parameters import LiveParameter, ParameterError, Parameters, live_parameters, plain

Kind = TypeVar("Kind", bound=Parameters)
#: What dynamic_reconfigure calls the types.
_TYPES = {bool: "bool", int: "int", float: "double", str: "str"}
#: Of numbers without a bound; its messages have integers of 32 bits.
_BOUNDS = {int: 2**31 - 1, float: math.inf}


class LiveParameters(Generic[Kind]):
    """The settings of a node, which ``rosrun dynamic_reconfigure dynparam`` and rqt_reconfigure can change.

    Offers: what a server of dynamic_reconfigure does, with the private parameters that were declared with ``is_live``.
    A value that contradicts others changes nothing, and the log says why.
    """

    def __init__(self, settings: Kind, on_change: Callable[[Kind], None], *, namespace: str = "") -> None:
        """Offer the parameters; rospy must be initialised.

        Args:
            settings: as they were read at the start
            on_change: called with the new settings, in a thread of rospy
            namespace: of the parameters; that of the node by default
        """
        self._settings = settings
        self._on_change = on_change
        self._names = [one.name for one in live_parameters(type(settings))]
        self._types = {one.name: type(one.default) for one in live_parameters(type(settings))}
        self._server = Server(_description(live_parameters(type(settings))), self._change, namespace)

    def _change(self, config: Any, _level: int) -> Any:
        try:
            settings = replace(self._settings, **{name: config[name] for name in self._names})
        except ParameterError as error:
            rospy.logwarn("not changed: %s", error)
            settings = self._settings
        if settings != self._settings:
            self._settings = settings
            rospy.loginfo("changed: %s", settings)
            self._on_change(settings)
        for name in self._names:
            config[name] = self._types[name](plain(getattr(settings, name)))
        return config


def _description(parameters: "tuple[LiveParameter, ...]") -> Any:
    """Return what the generator of dynamic_reconfigure makes of a .cfg file."""
    described = [_parameter(one) for one in parameters]
    whole = {
        "name": "Default",
        "type": "",
        "state": True,
        "cstate": "true",
        "id": 0,
        "parent": 0,
        "parameters": described,
        "groups": [],
        "upper": "DEFAULT",
        "lower": "groups",
        "class": "DEFAULT",
    }
    columns = {
        column: {one["name"]: one[key] for one in described}
        for column, key in (
            ("defaults", "default"),
            ("min", "min"),
            ("max", "max"),
            ("level", "level"),
            ("type", "type"),
        )
    }
    return SimpleNamespace(config_description=whole, all_level=0, **columns)


def _parameter(one: LiveParameter) -> Dict[str, Any]:
    kind = type(one.default)
    least: Any = ""
    most: Any = ""
    if kind is bool:
        least, most = False, True
    elif kind in _BOUNDS:
        least = kind(-_BOUNDS[kind] if one.least is None else one.least)
        most = kind(_BOUNDS[kind] if one.most is None else one.most)
    return {
        "name": one.name,
        "type": _TYPES[kind],
        "default": one.default,
        "min": least,
        "max": most,
        "level": 0,
        "description": one.name.replace("_", " "),
        "edit_method": str({"enum": _choices(one), "enum_description": one.name}) if one.choices else "",
    }


def _choices(one: LiveParameter) -> List[Dict[str, Any]]:
    return [
        {"name": choice, "type": "str", "value": choice, "description": choice, "srcline": 0, "srcfile": ""}
        for choice in one.choices
    ]
