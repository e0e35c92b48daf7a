"""The clauses of a sentence whose deeds are joined: their words, what they wait for, and how far they go."""

from dataclasses import replace
from typing import FrozenSet, List, NamedTuple, Sequence, Tuple

from semantic_framer.clauses.event_conditions import CONDITION_OF_DEED
from semantic_framer.filling.control import going_on, has_end, is_turn_assumed
from semantic_framer.linking.item_lists import has_items, items_apart
from semantic_framer.linking.link_file import LinkKind
from semantic_framer.units.frame_roles import GOAL, PATROLLING, STOPPING
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.clause_plan import PlanPart, leaves_of
from semantic_framer.values.condition_part import ConditionPart, happens
from semantic_framer.values.reading import Reading, with_argument
from semantic_framer.values.sentence import Sentence
from utterance_passes.phrases.clauses import Clause
from word_classes import word_class

#: The element of a place to keep out of.
AVOIDED = "avoided"
_CONTINUING = word_class("continuing_verbs")
#: Words between two deeds that belong to neither.
JOINING = word_class("linking_conjunctions") | {";"}
#: FrameNet's name of what only waits.
WAITING = "Waiting"
_ALL = word_class("determiners_of_all")
_HERE = word_class("here_and_there")


class NoStructure(ValueError):
    """The parts of the sentence cannot be joined."""


class Open(NoStructure):
    """The person must say how the parts of the sentence are joined; the text is the question."""


def which_of_it(words: str) -> str:
    """Return the question which deed some words belong to."""
    return f'Which deed do you mean by "{words}"? Say it first, for instance: "{words[0].upper()}{words[1:]}, ...".'


class Node(NamedTuple):
    """A node of the plan, with the positions of its words."""

    part: PlanPart
    positions: FrozenSet[int]


def ends_what_runs(readings: Sequence[Reading], known: FramedLexicon) -> bool:
    """Whether a clause ends what runs: "stop when ..."; its readings are given best first."""
    return known.frames[readings[0].unit.frame_name].framenet == STOPPING


