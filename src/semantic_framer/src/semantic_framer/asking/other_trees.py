"""What else a sentence may be: the trees in which a word hangs on another of its likely governors.

The parser gives one tree, and says what else each word may hang on. A tree without the signs of
:mod:`semantic_framer.asking.tree_doubts` is better than one with them. Of several trees without them, the one whose
readings have more elements is better, as far as its probability allows.
"""

import math
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Callable, FrozenSet, Iterator, Optional, Sequence, Tuple

from semantic_framer.asking.settling import Now
from semantic_framer.asking.tree_doubts import DOUBTS, doubts_of
from semantic_framer.clauses.readings import Heard
from semantic_framer.filling.attachment import tells_which
from semantic_framer.values.dialogue import Context
from semantic_framer.values.outcome import CAREFUL, Question, Refusal, Understood
from semantic_framer.values.reading import Reading, heads_of
from utterance_passes.engine.trace import Trace
from utterance_passes.trees.tree import Alternative, DependencyTree
from utterance_passes.trees.tree_edits import NotATree, TreeEdit

#: Name of the rule in the trace.
RULE = "other_governor"
#: Relations of words of content.
_CONTENT = frozenset(
    "nsubj obj iobj obl obl:unmarked nmod nmod:unmarked nmod:poss amod compound flat appos conj acl acl:relcl advcl "
    "ccomp xcomp advmod parataxis".split()
)
#: Words of grammar, which hang elsewhere only together with a word of content.
_OF_WORDS = frozenset(["case"])
#: Replies to a tree in place of which another one may be understood.
_NOT_UNDERSTOOD = frozenset(["LEFT_OVER_WORDS", "NO_READING", "MISSING_ELEMENT", "WRONG_TYPE", "CONDITION"])
_LEAST_PROBABILITY = 0.04
#: The least probability of a tree that is taken although the parser's shows no doubt, and beside that of the parser's.
_LEAST_OF_UNDERSTOOD = 0.1
_LEAST_RATIO = 0.1
#: The most trees that differ in one governor, and the most that differ in two.
_MOST_TREES = 6
#: So much an element that a tree fills more counts against its lower probability.
_OF_AN_ELEMENT = math.log(1.75)
_OF_A_DOUBT = 10.0


def best_of_trees(
    tree: DependencyTree,
    heard: Heard,
    context: Context,
    now: Now,
    read: Callable[[DependencyTree, Optional[Trace]], Heard],
) -> Heard:
    """Return what the best tree of an utterance means.

    Args:
        tree: as the parser has it
        heard: what that means
        context: what the framer remembers of earlier utterances
        now: the circumstances of the utterance
        read: understands another tree, and writes a trace
    """
    is_open = not (heard.is_answer or heard.is_small_talk or RULE in now.known.without)
    if not is_open or now.policy.left_over_words not in CAREFUL:
        return heard
    if not isinstance(heard.outcome, Understood) and heard.outcome.code not in _NOT_UNDERSTOOD:
        return heard
    doubts = doubts_of(tree, heard, now.known)
    best, best_merit, said, lines = heard, 0.0, "", Trace()
    for other in _other_trees(tree, is_doubtful=bool(doubts)):
        if not doubts and not _may_say_more(other, heard):
            continue
        trace = Trace()
        otherwise = read(other.tree, trace if now.trace is not None else None)
        if doubts_of(other.tree, otherwise, now.known):
            continue
        merit = _merit(other, otherwise, heard, doubts)
        if merit > best_merit:
            best, best_merit, said, lines = otherwise, merit, str(other), trace
    reasons = " ".join(DOUBTS[name].reason for name in doubts)
    if best is not heard:
        now.write(RULE, tree.text, f"{said}. {reasons or 'More is said.'}")
        if now.trace is not None:
            now.trace.extend(lines.lines)
        return best
    if not any(DOUBTS[name].is_grave for name in doubts):
        return heard
    now.write(RULE, tree.text, f"refused. {reasons}")
    return replace(heard, outcome=_refusal(heard), context=replace(context, pending=None))


@dataclass(frozen=True)
class _OtherTree:
    """A tree in which some words hang on other governors.

    Attributes:
        tree: the sentence
        changed: the words with their governors
        probability: of the least likely of them
        ratio: its probability beside that of the parser's choice
    """

    tree: DependencyTree
    changed: Tuple[Alternative, ...]
    probability: float
    ratio: float

    @property
    def positions(self) -> FrozenSet[int]:
        """The positions of the words that hang elsewhere."""
        return frozenset(one.word for one in self.changed)

    def __str__(self) -> str:
        word = self.tree.word
        return ", ".join(f"{word(one.word).form}: {one.deprel} of {word(one.head).form}" for one in self.changed)


def _other_trees(tree: DependencyTree, *, is_doubtful: bool) -> Iterator[_OtherTree]:
    """Return the trees that differ in one governor, the likeliest first; then those that differ in two.

    Args:
        tree: the sentence
        is_doubtful: whether its words show that it is wrong; only then a tree may differ in two
    """
    others = sorted((one for one in tree.alternatives if _may_hang(tree, one)), key=lambda one: -one.probability)
    ways = [(one,) for one in others if one.deprel in _CONTENT]
    pairs = [(one, two) for one, two in combinations(others, 2) if one.word != two.word]
    for changed in (*ways[:_MOST_TREES], *(pairs[:_MOST_TREES] if is_doubtful else ())):
        other = _changed(tree, changed)
        if other is not None:
            ratio = math.prod(one.probability / _likeliest(tree, one.word) for one in changed)
            yield _OtherTree(other, changed, min(one.probability for one in changed), ratio)


