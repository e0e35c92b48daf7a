"""The linters find nothing: the checks of ``make lint``. Types take longest, and are of the tier "acceptance"."""

import ast
import os
import re
import shutil
import subprocess
from pathlib import Path
from typing import Iterator, Tuple

import pytest

from roboframenet_testing.workspace import packages

REPOSITORY = Path(__file__).resolve().parents[2]
#: The checks of scripts/lint, and the program that each runs.
CHECKS = {"format": "ruff", "rules": "ruff", "types": "mypy", "packages": "catkin_lint"}


@pytest.mark.parametrize(
    "check", [pytest.param(one, marks=pytest.mark.acceptance if one == "types" else ()) for one in CHECKS]
)
def test_lint_finds_nothing(check: str) -> None:
    path = os.pathsep.join([str(REPOSITORY / ".venv" / "bin"), os.environ["PATH"]])
    if shutil.which(CHECKS[check], path=path) is None:
        pytest.skip(f"{CHECKS[check]} is not installed: make setup")
    run = subprocess.run(
        [str(REPOSITORY / "scripts" / "lint"), check],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        timeout=300,
        check=False,
    )
    assert run.returncode == 0, run.stdout.decode()


def broad_handlers(text: str) -> Iterator[Tuple[int, str]]:
    """Return line number and line of every ``except`` that catches all exceptions."""
    lines = text.splitlines()
    if not re.search(r"except\s*(:|(Base)?Exception\b)", text):
        return
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.ExceptHandler):
            name = node.type.id if isinstance(node.type, ast.Name) else ""
            if node.type is None or name in ("Exception", "BaseException"):
                yield node.lineno, lines[node.lineno - 1]


def test_a_broad_except_names_its_boundary() -> None:
    modules = sorted(path for one in packages("src", "underlay").values() for path in one.glob("src/**/*.py"))
    unnamed = [
        f"{path.relative_to(REPOSITORY)}:{number}: {line.strip()}"
        for path in modules
        for number, line in broad_handlers(path.read_text(encoding="utf-8"))
        if not re.search(r"# boundary: \w+", line)
    ]
    assert modules
    assert not unnamed, "say behind 'except' which boundary it is: # boundary: the reason\n" + "\n".join(unnamed)


def test_a_broad_except_is_found() -> None:
    text = "try:\n    pass\nexcept OSError:\n    pass\nexcept Exception as error:\n    pass\n"
    assert list(broad_handlers(text)) == [(5, "except Exception as error:")]
