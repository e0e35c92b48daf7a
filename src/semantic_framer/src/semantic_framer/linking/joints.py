"""Words that join the deeds of a sentence: conditions, times and joiners."""

from dataclasses import dataclass, replace
from typing import FrozenSet, List, Optional, Sequence, Tuple

from semantic_framer.linking.deed_orders import ItemOrder
from semantic_framer.linking.link_file import LinkKind
from semantic_framer.values.condition_part import ConditionPart
from typed_arguments import TimeExpression
from utterance_passes.trees.tree import NOUNS, DependencyTree

SENTENCE_ENDS = frozenset([".", "!", "?", ";", "..."])


@dataclass(frozen=True)
class Joint:
    """Words that join.

    Attributes:
        kind: what they mean
        first: position of the first of them
        positions: of all of them, the condition included
        condition: behind a link; None for a time or a joiner
        seconds: of a delay or a period
        words: of the link, as it was said
        limit_s: longest time that was said for it; 0 for none
        when: a time of the clock
        verb: of the deed behind "before" or "after", its position; 0 for other words
        is_kept_out: whether the robot keeps out of where the other deed leads until that deed is done
        number: a least or a largest number of times
        order: of two items of a list
        items: positions of the first item, of the word between, and of the second item, if these words are the list; of
            the preposition of both, if the robot goes between them
        is_of_persons: whether they say what each of many persons does: "everybody *who comes in*"
    """

    kind: LinkKind
    first: int
    positions: FrozenSet[int]
    condition: Optional[ConditionPart] = None
    seconds: float = 0.0
    words: str = ""
    limit_s: float = 0.0
    when: Optional[TimeExpression] = None
    verb: int = 0
    is_kept_out: bool = False
    number: int = 0
    order: Optional[ItemOrder] = None
    items: Tuple[int, ...] = ()
    is_of_persons: bool = False


@dataclass(frozen=True)
class Joints:
    """What joins the deeds of a sentence.

    Attributes:
        found: in the order of the sentence
        question: asks for what is missing behind the last link: "Until when?"; empty if nothing is missing
        unknown: positions of the words behind the first link whose condition is not understood
        open_time: the words of a time that the question asks about: "tomorrow"
    """

    found: Tuple[Joint, ...] = ()
    question: str = ""
    unknown: Tuple[int, ...] = ()
    open_time: Optional[Joint] = None

    @property
    def positions(self) -> FrozenSet[int]:
        """Positions of all words that join."""
        return frozenset().union(*(joint.positions for joint in self.found))


def with_limits(found: Sequence[Joint], limits: Sequence[Joint]) -> List[Joint]:
    """Give each longest time to the nearest condition that is waited for; a bound that belongs to none stays alone."""
    joints = list(found)
    for bound in limits:
        near = [
            place
            for place, joint in enumerate(joints)
            if joint.kind in (LinkKind.UNTIL, LinkKind.WHEN, LinkKind.ANEW) and joint.condition is not None
        ]
        if not near:
            joints.append(bound)
            continue
        place = min(near, key=lambda place: abs(joints[place].first - bound.first))
        joints[place] = replace(
            joints[place], limit_s=bound.limit_s, positions=joints[place].positions | bound.positions
        )
    return sorted(joints, key=lambda joint: joint.first)


def may_be_of_last_choice(tree: DependencyTree, joints: Sequence[Joint]) -> bool:
    """Whether a condition may be that of the last choice alone: "bring me the cup, or the glass *if there is none*".

    Without the comma it is, if it is about a choice before: "bring me coffee or tea *if there is no coffee*".
    """
    conditional = [joint for joint in joints if joint.kind in (LinkKind.IF, LinkKind.UNLESS)]
    return any(
        word.said == "or" and (tree.word(word.index - 1).form == "," or _is_about(tree, joint, word.index))
        for joint in conditional
        for word in tree.words[1 : max(1, joint.first - 2)]
    )


def _is_about(tree: DependencyTree, joint: Joint, end: int) -> bool:
    """Whether a condition names a thing that was named before a position."""
    before = {word.lemma.lower() for word in tree.words[: end - 1] if word.upos in NOUNS}
    return any(tree.word(index).lemma.lower() in before for index in joint.positions)
