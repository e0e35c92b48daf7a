#!/usr/bin/python3
"""A driver with a real dynamic_reconfigure server: settings exposure (1 to 100), gain and auto_gain."""

from typing import Any, ClassVar, Dict, List

import rospy
from dynamic_reconfigure.server import Server


def setting(name, type_name, default, minimum, maximum):
    return {
        "name": name,
        "type": type_name,
        "default": default,
        "min": minimum,
        "max": maximum,
        "level": 0,
        "description": name,
        "edit_method": "",
    }


class CameraType:
    """What the generator of dynamic_reconfigure makes of a .cfg file."""

    _parameters: ClassVar[List[Dict[str, Any]]] = [
        setting("exposure", "int", 10, 1, 100),
        setting("gain", "double", 1.0, 0.0, 8.0),
        setting("auto_gain", "bool", True, False, True),
    ]
    config_description: ClassVar[Dict[str, Any]] = {
        "name": "Default",
        "type": "",
        "state": True,
        "cstate": "true",
        "id": 0,
        "parent": 0,
        "parameters": _parameters,
        "groups": [],
        "upper": "DEFAULT",
        "lower": "groups",
        "class": "DEFAULT",
    }
    defaults: ClassVar[Dict[str, Any]] = {parameter["name"]: parameter["default"] for parameter in _parameters}
    min: ClassVar[Dict[str, Any]] = {parameter["name"]: parameter["min"] for parameter in _parameters}
    max: ClassVar[Dict[str, Any]] = {parameter["name"]: parameter["max"] for parameter in _parameters}
    level: ClassVar[Dict[str, int]] = {parameter["name"]: parameter["level"] for parameter in _parameters}
    type: ClassVar[Dict[str, str]] = {parameter["name"]: parameter["type"] for parameter in _parameters}
    all_level = 0


if __name__ == "__main__":
    rospy.init_node("camera")
    server = Server(CameraType, lambda config, level: config)
    rospy.spin()
