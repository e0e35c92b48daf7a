"""Reads what servers of binding files state about themselves."""

from typing import Any, Dict, Mapping, Sequence

import yaml

from checked_files.marked_yaml import Reader, is_empty
from semantic_frames.server_statement import ProfileError, stated_profile


def read_statement(
    reader: Reader, node: yaml.Node, key: str, entries: Mapping[str, yaml.Node], keys: Sequence[str]
) -> Dict[str, Any]:
    """Return the keys of a statement in an entry of a file; problems are reported.

    Args:
        reader: of the file
        node: the entry
        key: of the entry
        entries: its keys
        keys: those of a statement
    """
    statement = {name: _plain(entries[name]) for name in keys if name in entries}
    try:
        stated_profile(statement)
    except ProfileError as error:
        for problem in error.problems:
            reader.report("STATEMENT", node, key, problem, f"what a server may state: {', '.join(keys)}")
    return statement


def _plain(node: yaml.Node) -> Any:
    """Return a node as mappings, lists and texts."""
    if isinstance(node, yaml.MappingNode):
        return {str(name.value): _plain(value) for name, value in node.value}
    if isinstance(node, yaml.SequenceNode):
        return [_plain(item) for item in node.value]
    return None if is_empty(node) else str(node.value)
