"""Makes the values of frame elements from words and amounts."""

from dataclasses import replace
from typing import FrozenSet, List, Tuple

from semantic_framer.reading import ElementValue
from semantic_frames.lexical_unit import ArgumentForm
from utterance_passes.measures import Amount
from utterance_passes.tree import DependencyTree

#: Relations of words at the front of a phrase that are not part of it.
_BEFORE_A_PHRASE = frozenset(["cc", "discourse", "mark"])
#: Prepositions that may introduce a verb.
_OF_VERBS = frozenset(["by"])


def phrase_value(
    tree: DependencyTree,
    name: str,
    head: int,
    form: ArgumentForm,
    left_out: FrozenSet[int],
    attached: FrozenSet[int] = frozenset(),
) -> ElementValue:
    """Make the value of a phrase.

    Args:
        tree: the sentence
        name: name of the frame element
        head: index of the head word
        form: which words become the argument
        left_out: positions of words that belong to something else
        attached: positions of words that belong to the phrase although the tree attaches them elsewhere
    Returns:
        the value; its positions include a preposition at the front, but its argument does not
    """
    conjuncts = [child for child in tree.children(head) if child.deprel == "conj" and child.upos not in ("VERB", "AUX")]
    left_out |= tree.abandoned | tree.fillers - {head}
    positions = sorted((tree.subtree(head) - left_out) | attached)
    # In "whether it is on the table" the preposition is part of the question.
    is_clause = any(child.deprel == "cop" and child.index in positions for child in tree.children(head))
    prepositions = frozenset() if is_clause else _prepositions(tree, head)
    while len(positions) > 1 and tree.word(positions[-1]).upos == "PUNCT":
        positions.pop()
    while (
        len(positions) > 1
        and positions[0] not in prepositions
        and (tree.word(positions[0]).upos == "PUNCT" or tree.word(positions[0]).deprel in _BEFORE_A_PHRASE)
    ):
        positions.pop(0)
    if prepositions and positions[0] < min(prepositions):
        prepositions |= frozenset(index for index in attached if index < min(prepositions))
    bare = [index for index in positions if index not in prepositions]
    children = tree.children(head)
    conjunction = ""
    items: Tuple[str, ...] = ()
    if conjuncts:
        conjunction = next(
            (
                inner.form.lower()
                for conjunct in conjuncts
                for inner in tree.children(conjunct.index)
                if inner.deprel == "cc"
            ),
            "and",
        )
        items = _items(tree, head, [conjunct.index for conjunct in conjuncts], left_out | prepositions, attached)
    phrase_argument = tree.text_of(bare)
    return ElementValue(
        name=name,
        argument=phrase_argument if form is ArgumentForm.PHRASE else tree.word(head).form,
        head=tree.word(head).form,
        phrase=tree.text_of(positions),
        possessor=next((child.form for child in children if child.deprel == "nmod:poss"), ""),
        determiner=next((child.form for child in children if child.deprel == "det"), ""),
        adjectives=tuple(child.form for child in children if child.deprel == "amod"),
        conjunction=conjunction if len(items) > 1 else "",
        items=items if len(items) > 1 else (),
        positions=tuple(positions),
        head_position=head,
    )


def _prepositions(tree: DependencyTree, head: int) -> FrozenSet[int]:
    found: List[int] = []
    for child in tree.children(head):
        # In "by crossing the hall" the preposition of the verb has the relation "mark".
        is_preposition = child.deprel == "case" or (child.deprel == "mark" and child.form.lower() in _OF_VERBS)
        if is_preposition and child.index < head:
            found += tree.subtree(child.index)
    return frozenset(found)


def _items(
    tree: DependencyTree, head: int, conjuncts: List[int], left_out: FrozenSet[int], attached: FrozenSet[int]
) -> Tuple[str, ...]:
    later = frozenset(index for conjunct in conjuncts for index in tree.subtree(conjunct))
    groups = [tree.subtree(head) - later - left_out] + [tree.subtree(conjunct) - left_out for conjunct in conjuncts]
    groups[-1] |= attached
    items = []
    for item, group in zip([head] + conjuncts, groups):
        own = _prepositions(tree, item)
        words = [
            index
            for index in sorted(group)
            if tree.word(index).upos != "PUNCT" and tree.word(index).deprel != "cc" and index not in own
        ]
        if words:
            items.append(tree.text_of(words))
    return tuple(items)


def amount_value(tree: DependencyTree, name: str, amount: Amount, *, is_whole: bool) -> ElementValue:
    """Make the value of an amount.

    Args:
        tree: the sentence
        name: name of the frame element
        amount: the amount
        is_whole: whether the argument is the amount with its unit ("5 minutes") or only the number ("120")
    """
    # The head of "60 degrees" is the unit; for an element that has only the number, the head is the number.
    numeral = [position for position in amount.positions if is_whole or position != amount.unit_position]
    whole = f"{amount.digits()} {amount.unit}".strip()
    return ElementValue(
        name=name,
        argument=whole if is_whole else amount.digits(),
        head=tree.word(amount.positions[-1]).form,
        phrase=tree.text_of(amount.positions),
        amount=amount.amount,
        unit=amount.unit,
        quantity=amount.quantity,
        si_amount=amount.si_amount,
        positions=amount.positions,
        head_position=(numeral or list(amount.positions))[-1],
    )


def unit_value(tree: DependencyTree, name: str, amount: Amount) -> ElementValue:
    """Make the value of the unit of an amount."""
    return ElementValue(
        name=name,
        argument=amount.unit,
        head=amount.unit,
        phrase=amount.unit,
        unit=amount.unit,
        positions=(amount.unit_position,),
        head_position=amount.unit_position,
    )


def given_value(name: str, argument: str) -> ElementValue:
    """Make a value that has no words in the sentence: a default, or something that was said before."""
    return ElementValue(name=name, argument=argument, head=argument, phrase=argument)


def resolved(value: ElementValue, argument: str) -> ElementValue:
    """Replace the argument of a pronoun by its referent; the head, phrase and positions stay."""
    return replace(value, argument=argument)
