"""The second run of the tests, on another SMACH, takes its packages from the folder that is given."""

import os
import subprocess
import sys
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"


def run(*command, **environment):
    return subprocess.run(
        command, env={**os.environ, **environment}, capture_output=True, text=True, timeout=120, check=False
    )


def make_package(folder, name):
    (folder / name).mkdir(parents=True)
    (folder / name / "__init__.py").write_text("")


def test_packages_of_a_checkout_come_first(tmp_path):
    make_package(tmp_path / "smach" / "src", "smach")
    make_package(tmp_path / "smach_ros" / "src", "smach_ros")
    code = (
        "import sys, test_upstream_smach as script; print(script.environment(script.Path(sys.argv[1]))['PYTHONPATH'])"
    )
    found = run(sys.executable, "-c", code, str(tmp_path), PYTHONPATH=str(SCRIPTS))
    assert found.stdout.split(os.pathsep)[:2] == [f"{tmp_path}/smach/src", f"{tmp_path}/smach_ros/src"], found.stderr


def test_folder_without_smach_is_named(tmp_path):
    ended = run(sys.executable, str(SCRIPTS / "test_upstream_smach.py"), str(tmp_path))
    assert ended.returncode == 1
    assert f"{tmp_path} does not hold the Python packages smach and smach_ros" in ended.stderr
