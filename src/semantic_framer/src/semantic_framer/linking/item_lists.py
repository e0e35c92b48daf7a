"""Divides a deed with a list of things or places into one deed for each item: "visit the hall and the office"."""

from dataclasses import replace
from typing import FrozenSet, Optional, Sequence, Tuple

from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from typed_arguments import TypedArgument

_AND = ("and", "")


def _list_of(reading: Reading) -> Optional[TypedArgument]:
    lists = [one for one in reading.arguments if one.separate_members and one.conjunction in _AND]
    return lists[0] if len(lists) == 1 else None


def has_items(readings: Sequence[Reading]) -> bool:
    """Whether the likeliest reading of a clause has one list of things that are all meant."""
    return _list_of(readings[0]) is not None


def listed_items(reading: Reading) -> Tuple[TypedArgument, ...]:
    """Return the items of the list that a reading has; nothing without one."""
    listed = _list_of(reading)
    return () if listed is None else _flat(listed)


def items_apart(
    sentence: Sentence, readings: Sequence[Reading], positions: FrozenSet[int]
) -> Tuple[Tuple[Tuple[Reading, ...], FrozenSet[int]], ...]:
    """Return the readings of each item of the list of a clause, with the positions of its words.

    Args:
        sentence: the sentence
        readings: of the clause, best first; those without the same list are left out
        positions: of the words of the clause
    Returns:
        nothing without a list
    """
    listed = _list_of(readings[0])
    if listed is None:
        return ()
    found = []
    members = _flat(listed)
    every = frozenset().union(*(member.positions for member in members))
    between = frozenset(index for index in listed.positions if index not in every)
    for member in members:
        own = positions - between - every.difference(member.positions)
        said = sentence.text(sorted(own - readings[0].control.positions)).strip(" ,;.!?")
        alone = tuple(
            replace(reading, arguments=_with(reading, listed, member), clause_text=said)
            for reading in readings
            if _same_list(_list_of(reading), listed)
        )
        found.append((alone, own))
    return tuple(found)


def _flat(listed: TypedArgument) -> Tuple[TypedArgument, ...]:
    """Return the items of a list, those of a list inside it too: the parser may take "B and C" for one item."""
    if listed.conjunction not in _AND or not listed.separate_members:
        return (listed,)
    return tuple(item for member in listed.separate_members for item in _flat(member))


def _same_list(one: Optional[TypedArgument], other: TypedArgument) -> bool:
    return one is not None and one.name == other.name and one.positions == other.positions


def _with(reading: Reading, listed: TypedArgument, member: TypedArgument) -> Tuple[TypedArgument, ...]:
    """Return the arguments with one item in the place of its list."""
    return tuple(member if argument.name == listed.name else argument for argument in reading.arguments)
