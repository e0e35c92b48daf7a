"""Makes the tree of a sentence whose deeds are joined by conditions, times and joiners.

A link at the front ("if the door is open, ...") reaches to the end of its sentence, or to "otherwise". A link behind a
deed belongs to that deed alone; where it could belong to the deed before as well, the person is asked.
"""

from dataclasses import dataclass, replace
from typing import FrozenSet, List, Optional, Sequence, Tuple

from semantic_framer.linking.deed_orders import ItemOrder, sorted_by
from semantic_framer.linking.joints import SENTENCE_ENDS, Joint
from semantic_framer.linking.link_file import LinkKind
from semantic_framer.linking.linked_clauses import JOINING, LinkedClauses, Node, NoStructure, Open, which_of_it
from semantic_framer.linking.plan_nodes import COUNTS, ORDERS, PlanNodes
from semantic_framer.linking.standing_plan import NotAlone, with_orders_at_the_root
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.clause_plan import Clauses, PlanPart, part_of
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from utterance_passes.phrases.clauses import Clause

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
    LinkKind.AFTER,
)
#: Words that are no unit of their own.
_WITHOUT_UNIT = (LinkKind.THEN, LinkKind.BEFOREHAND, LinkKind.IN_ORDER, LinkKind.NOT_BEFORE)


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
        return bool(self.before & SENTENCE_ENDS)


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
        if any(joint.kind is LinkKind.THEN and joint.limit_s for joint in joints):
            raise NoStructure("a longest time belongs to nothing that waits")
        if len(deeds) < 2 and any(joint.kind is LinkKind.THEN and joint.condition is None for joint in joints):
            # "Make sure that the door is closed before you go": the second deed is read as a part of the first.
            raise NoStructure("words that join stand inside one deed")
        kinds = {joint.kind for joint in joints}
        if LinkKind.AT_A_TIME in kinds and not kinds & {LinkKind.UNTIL, LinkKind.WHILE}:
            raise Open('How often? Say it with "until", for instance: "until the table is empty".')
        self._orders: List[ItemOrder] = [joint.order for joint in joints if joint.order is not None]
        #: Prohibitions before the deed that ends them.
        self._fronts = [joint for joint in joints if joint.is_kept_out and joint.kind is LinkKind.THEN]
        self._table = LinkedClauses(sentence, known, deeds)
        self._nodes = PlanNodes(self._table)
        self._units = self._in_order(joints)
        self._place = 0

    def _in_order(self, joints: Sequence[Joint]) -> List[_Unit]:
        said = enumerate(self._table.positions)
        units = [_Unit(min(positions), max(positions), clause=place) for place, positions in said]
        units += [
            _Unit(joint.first, max(joint.positions), joint) for joint in joints if joint.kind not in _WITHOUT_UNIT
        ]
        units.sort(key=lambda unit: unit.first)
        taken = frozenset().union(*self._table.positions, *(unit.joint.positions for unit in units if unit.joint))
        then = frozenset().union(*(joint.positions for joint in joints if joint.kind is LinkKind.THEN))
        found: List[_Unit] = []
        for unit in units:
            between = range(found[-1].first if found else 1, unit.first)
            before = {self._sentence.word(index).said for index in between if index not in taken}
            if then.intersection(between):
                before.add("then")
            found.append(replace(unit, before=frozenset(before)))
        return found

    def build(self) -> Tuple[Clauses, PlanPart]:
        nodes: List[Node] = []
        while self._place < len(self._units):
            if nodes and self._is_now(LinkKind.BEFORE_THAT):
                nodes = [self._before_those(nodes)]
            elif nodes and (self._is_now(LinkKind.ROUND) or self._is_now(LinkKind.FOREVER)):
                self._take()
                nodes = [self._nodes.again_and_again(nodes)]
            elif nodes and self._now is not None and self._now.kind in ORDERS:
                nodes = [self._nodes.ordered(self._take().kind, nodes)]
            else:
                nodes.append(self._statement())
        if self._orders:
            raise NoStructure("an order of what is in no list")
        _keep_out(self._table, self._fronts, nodes)
        try:
            plan = with_orders_at_the_root(self._nodes.sequence(nodes).part)
        except NotAlone as words:
            raise Open(f'I can keep only one order at a time. Say it alone: "{words}".') from words
        order = sorted(range(len(self._table.readings)), key=lambda place: self._table.firsts[place])
        return tuple(self._table.readings[place] for place in order), _with_places(plan, order)

    @property
    def _now(self) -> Optional[_Unit]:
        return self._units[self._place] if self._place < len(self._units) else None

    def _take(self) -> _Unit:
        unit = self._units[self._place]
        self._place += 1
        return unit

    def _is_now(self, kind: LinkKind) -> bool:
        return self._now is not None and self._now.kind is kind

    def _before_those(self, nodes: List[Node]) -> Node:
        """Read words that put a deed before all others: "..., *but first* go to the hall", "... *before that*"."""
        self._take()
        if self._now is not None and self._now.joint is None:
            return self._nodes.sequence([*self._scope(is_conditional=False), *nodes])
        if len(nodes) < 2:
            raise NoStructure("an order of one deed")
        return self._nodes.sequence([nodes[-1], *nodes[:-1]])

    def _statement(self) -> Node:
        """Read a link at the front with what it joins, or a deed."""
        unit = self._now
        if unit is None or unit.kind in _JOINERS:
            raise NoStructure("nothing stands before words that join")
        if not unit.is_link:
            return self._deed(is_conditional=False)
        if unit.kind is LinkKind.BEFORE:
            return self._before()
        links = [self._take()]
        while self._now is not None and self._now.is_link and not self._now.before & JOINING:
            links.append(self._take())
        links = _with_delays_outside(links)
        body = self._scope(is_conditional=True)
        if not body:
            words = self._sentence.text(sorted(links[-1].joint.positions if links[-1].joint else ()))
            raise Open(f"What should I do {words[0].lower()}{words[1:]}?")
        otherwise = self._otherwise(links[-1])
        node = self._joined(links[-1], body, otherwise)
        for link in reversed(links[:-1]):
            node = self._joined(link, [node])
        return node

    def _before(self) -> Node:
        """Read a deed that follows those behind it: "*before you go to the kitchen*, close the door"."""
        self._take()
        last, body = [self._next_deed()], []  # type: List[Node], List[Node]
        while self._now is not None and self._now.joint is None and "," not in self._now.before:
            last.append(self._next_deed())
        if self._now is not None and self._now.joint is None:
            body = self._scope(is_conditional=True)
        if not body and len(last) == 2:
            body = [last.pop()]
        if not body:
            raise Open(f"What should I do before I do this: {self._table.label(self._nodes.sequence(last).positions)}?")
        return self._nodes.sequence(body + last)

    def _otherwise(self, link: _Unit) -> List[Node]:
        """Read what is to be done if the condition of a link does not hold."""
        if not self._is_now(LinkKind.OTHERWISE) and not self._is_now(LinkKind.OR_ELSE):
            return []
        if link.kind not in (LinkKind.IF, LinkKind.UNLESS):
            raise NoStructure("otherwise, without an if")
        joiner = self._take()
        other = self._now
        if other is not None and other.is_link:
            return [_led_by(joiner, self._statement())]
        found = self._scope(is_conditional=True)
        if not found:
            raise Open("What should I do otherwise?")
        return [_led_by(joiner, found[0]), *found[1:]]

    def _scope(self, *, is_conditional: bool) -> List[Node]:
        found: List[Node] = []
        while self._now is not None and self._now.joint is None and not (found and self._now.begins_sentence):
            found.append(self._deed(is_conditional=is_conditional))
        return found

    def _deed(self, *, is_conditional: bool) -> Node:
        """Read a deed with the links behind it."""
        unit = self._take()
        node = Node(part_of(self._table.readings[unit.clause][0], unit.clause), self._table.positions[unit.clause])
        listed = node
        node = self._sorted(listed)
        while self._now is not None and self._now.is_link and self._is_behind():
            link = self._take()
            self._must_belong_to(unit, link)
            if link.kind in ORDERS and (node is listed or link.kind is not LinkKind.ANY_ORDER):
                node = self._nodes.ordered(link.kind, [node])
            elif link.kind in ORDERS:
                continue  # "The hall first, then the others in any order": the order in which they were said is one.
            elif link.kind is LinkKind.AFTER:
                first = self._next_deed()
                if link.joint is not None and link.joint.is_kept_out:
                    self._table.keep_out(first, node)
                node = self._nodes.sequence([first, node])
            elif self._is_now(LinkKind.OTHERWISE) and link.kind in (LinkKind.IF, LinkKind.UNLESS):
                node = self._joined(link, [node], self._otherwise(link))
            else:
                node = self._joined(link, [node])
        if self._is_now(LinkKind.MEANWHILE):
            node = self._meanwhile(node)
        if self._is_now(LinkKind.OR_ELSE) and not is_conditional:
            joiner = self._take()
            node = self._nodes.several("FALLBACK", [node, _led_by(joiner, self._next_deed())])
        elif self._is_now(LinkKind.OTHERWISE) and not is_conditional:
            raise NoStructure("otherwise, without an if")
        return node

    def _sorted(self, node: Node) -> Node:
        """Return a deed with the items of its list in the order that was said: "but not the hall before the office"."""
        if not self._orders or node.part.kind != "DO":
            return node
        items = self._table.items(node)
        names = [frozenset(self._sentence.word(index).said for index in item.positions) for item in items]
        order = sorted_by(names, self._orders)
        if order is None or len(items) < 2:
            return node
        self._orders = []
        return self._nodes.sequence([items[place] for place in order])

    def _next_deed(self) -> Node:
        if self._now is None or self._now.joint is not None:
            raise NoStructure("nothing stands behind words that join")
        return self._deed(is_conditional=False)

    def _meanwhile(self, node: Node) -> Node:
        joint = self._take()
        if self._now is None:
            # "Go to the kitchen and tell me a joke meanwhile": the deed before is already read.
            raise NoStructure("meanwhile at the end")
        if joint.begins_sentence:
            raise NoStructure("meanwhile begins a sentence")
        return self._nodes.several("PARALLEL", [node, _led_by(joint, self._next_deed())])

    def _is_behind(self) -> bool:
        """Whether the next unit, a link, belongs to the deed before it."""
        link = self._units[self._place]
        following = self._units[self._place + 1] if self._place + 1 < len(self._units) else None
        is_last = following is None or following.begins_sentence or following.kind in _JOINERS
        if link.begins_sentence or link.kind in (LinkKind.BEFORE_THAT, LinkKind.ROUND):
            return False
        if link.kind in ORDERS:
            before = self._units[self._place - 1]
            return before.joint is None and (
                self._table.has_items(before.clause) or self._table.is_of_all(before.clause)
            )
        if link.kind is LinkKind.FOREVER and "," in link.before and self._place > 1:
            return False  # "Go to the hall, then to the office, again and again."
        if link.kind in COUNTS or link.kind is LinkKind.AFTER:
            return True
        if link.before & JOINING:
            if is_last:
                raise NoStructure("a link stands behind a conjunction, and joins nothing")
            return False
        if is_last or (following is not None and (following.is_link or following.before & JOINING)):
            return True
        if link.kind in (LinkKind.UNTIL, LinkKind.WHILE, LinkKind.PERIOD):
            return True
        raise Open(self._which(link))

    def _joined(self, unit: _Unit, body: List[Node], otherwise: Sequence[Node] = ()) -> Node:
        if unit.joint is None:
            raise NoStructure("no link")
        return self._nodes.joined(unit.joint, body, otherwise)

    def _which(self, link: _Unit) -> str:
        said = link.joint.positions if link.joint else frozenset()
        if link.kind is LinkKind.AFTER and self._now is not None and self._now.joint is None:
            said |= self._table.positions[self._now.clause]
        return which_of_it(self._sentence.text(sorted(said)))

    def _must_belong_to(self, deed: _Unit, link: _Unit) -> None:
        """Ask if a link could belong to the deed before as well: "go to the hall and open the window if it is hot"."""
        place = self._units.index(deed)
        before = self._units[place - 1] if place else None
        is_joined = before is not None and before.joint is None and not deed.begins_sentence
        if is_joined and link.kind in _BEGINNING and "then" not in deed.before:
            raise Open(self._which(link))


