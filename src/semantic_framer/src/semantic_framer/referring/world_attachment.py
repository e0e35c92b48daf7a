"""Decides by the world which of the places behind a noun tell which thing is meant, and which say where it shall be:
"take the box near the lamp on the table".
"""

from dataclasses import dataclass
from typing import FrozenSet, List, Optional, Sequence, Tuple

from referring_expressions import Situation, fitting
from referring_expressions.fitting import at_place
from semantic_framer.units.frame_roles import GOAL
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.dialogue import Context
from semantic_framer.values.outcome import Question
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from typed_arguments import TypedArgument
from utterance_passes.phrases.clauses import find_clauses
from utterance_passes.trees.tree import NOUNS, DependencyTree
from utterance_passes.trees.tree_edits import TreeEdit
from word_classes import word_class
from world_model import Sort, WorldObject

_PLACE_PREPOSITIONS = word_class("place_prepositions") - frozenset(["of"])


@dataclass(frozen=True)
class Attached:
    """A sentence whose phrases of place are attached as the world has it.

    Attributes:
        sentence: with the phrases where they belong
        goals: heads of the phrases that say where the thing shall be; none if all phrases describe it
        unknown: the description that fits nothing known, "book near the pillow on the couch"; empty without goals
        note: what was found, for the trace
    """

    sentence: Sentence
    goals: FrozenSet[int]
    unknown: str
    note: str


@dataclass(frozen=True)
class _Phrase:
    """A phrase of place behind a noun.

    Attributes:
        head: position of its noun
        first: position of its first word
        is_clause: whether it is a relative clause, which always describes: "that is on the table"
    """

    head: int
    first: int
    is_clause: bool


def attached_by_world(sentence: Sentence, known: FramedLexicon, context: Context) -> Optional[Attached]:
    """Return a sentence with the places of an object attached by what the robot knows; None if it cannot tell.

    A phrase that is true of the thing, or of the place before it, describes it. The first phrase that is true of
    neither says where the thing shall be. A thing or a place that the robot does not know leaves all as it was.
    """
    if not known.world.objects:
        return None
    situation = known.situation(context.ids_spoken_of)
    tree = sentence.tree
    for clause in find_clauses(tree, known):
        for noun in tree.children(clause.verb):
            if noun.deprel != "obj" or noun.upos not in NOUNS:
                continue
            phrases = _phrases_behind(tree, noun.index, clause.positions)
            found = _Judging(sentence, noun.index, phrases, situation).attached(clause.verb) if phrases else None
            if found is not None:
                return found
    return None


def is_better(attached: Attached, best: Sequence[Reading], before: Sequence[Reading], known: FramedLexicon) -> bool:
    """Whether a sentence is understood better as it is attached.

    Args:
        attached: the sentence
        best: its readings, one for each clause: nothing may be missing or left over, and the goals must be said
        before: the readings of the sentence as it was: without goals, one of them must take a description for a goal
        known: lexical units and frames
    """
    if any(one.missing or one.left_over or one.wrong_types for one in best):
        return False
    if _said(best) == _said(before):
        return False
    if attached.goals:
        return attached.goals <= _goals(best, known)
    return bool(attached.sentence.described & _goals(before, known))


def _said(readings: Sequence[Reading]) -> Tuple[Tuple[str, FrozenSet[Tuple[str, str]]], ...]:
    return tuple((reading.unit.frame_name, reading.said) for reading in readings)


def _goals(readings: Sequence[Reading], known: FramedLexicon) -> FrozenSet[int]:
    """Return the heads of the goals of some readings."""
    found = set()
    for reading in readings:
        for argument in reading.arguments:
            element = known.frames[reading.unit.frame_name].element(argument.name)
            if element is not None and element.framenet == GOAL:
                found.add(argument.head_position)
    return frozenset(found)


def question_of_goal(attached: Attached) -> Question:
    """Return the question whether a place is meant as a goal."""
    sentence = attached.sentence
    goal = next(iter(attached.goals))
    where = sentence.text(sorted(sentence.subtree(goal)))
    return Question(
        "CONFIRM", f"I know of no {attached.unknown}. Do you want me to put it there: {where}? Say yes or no."
    )


def _phrases_behind(tree: DependencyTree, noun: int, inside: FrozenSet[int]) -> Tuple[_Phrase, ...]:
    """Return the phrases of place that follow a noun without a gap, in order; none for a list of nouns."""
    if any(child.deprel == "conj" for child in tree.children(noun)):
        return ()
    found: List[_Phrase] = []
    for word in tree.words[noun:]:
        cases = tree.prepositions(word.index)
        is_place = word.upos in NOUNS and cases and cases[0].said in _PLACE_PREPOSITIONS
        is_clause = word.deprel == "acl:relcl" and word.head == noun
        if is_place and word.index in inside | tree.subtree(noun):
            first = tree.phrase_start(word.index) if is_clause else cases[0].index
            found.append(_Phrase(word.index, first, is_clause))
    heads = frozenset(phrase.head for phrase in found)
    end = max(_without(tree, noun, heads))
    kept: List[_Phrase] = []
    for phrase in found:
        own = _without(tree, phrase.head, heads)
        if phrase.first != end + 1 or min(own) < phrase.first:
            break
        kept.append(phrase)
        end = max(own)
    return tuple(kept)


