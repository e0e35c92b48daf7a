"""Makes the nodes of the plan of a sentence: what a condition, a time or an order makes of the deeds that it joins."""

from dataclasses import replace
from typing import List, Optional, Sequence

from semantic_framer.linking.joints import Joint
from semantic_framer.linking.link_file import LinkKind
from semantic_framer.linking.linked_clauses import LinkedClauses, Node, NoStructure, Open
from semantic_framer.values.clause_plan import PlanPart
from typed_arguments import TimeExpression
from word_classes import word_class

#: How the items of a list, or several deeds, are done.
ORDERS = (LinkKind.ANY_ORDER, LinkKind.REVERSED, LinkKind.ALTERNATING, LinkKind.RETURNING)
_UNTIL = word_class("conjunctions_of_ends")
#: How the robot goes between the items.
_BETWEEN = (LinkKind.ALTERNATING, LinkKind.RETURNING)
#: How often a deed is done.
COUNTS = (LinkKind.FOREVER, LinkKind.AT_A_TIME, LinkKind.AT_LEAST, LinkKind.AT_MOST, LinkKind.TIMES)


class PlanNodes:
    """Makes nodes of the clauses of a sentence."""

    def __init__(self, table: LinkedClauses) -> None:
        self._table = table

    def joined(self, joint: Joint, body: List[Node], otherwise: Sequence[Node] = ()) -> Node:
        """Return the node of a link with what it joins.

        Args:
            joint: the link, or a time
            body: what is done
            otherwise: what is done if its condition does not hold
        Raises:
            NoStructure: the link cannot join it
        """
        positions = joint.positions.union(*(node.positions for node in (*body, *otherwise)))
        label = self._table.label(positions)
        child = self.sequence(body)
        if joint.kind is LinkKind.DELAY:
            when = TimeExpression("time", self._table.label(joint.positions), "in", offset_s=joint.seconds)
            return Node(PlanPart("AT", label, (child.part,), when=when), positions)
        if joint.kind is LinkKind.CLOCK:
            return Node(PlanPart("AT", label, (child.part,), when=joint.when), positions)
        if joint.kind is LinkKind.PERIOD:
            if child.part.kind in ("UNTIL", "WHILE") and not child.part.duration_s:
                # "Every ten seconds say hello until ...": the end is that of the repetition.
                until, deed = child.part, child.part.children[-1]
                again = PlanPart("REPEAT", deed.label, (deed,), period_s=joint.seconds)
                if deed.kind == "DO":
                    return Node(replace(until, label=label, children=(until.children[0], again)), positions)
            if child.part.kind in ("REPEAT", "WAIT", "UNTIL", "WHILE"):
                raise NoStructure("two ways to repeat")
            when = TimeExpression("set", self._table.label(joint.positions), "every", period_s=joint.seconds)
            return Node(PlanPart("AT", label, (child.part,), when=when), positions)
        if joint.kind in ORDERS:
            return self.ordered(joint.kind, body)
        if joint.kind in COUNTS:
            if joint.number == 1 and child.part.kind == "DO" and self._table.is_turn_assumed(child.part.clause):
                raise NoStructure("how far to turn")  # "Turn around only once."
            return Node(_repeated(child.part, label, joint), positions)
        said = joint.condition
        if said is None:
            raise NoStructure("a link without a condition")
        is_only = "only" in joint.words.lower().split()  # "Only if the bell rings" waits for nothing.
        if joint.kind is LinkKind.IF and not (otherwise or is_only):
            # "Stop if you see Anna": there is nothing to stop for now.
            is_stop = all(node.part.kind == "DO" and self._table.stops(node.part.clause) for node in body)
            joint = replace(joint, kind=LinkKind.WHEN) if is_stop or self._table.happens(said) else joint
        if joint.limit_s and joint.kind not in (LinkKind.UNTIL, LinkKind.WHEN, LinkKind.ANEW):
            raise NoStructure("a longest time for what does not wait")
        # "Do not enter until you have knocked" waits for what comes first.
        is_when = joint.kind is LinkKind.WHEN and joint.words.lower() not in _UNTIL
        if is_when and self._table.is_new_deed(said, joint.first):
            # "Once you have visited the hall, go to the office": nobody told the robot to visit the hall.
            words = self._table.label(said.positions)
            raise Open(f'Should I do this first, or wait for it: "{words}"? Say "first ..." or "wait until ...".')
        is_opposite = joint.kind is LinkKind.UNLESS
        condition = self._table.condition(said, is_opposite, joint.kind)
        if joint.kind in (LinkKind.IF, LinkKind.UNLESS):
            parts = (condition, child.part) + ((self.sequence(otherwise).part,) if otherwise else ())
            return Node(PlanPart("IF", label, parts), positions)
        if joint.kind is LinkKind.WHENEVER:
            return Node(PlanPart("WHENEVER", label, (condition, child.part)), positions)
        if joint.kind in (LinkKind.WHEN, LinkKind.ANEW):
            wait = PlanPart("WAIT", self._table.label(joint.positions), (condition,), limit_s=joint.limit_s)
            return self.sequence([Node(wait, joint.positions), *body])
        return self._ended(joint, body, condition, Node(child.part, positions))

    def _ended(self, joint: Joint, body: List[Node], condition: PlanPart, whole: Node) -> Node:
        """Return what a condition ends: "follow me until ...", "wait until ..."."""
        label = self._table.label(whole.positions)
        is_until = joint.kind is LinkKind.UNTIL
        if len(body) == 1 and body[0].part.kind == "DO" and self._table.only_waits(body[0].part.clause):
            held = condition if is_until else replace(condition, is_negated=not condition.is_negated)
            return Node(PlanPart("WAIT", label, (held,), limit_s=joint.limit_s), whole.positions)
        last = body[-1].part
        if last.is_endless and last.children[0].kind == "DO":
            deed = self._table.going_on(last.children[0])
            last = deed if deed.kind == "REPEAT" else replace(last, children=(deed,))
        elif last.kind == "DO":
            last = self._table.going_on(last)
        parts = [node.part for node in body[:-1]] + [last]
        child = parts[0] if len(parts) == 1 else replace(whole.part, children=tuple(parts))
        if is_until:
            return Node(PlanPart("UNTIL", label, (condition, child), limit_s=joint.limit_s), whole.positions)
        return Node(PlanPart("WHILE", label, (condition, child)), whole.positions)

    def sequence(self, nodes: Sequence[Node]) -> Node:
        """Return deeds one after the other; a deed that is alone stays as it is."""
        if len(nodes) == 1:
            return nodes[0]
        return self.several("SEQUENCE", nodes)

    def several(self, kind: str, nodes: Sequence[Node]) -> Node:
        """Return one node of a kind; nodes of this kind among its children dissolve in it."""
        positions = frozenset().union(*(node.positions for node in nodes))
        parts: List[PlanPart] = []
        for node in nodes:
            is_same = node.part.kind == kind and not node.part.limit_s
            parts += node.part.children if is_same else (node.part,)
        return Node(PlanPart(kind, self._table.label(positions), tuple(parts)), positions)

    def ordered(self, kind: Optional[LinkKind], nodes: List[Node]) -> Node:
        """Return deeds, or the items of a list of one deed, in any order or in reverse order.

        Raises:
            NoStructure: there is only one deed, without a list
        """
        times = nodes[0].part if len(nodes) == 1 and nodes[0].part.kind == "REPEAT" else None
        if times is not None and kind in _BETWEEN:
            nodes = [_with_part(nodes[0], times.children[0])]
        if len(nodes) == 1 and nodes[0].part.kind == "DO":
            nodes = self._table.items(nodes[0])
        elif len(nodes) == 1 and nodes[0].part.kind == "SEQUENCE":
            nodes = [Node(part, nodes[0].positions) for part in nodes[0].part.children]
        if len(nodes) == 1 and kind is LinkKind.ANY_ORDER and self._table.is_of_all(nodes[0].part.clause):
            return nodes[0]  # The server that visits all rooms chooses the order itself.
        if len(nodes) == 1 and kind is LinkKind.ALTERNATING and self._table.is_endless(nodes[0].part.clause):
            return nodes[0]  # "Patrol back and forth between ...".
        if len(nodes) < 2:
            raise NoStructure("an order of one deed")
        if kind is LinkKind.REVERSED:
            return self.sequence(nodes[::-1])
        if kind in _BETWEEN:
            count = times.count if times is not None else 0
            return self._alternating(nodes, count or int(kind is LinkKind.RETURNING))
        return self.several("ANY_ORDER", nodes)

    def again_and_again(self, nodes: List[Node]) -> Node:
        """Return all deeds, done again and again: "go to the hall, then to the office, *and so on*"."""
        all_of_them = self.sequence(nodes)
        part = all_of_them.part
        if part.kind in ("UNTIL", "WHILE") or (part.kind == "REPEAT" and not part.is_endless):
            raise NoStructure("two ways to repeat")
        return _with_part(all_of_them, part if part.is_endless else PlanPart("REPEAT", part.label, (part,)))

    def _alternating(self, nodes: List[Node], times: int) -> Node:
        """Return deeds that are done in turn: without an end, or so many times each way."""
        there = self.sequence(nodes)
        if not times or len(nodes) > 2:
            return _with_part(there, PlanPart("REPEAT", there.part.label, (there.part,), count=times, most=times))
        back = self.sequence([nodes[1], self._table.again(nodes[0])])
        if times == 1:
            return self.several("SEQUENCE", [nodes[0], back])
        again = PlanPart("REPEAT", there.part.label, (back.part,), count=times, most=times)
        return self.several("SEQUENCE", [nodes[0], _with_part(there, again)])


def _with_part(node: Node, part: PlanPart) -> Node:
    return Node(part, node.positions)


def _repeated(part: PlanPart, label: str, joint: Joint) -> PlanPart:
    """Return a deed that is done so many times at least or at most, or again and again."""
    if part.is_endless and joint.kind is LinkKind.FOREVER:
        return part
    if part.kind in ("REPEAT", "UNTIL", "WHILE", "AT", "WHENEVER"):
        raise NoStructure("two ways to repeat")
    least = 0 if joint.kind is LinkKind.AT_MOST else joint.number
    most = 0 if joint.kind is LinkKind.AT_LEAST else joint.number
    return PlanPart("REPEAT", label, (part,), count=least, most=most)
