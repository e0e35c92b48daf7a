"""Run the test programs that ctest knows, several at a time, and tell what each of them took.

    scripts/run_tests.py TIMEOUT_S [options of ctest that choose tests ...]

As ctest, but that it tells the processor time (user and system, with all that a program starts), the slowest programs,
and the sum. A program takes as many jobs as its property PROCESSORS says; two jobs run on each core. Those with the
greatest COST begin first, of equal ones the one that took longest the last time.
"""

import json
import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, List, Sequence, Set

ROOT = Path(__file__).resolve().parent.parent
BUILD = ROOT / "build"
#: What each program took the last time.
TIMES = BUILD / "test_times.json"
#: So long a program may clean up before it is killed, seconds.
PATIENCE_S = 30.0
SLOWEST = 10


@dataclass(frozen=True)
class Program:
    """A test program: its name, its command, how many jobs it counts as, and how early it begins."""

    name: str
    command: Sequence[str]
    jobs: int
    cost: float


@dataclass(frozen=True)
class Result:
    """What a program has come to.

    Attributes:
        program: the program
        has_passed: whether its exit status is 0
        wall_s: how long it ran
        cpu_s: processor time of it and of all that it has started and waited for
        output: what it printed
    """

    program: Program
    has_passed: bool
    wall_s: float
    cpu_s: float
    output: str


def programs(options: Sequence[str]) -> List[Program]:
    """Return the chosen programs in the order in which they begin."""
    command = ["ctest", "--test-dir", str(BUILD), "--show-only=json-v1", *options]
    listed = json.loads(subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout)["tests"]
    last: Dict[str, float] = json.loads(TIMES.read_text(encoding="utf-8")) if TIMES.exists() else {}
    found = []
    for test in listed:
        properties = {one["name"]: one["value"] for one in test["properties"]}
        jobs, cost = int(properties.get("PROCESSORS", 1)), float(properties.get("COST", 0))
        found.append(Program(test["name"].replace("_ctest_", "", 1), test["command"], jobs, cost))
    return sorted(found, key=lambda one: (-one.cost, -last.get(one.name, 0.0), one.name))


class Runner:
    """Runs programs, and ends all of them when it is closed."""

    def __init__(self, timeout_s: float) -> None:
        self._timeout_s = timeout_s
        self._lock = threading.Lock()
        self._running: Set[int] = set()
        self._is_closed = False

    def run(self, program: Program) -> Result:
        """Run a program to its end, or to its time limit."""
        log = BUILD / "test_logs" / f"{program.name}.log"
        log.parent.mkdir(exist_ok=True)
        begin_s = time.monotonic()
        with log.open("wb") as file:
            with self._lock:
                if self._is_closed:
                    return Result(program, False, 0.0, 0.0, "not run")
                process = subprocess.Popen(
                    program.command, stdout=file, stderr=subprocess.STDOUT, start_new_session=True
                )
                self._running.add(process.pid)
            limits = [
                threading.Timer(self._timeout_s + wait_s, self._send, (process.pid, number))
                for wait_s, number in ((0.0, signal.SIGINT), (PATIENCE_S, signal.SIGKILL))
            ]
            for limit in limits:
                limit.start()
            # Only this call tells what the program and its children have used.
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = status
            with self._lock:
                self._running.discard(process.pid)
            for limit in limits:
                limit.cancel()
        wall_s = time.monotonic() - begin_s
        output = log.read_text(encoding="utf-8", errors="replace")
        if wall_s >= self._timeout_s:
            output += f"\nended after {wall_s:.0f} s: its time limit\n"
        return Result(program, status == 0, wall_s, usage.ru_utime + usage.ru_stime, output)

    def _send(self, pid: int, number: int) -> None:
        with self._lock:
            if pid in self._running:
                os.killpg(pid, number)

    def close(self) -> None:
        """End what runs; nothing more begins."""
        with self._lock:
            self._is_closed = True
            running = list(self._running)
        for pid in running:
            self._send(pid, signal.SIGINT)


def run_all(chosen: Sequence[Program], runner: Runner, jobs: int) -> List[Result]:
    """Run programs, as many at a time as their jobs allow; tell of each one that has ended."""
    waiting, results = list(chosen), []
    running: Dict[Future[Result], Program] = {}
    with ThreadPoolExecutor(max_workers=jobs) as pool:
        try:
            while waiting or running:
                free = jobs - sum(min(one.jobs, jobs) for one in running.values())
                # One that is too large for what is free lets a smaller one pass.
                following = next((one for one in waiting if min(one.jobs, jobs) <= free), None)
                if following is not None:
                    waiting.remove(following)
                    running[pool.submit(runner.run, following)] = following
                    continue
                for future in wait(running, return_when=FIRST_COMPLETED).done:
                    del running[future]
                    results.append(future.result())
                    tell(results[-1], f"{len(results)}/{len(chosen)}")
        except BaseException:
            runner.close()
            raise
    return results


def tell(result: Result, number: str) -> None:
    """Print a line for a program; its output, too, when it failed."""
    how = "passed" if result.has_passed else "FAILED"
    print(f"{number:>8} {how} {result.program.name}  {result.wall_s:.1f} s, cpu {result.cpu_s:.1f} s", flush=True)
    if not result.has_passed:
        print(result.output, flush=True)


def main() -> int:
    """Run the programs; return 1 when one failed or none was chosen."""
    chosen = programs(sys.argv[2:])
    begin_s = time.monotonic()
    results = run_all(chosen, Runner(float(sys.argv[1])), 2 * (os.cpu_count() or 1))
    known = json.loads(TIMES.read_text(encoding="utf-8")) if TIMES.exists() else {}
    known.update({one.program.name: one.wall_s for one in results})
    TIMES.write_text(json.dumps(known, indent=1, sort_keys=True), encoding="utf-8")
    print(f"The slowest of {len(results)} programs:")
    for one in sorted(results, key=lambda one: -one.wall_s)[:SLOWEST]:
        print(f"{one.wall_s:8.1f} s, cpu {one.cpu_s:6.1f} s  {one.program.name}")
    cpu_s, wall_s = sum(one.cpu_s for one in results), time.monotonic() - begin_s
    print(f"Processor time {cpu_s:.0f} s (user and system), {wall_s:.0f} s by the clock")
    return 0 if results and all(one.has_passed for one in results) else 1


if __name__ == "__main__":
    sys.exit(main())
