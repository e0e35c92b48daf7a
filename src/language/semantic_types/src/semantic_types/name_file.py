"""Reads the names that a robot knows: persons, rooms and things, each with its semantic types."""

from typing import Dict, Iterable, List, Mapping, Sequence, Tuple

from checked_files.marked_yaml import Reader, did_you_mean
from checked_files.problem import FileRefused, Problem
from semantic_frames.semantic_type import SEMANTIC_TYPES, read_semantic_types

#: A robot's world has fewer named things.
MOST_NAMES = 5000
LONGEST_NAME = 100
MOST_TYPES = 8

#: Types by name, in lower case and with single blanks.
Names = Mapping[str, Tuple[str, ...]]


def load_name_file(text: str, path: str) -> Names:
    """Read a file of names, such as ``names: {Anna: Human, coffee corner: [Location, Room]}``.

    Args:
        text: content of the file
        path: where it came from, for problems
    Returns:
        the types of each name, in the order of likelihood
    Raises:
        FileRefused: the file has mistakes; the exception carries all of them
    """
    reader = Reader(path)
    root = reader.mapping(reader.compose(text, "a mapping with names"), "", ("names",), required=("names",))
    names: Dict[str, Tuple[str, ...]] = {}
    entries = reader.free_mapping(root.get("names"), "names")
    if len(entries) > MOST_NAMES:
        reader.report("TOO_MANY", root["names"], "names", f"{len(entries)} names", f"at most {MOST_NAMES}")
    for name_node, node in entries[:MOST_NAMES]:
        said = reader.name(name_node, "names")
        name = spoken(said)
        key = f"names.{said[:LONGEST_NAME]}"
        types = read_semantic_types(reader, node, key)
        if not name or len(name) > LONGEST_NAME:
            reader.report("NAME_LENGTH", name_node, key, f"{len(name)} characters", f"1 to {LONGEST_NAME}")
        if not types and not reader.problems:
            reader.report("EMPTY", node, key, "no type", "a semantic type such as Human")
        if len(types) > MOST_TYPES:
            reader.report("TOO_MANY", node, key, f"{len(types)} types", f"at most {MOST_TYPES}")
        if name in names:
            reader.report("DUPLICATE_NAME", name_node, key, f"a second '{name}'", "each name once")
        names[name] = types
    reader.refuse_if_wrong()
    return names


def checked_names(pairs: Iterable[Tuple[str, Sequence[str]]], source: str) -> Names:
    """Check names that another program sends.

    Args:
        pairs: names with their types
        source: the program, for problems
    Returns:
        the types of each name; a name that comes twice has the types of the last one
    Raises:
        FileRefused: there are too many names, or one of them is wrong; the exception carries all problems
    """
    problems: List[Problem] = []
    names: Dict[str, Tuple[str, ...]] = {}
    for place, (said, types) in enumerate(pairs):
        if place >= MOST_NAMES:
            problems.append(Problem("TOO_MANY", source, 1, "names", "more names", f"at most {MOST_NAMES}"))
            break
        key = f"names[{place}]"
        name = spoken(said)
        if not name or len(name) > LONGEST_NAME:
            problems.append(Problem("NAME_LENGTH", source, 1, key, f"{len(name)} characters", f"1 to {LONGEST_NAME}"))
        if not 0 < len(types) <= MOST_TYPES:
            problems.append(Problem("TYPE_COUNT", source, 1, key, f"{len(types)} types", f"1 to {MOST_TYPES}"))
        for wrong in [kind for kind in types[:MOST_TYPES] if kind not in SEMANTIC_TYPES]:
            hint = did_you_mean(wrong, SEMANTIC_TYPES)
            problems.append(Problem("UNKNOWN_TYPE", source, 1, key, f"'{wrong}'", "a semantic type", hint))
        names[name] = tuple(types)
    if problems:
        raise FileRefused(problems)
    return names


def spoken(name: str) -> str:
    """Return a name as it is compared: in lower case and with single blanks."""
    return " ".join(name.lower().split())
