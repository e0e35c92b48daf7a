"""The environment of the scripts: nothing listens beyond this machine unless it is asked to."""

import os
import shlex
import subprocess
from pathlib import Path
from typing import Dict

import pytest

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "environment.sh"
NAMES = ("ROS_HOSTNAME", "ROS_IP")


def environment(workspace: Path, **given: str) -> Dict[str, str]:
    """The variables that the script sets in a built workspace."""
    (workspace / "devel").mkdir()
    (workspace / "devel" / "setup.bash").touch()
    unset = {name: value for name, value in os.environ.items() if name not in NAMES}
    shown = "; ".join(f'echo "${{{name}:-}}"' for name in NAMES)
    ended = subprocess.run(
        ["bash", "-euc", f". {shlex.quote(str(SCRIPT))}; {shown}"],
        cwd=workspace,
        env={**unset, **given},
        capture_output=True,
        text=True,
        timeout=60,
        check=True,
    )
    return dict(zip(NAMES, ended.stdout.split("\n")))


def test_nodes_of_both_languages_listen_on_this_machine_only(tmp_path: Path) -> None:
    assert environment(tmp_path) == {"ROS_HOSTNAME": "127.0.0.1", "ROS_IP": "127.0.0.1"}


@pytest.mark.parametrize("given", [{"ROS_HOSTNAME": "robot"}, {"ROS_HOSTNAME": "robot", "ROS_IP": "10.0.0.7"}])
def test_several_machines_can_be_used(tmp_path: Path, given: Dict[str, str]) -> None:
    assert environment(tmp_path, **given) == {"ROS_IP": "", **given}
