"""Policies compared in the home, whose servers fetch and carry with one of two arms: one lets things slip.

Commands are understood, and carried out by the home's own skills on its engine, without ROS. The left arm holds paper
only, the right arm anything else. Half-way the left arm is mended, and the right arm breaks.

    PYTHONPATH=tests/unit:$PYTHONPATH python -m learned_policies.home --commands 60
"""

import argparse
from dataclasses import replace
from typing import Dict, Sequence

from home_referee.annotated import read_annotated
from home_referee.direct_run import DirectRun

from arbitrator.plan import Candidate
from home_servers.body import CannotDo, Interrupted
from home_servers.frames import FRAMES
from home_servers.skills import Skills
from roboframenet_sim.home_state import Faults

from .chooser import Chooser
from .comparison import CHOOSERS, Result
from .simulation import Request

LEFT, RIGHT = ARMS = ("left_arm", "right_arm")
#: What is said, and the thing that is carried.
SAID = (
    ("Bring me the newspaper.", "newspaper"),
    ("Put the apple on the desk.", "apple"),
    ("Bring the keys to Bob.", "keys"),
)
SPEAKER = "alice"
POLICIES = ("random", "in_order", "fewest_steps", "counts", "learned")
#: How often a thing slips out of an arm.
_WEAK, _STRONG = 1.0, 0.1


class Arms:
    """How often a thing slips out of each arm."""

    def __init__(self, commands: int) -> None:
        self._half = commands // 2

    def slip(self, arm: str, request: Request) -> float:
        """Return how often the thing of a command slips out of an arm."""
        good = LEFT if request.number >= self._half or request.kind == "newspaper" else RIGHT
        return _STRONG if arm == good else _WEAK


class Oracle(Chooser):
    """Knows the arms: what slips least comes first."""

    def __init__(self, arms: Arms) -> None:
        self._arms = arms

    def choose(self, request: Request, candidates: Sequence[Candidate]) -> Sequence[Candidate]:
        """Sort by the arms."""
        return sorted(candidates, key=lambda one: max(self._arms.slip(part.server, request) for part in one.frames))


class HomeWithArms:
    """Carries commands out, each in a home that is as at the beginning."""

    def __init__(self, commands: int) -> None:
        self._runs = DirectRun(speaker=SPEAKER, servers=ARMS)
        self._commands = commands
        self.arms = Arms(commands)

    def run(self, chooser: Chooser) -> Result:
        """Return what a policy costs."""
        result, annotated = Result(), read_annotated()[0]
        for number in range(self._commands):
            text, kind = SAID[number % len(SAID)]
            body, _ = self._runs.body_for(replace(annotated, text=text, arranged={}))
            skills, began_s, failures = Skills(body, speaker=SPEAKER), body.home.state.time_s, 0
            for candidates in self._runs.understand(text).candidates:
                request = Request(number, candidates[0].frames[0].name, kind, "")
                for candidate in chooser.choose(request, candidates):
                    if self._is_done(candidate, request, skills, chooser):
                        break
                    failures += 1
            result.failures.append(failures)
            result.seconds.append(body.home.state.time_s - began_s)
        return result

    def _is_done(self, candidate: Candidate, request: Request, skills: Skills, chooser: Chooser) -> bool:
        home = skills.body.home
        for frame in candidate.frames:
            home.faults, began_s = Faults(slip=self.arms.slip(frame.server, request)), home.state.time_s
            try:
                FRAMES[frame.name](skills, frame)
                skills.tidy()
                succeeded = True
            except (CannotDo, Interrupted):
                succeeded = False
            chooser.hear(request, frame, succeeded=succeeded, took_s=home.state.time_s - began_s)
            if not succeeded:
                return False
        return True


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(prog="learned_policies.home", description=__doc__)
    parser.add_argument("--commands", type=int, default=60, help="how many commands")
    given = parser.parse_args()
    home = HomeWithArms(given.commands)
    choosers: Dict[str, Chooser] = {name: CHOOSERS[name](None, 1) for name in POLICIES}
    choosers["oracle"] = Oracle(home.arms)
    print("| policy | goals that failed | of the second half | home time, s |\n| --- | --- | --- | --- |")
    for name, chooser in choosers.items():
        found = home.run(chooser)
        second = found.between(given.commands // 2, given.commands)
        print(f"| `{name}` | {sum(found.failures)} | {second} | {sum(found.seconds):.0f} |", flush=True)


if __name__ == "__main__":
    main()
