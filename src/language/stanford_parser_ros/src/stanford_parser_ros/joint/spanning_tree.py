"""The tree with the highest score, by the algorithm of Chu, Liu and Edmonds."""

from typing import TYPE_CHECKING, List, Optional

import numpy as np

if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray


def heads_of_best_tree(scores: "NDArray[Any]") -> List[int]:
    """Return the heads of the best tree in which exactly one word hangs on the root.

    Args:
        scores: row i, column j: the score of word j as the head of word i, not above 0; word 0 is the root
    Returns:
        the head of each word; the first, that of the root, is 0
    """
    scores = scores.astype(np.float64)
    np.fill_diagonal(scores, -np.inf)
    scores[0] = -np.inf
    heads: List[int] = scores.argmax(axis=1).tolist()
    heads[0] = 0
    if heads[1:].count(0) == 1 and _cycle(heads) is None:
        return heads  # nearly always
    lowest = scores[1:][np.isfinite(scores[1:])].min()
    # A second word on the root costs more than any tree can gain by it.
    scores[:, 0] += lowest * len(scores)
    return _best_tree(scores)


def _best_tree(scores: "NDArray[Any]") -> List[int]:
    """Return the head of each node; node 0 is the root."""
    # Of each step, only what leads back: the scores of all steps of a long text would take hundreds of megabytes.
    steps = []
    while True:
        heads: List[int] = scores.argmax(axis=1).tolist()
        heads[0] = 0
        cycle = _cycle(heads)
        if cycle is None:
            break
        # The nodes of the cycle become one node, the last. Whoever enters the cycle replaces one of its arcs.
        others = [node for node in range(len(heads)) if node not in cycle]
        entering = scores[np.ix_(cycle, others)] - scores[cycle, [heads[node] for node in cycle]][:, None]
        leaving = scores[np.ix_(others, cycle)]
        count = len(others)
        contracted = np.full((count + 1, count + 1), -np.inf)
        contracted[:count, :count] = scores[np.ix_(others, others)]
        contracted[count, :count] = entering.max(axis=0)
        contracted[:count, count] = leaving.max(axis=1)
        steps.append((heads, cycle, others, entering.argmax(axis=0).tolist(), leaving.argmax(axis=1).tolist()))
        scores = contracted
    for before, cycle, others, entries, exits in reversed(steps):
        result = list(before)
        for number, node in enumerate(others):
            head = heads[number]
            result[node] = others[head] if head < len(others) else cycle[exits[number]]
        entry = heads[len(others)]
        result[cycle[entries[entry]]] = others[entry]
        result[0] = 0
        heads = result
    return heads


def _cycle(heads: List[int]) -> Optional[List[int]]:
    """Return the nodes of a cycle, if there is one."""
    seen = [0] * len(heads)  # the node from which it was first reached
    seen[0] = -1
    for start in range(1, len(heads)):
        node = start
        while not seen[node]:
            seen[node] = start
            node = heads[node]
        if seen[node] == start:
            cycle = [node]
            while heads[cycle[-1]] != node:
                cycle.append(heads[cycle[-1]])
            return sorted(cycle)
    return None
