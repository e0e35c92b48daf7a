"""The README and each tutorial run to their ends by their own text, each in an empty folder."""

import json
import os
import re
import shutil
import signal
import socket
import subprocess
import time
from pathlib import Path
from typing import Dict, Iterator, List

import pytest

from page import script_of, steps

REPOSITORY = Path(os.path.realpath(__file__)).parents[2]
PAGES = (REPOSITORY / "README.md", *sorted((REPOSITORY / "docs" / "tutorials").glob("*/README.md")))
#: What a fresh Debian has, so that another Python on the path of a developer is not the one of ROS.
SYSTEM_PATH = "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin"
#: The whole of a page, and the start of the pipeline, on a busy machine; seconds.
PAGE_TIMEOUT_S = 600.0
START_TIMEOUT_S = 300.0
#: Deadlines of the pipeline, seconds; a test machine that is busy is slower than a robot.
PATIENT = {
    "/command_server/stop_timeout_s": 30.0,
    "/command_server/stage_timeout_s": 60.0,
    "/stop_server/confirmation_timeout_s": 10.0,
    "/command_server/confirmation_timeout_s": 10.0,
    "/semantic_framer/question_timeout_s": 300.0,
    "/frame_registrar/liveness_timeout_s": 10.0,
    "/executor/acceptance_timeout_s": 30.0,
    "/executor/silence_timeout_s": 30.0,
    "/move_action_server/odometry_timeout_s": 2.0,
    "/move_action_server/stall_timeout_s": 30.0,
}
_COLOURS = re.compile("\x1b\\[[0-9;]*m")


def environment() -> Dict[str, str]:
    """Return the environment of a shell that has sourced the workspace, with a master of its own."""
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        port = one.getsockname()[1]
    return {
        **os.environ,
        "PATH": f"{REPOSITORY}/devel/bin:{SYSTEM_PATH}",
        "ROS_MASTER_URI": f"http://127.0.0.1:{port}",
        "ROS_HOSTNAME": "127.0.0.1",
    }


def end(process: "subprocess.Popen[bytes]") -> None:
    """End a process and those that it started."""
    for number, patience_s in ((signal.SIGINT, 60.0), (signal.SIGKILL, 60.0)):
        try:
            os.killpg(process.pid, number)
        except ProcessLookupError:
            return
        try:
            process.wait(patience_s)
            return
        except subprocess.TimeoutExpired:
            continue


class PatientMaster:
    """A master whose pipeline has longer deadlines, and the programs that are started under it.

    Attributes:
        environment: of the programs
    """

    def __init__(self, folder: Path) -> None:
        self.environment = environment()
        self._log = folder / "log"
        self._processes: List[subprocess.Popen[bytes]] = []
        self.start("roscore", "-p", self.environment["ROS_MASTER_URI"].rpartition(":")[2])
        try:
            (folder / "patient.yaml").write_text(json.dumps(PATIENT), encoding="utf-8")
            self.wait_for("rosparam", "load", str(folder / "patient.yaml"))
        except AssertionError:
            self.close()
            raise

    def start(self, *command: str) -> None:
        """Start a program."""
        with open(self._log, "ab") as file:
            self._processes.append(
                subprocess.Popen(
                    command, env=self.environment, stdout=file, stderr=subprocess.STDOUT, start_new_session=True
                )
            )

    def wait_for(self, *command: str) -> None:
        """Repeat a command until it succeeds."""
        deadline_s = time.monotonic() + START_TIMEOUT_S
        while subprocess.run(command, env=self.environment, capture_output=True, check=False).returncode:
            # What is started needs the processor more than who asks.
            time.sleep(1.0)
            alive = self._processes[-1].poll() is None
            assert alive and time.monotonic() < deadline_s, self._log.read_text()[-3000:]

    def close(self) -> None:
        """End the programs, the last first."""
        for process in reversed(self._processes):
            end(process)


@pytest.fixture(scope="module")
def running(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Dict[str, str]]:
    """The environment of the pages that need a running pipeline; it runs as ``make run`` runs it."""
    master = PatientMaster(tmp_path_factory.mktemp("make_run"))
    try:
        master.start(str(REPOSITORY / "scripts" / "run"))
        master.wait_for("rfn", "say", "Ping.")
        yield master.environment
    finally:
        master.close()


def without_make(text: str) -> str:
    """Return a page without what the fixture does, and without the targets that run this test themselves."""
    targets = re.findall(r"^make (\w+)", text, re.MULTILINE)
    makefile = (REPOSITORY / "Makefile").read_text(encoding="utf-8")
    assert all(re.search(rf"^{target}:", makefile, re.MULTILINE) for target in targets)
    return re.sub(r"^(make \w+.*|source devel/setup.bash)$", ":", text, flags=re.MULTILINE)


def run_page(page: Path, text: str, surroundings: Dict[str, str], folder: Path) -> None:
    """Run a page in an empty folder; the failure shows the block that failed and its output."""
    workspace, blocks = folder / "workspace", folder / "blocks"
    workspace.mkdir()
    blocks.mkdir()
    process = subprocess.Popen(
        ["bash", "-c", script_of(text, blocks)],
        cwd=workspace,
        env=surroundings,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        start_new_session=True,
    )
    try:
        _, errors = process.communicate(timeout=PAGE_TIMEOUT_S)
    finally:
        end(process)
    reached = (blocks / "reached").read_text().strip()
    found = steps(text)
    if reached != "done":
        step = found[int(reached)].block
        newest = sorted(blocks.glob("*.out"), key=lambda path: int(path.stem))[-4:]
        outputs = "\n".join(path.read_text()[-2000:] for path in newest)
        pytest.fail(f"{page}:{step.line} failed:\n{step.text}\n{outputs}\n{errors.decode()[-500:]}")
    for number, step in enumerate(found):
        output = _COLOURS.sub("", (blocks / f"{number}.out").read_text(encoding="utf-8"))
        assert step.output.fullmatch(output), f"{page}:{step.block.line} printed:\n{output}"


@pytest.mark.parametrize("page", PAGES[:-1], ids=lambda page: page.parent.name)
def test_page(page: Path, running: Dict[str, str], tmp_path: Path) -> None:
    run_page(page, without_make(page.read_text(encoding="utf-8")), running, tmp_path)


def test_your_own_robot(tmp_path: Path) -> None:
    assert shutil.which("catkin_make", path=SYSTEM_PATH)
    folder = tmp_path / "master"
    folder.mkdir()
    master = PatientMaster(folder)
    try:
        run_page(PAGES[-1], PAGES[-1].read_text(encoding="utf-8"), master.environment, tmp_path)
    finally:
        master.close()
