"""Fields of a goal, and how words fill them."""

import re
from dataclasses import dataclass
from enum import Enum
from typing import Dict, Mapping, Optional, Tuple, Union

Constant = Union[int, float, str, bool]


class Filling(Enum):
    """How words become the value of a field."""

    INTEGER = "integer"
    FLOAT = "float"
    BOOLEAN = "boolean"
    STRING = "string"
    DURATION = "duration"
    PLACE = "place"


_INTEGERS = tuple(f"{sign}int{bits}" for sign in ("", "u") for bits in (8, 16, 32, 64)) + ("byte", "char")
#: Types that hold a pose or a part of one; the name of a place fills them.
PLACE_TYPES = (
    "geometry_msgs/PoseStamped",
    "geometry_msgs/PointStamped",
    "geometry_msgs/Pose",
    "geometry_msgs/Point",
    "geometry_msgs/Pose2D",
)
#: By the name of a field's type, as message definitions write it.
FILLING_OF_TYPE: Dict[str, Filling] = {
    **dict.fromkeys(_INTEGERS, Filling.INTEGER),
    "float32": Filling.FLOAT,
    "float64": Filling.FLOAT,
    "bool": Filling.BOOLEAN,
    "string": Filling.STRING,
    "duration": Filling.DURATION,
    **dict.fromkeys(PLACE_TYPES, Filling.PLACE),
}


@dataclass(frozen=True)
class GoalField:
    """One field of a goal, or of a message nested in it.

    Attributes:
        path: from the goal, "target_pose" or "limits.speed"
        type_name: as message definitions write it, "int32", "string[]", "float64[3]", "geometry_msgs/PoseStamped"
        constants: of the message that holds the field
    """

    path: str
    type_name: str
    constants: Mapping[str, Constant]

    @property
    def name(self) -> str:
        """The last part of the path."""
        return self.path.rpartition(".")[2]

    @property
    def element(self) -> str:
        """The name that an element for it has: "hold_time" for a field "holdTime"."""
        return element_name(self.name)

    @property
    def is_list(self) -> bool:
        """Whether it is an array."""
        return self.type_name.endswith("]")

    @property
    def length(self) -> Optional[int]:
        """How many values an array has; None for any number of them."""
        size = self.type_name.partition("[")[2].rstrip("]")
        return int(size) if size else None

    @property
    def filling(self) -> Optional[Filling]:
        """How words fill it; None when they cannot."""
        return FILLING_OF_TYPE.get(base_type(self.type_name))

    @property
    def own_choices(self) -> Mapping[str, int]:
        """The constants that are named after the field, by their other words: {"fast": 1} of ``uint8 MODE_FAST=1``."""
        own = set(self.element.split("_"))
        found = {}
        for name, value in self._integers().items():
            words = name.lower().split("_")
            rest = " ".join(word for word in words if word not in own)
            if rest and own.intersection(words):
                found[rest] = value
        return found

    @property
    def choices(self) -> Mapping[str, int]:
        """The constants that it may hold, by the words that name them; where some are named after it, only those."""
        return self.own_choices or {name.lower().replace("_", " "): value for name, value in self._integers().items()}

    def _integers(self) -> Mapping[str, int]:
        if self.filling is not Filling.INTEGER:
            return {}
        return {name: value for name, value in self.constants.items() if isinstance(value, int)}

    def constant(self, words: str, kind: type) -> Optional[Constant]:
        """Return the constant that words name: "fast" is FAST, or SPEED_FAST in a field called speed.

        Args:
            words: in any spelling
            kind: of the constant: int or str
        """
        wanted = "_".join(words.upper().replace("-", " ").split())
        for name in (wanted, f"{self.element.upper()}_{wanted}"):
            value = self.constants.get(name)
            if isinstance(value, kind) and isinstance(value, (int, str)) and not isinstance(value, bool):
                return value
        return self.choices.get(wanted.replace("_", " ").lower()) if kind is int else None

    @property
    def integer_range(self) -> Tuple[int, int]:
        """Least and greatest value of an integer field."""
        base = base_type(self.type_name)
        base = {"byte": "int8", "char": "uint8"}.get(base, base)
        bits = int(base[4:] if base.startswith("u") else base[3:])
        return (0, 2**bits - 1) if base.startswith("u") else (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1)


def base_type(type_name: str) -> str:
    """Return the type of the values of an array; other types as they are."""
    return type_name.partition("[")[0]


def element_name(name: str) -> str:
    """Return the name of a field as elements are named: "hold_time" for "holdTime" and "HoldTime"."""
    parts = re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name)
    return re.sub(r"_+", "_", parts).strip("_").lower()
