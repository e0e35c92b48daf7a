"""Fields of a goal, and how words fill them."""

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
        type_name: as message definitions write it, "int32", "string[]", "geometry_msgs/PoseStamped"
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
    def is_list(self) -> bool:
        """Whether it is an array."""
        return self.type_name.endswith("[]")

    @property
    def filling(self) -> Optional[Filling]:
        """How words fill it; None when they cannot."""
        return FILLING_OF_TYPE.get(self.type_name[:-2] if self.is_list else self.type_name)

    @property
    def integer_range(self) -> Tuple[int, int]:
        """Least and greatest value of an integer field."""
        base = {"byte": "int8", "char": "uint8"}.get(self.type_name.rstrip("[]"), self.type_name.rstrip("[]"))
        bits = int(base[4:] if base.startswith("u") else base[3:])
        return (0, 2**bits - 1) if base.startswith("u") else (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1)
