"""The machines of the network tests: what one sends reaches the other until the cable is cut."""

import subprocess
import sys
from pathlib import Path

import pytest
from namespaces import Machines, NotPossible

from roboframenet_testing import wait_until

PORT = 8000
SERVER = "import socket; socket.create_server(('0.0.0.0', {port})).accept()"
CLIENT = "import socket; socket.create_connection(('{address}', {port}), timeout=2.0)"


def test_cut_cable_keeps_everything_back(tmp_path: Path) -> None:
    def start(machine: str, code: str) -> "subprocess.Popen[str]":
        return machines.start(machine, sys.executable, "-c", code, log=tmp_path / machine, environment={})

    def is_reached() -> bool:
        return start("b", CLIENT.format(address=machines.addresses["a"], port=PORT)).wait(30.0) == 0

    try:
        machines = Machines(("a", "b"))
    except NotPossible as why:
        pytest.skip(f"not run: {why}")
    with machines:
        for _ in range(2):
            server = start("a", SERVER.format(port=PORT))
            wait_until(is_reached)
            assert server.wait(30.0) == 0
            machines.cut("b")
            start("a", SERVER.format(port=PORT))
            assert not is_reached()
            machines.join("b")
            wait_until(is_reached)
