"""How far a command is, in words of persons: no server, frame or pattern."""

from typing import Iterator, Mapping, Sequence, Tuple

from roboframenet_ros.spoken_text import with_capital
from web_console.views import PlanView, StageView, TaskView

#: What a stage is doing once it has reported.
_STAGES: Mapping[str, str] = {
    "command_server": "I heard you.",
    "stanford_parser_ros": "Reading the sentence.",
    "semantic_framer": "Working out what it means.",
    "frame_registrar": "Deciding how to do it.",
    "arbitrator": "Deciding how to do it.",
    "question_answering": "Looking for the answer.",
}
_OTHER_STAGE = "Working on it."
#: What would help after a reply of this code. Others say it themselves.
_HELP: Mapping[str, str] = {
    "UNKNOWN_VERB": "Say it in other words, or choose a sentence under “What it can do”.",
    "NO_VERB": "Say what the robot shall do, or choose a sentence under “What it can do”.",
    "NO_READING": "Say it in other words, or choose a sentence under “What it can do”.",
    "NO_SERVER": "The program that does this does not run. Start it, or ask for something else.",
    "ALL_CANDIDATES_FAILED": "Change what stands in the way, and say it again.",
    "LIMIT_REACHED": "Give it more time, or ask for less.",
    "STAGE_SILENT": "Say it again. If that does not help, look at “Nodes” in the engineer's view.",
    "STAGE_ERROR": "Say it again. If that does not help, look at the trace in the engineer's view.",
    "MASTER_LOST": "Start the robot's programs again.",
    "EMERGENCY_STOP": "Release the emergency stop first.",
}
_CONDITIONS = frozenset(("CONDITION", "ALL", "ANY"))
#: What stands between a condition and what depends on it.
_WAYS: Mapping[str, str] = {"IF": "if", "UNTIL": "until", "WHILE": "while", "WHENEVER": "whenever"}


def help_after(outcome: str, code: str) -> str:
    """Return what would help after a reply; empty for nothing more than the reply says."""
    return _HELP.get(code, "") if outcome in ("FAILED", "REFUSED") else ""


def tasks_of(plan: PlanView) -> Tuple[TaskView, ...]:
    """Return the clauses of a plan as a line: what is done, what runs and what may come."""
    return tuple(_tasks(plan, ()))


def now_of(stages: Sequence[StageView], tasks: Sequence[TaskView], did: Sequence[str]) -> str:
    """Return what happens now.

    Args:
        stages: that have reported
        tasks: of the plan
        did: what the robot said that it was doing, the newest last
    """
    if did:
        return with_capital(did[-1])
    active = [task.text for task in tasks if task.state == "active"]
    if active:
        return f"Doing “{'” and “'.join(active)}”"
    return _STAGES.get(stages[-1].name, _OTHER_STAGE) if stages else ""


def _tasks(node: PlanView, notes: Tuple[str, ...]) -> Iterator[TaskView]:
    notes = (*notes, *(note for note in node.notes if note not in notes))
    if node.kind in ("DO", "WAIT"):
        conditions = [_words(child) for child in node.children if child.kind in _CONDITIONS]
        text = _words(node) or (f"wait until {conditions[0]}" if conditions else "wait")
        yield TaskView(text, node.state, ", ".join(notes))
        return
    inner = [child for child in node.children if child.kind not in _CONDITIONS]
    said = " and ".join(_words(child) for child in node.children if child.kind in _CONDITIONS)
    way = _WAYS.get(node.kind, "")
    for place, child in enumerate(inner):
        if node.kind == "FALLBACK" and place:
            more: Tuple[str, ...] = ("or else",)
        elif node.kind == "IF" and place:
            more = ("otherwise",)
        else:
            more = (f"{way} {said}",) if way and said else ()
        yield from _tasks(child, (*notes, *more))


def _words(node: PlanView) -> str:
    return node.label.strip(" .!?")
