"""The occupied parts of the floor, as a grid of cells."""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Tuple

import numpy as np

from roboframenet_sim.room import Room

if TYPE_CHECKING:
    from numpy.typing import NDArray

Cell = Tuple[int, int]
"""Row (along y) and column (along x)."""


@dataclass(frozen=True, eq=False)
class OccupancyGrid:
    """A grid of square cells; everything outside the grid is occupied.

    ``is_taken`` has one row per step along y and one column per step along x; the origin is the corner of cell (0, 0).
    It must not be changed.
    """

    resolution_m: float
    origin_x_m: float
    origin_y_m: float
    is_taken: "NDArray[np.bool_]"

    def cell_of(self, x_m: float, y_m: float) -> Cell:
        """Return the cell of a point, which may lie outside the grid."""
        return (
            math.floor((y_m - self.origin_y_m) / self.resolution_m),
            math.floor((x_m - self.origin_x_m) / self.resolution_m),
        )

    def centre_of(self, cell: Cell) -> Tuple[float, float]:
        """Return x and y of the centre of a cell, in metres."""
        return (
            self.origin_x_m + (cell[1] + 0.5) * self.resolution_m,
            self.origin_y_m + (cell[0] + 0.5) * self.resolution_m,
        )

    def is_cell_free(self, cell: Cell) -> bool:
        """Whether a cell is on the grid and free."""
        rows, columns, taken = self._cells
        return 0 <= cell[0] < rows and 0 <= cell[1] < columns and not taken[cell[0] * columns + cell[1]]

    @cached_property
    def _cells(self) -> Tuple[int, int, bytes]:
        """Rows, columns and the cells as bytes: to look at one of them takes a fraction of the time of an array."""
        rows, columns = self.is_taken.shape
        return rows, columns, self.is_taken.tobytes()

    @cached_property
    def parts(self) -> "NDArray[np.int64]":
        """The number of the connected part of each free cell, from 1; 0 for taken cells."""
        rows, columns, taken = self._cells
        # A taken cell around all spares the look at the edge.
        width = columns + 2
        parts = [-1] * (width * (rows + 2))
        free = [(at // columns + 1) * width + at % columns + 1 for at, is_taken in enumerate(taken) if not is_taken]
        for at in free:
            parts[at] = 0
        number = 0
        for start in free:
            if parts[start] == 0:
                number += 1
                parts[start] = number
                todo = [start]
                while todo:
                    at = todo.pop()
                    for beside in (at + 1, at - 1, at + width, at - width):
                        if parts[beside] == 0:
                            parts[beside] = number
                            todo.append(beside)
        found = np.array(parts, dtype=np.int64).reshape(rows + 2, width)[1:-1, 1:-1]
        return np.maximum(found, 0)

    def is_free(self, x_m: float, y_m: float) -> bool:
        """Whether a point is on the grid and free."""
        return self.is_cell_free(self.cell_of(x_m, y_m))

    def inflated(self, radius_m: float) -> "OccupancyGrid":
        """Return the grid with all obstacles grown by a radius: the cells that the centre of a round robot must
        avoid."""
        reach = math.ceil(radius_m / self.resolution_m)
        rows, columns = self.is_taken.shape
        padded = np.ones((rows + 2 * reach, columns + 2 * reach), dtype=bool)
        padded[reach : reach + rows, reach : reach + columns] = self.is_taken
        grown = np.zeros_like(self.is_taken)
        for down in range(-reach, reach + 1):
            for right in range(-reach, reach + 1):
                if math.hypot(down, right) * self.resolution_m <= radius_m:
                    grown |= padded[reach + down : reach + down + rows, reach + right : reach + right + columns]
        return OccupancyGrid(self.resolution_m, self.origin_x_m, self.origin_y_m, grown)


def grid_of_room(room: Room) -> OccupancyGrid:
    """Draw the walls and boxes of a room."""
    columns = math.ceil((room.x_m[1] - room.x_m[0]) / room.resolution_m)
    rows = math.ceil((room.y_m[1] - room.y_m[0]) / room.resolution_m)
    x = (room.x_m[0] + (np.arange(columns) + 0.5) * room.resolution_m)[None, :]
    y = (room.y_m[0] + (np.arange(rows) + 0.5) * room.resolution_m)[:, None]
    is_taken = np.zeros((rows, columns), dtype=bool)
    # A wall thinner than a cell must not be lost between the centres of cells.
    reach_m = max(room.wall_thickness_m / 2.0, room.resolution_m * math.sqrt(0.5))
    for x0, y0, x1, y1 in room.all_walls():
        length_squared = (x1 - x0) ** 2 + (y1 - y0) ** 2
        # Only the cells around the wall can be part of it.
        right = slice(*np.searchsorted(x[0], (min(x0, x1) - 2.0 * reach_m, max(x0, x1) + 2.0 * reach_m)))
        down = slice(*np.searchsorted(y[:, 0], (min(y0, y1) - 2.0 * reach_m, max(y0, y1) + 2.0 * reach_m)))
        along_x, along_y = x[:, right] - x0, y[down] - y0
        along = (along_x * (x1 - x0) + along_y * (y1 - y0)) / (length_squared or 1.0)
        share = np.clip(along, 0.0, 1.0)
        is_taken[down, right] |= np.hypot(along_x - share * (x1 - x0), along_y - share * (y1 - y0)) <= reach_m
    for box in room.boxes:
        is_taken |= (box.x_m[0] <= x) & (x <= box.x_m[1]) & (box.y_m[0] <= y) & (y <= box.y_m[1])
    return OccupancyGrid(room.resolution_m, room.x_m[0], room.y_m[0], is_taken)
