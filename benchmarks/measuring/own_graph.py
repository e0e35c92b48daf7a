"""Programs under a master of their own, for the benchmarks."""

import os
import socket
import subprocess
import sys
import time
from contextlib import ExitStack
from typing import Sequence

import rosgraph

#: Name of the node that does nothing.
BARE = "bare"
_START_TIMEOUT_S = 60.0
_END_TIMEOUT_S = 30.0


def free_port() -> int:
    """Return a port that nobody listens to."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


def end(process: subprocess.Popen) -> None:
    """Ask a program to end, and kill it if it does not."""
    process.terminate()
    try:
        process.wait(_END_TIMEOUT_S)
    except subprocess.TimeoutExpired:
        process.kill()


class OwnGraph(ExitStack):
    """A context whose programs find each other under a port of their own; at its end they are ended.

    Attributes:
        port: of the master, which one of the programs must be or start
    """

    def __init__(self) -> None:
        super().__init__()
        self.port = free_port()
        self._environment = dict(os.environ, ROS_MASTER_URI=f"http://127.0.0.1:{self.port}")

    def start(self, command: Sequence[str]) -> None:
        """Start a program that prints nothing."""
        quiet = subprocess.DEVNULL
        self.callback(end, subprocess.Popen(command, env=self._environment, stdout=quiet, stderr=quiet))

    def start_master(self) -> None:
        """Start a master, and return when it answers.

        Raises:
            SystemExit: it does not answer in time
        """
        self.start(["roscore", "-p", str(self.port)])
        end_s = time.monotonic() + _START_TIMEOUT_S
        while not rosgraph.is_master_online(self._environment["ROS_MASTER_URI"]):
            if time.monotonic() > end_s:
                raise SystemExit(f"no master within {_START_TIMEOUT_S:g} s")
            time.sleep(0.1)

    def start_bare_node(self) -> None:
        """Start the node that does nothing."""
        program = os.path.join(os.path.dirname(os.path.abspath(__file__)), "bare_node.py")
        self.start([sys.executable, program, f"__name:={BARE}"])

    def run(self, command: Sequence[str]) -> int:
        """Run a program to its end; returns its exit status."""
        return subprocess.run(command, env=self._environment, check=False).returncode
