"""What a planar laser shows: the nearest point, walls, and what is as wide as a person."""

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Iterator, List, Sequence, Tuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

#: The robot drives into what is in this sector, to each side of ahead.
AHEAD_RAD = math.radians(30.0)
#: Two neighbouring points are of different things if their ranges differ by more, metres.
_GAP_M = 0.3
#: A piece is straight if no point is farther from the line between its ends, metres.
_STRAIGHT_M = 0.06
#: A straight piece is a wall from this length on, metres.
_WALL_M = 0.6
#: Widths of a person, metres.
_PERSON_M = (0.12, 0.9)
#: Fewer points show nothing.
_LEAST_POINTS = 3


@dataclass(frozen=True)
class Thing:
    """Something that the laser shows.

    Attributes:
        distance_m: of its nearest point
        ahead_m: of its nearest point in the sector of :data:`AHEAD_RAD`; infinite for none there
        width_m: from one end to the other
        is_straight: whether it is a piece of a wall
    """

    distance_m: float
    ahead_m: float
    width_m: float
    is_straight: bool = False

    @property
    def is_wall(self) -> bool:
        """Whether it is a wall."""
        return self.is_straight and self.width_m >= _WALL_M

    @property
    def is_as_wide_as_a_person(self) -> bool:
        """Whether it may be a person, by its width."""
        return not self.is_wall and _PERSON_M[0] <= self.width_m <= _PERSON_M[1]


class Scan:
    """One turn of a laser. Readings that are not finite, or beyond its limits, show nothing."""

    def __init__(
        self,
        ranges_m: Sequence[float],
        *,
        first_rad: float,
        step_rad: float,
        least_m: float = 0.0,
        most_m: float = math.inf,
    ) -> None:
        """
        Args:
            ranges_m: distances, in the order of their angles
            first_rad: angle of the first one; 0 ahead, positive to the left
            step_rad: from one to the next
            least_m: shorter ones are no readings
            most_m: longer ones are none
        """
        distances: NDArray[np.float64] = np.array(ranges_m, dtype=float)
        angles = first_rad + step_rad * np.arange(len(distances))
        angles = (angles + math.pi) % (2.0 * math.pi) - math.pi
        with np.errstate(invalid="ignore"):
            self._is_seen = np.isfinite(distances) & (distances >= least_m) & (distances <= most_m)
        self._distances, self._angles = distances, angles

    def nearest_m(self, half_angle_rad: float) -> float:
        """Return the distance of the nearest point ahead; infinite if there is none.

        Args:
            half_angle_rad: of the sector that counts, to each side
        """
        counts = self._is_seen & (np.abs(self._angles) <= half_angle_rad)
        return float(self._distances[counts].min()) if counts.any() else math.inf

    def things(self) -> Tuple[Thing, ...]:
        """Return what it shows; a wall is a thing for each of its straight pieces."""
        return tuple(thing for points in self._clusters() for thing in _things_of(points))

    def _clusters(self) -> Iterator["NDArray[np.float64]"]:
        """Yield the points of each thing: angle, distance, x and y."""
        points: List[Tuple[float, float]] = []
        for angle, distance, is_seen in zip(self._angles, self._distances, self._is_seen):
            if points and (not is_seen or abs(distance - points[-1][1]) > _GAP_M or abs(angle - points[-1][0]) > 0.2):
                yield _with_places(points)
                points = []
            if is_seen:
                points.append((float(angle), float(distance)))
        if points:
            yield _with_places(points)


def _with_places(points: Sequence[Tuple[float, float]]) -> "NDArray[np.float64]":
    polar: NDArray[np.float64] = np.array(points)
    places = polar[:, 1:] * np.stack([np.cos(polar[:, 0]), np.sin(polar[:, 0])], axis=1)
    return np.hstack([polar, places])


def _things_of(points: "NDArray[np.float64]") -> List[Thing]:
    pieces = _straight_pieces(points)
    if any(piece.is_wall for piece in pieces):
        return [piece for piece in pieces if piece.is_wall]
    if len(points) < _LEAST_POINTS:
        return []
    return [_thing(points, is_straight=len(pieces) == 1)]


def _straight_pieces(points: "NDArray[np.float64]") -> List[Thing]:
    """Divide points where they are farthest from the line between the ends, until each piece is straight."""
    found: List[Thing] = []
    waiting = [points]
    while waiting:
        piece = waiting.pop()
        if len(piece) < _LEAST_POINTS:
            continue
        start, end = piece[0, 2:], piece[-1, 2:]
        along = end - start
        length = float(np.hypot(*along))
        away = piece[:, 2:] - start
        offsets = (
            np.abs(along[0] * away[:, 1] - along[1] * away[:, 0]) / length
            if length > 0.0
            else np.hypot(away[:, 0], away[:, 1])
        )
        farthest = int(offsets.argmax())
        if offsets[farthest] <= _STRAIGHT_M:
            found.append(_thing(piece, is_straight=True))
        elif 0 < farthest < len(piece) - 1:
            waiting += [piece[: farthest + 1], piece[farthest:]]
    return found


def _thing(points: "NDArray[np.float64]", *, is_straight: bool) -> Thing:
    ahead = points[np.abs(points[:, 0]) <= AHEAD_RAD, 1]
    return Thing(
        distance_m=float(points[:, 1].min()),
        ahead_m=float(ahead.min()) if len(ahead) else math.inf,
        width_m=float(np.hypot(*(points[-1, 2:] - points[0, 2:]))),
        is_straight=is_straight,
    )