def _may_hang(tree: DependencyTree, other: Alternative) -> bool:
    """Whether a word may hang on another governor: one that tells which thing is meant stays where it is."""
    relations = {tree.word(other.word).deprel, other.deprel}
    is_likely = other.probability >= _LEAST_PROBABILITY and bool(other.head)
    return is_likely and relations <= _CONTENT | _OF_WORDS and not tells_which(tree, other.word)


def _likeliest(tree: DependencyTree, word: int) -> float:
    others = [one.probability for one in tree.alternatives if one.word == word]
    return max(1.0 - sum(others), *others)


def _changed(tree: DependencyTree, changed: Sequence[Alternative]) -> Optional[DependencyTree]:
    """Return the tree with other governors; None if there is none, or if its branches cross and did not before."""
    edit = TreeEdit(tree)
    for one in changed:
        edit.rehang(one.word, one.head, one.deprel)
    try:
        other = edit.tree()
    except NotATree:
        return None
    return other if _is_projective(other) or not _is_projective(tree) else None


def _is_projective(tree: DependencyTree) -> bool:
    """Whether no two branches cross; an item of a list may come later: "bring *the cup* to me *and the fork*"."""
    for word in tree.words:
        if word.head and word.deprel not in ("conj", "punct"):
            between = range(min(word.index, word.head) + 1, max(word.index, word.head))
            if not tree.subtree(word.head).issuperset(between):
                return False
    return True


def _may_say_more(other: _OtherTree, before: Heard) -> bool:
    """Whether another tree may have more elements, so that it is worth reading: of what is understood, it gives a verb
    something."""
    is_likely = other.ratio >= _LEAST_RATIO and other.probability >= _LEAST_OF_UNDERSTOOD
    verbs = frozenset(index for reading in _best(before) for index in reading.verb_positions)
    return is_likely and (not verbs or any(one.head in verbs for one in other.changed))


def _merit(other: _OtherTree, heard: Heard, before: Heard, doubts: Sequence[str]) -> float:
    """Return by how much another tree, which shows no doubt, is better than the parser's; 0 or less if it is not.

    A phrase that is only hidden in another one is understood no better: it must fill an element, or be a verb.

    Args:
        other: the tree
        heard: what it means
        before: what the parser's tree means
        doubts: what that shows
    """
    old, new = _best(before), _best(heard)
    if not new:
        return 0.0
    if not old:
        is_one = not isinstance(before.outcome, Question) or len(new) == 1
        is_named = other.positions <= heads_of(new) | _parts_of_objects(before, other)
        return other.probability if is_named and is_one else 0.0
    more = _said(new) - _said(old)
    by_elements = math.log(other.ratio) + more * _OF_AN_ELEMENT
    if doubts:
        return _OF_A_DOUBT + by_elements if more >= 0 and [*map(str, old)] != [*map(str, new)] else 0.0
    is_same = [one.verb_positions[:1] for one in old] == [one.verb_positions[:1] for one in new]
    is_planned = any(one.outcome.plan is not None for one in (heard, before) if isinstance(one.outcome, Understood))
    is_named = other.positions <= heads_of(new)
    return by_elements if more > 0 and is_same and is_named and not is_planned else 0.0


def _parts_of_objects(before: Heard, other: _OtherTree) -> FrozenSet[int]:
    """Return the words that another tree makes the front of a compound, and that were objects beside it: Universal
    Dependencies gives a verb one object, "turn on the *living room* light"."""
    sentence = before.sentence
    if sentence is None:
        return frozenset()
    return frozenset(one.word for one in other.changed if _joins_objects(sentence.tree, one))


def _joins_objects(tree: DependencyTree, other: Alternative) -> bool:
    """Whether an alternative makes one object of a verb the front of a compound that was an object beside it."""
    if other.deprel != "compound" or other.word > other.head:
        return False
    word, head = tree.word(other.word), tree.word(other.head)
    # "Take the red cup barefoot": what has an article is a phrase of its own.
    is_bare = all(child.deprel == "compound" for child in tree.children(word.index))
    return word.deprel == head.deprel == "obj" and word.head == head.head and is_bare


def _said(readings: Sequence[Reading]) -> int:
    """Return how much units say of the words: the elements, and the words of the verbs."""
    return sum(len(reading.said) + len(reading.verb.split()) for reading in readings)


def _best(heard: Heard) -> Tuple[Reading, ...]:
    return tuple(readings[0] for readings in heard.outcome.clauses) if isinstance(heard.outcome, Understood) else ()


def _refusal(heard: Heard) -> Refusal:
    """Return why a sentence is not acted on although it is understood."""
    arguments = [one for reading in _best(heard) for one in reading.arguments]
    said = max(arguments, key=lambda one: len(one.positions)).text
    return Refusal("CONDITION", f'I do not understand what "{said}" means here. Please say it in two sentences.')
