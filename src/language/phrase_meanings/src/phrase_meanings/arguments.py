"""Makes typed arguments of amounts and defaults, and resolves those of pronouns; ``phrases`` makes those of phrases."""

import math
import re
from dataclasses import replace
from typing import Optional, Sequence

from phrase_meanings.head_words import is_plural
from phrase_meanings.meaning_file import shipped_meanings
from spoken_quantities import find_unit
from typed_arguments import Measure, Modifier, Source, TypedArgument
from typed_arguments.positions import without_any_position
from utterance_passes.phrases.measures import Amount
from utterance_passes.trees.tree import DependencyTree
from word_classes import word_class

_MORE = word_class("more_words")


def amount_argument(tree: DependencyTree, name: str, amount: Amount, *, is_whole: bool) -> TypedArgument:
    """Make the argument of an amount.

    Args:
        tree: the sentence
        name: name of the frame element
        amount: the amount
        is_whole: whether the text is the amount with its unit ("5 minutes") or only the number ("120")
    """
    # The head of "60 degrees" is the unit; for an element that has only the number, the head is the number.
    numeral = [position for position in amount.positions if is_whole or position != amount.unit_position]
    whole = f"{amount.digits()} {amount.unit}".strip()
    last = tree.word(amount.positions[-1])
    return TypedArgument(
        name=name,
        text=whole if is_whole else amount.digits(),
        words=tree.text_of(amount.positions),
        positions=amount.positions,
        head=last.form,
        lemma=last.lemma.lower(),
        head_position=(numeral or list(amount.positions))[-1],
        measure=measure_of(tree, amount),
    )


def measure_of(tree: DependencyTree, amount: Amount) -> Measure:
    """Return an amount as a measure; an amount that is not finite has no value."""
    unit = find_unit(amount.unit) if amount.unit else None
    forms = [tree.word(index).said for index in amount.positions]
    first = min(amount.positions) - 1
    before = [tree.word(index).said for index in range(max(1, first - 1), first + 1)]
    return Measure(
        kind=amount.quantity or "number",
        words=tree.text_of(amount.positions),
        amount=_finite(amount.amount),
        unit=unit.name if unit else amount.unit,
        si=_finite(amount.si_amount),
        bound=shipped_meanings().bound(before),
        change="more" if _MORE & frozenset(forms + before[-1:]) else "",
        is_assumed=amount.is_assumed or (unit is not None and unit.is_assumed),
    )


def _finite(number: float) -> Optional[float]:
    return number if math.isfinite(number) else None


def unit_argument(tree: DependencyTree, name: str, amount: Amount) -> TypedArgument:
    """Make the argument of the unit of an amount."""
    word = tree.word(amount.unit_position)
    return TypedArgument(
        name=name,
        text=amount.unit,
        words=amount.unit,
        positions=(amount.unit_position,),
        head=amount.unit,
        lemma=word.lemma.lower(),
        head_position=amount.unit_position,
        is_plural=is_plural(word),
        measure=measure_of(tree, amount),
    )


def default_argument(name: str, text: str) -> TypedArgument:
    """Make the argument of an element that the sentence does not fill: the default of its frame."""
    return TypedArgument(name=name, text=text, words=text, head=text, source=Source.DEFAULT)


def resolved(argument: TypedArgument, text: str, listed: Sequence[TypedArgument] = ()) -> TypedArgument:
    """Replace the text of a pronoun by its referent; the head, words and positions stay.

    Args:
        argument: the pronoun
        text: what it stands for
        listed: the items of what it stands for; more than one become the members of the argument
    """
    argument = replace(argument, text=text, source=Source.INFERRED)
    if len(listed) < 2:
        return argument
    items = tuple(replace(without_any_position(one), name="", relation="") for one in listed)
    return replace(argument, members=items, conjunction="and")


def referring_to(argument: TypedArgument, before: TypedArgument) -> TypedArgument:
    """Return the argument of a pronoun that stands for a whole earlier argument: "one" after "a coffee"."""
    return replace(
        before,
        name=argument.name,
        words=argument.words,
        positions=argument.positions,
        head_position=argument.head_position,
        source=Source.INFERRED,
    )


def with_words(tree: DependencyTree, argument: TypedArgument, positions: Sequence[int]) -> TypedArgument:
    """Return an argument with other words; its text stays."""
    return replace(argument, words=tree.text_of(positions), positions=tuple(sorted(positions)))


def on_other_side(
    tree: DependencyTree, argument: TypedArgument, side: str, other: str, positions: Sequence[int]
) -> TypedArgument:
    """Return an earlier argument on the opposite side: "the other one" after "the left door" is the right door.

    Args:
        tree: the sentence
        argument: of an earlier sentence
        side: the word for the side in the argument
        other: the word for the opposite side
        positions: of the words in this sentence
    """
    before = without_any_position(argument)
    return replace(
        before,
        text=re.sub(rf"\b{side}\b", other, before.text, flags=re.IGNORECASE),
        source=Source.SAID,
        words=tree.text_of(positions),
        positions=tuple(sorted(positions)),
        head=other if before.head.lower() == side else before.head,
        lemma=other if before.lemma == side else before.lemma,
        direction=other if before.direction else "",
        modifiers=tuple(
            replace(one, word=other, lemma=other) if one.word.lower() == side else one for one in before.modifiers
        ),
    )


def of_same_kind(argument: TypedArgument, before: TypedArgument, named: Optional[Modifier] = None) -> TypedArgument:
    """Return an argument with the head "one" as a thing of the kind of an earlier one: "the red one" after "the blue
    mug" is the red mug, and after "some mugs", too.

    Args:
        argument: "the red one"
        before: "the blue mug"
        named: the property that an argument without a noun names: "the smallest"; None if it has the head "one"
    """
    if named is not None:
        argument = replace(argument, text=f"{argument.text} one", modifiers=(*argument.modifiers, named))
    compounds = tuple(replace(one, position=0) for one in before.modifiers if one.kind == "compound")
    is_one_of_several = before.is_plural and argument.head.lower() == "one"
    head = before.lemma if is_one_of_several else before.head
    noun = " ".join([*(one.word for one in compounds), head])
    return replace(
        argument,
        text=re.sub(r"\bones?\b", lambda match: noun, argument.text, count=1, flags=re.IGNORECASE),
        head=head,
        lemma=before.lemma,
        is_plural=before.is_plural and not is_one_of_several,
        semantic_type=before.semantic_type,
        modifiers=compounds + argument.modifiers,
    )
