"""Amounts in a sentence, found in its words: the same words hang in the tree in many ways ("move 3 feet forward")."""

import math
from dataclasses import dataclass
from typing import List, Optional, Sequence, Tuple

from spoken_quantities import QuantityError, find_unit, number_words, parse_measure, parse_number

from utterance_passes.tree import DependencyTree

#: No amount has more words ("one hundred and twenty five and a half feet and six inches").
LONGEST = 12
_NUMBER_WORDS = frozenset(number_words()) | {"a", "an", "and", "of", "-", "point"}


@dataclass(frozen=True)
class Amount:
    """A number in a sentence, and its unit if one was said.

    Attributes:
        positions: of its words, unit included
        amount: the number
        unit: as it was said, "feet"; empty for a bare number
        quantity: length, angle, duration or number
        si_amount: metres, radians, seconds or the bare number
        numeral: the number as it was said, "minus two"
        unit_position: of the unit, 0 for none
    """

    positions: Tuple[int, ...]
    amount: float
    unit: str
    quantity: str
    si_amount: float
    numeral: str
    unit_position: int = 0

    def digits(self) -> str:
        """The number in digits, without needless zeros; as it was said where it is not finite."""
        return f"{self.amount:.12g}" if math.isfinite(self.amount) else self.numeral


def find_amounts(tree: DependencyTree, positions: Sequence[int]) -> Tuple[Amount, ...]:
    """Find the amounts among some words.

    Args:
        tree: the sentence
        positions: of the words to look at, in order
    Returns:
        amounts that do not overlap, the longest first where they could; amounts that are not finite are found too.
        A number that counts things ("two eggs") is none
    """
    found: List[Amount] = []
    start = 0
    ordered = sorted(positions)
    while start < len(ordered):
        amount = None
        for length in range(min(LONGEST, len(ordered) - start), 0, -1):
            window = ordered[start : start + length]
            if window[-1] - window[0] == length - 1:
                amount = _amount(tree, window)
            if amount is not None:
                break
        if amount is None:
            start += 1
        else:
            found.append(amount)
            start += len(amount.positions)
    return tuple(amount for amount in found if not _counts_things(tree, amount))


def _counts_things(tree: DependencyTree, amount: Amount) -> bool:
    """Whether a number stands in front of the noun that it counts."""
    numeral = tree.word(amount.positions[-1])
    noun = tree.word(numeral.head) if numeral.head else numeral
    between = [tree.word(index) for index in range(numeral.index + 1, noun.index)]
    is_counted = numeral.deprel == "nummod" and noun.index > numeral.index and noun.upos in ("NOUN", "PROPN")
    is_next = all(word.upos in ("ADJ", "NOUN", "PROPN") for word in between)
    return is_counted and is_next and not amount.unit and not find_unit(noun.form) and noun.lemma.lower() != "time"


def _amount(tree: DependencyTree, window: Sequence[int]) -> Optional[Amount]:
    forms = [tree.word(index).form for index in window]
    unit = find_unit(forms[-1]) if len(forms) > 1 else None
    numeral = forms[:-1] if unit else forms
    if not all(_is_of_a_number(form) for form in numeral):
        return _sum(tree, window, forms)
    if not any(
        form[0].isdigit() or form.lower() in _NUMBER_WORDS - {"a", "an", "and", "of", "-", "point", "plus"}
        for form in numeral
    ) and not (unit and len(forms) == 2):
        return None
    if numeral[-1].lower() == "and" or (unit is None and numeral[0].lower() in ("a", "an", "and", "of")):
        return None
    said = " ".join(forms)
    spoken = " ".join(numeral)
    try:
        if unit is None:
            number = parse_number(said)
            return Amount(tuple(window), number, "", "number", number, spoken)
        measure = parse_measure(said)
    except QuantityError as error:
        if error.code == "NOT_FINITE":
            return Amount(
                tuple(window),
                float("inf"),
                forms[-1] if unit else "",
                unit.quantity if unit else "number",
                float("inf"),
                spoken,
                window[-1] if unit else 0,
            )
        return None
    return Amount(tuple(window), measure.amount, forms[-1], measure.quantity, measure.si_amount, spoken, window[-1])


def _is_of_a_number(form: str) -> bool:
    return form.lower() in _NUMBER_WORDS or form[0].isdigit() or form in ("-", "+") or form[0] in "+-."


def _sum(tree: DependencyTree, window: Sequence[int], forms: List[str]) -> Optional[Amount]:
    """Return an amount in several units, "5 feet 6 inches", counted in the first of them."""
    if not all(_is_of_a_number(form) or find_unit(form) for form in forms) or not _is_of_a_number(forms[0]):
        return None
    if not find_unit(forms[-1]) and window[-1] < len(tree.words):
        # "5 feet 6 times" and "2 metres 90 degrees" are two amounts.
        following = tree.word(window[-1] + 1)
        if find_unit(following.form) or following.upos in ("NOUN", "PROPN", "ADJ", "NUM"):
            return None
    said = " ".join(forms)
    try:
        measure = parse_measure(said)
    except QuantityError:
        return None
    position = next(index for index, form in enumerate(forms) if find_unit(form) and index)
    return Amount(
        tuple(window), measure.amount, forms[position], measure.quantity, measure.si_amount, said, window[position]
    )
