"""Puts what the stages report into the order of the stages.

A stage passes a command on before it reports it, so that the next one need not wait: reports may come in any order.
"""

from dataclasses import dataclass
from typing import Dict, List, Set, Tuple

#: The stages that each command passes; others report at any time.
STAGES = ("stanford_parser_ros", "semantic_framer", "frame_registrar", "arbitrator", "executor")


@dataclass(frozen=True)
class _Held:
    command_id: str
    stage: str
    text: str
    due_s: float


class StageOrder:
    """Holds a report back until the stages before have reported the same command, but not for long."""

    def __init__(self, *, longest_s: float) -> None:
        """
        Args:
            longest_s: a report is held back no longer: a command may leave out stages
        """
        self._longest_s = longest_s
        self._held: List[_Held] = []
        self._reported: Dict[str, Set[str]] = {}

    def add(self, command_id: str, stage: str, text: str, *, now_s: float) -> Tuple[str, ...]:
        """Take a report; return what is to be shown now, in order."""
        self._held.append(_Held(command_id, stage, text, now_s + self._longest_s))
        return self.due(now_s=now_s)

    def due(self, *, now_s: float) -> Tuple[str, ...]:
        """Return what is to be shown now, in order."""
        shown: List[str] = []
        self._held.sort(key=lambda held: _rank(held.stage))
        for held in tuple(self._held):
            before = STAGES[: max(0, _rank(held.stage))]
            if now_s >= held.due_s or self._reported.get(held.command_id, set()).issuperset(before):
                self._held.remove(held)
                self._reported.setdefault(held.command_id, set()).update((*before, held.stage))
                shown.append(held.text)
        return tuple(shown)


def _rank(stage: str) -> int:
    return STAGES.index(stage) if stage in STAGES else -1
