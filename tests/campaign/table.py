"""The table of a campaign, and the file of trials that makes it resumable."""

import json
import os
from pathlib import Path
from typing import Any, Dict, List, Mapping, Sequence

from .demand import Demand, Figure, Trial


class TrialFile:
    """Trials of one demand, a line of JSON each; a line that was cut short by a kill is forgotten."""

    def __init__(self, path: Path) -> None:
        """
        Args:
            path: of the file; its folder is made
        """
        path.parent.mkdir(parents=True, exist_ok=True)
        self._path = path
        self.trials: List[Trial] = []
        whole = 0
        if path.exists():
            for line in path.read_bytes().splitlines(keepends=True):
                try:
                    self.trials.append(json.loads(line))
                except ValueError:
                    break
                whole += len(line)
            os.truncate(path, whole)

    def add(self, trial: Mapping[str, Any]) -> None:
        """Append a trial; it is on the disk when this returns."""
        with self._path.open("a", encoding="utf-8") as file:
            file.write(json.dumps(trial) + "\n")
            file.flush()
            os.fsync(file.fileno())
        self.trials.append(trial)


def figures_of(demand: Demand, trials: Sequence[Trial], wanted_count: int) -> List[Figure]:
    """Return all figures of a demand, and of trials that are missing or broke."""
    sound = [trial for trial in trials if "error" not in trial]
    figures = demand.figures(sound) if sound else []
    if len(trials) < wanted_count:
        figures.append(Figure("trials", f"{len(trials)}", f"{wanted_count}", False))
    broken = [trial for trial in trials if "error" in trial]
    if broken:
        first = f"trial {broken[0]['number']}: {broken[0]['error']}"
        figures.append(Figure("trials that broke", f"{len(broken)}; {first[:160]}", "0", False))
    return figures


def markdown(results: Mapping[str, Sequence[Figure]], titles: Mapping[str, str], about: Dict[str, str]) -> str:
    """Return the table.

    Args:
        results: figures by demand
        titles: of the demands
        about: what was run and under which load, by name
    """
    lines = [f"{name}: {text}" for name, text in about.items()]
    lines += ["", "| | demand | figure | found | wanted | holds |", "| --- | --- | --- | --- | --- | --- |"]
    for name, figures in results.items():
        for number, figure in enumerate(figures):
            head = (name, titles[name]) if number == 0 else ("", "")
            cells = (*head, figure.name, figure.found, figure.wanted, "yes" if figure.holds else "**no**")
            lines.append("| " + " | ".join(cell.replace("|", "\\|").replace("\n", " ") for cell in cells) + " |")
    return "\n".join(lines) + "\n"
