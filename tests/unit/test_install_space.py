"""An install space works without the source folders of the packages."""

import os
import re
import subprocess
from pathlib import Path

import pytest

REPOSITORY = Path(os.path.realpath(__file__)).parents[2]
BUILD = REPOSITORY / "build"


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The install space, below a folder that does not say where the sources are."""
    folder = tmp_path_factory.mktemp("root")
    subprocess.run(
        ["cmake", "--install", str(BUILD)],
        env={**os.environ, "DESTDIR": str(folder)},
        stdout=subprocess.DEVNULL,
        check=True,
        timeout=600,
    )
    (prefix,) = re.findall(r"^CMAKE_INSTALL_PREFIX:\w+=(.*)$", (BUILD / "CMakeCache.txt").read_text(), re.MULTILINE)
    return folder / prefix.lstrip("/")


def run(installed: Path, commands: str, folder: Path) -> "subprocess.CompletedProcess[str]":
    """Run commands in a shell that has sourced only the install space."""
    return subprocess.run(
        ["bash", "-e", "-c", f"set +e; source {installed}/setup.bash; set -e\n{commands}"],
        env={"PATH": "/usr/bin:/bin", "HOME": str(folder), "ROS_HOSTNAME": "127.0.0.1", "LANG": "C.UTF-8"},
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )


@pytest.mark.acceptance
@pytest.mark.parametrize(
    "commands, printed",
    [
        ('rfn explain "Turn left."', "would run: turning(direction=left"),
        ("rfn new winking; rfn check --examples .", "2 files, 0 problems"),
        ("rfn doctor --no-master", "ok       models"),
        ("rfn --help", "bind"),
        ("rosrun roboframenet_tools rfn list", "lexical units"),
        ("roslaunch --nodes roboframenet_bringup robot.launch robot:=pr2", "/stanford_parser_ros"),
        ('python3 -c "import roboframenet_rostest as one; print(one.__file__)"', "dist-packages"),
    ],
)
def test_commands_of_an_install_space(installed: Path, commands: str, printed: str, tmp_path: Path) -> None:
    ended = run(installed, commands, tmp_path)
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert printed in ended.stdout
    assert str(REPOSITORY / "src") not in ended.stdout
