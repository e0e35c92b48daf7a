"""``scripts/build`` asks CMake only when something has changed that CMake reads."""

import os
import shutil
import subprocess
import time
from pathlib import Path

import pytest

REPOSITORY = Path(os.path.realpath(__file__)).parents[2]
NODE = "src/one/nodes/one"
FILES = (
    "CMakeLists.txt",
    NODE,
    "src/one/setup.py",
    "src/one/src/one/core.py",
    "src/one/README.md",
    "underlay/x",
    "tests/x",
)


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """A workspace that is built by a program that counts its calls."""
    for name in (*FILES, "devel/setup.bash"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).touch()
    for folder in ("scripts", "programs"):
        (tmp_path / folder).mkdir()
    shutil.copy(REPOSITORY / "scripts" / "build", tmp_path / "scripts" / "build")
    cmake = tmp_path / "programs" / "cmake"
    cmake.write_text(f"#!/bin/sh\necho call >> {tmp_path}/programs/calls\nexit $(cat {tmp_path}/programs/status)\n")
    cmake.chmod(0o755)
    (tmp_path / "programs" / "status").write_text("0")
    build(tmp_path)
    return tmp_path


def build(workspace: Path) -> int:
    """Build; return how often CMake was called."""
    calls = workspace / "programs" / "calls"
    calls.write_text("")
    # The file system may count in steps of some milliseconds.
    time.sleep(0.02)
    environment = {**os.environ, "PATH": f"{workspace / 'programs'}:{os.environ['PATH']}"}
    subprocess.run(
        [str(workspace / "scripts" / "build")], env=environment, capture_output=True, check=False, timeout=60
    )
    return calls.read_text().count("call")


def test_nothing_has_changed(workspace: Path) -> None:
    assert build(workspace) == 0


@pytest.mark.parametrize("name", ["src/one/src/one/core.py", "src/one/README.md"])
def test_what_is_used_where_it_is(workspace: Path, name: str) -> None:
    (workspace / name).write_text("changed")
    assert build(workspace) == 0


@pytest.mark.parametrize(
    "name", ["CMakeLists.txt", NODE, "src/one/setup.py", "src/one/msg/New.msg", "tests/rostest/new.test"]
)
def test_what_cmake_reads(workspace: Path, name: str) -> None:
    (workspace / name).parent.mkdir(exist_ok=True)
    (workspace / name).write_text("changed")
    assert build(workspace) > 0
    assert build(workspace) == 0


def test_file_that_is_gone(workspace: Path) -> None:
    (workspace / NODE).unlink()
    assert build(workspace) > 0


def test_build_that_failed_is_repeated(workspace: Path) -> None:
    (workspace / "programs" / "status").write_text("1")
    (workspace / NODE).write_text("changed")
    assert build(workspace) > 0
    assert build(workspace) > 0


def test_devel_space_that_is_gone_is_built(workspace: Path) -> None:
    shutil.rmtree(workspace / "devel")
    assert build(workspace) > 0
