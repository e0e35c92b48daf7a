"""Makes the tree of a sentence whose deeds are joined by conditions, times and joiners.

A link at the front ("if the door is open, ...") reaches to the end of its sentence, or to "otherwise". A link behind a
deed belongs to that deed alone; where it could belong to the deed before as well, the person is asked.
"""

from dataclasses import dataclass, replace
from typing import FrozenSet, List, Mapping, NamedTuple, Optional, Sequence, Tuple

from phrase_meanings.arguments import resolved
from semantic_framer.clause_links import Joint
from semantic_framer.clause_plan import Clauses, PlanPart, part_of
from semantic_framer.conditions import ConditionPart
from semantic_framer.control import going_on
from semantic_framer.framed_lexicon import FramedLexicon
from semantic_framer.link_file import LinkKind
from semantic_framer.reading import Reading
from semantic_framer.sentence import Sentence
from semantic_framer.standing_plan import NotAlone, with_orders_at_the_root
from semantic_frames.frame import SemanticFrame
from typed_arguments import TimeExpression, TypedArgument
from utterance_passes.clauses import Clause
from word_classes import word_class

_CONTINUING = word_class("continuing_verbs")
_JOINING = word_class("linking_conjunctions") | {";"}
_SENTENCE_ENDS = frozenset([".", "!", "?", ";", "..."])
_JOINERS = (LinkKind.OTHERWISE, LinkKind.OR_ELSE, LinkKind.MEANWHILE)
#: Links that decide whether or when something begins. Behind several deeds, it is open to which of them they belong.
_BEGINNING = (
    LinkKind.IF,
    LinkKind.UNLESS,
    LinkKind.WHEN,
    LinkKind.ANEW,
    LinkKind.WHENEVER,
    LinkKind.DELAY,
    LinkKind.CLOCK,
)
#: FrameNet's name of what only waits.
_WAITING = "Waiting"
#: FrameNet's semantic type of persons.
_PERSON = "Human"
_PERSONS = word_class("persons_of_the_sentence")
_NO_NAMES = _PERSONS | word_class("participants") | word_class("pronouns")
_HERE = word_class("place_adverbs_of_waiting")


class NoStructure(ValueError):
    """The parts of the sentence cannot be joined."""


class Open(NoStructure):
    """The person must say how the parts of the sentence are joined; the text is the question."""


@dataclass(frozen=True)
class _Unit:
    """A deed, or words that join, in the order of the sentence.

    Attributes:
        first, last: its first and its last position
        joint: the words that join; None for a deed
        clause: position of the deed among the clauses; -1 for words that join
        before: words and marks between this unit and the one before
    """

    first: int
    last: int
    joint: Optional[Joint] = None
    clause: int = -1
    before: FrozenSet[str] = frozenset()

    @property
    def kind(self) -> Optional[LinkKind]:
        return self.joint.kind if self.joint is not None else None

    @property
    def is_link(self) -> bool:
        """Whether it stands before a condition or is a time."""
        return self.joint is not None and self.joint.kind not in _JOINERS

    @property
    def begins_sentence(self) -> bool:
        return bool(self.before & _SENTENCE_ENDS)


class _Node(NamedTuple):
    part: PlanPart
    positions: FrozenSet[int]


def linked_plan(
    sentence: Sentence,
    known: FramedLexicon,
    deeds: Sequence[Tuple[Clause, Tuple[Reading, ...]]],
    joints: Sequence[Joint],
) -> Tuple[Clauses, PlanPart]:
    """Return the clauses of a sentence, deeds and conditions, in the order in which they were said, and their tree.

    Args:
        sentence: the whole sentence
        known: lexical units and frames
        deeds: each clause that asks for something, with its readings, best first
        joints: what joins them
    Raises:
        Open: the person must say how the parts are joined
        NoStructure: they cannot be joined
    """
    return _Builder(sentence, known, deeds, joints).build()


