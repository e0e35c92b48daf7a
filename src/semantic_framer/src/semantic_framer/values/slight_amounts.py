"""Finds "a bit" and "slightly" where they say how far, and gives them a stated amount: "move back a bit".

The person hears the amount, because it stands behind the words of the clause: "move back a bit (20 centimetres)".
"""

from typing import Iterable, List, Mapping, Optional, Sequence, Tuple

from spoken_quantities import find_unit, parse_measure
from typed_arguments import TypedArgument
from utterance_passes.phrases.measures import Amount
from utterance_passes.trees.tree import DependencyTree
from word_classes import word_class

#: How much "a bit" is.
ASSUMED: Mapping[str, str] = {"length": "20 centimetres", "angle": "15 degrees"}
_DEGREES = word_class("degrees")
_BEFORE = word_class("amount_modifiers")
_ARTICLES = frozenset(["a", "one"])
_BEHIND = word_class("more_words")
#: Behind "a bit", other words would say of what: "a bit faster", "a little milk".
_NEXT = (
    word_class("all_directions")
    | word_class("placing_prepositions")
    | word_class("directional_prepositions")
    | word_class("along_prepositions")
    | word_class("lead_in")
    | word_class("more_words")
) - {"of"}


def slight_words(tree: DependencyTree, positions: Iterable[int]) -> Tuple[int, ...]:
    """Return the words among these that say that little is meant, without saying of what; none if there are none."""
    spoken = [index for index in sorted(positions) if tree.word(index).upos != "PUNCT"]
    forms = [tree.word(index).said for index in spoken]
    tags = [tree.word(index).upos for index in spoken]
    for place in range(len(forms)):
        end = _end(forms, tags, place)
        first = place - 1 if place and forms[place - 1] in _BEFORE else place
        is_one = all(after == before + 1 for before, after in zip(spoken[first:end], spoken[first + 1 : end]))
        if end and is_one and (end == len(forms) or forms[end] in _NEXT or spoken[end] != spoken[end - 1] + 1):
            return tuple(spoken[first:end])
    return ()


def _end(forms: Sequence[str], tags: Sequence[str], place: int) -> int:
    """Return where a phrase ends that begins at a place; 0 if none begins there."""
    here = place
    if forms[here] in _DEGREES and tags[here] == "ADV":
        here += 1
    elif forms[here] in _ARTICLES:
        here += 1
        while here + 1 < len(forms) and forms[here] in _DEGREES and forms[here + 1] in _DEGREES:
            here += 1
        if here == len(forms) or forms[here] not in _DEGREES:
            return 0
        here += 1
    else:
        return 0
    return here + 1 if here < len(forms) and forms[here] in _BEHIND else here


def slight_amount(positions: Tuple[int, ...], quantity: str) -> Optional[Amount]:
    """Return the amount that is assumed for such words; None if nothing is assumed for the quantity."""
    if quantity not in ASSUMED or not positions:
        return None
    measure = parse_measure(ASSUMED[quantity])
    numeral, _, unit = ASSUMED[quantity].partition(" ")
    return Amount(
        positions=positions,
        amount=measure.amount,
        unit=unit,
        quantity=quantity,
        si_amount=measure.si_amount,
        numeral=numeral,
        unit_position=positions[-1],
        is_assumed=True,
    )


def stated(arguments: Iterable[TypedArgument]) -> str:
    """Return the amounts that are assumed, as they stand behind the words of a clause; empty for none."""
    found: List[str] = []
    for argument in arguments:
        measure = argument.measure
        if measure is None or not measure.is_assumed or measure.kind not in ASSUMED:
            continue
        unit = find_unit(measure.unit)
        if unit is not None and unit.is_assumed and measure.si is not None:
            # "Two steps" are a metre.
            found.append("1 metre" if measure.si == 1.0 else f"{measure.si:g} metres")
        else:
            found.append(ASSUMED[measure.kind])
    return f" ({', '.join(dict.fromkeys(found))})" if found else ""
