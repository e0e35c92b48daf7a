"""The benchmarks: each is a program that starts, and that the README of the folder tells of."""

import re
import subprocess
import sys
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[2] / "benchmarks"
PROGRAMS = sorted(FOLDER.glob("*.py"))


def test_the_readme_names_each_program():
    named = re.findall(r"^\|? ?`(\w+\.py)`", (FOLDER / "README.md").read_text(encoding="utf-8"), re.MULTILINE)
    assert sorted(named) == [path.name for path in PROGRAMS]


def test_they_start():
    """All that they need can be imported, and they measure nothing before they are asked to. In one process."""
    started = f"import runpy, sys; sys.path.insert(0, {str(FOLDER)!r})\nfor path in sys.argv[1:]:\n    print(path)\n"
    started += "    runpy.run_path(path, run_name='started')"
    ended = subprocess.run(
        [sys.executable, "-c", started, *map(str, PROGRAMS)], capture_output=True, text=True, timeout=300, check=False
    )
    assert ended.returncode == 0, ended.stdout.splitlines()[-1:] + ended.stderr.splitlines()[-20:]
    for path in PROGRAMS:
        assert '__name__ == "__main__"' in path.read_text(encoding="utf-8"), path


def test_units_are_made_up():
    """The units of a bigger lexicon are the shipped ones with other verbs: each of their parts is known."""
    made = "import runpy, sys; sys.path.insert(0, sys.argv[1])\n"
    made += "lexicons, _, _, _ = runpy.run_path(sys.argv[1] + '/framing_scale.py', run_name='made')['scales']()\n"
    made += "print(max(lexicons), len(lexicons[max(lexicons)][0].verbs) > 2500)"
    ended = subprocess.run(
        [sys.executable, "-c", made, str(FOLDER)], capture_output=True, text=True, timeout=300, check=False
    )
    assert ended.stdout.split() == ["10000", "True"], ended.stderr
