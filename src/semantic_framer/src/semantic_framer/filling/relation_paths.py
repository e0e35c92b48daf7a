"""Follows the relations of a unit from the verb to the words that may fill an element."""

from typing import List, Set

from semantic_framer.filling.attachment import (
    are_contents,
    behind_description,
    is_all_at_first_of_two_places,
    objects_elsewhere,
    persons_behind,
    tells_which,
)
from semantic_framer.filling.tried_unit import TriedUnit
from semantic_framer.units.frame_roles import THINGS
from semantic_framer.units.required_relations import TOWARDS
from semantic_frames.lexical_unit import RelationPath
from semantic_frames.relation_names import MEASURE
from word_classes import word_class

#: A phrase with one of these belongs to the verb if the unit asks for it, even if the parser attached it to the object:
#: "bring the mug to the table". A phrase with another preposition ("on", "in", "near") belongs to the verb only for a
#: core or required element: "put the mug on the table".
DIRECTIONAL = frozenset(phrase.replace(" ", "_") for phrase in word_class("directional_prepositions"))


class RelationFollower:
    """Follows chains of relations in the clause of a unit.

    Attributes:
        moved: heads of phrases that the parser attached to an object, and that are read at the verb
    """

    def __init__(self, tried: TriedUnit) -> None:
        self._tried = tried
        self._sentence = tried.sentence
        self._tree = tried.sentence.tree
        self._clause = tried.clause
        self._frame = tried.frame
        self._match = tried.match
        #: Objects of the verb, and phrases without a preposition, each with whether it is the direct object.
        self._nouns = tuple(
            (noun, relation == "dobj")
            for relation in ("dobj", "iobj", "obl", "tmod")
            for noun in tried.sentence.dependents(tried.clause.verb, relation)
        )
        # In "let go of the rope", "go" governs the rope.
        self._verbs = [tried.clause.verb] + [
            index for index in tried.match.positions[1:] if tried.sentence.word(index).upos == "VERB"
        ]
        self.moved: Set[int] = set()

    def follow(self, path: RelationPath, is_core: bool) -> List[int]:
        """Return the words at the end of a chain of relations that starts at the verb."""
        governors = self._verbs
        for number, step in enumerate(path.steps):
            if step == MEASURE:
                return []
            found: List[int] = []
            for governor in governors:
                found += self._sentence.dependents(governor, step)
                if number == 0:
                    found += objects_elsewhere(self._tree, self._match.positions) if step == "dobj" else []
                    found += self._reattached(path.preposition, is_core)
                    goals = self._sentence.goals if step in TOWARDS else ()
                    if goals and any(one.is_core and one.framenet in THINGS for one in self._frame.frame_elements):
                        found += [index for index in goals if self._sentence.word(index).head == governor]
                    if step == "nsubj" and self._tried.subject and not self._clause.subject:
                        found.append(self._tried.subject)
            governors = list(dict.fromkeys(found))
        return [head for head in governors if not are_contents(self._tree, head)]

    def _reattached(self, preposition: str, is_core: bool) -> List[int]:
        """Return the phrases that the parser attached to an object although the unit asks for them at the verb."""
        if not preposition or not (is_core or preposition in DIRECTIONAL) or "reattached" in self._tried.without:
            return []
        found: List[int] = []
        for noun, is_object in self._nouns:
            if not (is_core and is_all_at_first_of_two_places(self._tree, noun)):
                found += self._sentence.dependents(noun, f"prep_{preposition}")
            # "Bring the plant on the shelf near the window": the window is the goal, not part of the shelf.
            for inner in self._sentence.children(noun) if is_object else ():
                below = self._sentence.dependents(inner.index, f"prep_{preposition}")
                if inner.deprel == "nmod" and inner.index > noun:
                    found += below
                if inner.deprel == "acl":
                    found += persons_behind(self._tree, inner.index, preposition, is_needed=is_core)
                    found += behind_description(self._tree, inner.index, below)
        if not found:
            return found
        particle = [index for index in self._match.positions[1:] if self._sentence.word(index).said == preposition]
        heads = [
            head
            for head in found
            if head not in particle
            and head not in self._sentence.described
            and not tells_which(self._tree, head)
            and not self._sentence.word(head).deprel.startswith("acl")  # "which is on the bed"
        ]
        self.moved.update(heads)
        return heads
