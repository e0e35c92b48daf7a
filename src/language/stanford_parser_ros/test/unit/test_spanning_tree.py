"""The best tree is the best of all trees."""

import itertools
import tracemalloc
from typing import List

import numpy as np

from stanford_parser_ros.joint.spanning_tree import heads_of_best_tree

SEED = 13


def trees(size: int) -> List[List[int]]:
    """All trees of a root and some words with one word on the root, as heads."""
    found = []
    for heads in itertools.product(range(size), repeat=size - 1):
        if heads.count(0) != 1:
            continue
        reached = {0}
        for _ in range(size):
            reached |= {word for word, head in enumerate(heads, 1) if head in reached}
        if len(reached) == size:
            found.append([0, *heads])
    return found


def test_the_best_tree_is_the_best_of_all_trees() -> None:
    chance = np.random.default_rng(SEED)
    for size in (2, 3, 4, 5):
        every = trees(size)
        for _ in range(60):
            scores = -(chance.random((size, size)) ** 3) * 20.0
            best = max(every, key=lambda tree: sum(scores[word, tree[word]] for word in range(1, size)))
            assert heads_of_best_tree(scores) == best


def test_a_long_text_takes_little_memory() -> None:
    """A tree with many cycles on the way to it: the scores of all steps would take 80 MB here, and more elsewhere."""
    scores = -np.random.default_rng(5).random((500, 500))
    tracemalloc.start()
    heads = heads_of_best_tree(scores)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert heads[1:].count(0) == 1
    assert peak < 40 * 2**20