class _Builder:
    def __init__(
        self,
        sentence: Sentence,
        known: FramedLexicon,
        deeds: Sequence[Tuple[Clause, Tuple[Reading, ...]]],
        joints: Sequence[Joint],
    ) -> None:
        self._sentence = sentence
        self._known = known
        if any(joint.kind is LinkKind.THEN and joint.limit_s for joint in joints):
            raise NoStructure("a longest time belongs to nothing that waits")
        self._positions: List[FrozenSet[int]] = []
        self._clauses: List[Tuple[Reading, ...]] = []
        self._firsts: List[int] = []
        for clause, readings in deeds:
            self._positions.append(frozenset(self._content(clause.positions)))
            self._clauses.append(readings)
            self._firsts.append(min(self._positions[-1]))
        self._units = self._in_order(joints)
        self._place = 0

    def _content(self, positions: FrozenSet[int]) -> List[int]:
        found = sorted(positions - self._sentence.abandoned)
        words = [self._sentence.word(index) for index in found]
        while len(words) > 1 and (words[0].deprel in ("punct", "cc") or words[0].form.lower() in _JOINING):
            words.pop(0)
        while len(words) > 1 and words[-1].deprel in ("punct", "cc"):
            words.pop()
        return [word.index for word in words]

    def _in_order(self, joints: Sequence[Joint]) -> List[_Unit]:
        units = [_Unit(min(positions), max(positions), clause=place) for place, positions in enumerate(self._positions)]
        units += [
            _Unit(joint.first, max(joint.positions), joint) for joint in joints if joint.kind is not LinkKind.THEN
        ]
        units.sort(key=lambda unit: unit.first)
        taken = frozenset().union(*self._positions, *(unit.joint.positions for unit in units if unit.joint))
        then = frozenset().union(*(joint.positions for joint in joints if joint.kind is LinkKind.THEN))
        found: List[_Unit] = []
        for unit in units:
            between = range(found[-1].first if found else 1, unit.first)
            before = {self._sentence.word(index).form.lower() for index in between if index not in taken}
            if then.intersection(between):
                before.add("then")
            found.append(replace(unit, before=frozenset(before)))
        return found

    def build(self) -> Tuple[Clauses, PlanPart]:
        nodes: List[_Node] = []
        while self._place < len(self._units):
            nodes.append(self._statement())
        try:
            plan = with_orders_at_the_root(self._sequence(nodes).part)
        except NotAlone as words:
            raise Open(f'I can keep only one order at a time. Say it alone: "{words}".') from words
        order = sorted(range(len(self._clauses)), key=lambda place: self._firsts[place])
        return tuple(self._clauses[place] for place in order), _with_places(plan, order)

    @property
    def _now(self) -> Optional[_Unit]:
        return self._units[self._place] if self._place < len(self._units) else None

    def _take(self) -> _Unit:
        unit = self._units[self._place]
        self._place += 1
        return unit

    def _is_now(self, kind: LinkKind) -> bool:
        return self._now is not None and self._now.kind is kind

    def _statement(self) -> _Node:
        """Read a link at the front with what it joins, or a deed."""
        unit = self._now
        if unit is None or unit.kind in _JOINERS:
            raise NoStructure("nothing stands before words that join")
        if not unit.is_link:
            return self._deed(is_conditional=False)
        links = [self._take()]
        while self._now is not None and self._now.is_link and not self._now.before & _JOINING:
            links.append(self._take())
        body = self._scope(is_conditional=True)
        if not body:
            words = self._sentence.text(sorted(links[-1].joint.positions if links[-1].joint else ()))
            raise Open(f"What should I do {words[0].lower()}{words[1:]}?")
        otherwise = self._otherwise(links[-1])
        node = self._joined(links[-1], body, otherwise)
        for link in reversed(links[:-1]):
            node = self._joined(link, [node], [])
        return node

    def _otherwise(self, link: _Unit) -> List[_Node]:
        """Read what is to be done if the condition of a link does not hold."""
        if not self._is_now(LinkKind.OTHERWISE) and not self._is_now(LinkKind.OR_ELSE):
            return []
        if link.kind not in (LinkKind.IF, LinkKind.UNLESS):
            raise NoStructure("otherwise, without an if")
        self._take()
        other = self._now
        if other is not None and other.is_link:
            return [self._statement()]
        found = self._scope(is_conditional=True)
        if not found:
            raise Open("What should I do otherwise?")
        return found

    def _scope(self, *, is_conditional: bool) -> List[_Node]:
        found: List[_Node] = []
        while self._now is not None and self._now.joint is None and not (found and self._now.begins_sentence):
            found.append(self._deed(is_conditional=is_conditional))
        return found

    def _deed(self, *, is_conditional: bool) -> _Node:
        """Read a deed with the links behind it."""
        unit = self._take()
        node = _Node(part_of(self._clauses[unit.clause][0], unit.clause), self._positions[unit.clause])
        while self._now is not None and self._now.is_link and self._is_behind():
            link = self._take()
            self._must_belong_to(unit, link)
            if self._is_now(LinkKind.OTHERWISE) and link.kind in (LinkKind.IF, LinkKind.UNLESS):
                node = self._joined(link, [node], self._otherwise(link))
            else:
                node = self._joined(link, [node], [])
        if self._is_now(LinkKind.MEANWHILE):
            node = self._meanwhile(node)
        if self._is_now(LinkKind.OR_ELSE) and not is_conditional:
            self._take()
            node = self._several("FALLBACK", [node, self._next_deed()])
        elif self._is_now(LinkKind.OTHERWISE) and not is_conditional:
            raise NoStructure("otherwise, without an if")
        return node

    def _next_deed(self) -> _Node:
        if self._now is None or self._now.joint is not None:
            raise NoStructure("nothing stands behind words that join")
        return self._deed(is_conditional=False)

    def _meanwhile(self, node: _Node) -> _Node:
        joint = self._take()
        if self._now is None:
            # "Go to the kitchen and tell me a joke meanwhile": the deed before is already read.
            raise NoStructure("meanwhile at the end")
        if joint.begins_sentence:
            raise NoStructure("meanwhile begins a sentence")
        return self._several("PARALLEL", [node, self._next_deed()])

    def _is_behind(self) -> bool:
        """Whether the next unit, a link, belongs to the deed before it."""
        link = self._units[self._place]
        following = self._units[self._place + 1] if self._place + 1 < len(self._units) else None
        is_last = following is None or following.begins_sentence or following.kind in _JOINERS
        if link.begins_sentence:
            return False
        if link.before & _JOINING:
            if is_last:
                raise NoStructure("a link stands behind a conjunction, and joins nothing")
            return False
        if is_last or (following is not None and (following.is_link or following.before & _JOINING)):
            return True
        if link.kind in (LinkKind.UNTIL, LinkKind.WHILE, LinkKind.PERIOD):
            return True
        raise Open(self._which(link))

    def _which(self, link: _Unit) -> str:
        words = self._sentence.text(sorted(link.joint.positions)) if link.joint else ""
        return (
            f'Which of it do you mean by "{words}"? Say it first, for instance: "{words[0].upper()}{words[1:]}, ...".'
        )

    def _must_belong_to(self, deed: _Unit, link: _Unit) -> None:
        """Ask if a link could belong to the deed before as well: "go to the hall and open the window if it is hot"."""
        place = self._units.index(deed)
        before = self._units[place - 1] if place else None
        is_joined = before is not None and before.joint is None and not deed.begins_sentence
        if is_joined and link.kind in _BEGINNING and "then" not in deed.before:
            raise Open(self._which(link))

    # --- nodes

    def _joined(self, unit: _Unit, body: List[_Node], otherwise: List[_Node]) -> _Node:
        """Return the node of a link with what it joins."""
        joint = unit.joint
        if joint is None:
            raise NoStructure("no link")
        positions = joint.positions.union(*(node.positions for node in body + otherwise))
        label = self._label(positions)
        child = self._sequence(body)
        if joint.kind is LinkKind.DELAY:
            when = TimeExpression("time", self._label(joint.positions), "in", offset_s=joint.seconds)
            return _Node(PlanPart("AT", label, (child.part,), when=when), positions)
        if joint.kind is LinkKind.CLOCK:
            return _Node(PlanPart("AT", label, (child.part,), when=joint.when), positions)
        if joint.kind is LinkKind.PERIOD:
            if child.part.kind in ("UNTIL", "WHILE") and not child.part.duration_s:
                # "Every ten seconds say hello until ...": the end is that of the repetition.
                until, deed = child.part, child.part.children[-1]
                again = PlanPart("REPEAT", deed.label, (deed,), period_s=joint.seconds)
                if deed.kind == "DO":
                    return _Node(replace(until, label=label, children=(until.children[0], again)), positions)
            if child.part.kind in ("REPEAT", "WAIT", "UNTIL", "WHILE"):
                raise NoStructure("two ways to repeat")
            when = TimeExpression("set", self._label(joint.positions), "every", period_s=joint.seconds)
            return _Node(PlanPart("AT", label, (child.part,), when=when), positions)
        if joint.condition is None:
            raise NoStructure("a link without a condition")
        if joint.limit_s and joint.kind not in (LinkKind.UNTIL, LinkKind.WHEN, LinkKind.ANEW):
            raise NoStructure("a longest time for what does not wait")
        is_opposite = joint.kind is LinkKind.UNLESS
        condition = self._condition(joint.condition, is_opposite, joint.kind)
        if joint.kind in (LinkKind.IF, LinkKind.UNLESS):
            parts = (condition, child.part) + ((self._sequence(otherwise).part,) if otherwise else ())
            return _Node(PlanPart("IF", label, parts), positions)
        if joint.kind is LinkKind.WHENEVER:
            return _Node(PlanPart("WHENEVER", label, (condition, child.part)), positions)
        if joint.kind in (LinkKind.WHEN, LinkKind.ANEW):
            wait = PlanPart("WAIT", self._label(joint.positions), (condition,), limit_s=joint.limit_s)
            return self._sequence([_Node(wait, joint.positions), *body])
        return self._ended(joint, body, condition, _Node(child.part, positions))

    def _ended(self, joint: Joint, body: List[_Node], condition: PlanPart, whole: _Node) -> _Node:
        """Return what a condition ends: "follow me until ...", "wait until ..."."""
        label = self._label(whole.positions)
        is_until = joint.kind is LinkKind.UNTIL
        if (
            len(body) == 1
            and body[0].part.kind == "DO"
            and any(map(self._only_waits, self._clauses[body[0].part.clause]))
        ):
            held = condition if is_until else replace(condition, is_negated=not condition.is_negated)
            return _Node(PlanPart("WAIT", label, (held,), limit_s=joint.limit_s), whole.positions)
        last = body[-1].part
        if last.kind == "DO":
            last = self._going_on(last)
        parts = [node.part for node in body[:-1]] + [last]
        child = parts[0] if len(parts) == 1 else replace(whole.part, children=tuple(parts))
        if is_until:
            return _Node(PlanPart("UNTIL", label, (condition, child), limit_s=joint.limit_s), whole.positions)
        return _Node(PlanPart("WHILE", label, (condition, child)), whole.positions)

    def _only_waits(self, reading: Reading) -> bool:
        frame = self._known.frames[reading.unit.frame_name]
        said = [argument for argument in reading.arguments if argument.positions]
        if frame.framenet != _WAITING or reading.left_over or reading.extra or reading.missing:
            return False
        return all(argument.text.lower() in _HERE for argument in said)

    def _going_on(self, part: PlanPart) -> PlanPart:
        """Return a deed that goes on until something ends it: as far as its frame allows, and again and again."""
        readings = self._clauses[part.clause]
        frames = self._known.frames
        longest = [going_on(reading, frames[reading.unit.frame_name]) for reading in readings]
        made = tuple(new or old for new, old in zip(longest, readings))
        complete = tuple(reading for reading in made if not reading.missing)
        readings = self._clauses[part.clause] = complete or made
        is_open = going_on(readings[0], frames[readings[0].unit.frame_name]) is not None
        first = min(self._positions[part.clause])
        is_kept_up = first > 1 and self._sentence.word(first - 1).form.lower() in _CONTINUING
        if is_kept_up or is_open:
            return PlanPart("REPEAT", part.label, (part,))
        return part

    def _condition(self, of: ConditionPart, is_opposite: bool, kind: LinkKind) -> PlanPart:
        is_anew = kind is LinkKind.ANEW or of.is_anew or any(child.is_anew for child in of.children)
        if is_anew and kind not in (LinkKind.ANEW, LinkKind.WHEN, LinkKind.UNTIL, LinkKind.WHENEVER):
            raise NoStructure("a condition that begins, where it must hold")
        part = self._condition_part(of)
        trigger = "BEGINS" if is_anew and kind is not LinkKind.WHENEVER else "HOLDS"
        return replace(part, trigger=trigger, is_negated=part.is_negated != is_opposite)

    def _condition_part(self, of: ConditionPart) -> PlanPart:
        label = self._label(of.positions)
        if of.reading is None:
            children = tuple(self._condition_part(child) for child in of.children)
            return PlanPart(of.kind, label, children, is_negated=of.is_negated)
        self._clauses.append((replace(of.reading, clause_text=label),))
        self._firsts.append(min(of.positions))
        return PlanPart("CONDITION", label, is_negated=of.is_negated, clause=len(self._clauses) - 1)

    def _sequence(self, nodes: Sequence[_Node]) -> _Node:
        if len(nodes) == 1:
            return nodes[0]
        return self._several("SEQUENCE", nodes)

    def _several(self, kind: str, nodes: Sequence[_Node]) -> _Node:
        positions = frozenset().union(*(node.positions for node in nodes))
        parts: List[PlanPart] = []
        for node in nodes:
            is_same = node.part.kind == kind and not node.part.limit_s
            parts += node.part.children if is_same else (node.part,)
        return _Node(PlanPart(kind, self._label(positions), tuple(parts)), positions)

    def _label(self, positions: FrozenSet[int]) -> str:
        return self._sentence.text(sorted(positions)).strip(" ,;.!?")


