"""catkin_lint has nothing to say about packages, CMake files and launch files."""

import shutil
import subprocess
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]


@pytest.mark.skipif(shutil.which("catkin_lint") is None, reason="catkin_lint is not installed")
def test_catkin_lint_finds_nothing() -> None:
    run = subprocess.run(
        ["catkin_lint", "--offline", "src", "underlay", "tests"],
        cwd=str(REPOSITORY),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        timeout=300,
        check=False,
    )
    assert run.returncode == 0, run.stdout.decode()
