"""Two machines on one: network namespaces that a cable joins, which can be bad, or be cut."""

import os
import shutil
import subprocess
import sys
import uuid
from pathlib import Path
from types import TracebackType
from typing import Dict, List, Mapping, Optional, Sequence, Type

_COMMAND_TIMEOUT_S = 10.0
_END_TIMEOUT_S = 30.0
_BAD_CABLE = str(Path(__file__).with_name("bad_cable.py"))


class NotPossible(Exception):
    """This machine forbids it; the text says what."""


class Machines:
    """Machines with one cable to a switch; a context that takes everything down at its end."""

    def __init__(self, names: Sequence[str]) -> None:
        """
        Args:
            names: of the machines

        Raises:
            NotPossible: this machine has no network namespaces, or not for this user
        """
        if not shutil.which("ip") or os.geteuid() != 0:
            raise NotPossible("network namespaces need root and the program ip")
        tag = uuid.uuid4().hex[:4]
        self.addresses: Dict[str, str] = {name: f"10.77.0.{number}" for number, name in enumerate(names, 1)}
        self._spaces = {name: f"rfn-{tag}-{name}" for name in names}
        self._cables = {name: f"rfn{tag}{number}" for number, name in enumerate(names)}
        self._switch = f"rfn{tag}sw"
        self._processes: List[subprocess.Popen[str]] = []
        self._bad_cables: Dict[str, subprocess.Popen[bytes]] = {}
        try:
            _ip("link", "add", self._switch, "type", "bridge")
            _ip("link", "set", self._switch, "up")
            for name, space in self._spaces.items():
                cable = self._cables[name]
                _ip("netns", "add", space)
                _ip("link", "add", cable, "type", "veth", "peer", "name", "eth0", "netns", space)
                _ip("link", "set", cable, "master", self._switch, "up")
                _ip("-n", space, "addr", "add", f"{self.addresses[name]}/24", "dev", "eth0")
                _ip("-n", space, "link", "set", "eth0", "up")
                _ip("-n", space, "link", "set", "lo", "up")
        except NotPossible:
            self.close()
            raise

    def __enter__(self) -> "Machines":
        return self

    def __exit__(
        self, kind: Optional[Type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType]
    ) -> None:
        self.close()

    def start(
        self, machine: str, *command: str, log: Path, environment: Mapping[str, str], reads: bool = False
    ) -> "subprocess.Popen[str]":
        """Start a program on a machine.

        Args:
            machine: its name
            command: the program and its arguments
            log: takes its output, or its errors when the output is read
            environment: beside the one of this process
            reads: its input is written, and its output read
        """
        with open(log, "a", encoding="utf-8") as file:
            process = subprocess.Popen(
                ["ip", "netns", "exec", self._spaces[machine], *command],
                env={**os.environ, "ROS_HOSTNAME": self.addresses[machine], **environment},
                stdin=subprocess.PIPE if reads else subprocess.DEVNULL,
                stdout=subprocess.PIPE if reads else file,
                stderr=file,
                universal_newlines=True,
                start_new_session=True,
            )
        self._processes.append(process)
        return process

    def cut(self, machine: str) -> None:
        """Cut the cable of a machine: packets are lost without a word to either end."""
        _ip("link", "set", self._cables[machine], "down")

    def join(self, machine: str) -> None:
        """Mend the cable."""
        _ip("link", "set", self._cables[machine], "up")

    def impair(self, machine: str, *, delay_ms: int, loss_percent: int) -> None:
        """Make the cable of a machine slow and unreliable, in the direction to it, until it is mended.

        The kernel does it, or a process where the kernel has no network emulation.

        Raises:
            NotPossible: neither can
        """
        netem = ("netem", "delay", f"{delay_ms}ms", "loss", f"{loss_percent}%")
        try:
            _run("tc", "qdisc", "replace", "dev", self._cables[machine], "root", *netem)
        except NotPossible:
            self._impair_by_process(machine, delay_ms, loss_percent)

    def _impair_by_process(self, machine: str, delay_ms: int, loss_percent: int) -> None:
        """Put a process between the switch and the cable."""
        cable, near, far = self._cables[machine], f"{self._cables[machine]}n", f"{self._cables[machine]}f"
        _ip("link", "add", far, "type", "veth", "peer", "name", near)
        for interface in (near, far):
            _run(sys.executable, _BAD_CABLE, "--without-offloads", interface)
            _ip("link", "set", interface, "up")
        # Frames from other machines must be finished as well.
        for space in self._spaces.values():
            _run("ip", "netns", "exec", space, sys.executable, _BAD_CABLE, "--without-offloads", "eth0")
        _ip("link", "set", cable, "nomaster")
        _ip("link", "set", far, "master", self._switch)
        command = [sys.executable, _BAD_CABLE, near, cable, str(delay_ms), str(loss_percent)]
        self._bad_cables[machine] = subprocess.Popen(command, start_new_session=True)

    def mend(self, machine: str) -> None:
        """End what :meth:`impair` did."""
        process = self._bad_cables.pop(machine, None)
        if process is None:
            _run("tc", "qdisc", "del", "dev", self._cables[machine], "root")
            return
        process.kill()
        process.wait(_END_TIMEOUT_S)
        _ip("link", "del", f"{self._cables[machine]}f")
        _ip("link", "set", self._cables[machine], "master", self._switch)

    def close(self) -> None:
        """End all programs, and remove the machines."""
        for machine in tuple(self._bad_cables):
            self.mend(machine)
        for process in reversed(self._processes):
            if process.poll() is None:
                process.terminate()
        for process in reversed(self._processes):
            try:
                process.wait(_END_TIMEOUT_S)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait(_END_TIMEOUT_S)
            for stream in (process.stdin, process.stdout):
                if stream is not None:
                    stream.close()
        for space in self._spaces.values():
            subprocess.run(["ip", "netns", "del", space], stderr=subprocess.DEVNULL, check=False)
        subprocess.run(["ip", "link", "del", self._switch], stderr=subprocess.DEVNULL, check=False)


def _ip(*arguments: str) -> None:
    _run("ip", *arguments)


def _run(*command: str) -> None:
    try:
        subprocess.run(command, check=True, capture_output=True, timeout=_COMMAND_TIMEOUT_S)
    except FileNotFoundError as error:
        raise NotPossible(f"{command[0]} is not installed") from error
    except subprocess.CalledProcessError as error:
        raise NotPossible(f"{' '.join(command)}: {error.stderr.decode().strip()}") from error
