"""Every node says on /diagnostics how it is (REP 107): `run_node` and `run_stages` see to it."""

import ast
from pathlib import Path
from typing import Set

import pytest

from roboframenet_testing.workspace import module_and_rest, packages

#: Programs that a person starts, and that end by themselves.
NO_NODES = {"rfn", "roboframenet_demo"}
PROGRAMS = [path for one in packages().values() for path in sorted(one.glob("nodes/*")) if path.name not in NO_NODES]


def calls_in(path: Path) -> Set[str]:
    """Return the names of the functions that a module calls."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    return {getattr(node.func, "id", "") for node in ast.walk(tree) if isinstance(node, ast.Call)}


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda path: path.name)
def test_node_says_how_it_is(program: Path) -> None:
    (line,) = [
        node
        for node in ast.parse(program.read_text(encoding="utf-8")).body
        if isinstance(node, ast.ImportFrom) and [alias.name for alias in node.names] == ["main"]
    ]
    path, _ = module_and_rest(str(line.module))
    calls = calls_in(path)
    assert calls & {"run_node", "run_stage", "run_stages"}
