"""Decides at a glance that a lexical unit does not fit: nothing in the sentence has a relation that it requires."""

from semantic_framer.sentence import Sentence
from semantic_frames.lexical_unit import LexicalUnit, RelationPath
from semantic_frames.relation_names import MEASURE

#: Relations that the parse need not have: measures, an object elsewhere, and the subject of another clause.
_FOUND_ELSEWHERE = frozenset([MEASURE, "dobj", "obj", "nsubj"])


def lacks_all_required(sentence: Sentence, unit: LexicalUnit) -> bool:
    """Whether a unit requires relations, and nothing in a sentence can have any of them. Most units of a verb do."""
    required = [path for relation in unit.relations if relation.is_required for path in relation.relations]
    return bool(required) and not any(_may_have(sentence, path) for path in required)


def _may_have(sentence: Sentence, path: RelationPath) -> bool:
    if path.steps[0] in sentence.relations or path.steps[0] in _FOUND_ELSEWHERE:
        return True
    # A phrase may depend on a noun, and be meant for the verb.
    return bool(path.preposition) and sentence.forms.issuperset(path.preposition.split("_"))