class LinkedClauses:
    """The clauses of a sentence; conditions and items of lists are added.

    Attributes:
        readings: of each clause, best first
        positions: of the words of each clause
        firsts: the position at which each clause is said
    """

    def __init__(
        self, sentence: Sentence, known: FramedLexicon, deeds: Sequence[Tuple[Clause, Tuple[Reading, ...]]]
    ) -> None:
        self._sentence = sentence
        self._known = known
        self.readings: List[Tuple[Reading, ...]] = []
        self.positions: List[FrozenSet[int]] = []
        self.firsts: List[int] = []
        for clause, readings in deeds:
            self._add(readings, frozenset(self._content(clause.positions)))

    def _add(self, readings: Tuple[Reading, ...], positions: FrozenSet[int], said: int = 0) -> int:
        self.readings.append(readings)
        self.positions.append(positions)
        self.firsts.append(said or min(positions))
        return len(self.readings) - 1

    def _content(self, positions: FrozenSet[int]) -> List[int]:
        found = sorted(positions - self._sentence.abandoned)
        words = [self._sentence.word(index) for index in found]
        while len(words) > 1 and (words[0].deprel in ("punct", "cc") or words[0].said in JOINING):
            words.pop(0)
        while len(words) > 1 and words[-1].deprel in ("punct", "cc"):
            words.pop()
        return [word.index for word in words]

    def label(self, positions: FrozenSet[int]) -> str:
        """Return words as they were said, without the marks around them."""
        return self._sentence.text(sorted(positions)).strip(" ,;.!?")

    def stops(self, clause: int) -> bool:
        """Whether a clause ends what runs: "stop when ..."."""
        return ends_what_runs(self.readings[clause], self._known)

    def only_waits(self, clause: int) -> bool:
        """Whether a clause may only wait: "wait here until ..."."""
        return any(map(self._only_waits, self.readings[clause]))

    def _only_waits(self, reading: Reading) -> bool:
        """Whether a reading only waits: "wait here"."""
        frame = self._known.frames[reading.unit.frame_name]
        said = [argument for argument in reading.arguments if argument.positions]
        if frame.framenet != WAITING or reading.left_over or reading.extra or reading.missing:
            return False
        return all(argument.lemma.lower() in _HERE for argument in said)

    def going_on(self, part: PlanPart) -> PlanPart:
        """Return a deed that goes on until something ends it: as far as its frame allows, and again and again."""
        readings = self.readings[part.clause]
        frames = self._known.frames
        longest = [going_on(reading, frames[reading.unit.frame_name]) for reading in readings]
        made = tuple(new or old for new, old in zip(longest, readings))
        complete = tuple(reading for reading in made if not reading.missing)
        readings = self.readings[part.clause] = complete or made
        is_open = going_on(readings[0], frames[readings[0].unit.frame_name]) is not None
        first = min(self.positions[part.clause])
        is_kept_up = first > 1 and self._sentence.word(first - 1).said in _CONTINUING
        if is_open or (is_kept_up and not has_end(readings[0], frames[readings[0].unit.frame_name])):
            return PlanPart("REPEAT", part.label, (part,))
        return part

    def items(self, node: Node) -> List[Node]:
        """Return a node for each item of the list of a deed; the node itself if there is none."""
        place = node.part.clause
        items = items_apart(self._sentence, self.readings[place], self.positions[place])
        found: List[Node] = []
        for readings, positions in items:
            clause = self._add(readings, positions, max(positions))
            part = replace(node.part, label=readings[0].clause_text, clause=clause)
            found.append(Node(part, positions))
        return found or [node]

    def again(self, node: Node) -> Node:
        """Return a node that does the deed of another one once more."""
        place = node.part.clause
        clause = self._add(self.readings[place], self.positions[place], self.firsts[place])
        return Node(replace(node.part, clause=clause), node.positions)

    def is_turn_assumed(self, clause: int) -> bool:
        """Whether a clause is a turn of which nobody said how far it goes."""
        reading = self.readings[clause][0]
        return is_turn_assumed(reading, self._known.frames[reading.unit.frame_name])

    def is_endless(self, clause: int) -> bool:
        """Whether a clause goes on until something ends it: "patrol the hall"."""
        return self._known.frames[self.readings[clause][0].unit.frame_name].framenet == PATROLLING

    def keep_out(self, node: Node, of: Node) -> None:
        """Let the robot keep out of where a deed leads while it does another one.

        Raises:
            NoStructure: no server could keep out of it
        """
        frames, place = self._known.frames, node.part.clause
        best = [self.readings[part.clause][0] for part in leaves_of(of.part)]
        goals = [reading.argument_in_role(GOAL, frames[reading.unit.frame_name]) for reading in best]
        able = [reading for reading in self.readings[place] if frames[reading.unit.frame_name].element(AVOIDED)]
        if len(goals) != 1 or goals[0] is None or goals[0].members or not able:
            raise NoStructure("what the robot cannot keep out of")
        avoided = replace(goals[0], name=AVOIDED)
        self.readings[place] = tuple(with_argument(reading, avoided) for reading in able)

    def has_items(self, clause: int) -> bool:
        """Whether a clause has a list of things or places."""
        return has_items(self.readings[clause])

    def is_of_all(self, clause: int) -> bool:
        """Whether a clause is about all things of a name: "visit *all rooms*"."""
        reading = self.readings[clause][0] if clause >= 0 else None
        return reading is not None and any(one.quantifier in _ALL for one in reading.arguments)

    def happens(self, condition: ConditionPart) -> bool:
        """Whether a condition happens in a moment, so that "if" means when: "if the door opens"."""
        return happens(condition, self._sentence.tree, self._known.frames)

    def is_new_deed(self, condition: ConditionPart, first: int) -> bool:
        """Whether a condition is that the robot has done something which nobody told it to do in the words before it.

        Args:
            condition: the condition
            first: position of the first word of its link
        """
        if condition.reading is None or condition.reading.unit.frame_name != CONDITION_OF_DEED:
            return False
        words = [self._sentence.word(index) for index in sorted(condition.positions)]
        said = {word.lemma.lower() for word in self._sentence.tree.words[: first - 1]}
        return not any(word.upos == "VERB" and word.lemma.lower() in said for word in words)

    def condition(self, of: ConditionPart, is_opposite: bool, kind: LinkKind) -> PlanPart:
        """Return the node of a condition.

        Raises:
            NoStructure: it must begin to hold, where its link wants it to hold
        """
        is_anew = kind is LinkKind.ANEW or of.is_anew or any(child.is_anew for child in of.children)
        if is_anew and kind not in (LinkKind.ANEW, LinkKind.WHEN, LinkKind.UNTIL, LinkKind.WHENEVER):
            raise NoStructure("a condition that begins, where it must hold")
        part = self._condition_part(of)
        trigger = "BEGINS" if is_anew and kind is not LinkKind.WHENEVER else "HOLDS"
        return replace(part, trigger=trigger, is_negated=part.is_negated != is_opposite)

    def _condition_part(self, of: ConditionPart, words: str = "") -> PlanPart:
        label = words or of.words or self.label(of.positions)
        if of.reading is None:
            children = tuple(self._condition_part(child, of.words) for child in of.children)
            return PlanPart(of.kind, label, children, is_negated=of.is_negated)
        clause = self._add((replace(of.reading, clause_text=label),), of.positions)
        return PlanPart("CONDITION", label, is_negated=of.is_negated, clause=clause)
