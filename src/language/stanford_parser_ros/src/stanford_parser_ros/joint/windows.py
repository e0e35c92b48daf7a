"""Long sentences in overlapping windows: each word is read where it has most words around it."""

from typing import List, NamedTuple, Sequence


class Window(NamedTuple):
    """A part of a sentence.

    Attributes:
        start, end: its words, from 0
        first, last: those of them that are read in it, the last one not among them
    """

    start: int
    end: int
    first: int
    last: int


def windows(sizes: Sequence[int], most: int) -> List[Window]:
    """Cut a sentence into windows that overlap by about a half.

    Args:
        sizes: number of pieces of each word, at most ``most`` each
        most: pieces in one window
    Returns:
        the windows in order; each word is read in exactly one
    """
    count = len(sizes)
    spans = []
    start = 0
    while True:
        end, used = start, 0
        while end < count and used + sizes[end] <= most:
            used += sizes[end]
            end += 1
        spans.append((start, end))
        if end == count:
            break
        # The next window begins in the middle of this one, and goes on at least one word further.
        start = max(start + 1, start + (end - start) // 2)
    found = []
    first = 0
    for number, (start, end) in enumerate(spans):
        last = count if number == len(spans) - 1 else (spans[number + 1][0] + end + 1) // 2
        if last > first:
            found.append(Window(start, end, first, last))
        first = max(first, last)
    return found