def _keep_out(table: LinkedClauses, fronts: Sequence[Joint], nodes: Sequence[Node]) -> None:
    """Let the robot keep out of a place before the deed there: "*do not enter the hall until you have* been to"."""
    for first, then in zip(nodes, nodes[1:]):
        if any(joint.verb in first.positions for joint in fronts):
            table.keep_out(first, then)
            return
    if fronts:
        raise NoStructure("what the robot cannot keep out of")


def _with_delays_outside(links: List[_Unit]) -> List[_Unit]:
    """Put each delay right behind a condition before it: "if I am not back *in ten minutes*" is looked at then."""
    found: List[_Unit] = []
    for link in links:
        is_of_condition = link.kind is LinkKind.DELAY and "," not in link.before
        if found and is_of_condition and found[-1].kind in (LinkKind.IF, LinkKind.UNLESS):
            found.insert(-1, link)
        else:
            found.append(link)
    return found


def _led_by(joiner: _Unit, node: Node) -> Node:
    """Return a node that is told with the words before it: "*otherwise* go to the kitchen"."""
    words = joiner.joint.positions if joiner.joint is not None else frozenset()
    return Node(node.part, node.positions | words)


def _with_places(part: PlanPart, order: Sequence[int]) -> PlanPart:
    """Return a tree with the new places of its clauses."""
    children = tuple(_with_places(child, order) for child in part.children)
    return replace(part, children=children, clause=order.index(part.clause) if part.clause >= 0 else -1)
