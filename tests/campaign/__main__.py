"""Runs the campaign: ``python -m campaign [--form short|standard|full] [--only R2,R5] [--seed N] [--folder F]``."""

import argparse
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Dict, Iterable, List, Sequence

from .demand import ATTACKS, FORMS, LANES, SUITE, Demand, Figure, chance_of
from .demands import DEMANDS
from .table import TrialFile, figures_of, markdown

_SEED = 20120514


def main() -> int:
    """Run demands and print the table; returns 0 when every figure holds."""
    parser = argparse.ArgumentParser(prog="campaign", description=__doc__)
    parser.add_argument("--form", choices=FORMS, default="short")
    parser.add_argument("--only", default="", help="names of demands, separated by commas")
    parser.add_argument("--seed", type=int, default=_SEED)
    parser.add_argument("--folder", type=Path, default=Path("build/reliability"), help="where the trials are kept")
    parser.add_argument("--again", action="store_true", help="forget the trials that are there")
    parser.add_argument("--make-trials", metavar="NAME", help="make the trials of one demand, and print nothing")
    arguments = parser.parse_args()
    folder = arguments.folder / f"{arguments.form}-{arguments.seed}"
    if arguments.make_trials:
        # A campaign that is ended leaves no robot behind.
        signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
        make_trials(DEMANDS[arguments.make_trials], arguments.form, arguments.seed, folder)
        return 0
    names = [name for name in arguments.only.split(",") if name] or list(DEMANDS)
    unknown = sorted(set(names) - set(DEMANDS))
    if unknown:
        parser.error(f"unknown: {', '.join(unknown)}; there are {', '.join(DEMANDS)}")
    if arguments.again:
        for name in names:
            _path(folder, name).unlink(missing_ok=True)
    return run([DEMANDS[name] for name in names], arguments.form, arguments.seed, arguments.folder, folder)


def run(demands: Sequence[Demand], form: str, seed: int, base: Path, folder: Path) -> int:
    """Make the trials of demands, each demand in a process of its own, and print the table."""
    begin_s, load = time.monotonic(), os.getloadavg()[0]
    print(f"form {form}, seed {seed}; trials in {folder}", flush=True)
    command = [sys.executable, "-m", "campaign", "--form", form, "--seed", str(seed), "--folder", str(base)]
    loads: Dict[str, float] = {}

    # What robots and tests keep between two starts is gone when the campaign ends.
    with tempfile.TemporaryDirectory(prefix="roboframenet_") as temporary:
        environment = dict(os.environ, TMPDIR=temporary)

        def try_all(chosen: Iterable[Demand]) -> None:
            for demand in chosen:
                print(f"{demand.name}: {demand.title}, {demand.count(form)} trials", flush=True)
                subprocess.run([*command, "--make-trials", demand.name], check=False, env=environment)
                loads[demand.name] = os.getloadavg()[0]

        may_test = threading.Event()

        def try_lane(lane: str) -> None:
            of_lane = [demand for demand in demands if demand.lane == lane]
            try:
                if lane == SUITE:
                    may_test.wait()
                try_all(demand for demand in of_lane if demand.is_without_tests)
            finally:
                if lane == ATTACKS:
                    may_test.set()
            try_all(demand for demand in of_lane if not demand.is_without_tests)

        with ThreadPoolExecutor(len(LANES)) as lanes:
            list(lanes.map(try_lane, LANES))
    results: Dict[str, List[Figure]] = {}
    taken: Dict[str, float] = {}
    for demand in demands:
        trials = TrialFile(_path(folder, demand.name)).trials
        results[demand.name] = figures_of(demand, trials, demand.count(form))
        taken[demand.name] = sum(trial["took_s"] for trial in trials) / 60.0
    about = {
        "Form": form,
        "Seed": str(seed),
        "Took": f"{(time.monotonic() - begin_s) / 60.0:.0f} min",
        "Cores": str(os.cpu_count()),
        "Load before": f"{load:.1f}",
        "Load behind each": ", ".join(f"{name} {value:.1f}" for name, value in loads.items()),
        "Minutes of the trials": ", ".join(f"{name} {minutes:.0f}" for name, minutes in taken.items()),
    }
    text = markdown(results, {demand.name: demand.title for demand in demands}, about)
    (folder / "table.md").write_text(text, encoding="utf-8")
    print(text)
    return 0 if all(figure.holds for figures in results.values() for figure in figures) else 1


def make_trials(demand: Demand, form: str, seed: int, folder: Path) -> None:
    """Make the trials of a demand that are not there yet."""
    file = TrialFile(_path(folder, demand.name))
    if len(file.trials) >= demand.count(form):
        return
    with demand.running():
        for number in range(len(file.trials), demand.count(form)):
            begin_s = time.monotonic()
            try:
                found = demand.trial(number, chance_of(seed, demand.name, number))
            except Exception as error:  # boundary: a trial that breaks is a line of the table, and others go on
                found = {"error": f"{type(error).__name__}: {error}"}
            file.add({"number": number, **found, "took_s": round(time.monotonic() - begin_s, 3)})


def _path(folder: Path, name: str) -> Path:
    return folder / f"{name}.jsonl"


if __name__ == "__main__":
    sys.exit(main())