def _without(tree: DependencyTree, head: int, heads: FrozenSet[int]) -> FrozenSet[int]:
    """Return the words of a phrase without other phrases below it."""
    others = [tree.subtree(other) for other in heads - {head} if other in tree.subtree(head)]
    return tree.subtree(head).difference(*others)


class _Judging:
    """Judges the places behind one noun."""

    def __init__(self, sentence: Sentence, noun: int, phrases: Tuple[_Phrase, ...], situation: Situation) -> None:
        self._sentence = sentence
        self._noun = noun
        self._phrases = phrases
        self._situation = situation
        #: For each phrase, the word that it describes.
        self._of: List[int] = []

    def attached(self, verb: int) -> Optional[Attached]:
        """Return the sentence with the phrases where they belong; None if that is not known."""
        things = fitting(self._argument(self._noun), self._situation)
        if any(one.sort is Sort.PERSON for one in things):
            return None  # a person is put nowhere
        # The places so far that things are at, each with its phrase, and the things that are at all of them.
        places: List[Tuple[TypedArgument, Tuple[WorldObject, ...]]] = []
        for phrase in self._phrases if things else ():
            place = self._argument(phrase.head)
            objects = fitting(place, self._situation)
            if not objects:
                return None
            direct = at_place(things, place, self._situation)
            if direct or phrase.is_clause:
                things = direct or things
                places.append((place, objects))
                self._of.append(self._noun)
                continue
            if not places:
                return self._with_goal(verb, 0)
            before, wholes = places[-1]
            wholes = at_place(wholes, place, self._situation)
            ids = self._situation.world.at(before.relation, wholes)
            nested = tuple(one for one in things if one.id in ids)
            if not nested:
                return self._with_goal(verb, len(places))
            things = nested
            places[-1] = (before, wholes)
            places.append((place, objects))
            self._of.append(self._phrases[len(places) - 2].head)
        return self._described() if things else None

    def _argument(self, head: int) -> TypedArgument:
        heads = frozenset(phrase.head for phrase in self._phrases)
        below = self._sentence.subtree(head)
        left_out = below - _without(self._sentence.tree, head, heads)
        return self._sentence.phrases.argument("", head, left_out=left_out)

    def _described(self) -> Attached:
        edit = TreeEdit(self._sentence.tree)
        for phrase, of in zip(self._phrases, self._of):
            if not phrase.is_clause:
                edit.rehang(phrase.head, of, "nmod")
        heads = frozenset(phrase.head for phrase in self._phrases)
        sentence = self._sentence.attached(edit.tree(), described=heads)
        return Attached(sentence, frozenset(), "", f"{self._words(0)}: known there, so no goal")

    def _with_goal(self, verb: int, first: int) -> Attached:
        """Return the sentence in which the phrases from a phrase on say where the thing shall be."""
        edit = TreeEdit(self._sentence.tree)
        for phrase, of in zip(self._phrases[:first], self._of):
            if not phrase.is_clause:
                edit.rehang(phrase.head, of, "nmod")
        goal = self._phrases[first].head
        edit.rehang(goal, verb, "obl")
        for before, phrase in zip(self._phrases[first:], self._phrases[first + 1 :]):
            edit.rehang(phrase.head, before.head, "nmod")
        described = frozenset(phrase.head for phrase in self._phrases) - {goal}
        sentence = self._sentence.attached(edit.tree(), goals=frozenset([goal]), described=described)
        unknown = self._argument_in_full(first)
        return Attached(sentence, frozenset([goal]), unknown, f"{self._words(first)}: no {unknown} is known, so a goal")

    def _argument_in_full(self, last: int) -> str:
        """Return the noun with its adjectives and its places up to one of them, without its article."""
        tree = self._sentence.tree
        heads = frozenset(phrase.head for phrase in self._phrases)
        inside = set(_without(tree, self._noun, heads))
        for phrase in self._phrases[: last + 1]:
            inside |= _without(tree, phrase.head, heads)
        articles = {child.index for child in tree.children(self._noun) if child.deprel in ("det", "nmod:poss")}
        return tree.text_of(inside - articles)

    def _words(self, first: int) -> str:
        end = self._sentence.tree.phrase_end(self._phrases[-1].head)
        return self._sentence.text(list(range(self._phrases[first].first, end + 1)))
