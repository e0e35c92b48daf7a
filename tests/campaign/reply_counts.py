"""Counts replies by text and by id: equal texts are told apart by the ids of their commands."""

from collections import Counter, defaultdict
from typing import Dict, Iterable, Mapping, Set, Tuple


def count_replies(said: Mapping[str, int], replies: Iterable[Tuple[str, str]]) -> Tuple[int, int]:
    """Return how many texts have no reply, and how many replies there are beyond one for each.

    Args:
        said: how often each text was said
        replies: text and id of the command of each reply
    """
    ids: Dict[str, Set[str]] = defaultdict(set)
    counts: Counter = Counter()
    for text, command_id in replies:
        ids[text].add(command_id)
        counts[text] += 1
    unanswered = sum(max(0, number - len(ids[text])) for text, number in said.items())
    # One id with two replies, or two ids for what was said once.
    doubled = sum(max(number - len(ids[text]), number - said.get(text, 0), 0) for text, number in counts.items())
    return unanswered, doubled
