"""A robot on a machine of its own: bad cables, and a cable that is cut for ten seconds."""

import json
import os
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any, Dict, Iterator, List

import pytest
from namespaces import Machines, NotPossible

from roboframenet_testing import comes_true, wait_until

pytestmark = pytest.mark.acceptance

#: The robot stops when it has not heard the language service for this time, seconds.
SILENCE_S = 2.0
CUT_S = 10.0
#: A robot takes part again within this time after the network does, seconds.
RETURN_S = 5.0
COMMANDS = 10
_START_S = 120.0
_PARTS_NOT_NEEDED = "without:=turtlebot_follower moo utter ping question_answering"


class Witnessed:
    """What one machine hears; see witness.py."""

    def __init__(self, process: "subprocess.Popen[str]") -> None:
        self._process = process
        self.heard: List[Dict[str, Any]] = []
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        assert self._process.stdout is not None
        for line in self._process.stdout:
            self.heard.append(json.loads(line))

    def say(self, text: str) -> None:
        """Say a sentence on the shared topic."""
        assert self._process.stdin is not None
        self._process.stdin.write(f"{text}\n")
        self._process.stdin.flush()

    def all(self, what: str, *, since: int = 0) -> List[Any]:
        """What was heard of one kind."""
        return [line[what] for line in self.heard[since:] if what in line]

    def last(self, what: str) -> Any:
        """What was heard last of one kind; None for nothing."""
        return next((line[what] for line in reversed(self.heard) if what in line), None)

    def time_of(self, what: str, value: object, *, since: int) -> float:
        """When something was first heard, monotonic seconds."""
        return next(line["t"] for line in self.heard[since:] if line.get(what) == value)


class Network:
    """The language service on one machine, the robot alpha on another."""

    def __init__(self, machines: Machines, folder: Path) -> None:
        self.machines = machines
        self._folder = folder
        self._environment = {
            "ROS_MASTER_URI": f"http://{machines.addresses['service']}:11311",
            "ROS_HOME": str(folder),
            "PYTHONUNBUFFERED": "1",
        }
        launch = ("roslaunch", "--wait", "roboframenet_bringup")
        self._start("service", "roscore")
        wait_until(lambda: self._set("/alpha/fleet_member/silence_s", str(SILENCE_S)), _START_S, "no master")
        self._start("service", *launch, "language_service.launch", "world:=false")
        self._start(
            "alpha", *launch, "fleet.launch", "service:=false", "robots:=alpha", "on_loss:=stop", _PARTS_NOT_NEEDED
        )
        self.service, self.alpha = self._witness("service"), self._witness("alpha")
        wait_until(lambda: self.service.last("members") == ["alpha"], _START_S)
        wait_until(lambda: self.alpha.last("moves") is not None, _START_S)
        # The robot takes part before its servers have registered.
        wait_until(lambda: self.ask("Alpha, turn left 10 degrees.") == ["DONE"], _START_S)

    def _start(self, machine: str, *command: str, reads: bool = False) -> "subprocess.Popen[str]":
        log = self._folder / f"{machine}.log"
        return self.machines.start(machine, *command, log=log, environment=self._environment, reads=reads)

    def _set(self, parameter: str, value: str) -> bool:
        return self._start("service", "rosparam", "set", parameter, value).wait(_START_S) == 0

    def _witness(self, machine: str) -> Witnessed:
        script = os.path.join(os.path.dirname(os.path.realpath(__file__)), "witness.py")
        return Witnessed(self._start(machine, sys.executable, script, "alpha", reads=True))

    def ask(self, text: str, timeout_s: float = 60.0) -> List[str]:
        """Say a sentence; return the codes of its replies, one if all is well, when the first has come."""
        since = len(self.service.heard)
        self.service.say(text)
        comes_true(lambda: text in self.service.all("reply", since=since), timeout_s)
        return self.codes(text, since=since)

    def codes(self, text: str, *, since: int) -> List[str]:
        """The codes of the replies to a sentence."""
        return [line["code"] for line in self.service.heard[since:] if line.get("reply") == text]

    def assert_answered_once(self) -> None:
        """Say commands: each has one reply, and its goal is sent once."""
        since, tried = len(self.service.heard), len(self.alpha.heard)
        # Different numbers, so that each sentence and its replies are known.
        texts = [f"Alpha, turn left {10 + number} degrees." for number in range(COMMANDS)]
        for text in texts:
            assert self.ask(text) == ["DONE"], text
        time.sleep(1.0)
        assert self.service.all("reply", since=since) == texts
        assert len(self.alpha.all("tried", since=tried)) == len(texts)


@pytest.fixture(scope="module")
def network(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Network]:
    try:
        machines = Machines(("service", "alpha"))
    except NotPossible as why:
        pytest.skip(f"not run: {why}")
    with machines:
        yield Network(machines, tmp_path_factory.mktemp("network"))


def test_commands_are_answered_once(network: Network) -> None:
    network.assert_answered_once()


def test_commands_are_answered_once_over_a_bad_cable(network: Network) -> None:
    try:
        network.machines.impair("alpha", delay_ms=50, loss_percent=2)
    except NotPossible as why:
        pytest.skip(f"not run: {why}")
    try:
        network.assert_answered_once()
    finally:
        network.machines.mend("alpha")


def test_cut_robot_stands_and_takes_part_again(network: Network) -> None:
    service, alpha = network.service, network.alpha
    since, there = len(service.heard), len(alpha.heard)
    long, lost, after = (f"Alpha, turn {what} degrees." for what in ("left 3600", "right 33", "left 12"))
    service.say(long)
    wait_until(lambda: alpha.last("moves"))
    cut_s = time.monotonic()
    network.machines.cut("alpha")
    try:
        # The robot still counts as there.
        service.say(lost)
        wait_until(lambda: alpha.last("moves") is False, CUT_S, "alpha goes on")
        stood_s = alpha.time_of("moves", False, since=there) - cut_s
        wait_until(lambda: service.last("members") == [], CUT_S)
        time.sleep(max(0.0, cut_s + CUT_S - time.monotonic()))
    finally:
        network.machines.join("alpha")
    joined_s, again = time.monotonic(), len(service.heard)
    wait_until(lambda: service.last("members") == ["alpha"])
    returned_s = service.time_of("members", ["alpha"], since=again) - joined_s
    # What was lost on its way must not be carried out when it arrives.
    time.sleep(RETURN_S)
    assert alpha.last("moves") is False
    assert network.ask(after) == ["DONE"]
    print(f"\nstood {stood_s:.1f} s after the cut, took part again {returned_s:.1f} s after the end of the cut")
    assert network.codes(long, since=since) == ["ROBOT_LOST"]
    assert network.codes(lost, since=since) == ["ROBOT_LOST"]
    # Without their address, and each once.
    assert alpha.all("tried", since=there) == ["turn left 3600 degrees.", "turn left 12 degrees."]
    assert returned_s <= RETURN_S
