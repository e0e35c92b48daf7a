"""Gives learned units the verbs that the sentences lack: who has learned "bring" can "fetch"."""

from typing import Dict, List, Sequence, Set

from frame_learning.unit_induction import LearnedUnit
from semantic_types.verbs import shipped_verbs

#: "Be" says nothing of its own.
_EMPTY = frozenset(["be"])


def add_similar_verbs(units: Sequence[LearnedUnit]) -> None:
    """Add to each unit the verbs that WordNet has for the meaning of its verbs.

    Verbs that no unit has, and that mean mostly the same, or a way to do it, go with the verb that is nearest. A verb
    that the sentences have in other frames only ("move" to a place) is added to the units of a verb that usually means
    the same ("go" forward).

    Args:
        units: learned units; they are changed
    Raises:
        NoWordNet: the database is not installed
    """
    known: Set[str] = {verb.split()[0] for unit in units for verb in unit.verbs} - _EMPTY
    alike: Dict[str, List[str]] = {verb: list(others) for verb, others in shipped_verbs().like(known).items()}
    frames: Dict[str, Set[str]] = {}
    for unit in units:
        for verb in unit.verbs:
            frames.setdefault(verb, set()).add(unit.frame_name)
    for verb, others in shipped_verbs().same(known).items():
        alike.setdefault(verb, []).extend(others)
    for unit in units:
        for verb in unit.verbs:
            new = [other for other in alike.get(verb, ()) if unit.frame_name not in frames.get(other, ())]
            unit.verbs_alike += [other for other in new if other not in unit.verbs_alike]
