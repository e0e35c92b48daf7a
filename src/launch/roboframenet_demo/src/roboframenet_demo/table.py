"""Tables for a terminal."""

import textwrap
from typing import List, Sequence


def format_table(header: Sequence[str], rows: Sequence[Sequence[str]], *, widths: Sequence[int]) -> str:
    """Arrange cells in columns; long cells are wrapped.

    Args:
        header: one title for each column
        rows: one cell for each column
        widths: width of each column in characters
    Returns:
        the table, without a newline at its end
    """

    def lines_of(cells: Sequence[str]) -> List[str]:
        wrapped = [textwrap.wrap(cell, width) or [""] for cell, width in zip(cells, widths)]
        height = max(len(cell) for cell in wrapped)
        return [
            "  ".join((cell[i] if i < len(cell) else "").ljust(width) for cell, width in zip(wrapped, widths)).rstrip()
            for i in range(height)
        ]

    rule = "  ".join("-" * width for width in widths)
    lines = lines_of(header) + [rule]
    for row in rows:
        lines += lines_of(row)
    return "\n".join(lines)
