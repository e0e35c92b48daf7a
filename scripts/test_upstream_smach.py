"""Run the tests of all that runs on SMACH once more, on a SMACH of another folder in place of the underlay's.

    scripts/test_upstream_smach.py FOLDER [FILTER]

FOLDER is a checkout of SMACH or a prefix where it is installed, FILTER a part of the names of packages.
"""

import json
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, Dict, List, Mapping, Optional

ROOT = Path(__file__).resolve().parent.parent
TESTS = "^_ctest_(arbitrator|executor|roboframenet_tests)_"
TIMEOUT_S = 900.0


def find_package(folder: Path, name: str) -> Optional[Path]:
    """Folder from which a Python package can be imported; None when there is none."""
    found = sorted(folder.rglob(f"{name}/__init__.py"), key=lambda path: len(path.parts))
    return found[0].parent.parent if found else None


def environment(folder: Path) -> Dict[str, str]:
    """The environment of this process, with SMACH of the folder first; exits with a sentence when it is not there."""
    packages = [find_package(folder, name) for name in ("smach", "smach_ros")]
    if None in packages:
        sys.exit(f"[upstream SMACH] {folder} does not hold the Python packages smach and smach_ros")
    paths = [*map(str, packages), os.environ["PYTHONPATH"]]
    return {**os.environ, "PYTHONPATH": os.pathsep.join(paths)}


def tests(filtered: str) -> List[Dict[str, Any]]:
    """Tests of the tier "test", as ctest tells them."""
    listed = subprocess.run(
        ["ctest", "--test-dir", "build", "--show-only=json-v1", "-R", TESTS, "-LE", "^(acceptance|reliability)$"],
        stdout=subprocess.PIPE,
        check=True,
    ).stdout
    return [test for test in json.loads(listed)["tests"] if re.search(filtered, test["name"])]


def run(test: Mapping[str, Any], env: Mapping[str, str]) -> bool:
    """Run one test; tell whether it passed."""
    # The first word is a script that sets the environment of the build, which knows only the underlay.
    command = test["command"][1:]
    try:
        done = subprocess.run(
            command, env=env, timeout=TIMEOUT_S, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False
        )
        output, has_passed = done.stdout, done.returncode == 0
    except subprocess.TimeoutExpired as late:
        output, has_passed = late.stdout or b"", False
    print(f"[upstream SMACH] {'passed' if has_passed else 'FAILED'} {test['name']}", flush=True)
    if not has_passed:
        sys.stdout.buffer.write(output)
    return has_passed


def main() -> int:
    """Run the tests; return 1 when one failed or there was none."""
    os.chdir(ROOT)
    env = environment(Path(sys.argv[1]).resolve())
    where = subprocess.run(
        [".venv/bin/python", "-c", "import smach, smach_ros; print(smach.__file__, smach_ros.__file__)"],
        env=env,
        stdout=subprocess.PIPE,
        text=True,
        check=True,
    ).stdout.strip()
    print(f"[upstream SMACH] running on {where}", flush=True)
    chosen = tests(sys.argv[2] if len(sys.argv) > 2 else "")
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        passed = list(pool.map(lambda test: run(test, env), chosen))
    return 0 if passed and all(passed) else 1


if __name__ == "__main__":
    sys.exit(main())
