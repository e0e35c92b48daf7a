"""Steps that run once: a step is skipped while its recorded inputs and settings are unchanged.

A step names the files it reads, the settings it depends on and the files it writes. Its record is a fingerprint of
all three. An interrupted run continues with the first step whose record is missing or differs. Steps run in parallel
as far as their inputs allow.
"""

import hashlib
import json
import sys
import time
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import dataclass
from pathlib import Path
from typing import Callable, Dict, List, Mapping, Sequence, Set, Tuple

from .errors import TrainingError

CHUNK = 1 << 20
REPORT_SECONDS = 30.0


@dataclass(frozen=True)
class Step:
    """One piece of work: ``run`` reads ``inputs``, writes ``outputs`` and logs to ``log``.

    It goes on from ``partial``, if these files are there from an interrupted run.
    """

    name: str
    inputs: Tuple[Path, ...]
    outputs: Tuple[Path, ...]
    settings: Mapping[str, object]
    run: Callable[[], None]
    log: Path
    partial: Tuple[Path, ...] = ()


def digest(path: Path) -> str:
    """Return the MD5 sum of a file."""
    hashed = hashlib.md5()
    with path.open("rb") as stream:
        for chunk in iter(lambda: stream.read(CHUNK), b""):
            hashed.update(chunk)
    return hashed.hexdigest()


def fingerprint(step: Step) -> Dict[str, object]:
    """Return a fingerprint of everything that the result of a step depends on."""
    return {
        "inputs": {path.name: digest(path) for path in step.inputs},
        "settings": {key: str(value) for key, value in sorted(step.settings.items())},
    }


def done(step: Step, records: Path) -> bool:
    """Whether the outputs of a step exist and were made from its present inputs and settings."""
    record = records / (step.name + ".json")
    if not record.is_file() or not all(path.is_file() for path in step.outputs):
        return False
    if not all(path.is_file() for path in step.inputs):
        return False
    kept: object = json.loads(record.read_text(encoding="utf-8"))
    return kept == fingerprint(step)


def begin(step: Step, records: Path) -> bool:
    """Note that a step begins, and return whether it goes on from where an earlier run was interrupted.

    What an interrupted run left is removed if its inputs or settings were others.
    """
    record = records / (step.name + ".begun.json")
    now = fingerprint(step)
    is_same = record.is_file() and json.loads(record.read_text(encoding="utf-8")) == now
    for path in step.partial:
        if path.is_file() and not is_same:
            path.unlink()
    record.write_text(json.dumps(now, indent=1), encoding="utf-8")
    return is_same and any(path.is_file() for path in step.partial)


def last_line(log: Path) -> str:
    """Return the last line in the log of a step, cut to the width of a screen; empty if there is none."""
    if not log.is_file():
        return ""
    with log.open("rb") as stream:
        stream.seek(0, 2)
        stream.seek(max(0, stream.tell() - 2000))
        lines = [line for line in stream.read().decode("utf-8", "replace").splitlines() if line.strip()]
    return lines[-1][-110:] if lines else ""


def tell(text: str) -> None:
    """Print one line of progress with the time of day."""
    sys.stdout.write(time.strftime("%H:%M:%S ") + text + "\n")
    sys.stdout.flush()


def execute(steps: Sequence[Step], records: Path, jobs: int) -> None:
    """Run all steps that are not done, at most ``jobs`` at once, in the order of the list.

    Raises TrainingError naming the step that failed; finished steps stay recorded.
    """
    records.mkdir(parents=True, exist_ok=True)
    waiting: List[Step] = list(steps)
    running: Dict[Future[None], Tuple[Step, float]] = {}
    finished: Set[str] = set()
    made_by = {path: step.name for step in steps for path in step.outputs}
    with ThreadPoolExecutor(max_workers=jobs) as pool:
        while waiting or running:
            for step in list(waiting):
                needs = {made_by[path] for path in step.inputs if path in made_by}
                if not needs <= finished or len(running) >= jobs:
                    continue
                waiting.remove(step)
                if done(step, records):
                    tell(f"[{len(finished) + 1}/{len(steps)}] {step.name}: done before")
                    finished.add(step.name)
                    continue
                missing = [path for path in step.inputs if not path.is_file()]
                if missing:
                    raise TrainingError(f"step {step.name}: input {missing[0]} is missing")
                how = "goes on" if begin(step, records) else "started"
                tell(f"[{len(finished) + len(running) + 1}/{len(steps)}] {step.name}: {how}")
                running[pool.submit(step.run)] = (step, time.monotonic())
            if not running:
                if waiting and all(
                    not {made_by[path] for path in step.inputs if path in made_by} <= finished for step in waiting
                ):
                    names = ", ".join(step.name for step in waiting)
                    raise TrainingError(f"steps wait for each other: {names}")
                continue
            ended, _ = wait(running, timeout=REPORT_SECONDS, return_when=FIRST_COMPLETED)
            if not ended:
                for step, started in running.values():
                    tell(f"      {step.name}, {int((time.monotonic() - started) / 60)} min: {last_line(step.log)}")
            for future in ended:
                step, started = running.pop(future)
                error = future.exception()
                if error is not None:
                    raise TrainingError(f"step {step.name} failed: {error}; see {step.log}") from error
                absent = [path for path in step.outputs if not path.is_file()]
                if absent:
                    raise TrainingError(f"step {step.name} ended without {absent[0]}; see {step.log}")
                record = records / (step.name + ".json")
                record.write_text(json.dumps(fingerprint(step), indent=1), encoding="utf-8")
                finished.add(step.name)
                tell(f"[{len(finished)}/{len(steps)}] {step.name}: done in {(time.monotonic() - started) / 60:.1f} min")
