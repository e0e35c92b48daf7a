"""Runs external programs that make sound, with a time limit, and ends them when they are no longer wanted."""

import shutil
import subprocess
import time
from typing import Callable, List, Optional, Sequence

#: Period of checks of a running program, seconds.
POLL_S = 0.05
#: Time for a program to end before it is killed, seconds.
GRACE_S = 0.5


def speech_command(text: str) -> Optional[List[str]]:
    """Return the command line that says a text aloud; None when no speech program is installed."""
    program = shutil.which("espeak-ng") or shutil.which("espeak")
    # The text follows "--", so that a text with a dash at its front is not an option.
    return [program, "--", text] if program else None


def wave_command(path: str) -> Optional[List[str]]:
    """Return the command line that plays a WAV file; None when no player is installed."""
    program = shutil.which("aplay")
    return [program, "-q", path] if program else None


def run_bounded(command: Sequence[str], *, timeout_s: float, is_wanted: Callable[[], bool]) -> bool:
    """Run a program to its end, to its deadline, or until it is no longer wanted.

    Args:
        command: program and arguments; no shell is involved
        timeout_s: seconds after which the program is ended
        is_wanted: called repeatedly; False ends the program
    Returns:
        whether the program ended by itself with exit status 0
    """
    try:
        process = subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
    except OSError:
        return False
    end = time.monotonic() + timeout_s
    try:
        while process.poll() is None:
            if time.monotonic() >= end or not is_wanted():
                return False
            time.sleep(POLL_S)
        return process.returncode == 0
    finally:
        _end(process)


def _end(process: "subprocess.Popen[bytes]") -> None:
    if process.poll() is not None:
        return
    process.terminate()
    try:
        process.wait(GRACE_S)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait(GRACE_S)
