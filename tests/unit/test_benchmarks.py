"""The benchmarks: each is a program that starts, and that the README of the folder tells of."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

FOLDER = Path(__file__).resolve().parents[2] / "benchmarks"
PROGRAMS = sorted(FOLDER.glob("*.py"))


def test_the_readme_names_each_program():
    named = re.findall(r"^\|? ?`(\w+\.py)`", (FOLDER / "README.md").read_text(encoding="utf-8"), re.MULTILINE)
    assert sorted(named) == [path.name for path in PROGRAMS]


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.stem)
def test_it_starts(path):
    """All that it needs can be imported, and it measures nothing before it is asked to."""
    started = (
        f"import runpy, sys; sys.path.insert(0, {str(FOLDER)!r}); runpy.run_path({str(path)!r}, run_name='started')"
    )
    ended = subprocess.run([sys.executable, "-c", started], stderr=subprocess.PIPE, text=True, timeout=120, check=False)
    assert ended.returncode == 0, ended.stderr
    assert '__name__ == "__main__"' in path.read_text(encoding="utf-8")
