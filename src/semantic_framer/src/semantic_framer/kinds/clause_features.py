"""The features of a clause, whatever its mood: who acts, what is asked, polarity, modality, tense and aspect.

They are read from the tree alone, and so hold for every verb: auxiliaries, subject, word order and question words.
"""

from dataclasses import dataclass, replace
from enum import Enum
from typing import FrozenSet, List, Optional, Sequence, Tuple

from utterance_passes.trees.tree import DependencyTree, Word
from word_classes import word_class

_ASKING = word_class("question_words")
_HAVE, _BE = word_class("forms_of_have"), word_class("forms_of_be")
_FUTURE = word_class("future_auxiliaries")
_NEGATIONS = word_class("negations")
#: Relations of clauses inside a clause, whose question words are their own.
_INNER = frozenset(["acl", "advcl", "ccomp", "csubj", "parataxis", "conj"])


class Form(Enum):
    """How a clause is said."""

    PLAIN = "plain"
    POLAR = "polar question"
    OPEN = "open question"


class Aspect(Enum):
    """When something happens, seen from now."""

    PRESENT = "present"
    RUNNING = "running"
    DONE = "done"
    EVER_DONE = "ever_done"
    PLANNED = "planned"


@dataclass(frozen=True)
class ClauseFeatures:
    """The features of a clause.

    Attributes:
        top: position of its main verb, or of its predicate
        form: a statement, or a question, of which only one has a question word
        agent: position of the head of who acts; 0 if the clause names nobody
        asked: position of the question word; 0 if there is none
        aspect: when it happens
        modal: the auxiliary of modality in lower case, "can"; empty if there is none
        is_passive: whether the subject is acted on: "was the door closed"
        is_negated: whether it is denied
        auxiliaries: positions of all auxiliaries and negations
    """

    top: int
    form: Form
    agent: int
    asked: int
    aspect: Aspect
    modal: str
    is_passive: bool
    is_negated: bool
    auxiliaries: FrozenSet[int]

    def as_question(self) -> "ClauseFeatures":
        """Return the features of the clause as one that is asked, whatever its order: "tell me whether *it is on*"."""
        return replace(self, form=Form.OPEN if self.asked else Form.POLAR)


def top_among(tree: DependencyTree, positions: Sequence[int]) -> int:
    """Return the position of the verb or predicate of some words; 0 if they are no clause."""
    words = frozenset(positions)
    tops = [index for index in positions if tree.word(index).head not in words and tree.word(index).upos != "PUNCT"]
    return tops[0] if len(tops) == 1 else 0


def features_among(tree: DependencyTree, positions: Sequence[int]) -> Optional[ClauseFeatures]:
    """Return the features of the clause that some words are, in order; None if they are no clause."""
    top = top_among(tree, positions)
    return features_of(tree, top) if top else None


def features_of(tree: DependencyTree, top: int) -> ClauseFeatures:
    """Return the features of the clause of a verb or predicate.

    Args:
        tree: the sentence
        top: position of the verb, which its auxiliaries hang on
    """
    children = children_of_clause(tree, top)
    helping = [child for child in children if child.deprel.split(":")[0] in ("aux", "cop")]
    # "Is it open or not" denies nothing.
    denying = [child for child in children if child.said in _NEGATIONS and child.deprel != "conj"]
    subject = next((child for child in children if child.deprel.startswith("nsubj")), None)
    is_passive = any(child.deprel == "aux:pass" for child in helping) or (
        subject is not None and subject.deprel == "nsubj:pass"
    )
    asked = _question_word(tree, top)
    # "Is there a mug": the verb itself stands before its subject; in "there is a mug", "there" stands before it.
    is_said = any(child.deprel == "expl" and child.index < top for child in children)
    verbs = [*helping, tree.word(top)] if tree.word(top).lemma.lower() == "be" and not is_said else helping
    is_inverted = any(subject is not None and child.index < subject.index for child in verbs)
    is_asked = asked is not None and (
        is_inverted or (subject is not None and asked.index in tree.subtree(subject.index))
    )
    modal = next((child.said for child in helping if child.xpos == "MD"), "")
    return ClauseFeatures(
        top=top,
        form=Form.OPEN if is_asked else Form.POLAR if is_inverted else Form.PLAIN,
        agent=_agent(tree, top, subject, is_passive),
        asked=asked.index if asked is not None else 0,
        aspect=_aspect(tree.word(top), helping, children),
        modal=modal,
        is_passive=is_passive,
        is_negated=bool(denying),
        auxiliaries=frozenset(child.index for child in [*helping, *denying]),
    )


def children_of_clause(tree: DependencyTree, top: int) -> Tuple[Word, ...]:
    """Return what hangs on a verb or predicate.

    The parser hangs the subject of "is the lamp on in the hall" on the hall.
    """
    children = tree.children(top)
    if any(child.deprel.startswith("nsubj") for child in children):
        return children
    places = [child for child in children if child.deprel in ("obl", "obl:unmarked")]
    below = [inner for place in places for inner in tree.children(place.index)]
    return (*children, *(inner for inner in below if inner.deprel == "cop" or inner.deprel.startswith("nsubj")))


def _question_word(tree: DependencyTree, top: int) -> Optional[Word]:
    """Return the first question word of a clause that is in no clause inside it."""
    for index in sorted(tree.subtree(top)):
        word = tree.word(index)
        # "Show me *where* the bathroom is" says a place.
        if word.said not in _ASKING or word.deprel == "case":
            continue
        above: List[Word] = []
        while word.index != top:
            above.append(word)
            word = tree.governor(word)
        if not any(one.deprel.split(":")[0] in _INNER for one in above):
            return tree.word(index)
    return None


def _agent(tree: DependencyTree, top: int, subject: Optional[Word], is_passive: bool) -> int:
    if not is_passive:
        return subject.index if subject is not None else 0
    for child in tree.children(top):
        cases = {case.said for case in tree.prepositions(child.index)}
        if child.deprel == "obl:agent" or (child.deprel == "obl" and cases == {"by"}):
            return child.index
    return 0


def _aspect(verb: Word, helping: List[Word], children: Tuple[Word, ...]) -> Aspect:
    forms = [child.said for child in helping]
    lemmas = [child.lemma.lower() for child in helping]
    if any(child.xpos == "VBG" for child in helping):
        return Aspect.RUNNING  # "The door is being closed."
    is_past = any(child.xpos == "VBD" for child in helping[:1]) or (not helping and verb.xpos in ("VBD", "VBN"))
    if "have" in lemmas or _HAVE.intersection(forms):
        is_ever = any(child.said == "ever" for child in children)
        return Aspect.EVER_DONE if is_ever else Aspect.DONE
    if is_past or "did" in forms:
        return Aspect.DONE
    if _FUTURE.intersection(forms):
        return Aspect.PLANNED
    is_going_on = verb.xpos == "VBG" and bool(_BE.intersection(forms) or "be" in lemmas)
    return Aspect.RUNNING if is_going_on else Aspect.PRESENT
