"""Every node says on /diagnostics how it is (REP 107): `run_node` and `run_stages` see to it."""

import ast
from pathlib import Path
from typing import Set

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
#: Programs that a person starts, and that end by themselves.
NO_NODES = {"rfn", "roboframenet_demo"}
PROGRAMS = [path for path in sorted(REPOSITORY.glob("src/*/nodes/*")) if path.name not in NO_NODES]


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
    package, module = str(line.module).split(".")
    calls = calls_in(REPOSITORY / "src" / package / "src" / package / f"{module}.py")
    assert calls & {"run_node", "run_stage", "run_stages"}