def _with_places(part: PlanPart, order: Sequence[int]) -> PlanPart:
    """Return a tree with the new places of its clauses."""
    children = tuple(_with_places(child, order) for child in part.children)
    return replace(part, children=children, clause=order.index(part.clause) if part.clause >= 0 else -1)


def with_persons(clauses: Clauses, frames: Mapping[str, SemanticFrame]) -> Clauses:
    """Return clauses in which "she" and "him" are the person who was named last: "follow Anna until she sits down".

    Raises:
        Open: a condition is about a person who was not named
    """
    named: Optional[TypedArgument] = None
    done: List[Tuple[Reading, ...]] = []
    for readings in clauses:
        is_condition = frames[readings[0].unit.frame_name].is_condition
        made: List[Reading] = []
        for reading in readings:
            arguments: List[TypedArgument] = []
            for argument in reading.arguments:
                if argument.text.lower() in _PERSONS and named is not None:
                    argument = resolved(argument, named.text)
                elif argument.text.lower() in _PERSONS and is_condition:
                    raise Open(f'Whom do you mean by "{argument.text}"?')
                arguments.append(argument)
            made.append(replace(reading, arguments=tuple(arguments)))
        done.append(tuple(made))
        persons = [argument for argument in made[0].arguments if argument.semantic_type == _PERSON]
        named = next((one for one in persons if one.text.lower() not in _NO_NAMES), named)
    return tuple(done)
