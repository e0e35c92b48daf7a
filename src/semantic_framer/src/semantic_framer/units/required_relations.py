"""Decides at a glance that a sentence has nothing for a relation of a lexical unit, or for all that it requires."""

from semantic_framer.values.sentence import Sentence
from semantic_frames.lexical_unit import LexicalUnit, RelationPath
from semantic_frames.relation_names import MEASURE

#: Relations that the parse need not have: measures, an object elsewhere, and the subject of another clause.
_FOUND_ELSEWHERE = frozenset([MEASURE, "dobj", "obj", "nsubj"])
#: Relations of a goal: a place that the world makes one may have any preposition.
TOWARDS = frozenset(["prep_to", "prep_into", "prep_onto"])


def lacks_all_required(sentence: Sentence, unit: LexicalUnit) -> bool:
    """Whether a unit requires relations, and nothing in a sentence can have any of them. Most units of a verb do."""
    required = [path for relation in unit.relations if relation.is_required for path in relation.relations]
    return bool(required) and not any(may_have(sentence, path) for path in required)


def may_have(sentence: Sentence, path: RelationPath) -> bool:
    """Whether a sentence may have a word at the end of a path; most paths of a unit lead nowhere."""
    first = path.steps[0]
    if first in sentence.relations or first in _FOUND_ELSEWHERE or (first in TOWARDS and sentence.goals):
        return True
    # A phrase may depend on a noun, and be meant for the verb.
    return bool(path.preposition) and sentence.forms.issuperset(path.preposition.split("_"))
