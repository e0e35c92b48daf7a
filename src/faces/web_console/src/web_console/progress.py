"""How far a plan is, by what SMACH publishes about the machine that carries it out.

A container of the machine has a path, "/Ping and wave/2 wave/candidate_1". The numbers in its parts, from 1, are the
places of children, candidates and steps in the plan; the words are for people. A machine may have containers that the
plan has not: parts without a number are skipped.
"""

import re
from dataclasses import dataclass, field, replace
from typing import Dict, List, Mapping, Optional, Sequence, Tuple

from web_console.views import CandidateView, PlanView, StepView

Place = Tuple[int, ...]

_CHILD = re.compile(r"(\d+)[ _]")
_CANDIDATE = re.compile(r"candidate_(\d+)$")
_OUTCOME = re.compile(r"outcome '?(\w+)'?")
_STATES: Mapping[str, str] = {"succeeded": "done", "aborted": "failed", "preempted": "stopped"}
_MOST_PLACES = 4000


@dataclass(frozen=True)
class Progress:
    """States of places in a plan: of children, candidates and steps, each place a path of positions from 0."""

    states: Mapping[Place, str] = field(default_factory=dict)

    def heard(self, path: str, active: Sequence[str], info: str) -> "Progress":
        """Return the progress after a container has published its status.

        Args:
            path: of the container
            active: labels of its active states
            info: why it was published; names the outcome of a container that has ended
        """
        place = place_of(path)
        states: Dict[Place, str] = dict(self.states)
        outcome = _OUTCOME.search(info)
        if outcome is not None and info.startswith("Terminated"):
            state = _STATES.get(outcome.group(1), "done")
            for inner, old in self.states.items():
                if old == "active" and inner[: len(place)] == place:
                    states[inner] = state
            states[place] = state
        else:
            lit = {place + (position,) for label in active for position in _positions(label)}
            for inner, old in self.states.items():
                if old == "active" and inner[:-1] == place and inner not in lit:
                    # The first that fails of alternatives is followed by another; all else is followed after success.
                    states[inner] = "done"
            for inner in lit:
                if states.get(inner) not in ("failed", "stopped"):
                    states[inner] = "active"
            if lit:
                states[place] = "active"
        return self if len(states) > _MOST_PLACES else replace(self, states=states)


def place_of(path: str) -> Place:
    """Return the place of a container in the plan; that of the root is empty."""
    found: List[int] = []
    root, *labels = path.strip("/").split("/")
    for label in labels[1:] if labels[:1] == [root] else labels:
        found += _positions(label)
    return tuple(found)


def _positions(label: str) -> List[int]:
    match = _CANDIDATE.match(label) or _CHILD.match(label)
    return [int(match.group(1)) - 1] if match and int(match.group(1)) > 0 else []


def is_machine_of(path: str, plan: PlanView) -> bool:
    """Whether a container belongs to the machine of a plan, by the name of the machine: the words of the plan.

    The machine of the command before may still report its end.
    """
    root = _letters(path.strip("/").split("/")[0])
    return root == "plan" or _letters(plan.label).startswith(root)


def _letters(text: str) -> str:
    return re.sub(r"\W+", "", text.lower())


def light(plan: PlanView, progress: Progress, *, place: Place = ()) -> PlanView:
    """Return a plan with the states of its parts."""
    state = progress.states.get(place, plan.state)
    return replace(
        plan,
        state=state,
        children=tuple(light(child, progress, place=place + (at,)) for at, child in enumerate(plan.children)),
        candidates=tuple(
            _light_candidate(candidate, progress, place + (at,)) for at, candidate in enumerate(plan.candidates)
        ),
    )


def _light_candidate(candidate: CandidateView, progress: Progress, place: Place) -> CandidateView:
    return replace(
        candidate,
        state=progress.states.get(place, candidate.state),
        steps=tuple(
            replace(step, state=progress.states.get(place + (at,), step.state))
            for at, step in enumerate(candidate.steps)
        ),
    )


def conclude(plan: PlanView, outcome: str) -> PlanView:
    """Return a plan whose command has ended: nothing is active any more, and a plan that was carried out is done.

    Short plans end before SMACH shows them; the reply knows the end of the whole.
    """
    ended = {"DONE": "done", "SUPERSEDED": "stopped"}.get(outcome, "failed")
    return _concluded(plan, ended, is_whole_done=outcome == "DONE")


def _concluded(plan: PlanView, ended: str, *, is_whole_done: bool) -> PlanView:
    def end_of(state: str) -> str:
        return ended if state == "active" or (state == "waiting" and is_whole_done) else state

    candidates = plan.candidates
    if candidates:
        tried = next((at for at, one in enumerate(candidates) if one.state in ("active", "done")), None)
        first = _first_waiting(candidates) if tried is None and is_whole_done else tried
        candidates = tuple(
            _concluded_candidate(one, ended, is_done=is_whole_done and at == first) for at, one in enumerate(candidates)
        )
    return replace(
        plan,
        state=end_of(plan.state),
        children=tuple(_concluded(child, ended, is_whole_done=is_whole_done) for child in plan.children),
        candidates=candidates,
    )


def _first_waiting(candidates: Sequence[CandidateView]) -> Optional[int]:
    return next((at for at, one in enumerate(candidates) if one.state == "waiting"), None)


def _concluded_candidate(candidate: CandidateView, ended: str, *, is_done: bool) -> CandidateView:
    def end_of(state: str) -> str:
        return "done" if is_done and state in ("active", "waiting") else ended if state == "active" else state

    steps: Tuple[StepView, ...] = tuple(replace(step, state=end_of(step.state)) for step in candidate.steps)
    return replace(candidate, state=end_of(candidate.state), steps=steps)


def ordered(plan: PlanView, sequences: Sequence[Sequence[Tuple[str, str]]]) -> PlanView:
    """Return a plan whose candidates are in the order in which they are tried.

    Args:
        plan: with the candidates of each clause in no particular order
        sequences: the frames of all clauses, each with its server, for combinations of candidates, the first one first
    """

    def rank(candidate: CandidateView) -> int:
        steps = [(step.frame, step.server) for step in candidate.steps]
        for place, sequence in enumerate(sequences):
            starts = range(len(sequence) - len(steps) + 1)
            if any(list(sequence[start : start + len(steps)]) == steps for start in starts):
                return place
        return len(sequences)

    return replace(
        plan,
        children=tuple(ordered(child, sequences) for child in plan.children),
        candidates=tuple(sorted(plan.candidates, key=rank)),
    )
