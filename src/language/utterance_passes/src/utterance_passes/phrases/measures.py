"""Checks the words beside an amount: a range, a sign, a negation or a number that the amount does not include.

An amount that covers only a part of what was said is *doubtful*. It fills no element, and its words are left over, so
that the robot never acts on half of a number: "ten to fifteen degrees", "not two metres", "five five metres", "20%".
"""

import math
import re
from dataclasses import replace
from typing import AbstractSet, FrozenSet, Iterable, List, Optional, Sequence, Tuple

from spoken_quantities import find_unit
from utterance_passes.phrases.amounts import Amount, counts_things, is_iteration, is_number, read_amounts, unit_at
from utterance_passes.trees.tree import DependencyTree
from word_classes import word_class

__all__ = ["Amount", "amounts_of", "find_amounts", "stands_free"]

#: Words between the ends of a range, or between two amounts to choose from.
_ALTERNATIVES = frozenset("to or till until through thru - versus".split())
#: Words between two numbers that form one expression, or between two amounts that belong together.
_ARITHMETIC = frozenset("/ by x * times plus minus of".split())
_JOINTS = _ALTERNATIVES | _ARITHMETIC | frozenset("and , . ; : out".split())
#: Words before an amount that negate it, make it a bound, or make it only a part of the meant amount.
_BEFORE = frozenset(
    "not no never n't without except but than least most under over below above within between beyond maximum max "
    "minimum minus plus negative double twice thrice triple point per every each".split()
)
_BOUNDS_BEFORE = frozenset(
    [
        ("up", "to"),
        ("at", "least"),
        ("at", "most"),
        ("maximum", "of"),
        ("minimum", "of"),
        ("out", "of"),
        ("percent", "of"),
    ]
)
#: Words after an amount that change it.
_BEHIND = frozenset("percent % per max maximum minimum tops plus minus times squared cubed o'clock ish".split())
#: Words between a length and the time that it takes: "two metres a second".
_PER = {"per"} | word_class("indefinite_articles") | word_class("determiners_of_all")
#: Phrases after an amount that change it: "two metres or more", "two metres and a bit".
_MORE_BEHIND = tuple(
    tuple(words.split())
    for words in (
        "or more,or less,or fewer,or over,or under,and more,and a bit,and a little,and something,and change,at least,"
        "at most,at the most,at the least"
    ).split(",")
)
#: Words of a bound that includes the amount: "at least two metres", "two metres or more". The speaker may mean it.
_KEPT = frozenset("least most at up to the or more less fewer of maximum max minimum tops".split())
#: Words of such a bound around a comparative: "no further than two metres".
_NO_MORE_THAN = frozenset(["no", "than"])
#: Words before an amount that do not change it.
_AROUND = frozenset(
    "about almost around roughly approximately nearly exactly precisely just some even only another".split()
) | word_class("hedges")
#: Marks that may touch an amount.
_MARKS = frozenset(". , ! ? ; : ) ( [ ] \" ' …".split())
#: Words that are units even without a number before them.
_ONLY_UNITS = frozenset(
    "metres meters centimetres centimeters millimetres millimeters kilometres kilometers cm mm km inches yards miles "
    "degrees degree radians radian feet miles turns revolutions rotations".split()
)
#: A number and what is written on it: "30xyz"; not a time or a range.
_WRITTEN_ON = re.compile(r"\d[\d.,]*[^\d\s.,:-][^\s:-]*")
#: Prepositions before an amount: "wait *for* two minutes", "turn *by* ten degrees".
_OF_AMOUNTS = frozenset(["for", "by", "of"])
_IN_NAMES = frozenset(["compound", "flat", "nummod", "appos", "nmod", "nmod:unmarked", "amod"])


def find_amounts(tree: DependencyTree, positions: Sequence[int]) -> Tuple[Amount, ...]:
    """Find the amounts among some words.

    Args:
        tree: the sentence
        positions: positions of the words to search
    Returns:
        amounts that do not overlap, in order. They include infinite amounts and doubtful ones: words that name one or
        more amounts but cannot be read as a whole. A number that counts things ("two eggs") is not an amount
    """
    spoken = sorted(index for index in positions if index not in tree.abandoned)
    amounts = list(read_amounts(tree, spoken))
    units = [index for index in spoken if _is_lone_unit(tree, index, amounts) or _is_unreadable(tree, index, amounts)]
    amounts = sorted(amounts + [_doubtful((index,), tree) for index in units], key=lambda one: one.positions)
    amounts = _joined(tree, spoken, _with_speeds(tree, spoken, amounts))
    taken = frozenset(index for amount in amounts for index in amount.positions)
    amounts = [_beside(tree, spoken, amount, taken) for amount in amounts]
    return tuple(amount for amount in amounts if amount.is_doubtful or not counts_things(tree, amount))


def amounts_of(tree: DependencyTree, positions: AbstractSet[int], verb: int) -> Tuple[Amount, ...]:
    """Find the amounts of a clause; the words of neighbouring clauses count as well.

    Args:
        tree: the sentence
        positions: positions of the words of the clause
        verb: verb of the clause; it may be the unit ("half a turn to the left")
    Returns:
        amounts as from :func:`find_amounts`; an amount that crosses the bounds of the clause is doubtful
    """
    spoken = [word.index for word in tree.words if word.index not in tree.quoted]
    found = []
    for amount in find_amounts(tree, spoken):
        inside = positions & frozenset(amount.positions)
        if inside - {verb}:
            is_whole = len(inside) == len(amount.positions) and (verb not in inside or verb == amount.unit_position)
            found.append(amount if is_whole else replace(amount, is_doubtful=True, amount=math.nan))
    return tuple(found)


def _with_speeds(tree: DependencyTree, spoken: Sequence[int], amounts: Sequence[Amount]) -> List[Amount]:
    """Read a length and the time that it takes as one speed: "half a metre per second", "two metres a second"."""
    found: List[Amount] = []
    for amount in amounts:
        if any(amount.positions[0] in speed.positions for speed in found):
            continue
        behind = [index for index in spoken if index > amount.positions[-1]][:2]
        is_length = amount.quantity == "length" and bool(amount.unit) and not amount.is_doubtful
        joint = tree.word(behind[0]).said if len(behind) == 2 else ""
        time = find_unit(tree.word(behind[1]).form) if is_length and joint in _PER else None
        is_next = len(behind) == 2 and behind == [amount.positions[-1] + 1, amount.positions[-1] + 2]
        if time is not None and time.quantity == "duration" and is_next:
            positions = (*amount.positions, *behind)
            amount = replace(
                amount,
                positions=positions,
                unit=tree.text_of(range(amount.unit_position, behind[1] + 1)),
                quantity="speed",
                si_amount=amount.si_amount / time.si_factor,
            )
        found.append(amount)
    return found


def _doubtful(
    positions: Iterable[int], tree: DependencyTree, parts: Sequence[Amount] = (), ends: Tuple[Tuple[int, ...], ...] = ()
) -> Amount:
    """Return one doubtful amount for words that name one or several amounts."""
    measured = [part for part in parts if part.unit]
    last = max(positions)
    unit = find_unit(tree.word(last).form)
    return Amount(
        positions=tuple(sorted(positions)),
        amount=math.nan,
        unit=measured[-1].unit if measured else tree.word(last).form if unit and not parts else "",
        quantity=measured[-1].quantity if measured else unit.quantity if unit and not parts else "number",
        si_amount=math.nan,
        numeral=tree.text_of(sorted(positions)),
        is_doubtful=True,
        ends=ends,
        is_of_noun=any(part.is_of_noun or counts_things(tree, part) for part in parts),
    )


def _is_lone_unit(tree: DependencyTree, index: int, amounts: Sequence[Amount]) -> bool:
    """Whether a word is a unit whose number could not be read: "umpteen degrees"; "the degrees" is not an amount."""
    word = tree.word(index)
    before = tree.word(index - 1) if index > 1 else None
    is_of_something = before is not None and before.deprel in ("det", "nmod:poss") and before.head == index
    is_of_something = is_of_something and before is not None and before.said not in ("a", "an")
    is_free = index not in tree.fillers and all(index not in amount.positions for amount in amounts)
    return is_free and word.upos not in ("VERB", "ADJ") and not is_of_something and word.said in _ONLY_UNITS


def _is_unreadable(tree: DependencyTree, index: int, amounts: Sequence[Amount]) -> bool:
    """Whether a word is a number with something written on it that is no unit, and stands where an amount may: "wait
    for *30xyz*"; "room 12b" and "the 7up" are names."""
    form = tree.word(index).form
    is_taken = index in tree.fillers or any(index in amount.positions for amount in amounts)
    return (
        not is_taken and _WRITTEN_ON.fullmatch(form) is not None and is_number(tree, index) and stands_free(tree, index)
    )


def stands_free(tree: DependencyTree, index: int) -> bool:
    """Whether a number stands where an amount may: it names no noun, and has no determiner and no preposition of a
    place."""
    children = tree.children(index)
    has_case = any(child.deprel == "case" and child.said not in _OF_AMOUNTS for child in children)
    has_more = any(child.deprel in ("det", "nmod:poss", "amod", "compound") for child in children)
    return not has_case and not has_more and tree.word(index).deprel not in _IN_NAMES


def _joined(tree: DependencyTree, spoken: Sequence[int], amounts: Sequence[Amount]) -> List[Amount]:
    """Merge amounts that form one expression into one doubtful amount."""
    done: List[Amount] = []
    for amount in amounts:
        if done:
            between = [index for index in spoken if done[-1].positions[-1] < index < amount.positions[0]]
            joint = _joint(tree, between)
            is_one = joint is not None and _are_one(tree, done[-1], amount, joint)
            if is_one or _counts(tree, done[-1], amount):
                done[-1] = _one(tree, spoken, done[-1], amount, joint or (), between)
                continue
        done.append(amount)
    return done


def _joint(tree: DependencyTree, between: Sequence[int]) -> Optional[Tuple[str, ...]]:
    """Return the words that join two amounts; None if other words separate them."""
    forms = tuple(tree.word(index).said for index in _without_hedges(tree, between))
    if all(form in _JOINTS for form in forms):
        return forms
    are_of_the_unit = all(tree.word(index).upos == "ADJ" for index in between)
    return ("adj",) if are_of_the_unit else None


def _are_one(tree: DependencyTree, first: Amount, second: Amount, joint: Tuple[str, ...]) -> bool:
    """Whether two amounts form one expression, not two separate amounts in a row."""
    if joint == ("adj",):
        # "Two big metres": the adjective kept the unit from being read with its number.
        return not first.unit and second.is_doubtful and len(second.positions) == 1
    if not second.unit and is_iteration(tree, second.positions[-1]):
        return False
    is_of_things = not second.unit and (counts_things(tree, second) or second.is_of_noun)
    if is_of_things and joint in ((",",), ("and",), ("to",)):
        return False
    if not first.unit or not second.unit or first.quantity == second.quantity:
        return True
    # "Two metres 90 degrees" are two amounts; "two metres a second" is a speed.
    first_word = tree.word(second.positions[0]).said
    if joint == ():
        return first_word in ("minus", "plus", "negative", "-", "+", "a", "an")
    return bool(set(joint) & (_ALTERNATIVES | _ARITHMETIC))


def _one(
    tree: DependencyTree,
    spoken: Sequence[int],
    first: Amount,
    second: Amount,
    joint: Tuple[str, ...],
    between: Sequence[int],
) -> Amount:
    before = [index for index in spoken if index < first.positions[0]][-1:]
    opening = [index for index in before if tree.word(index).said in ("between", "from")]
    is_between = joint == ("and",) and bool(opening) and tree.word(opening[0]).said == "between"
    is_choice = (len(joint) == 1 and joint[0] in _ALTERNATIVES) or is_between
    # In "two or three metres", both numbers share the unit; in "a metre or two", the unit has the wrong place for that.
    shared = (second.unit_position,) if second.unit and not first.unit else ()
    is_choice = is_choice and bool(first.unit) <= bool(second.unit) and not (first.is_doubtful or second.is_doubtful)
    ends = (first.positions + shared, second.positions) if is_choice else ()
    positions = [*opening, *first.positions, *between, *second.positions]
    return _doubtful(positions, tree, (first, second), ends)


def _beside(tree: DependencyTree, spoken: Sequence[int], amount: Amount, taken: AbstractSet[int]) -> Amount:
    """Return an amount, as doubtful if the words beside it change it; "between two chairs" changes no amount."""
    following = tree.word(amount.positions[-1]).head
    if counts_things(tree, amount) and tree.word(following).said not in _BEHIND:
        return amount
    before = [index for index in spoken if index < amount.positions[0]]
    behind = [index for index in spoken if index > amount.positions[-1]]
    changing = _changing_before(tree, before[::-1], amount) | _changing_behind(tree, behind, amount)
    if not changing - taken:
        return amount
    # If a range is negated or bounded, the speaker means neither of its ends.
    forms = {tree.word(index).said for index in changing}
    is_kept = (forms <= _KEPT or forms >= _NO_MORE_THAN) and not amount.is_doubtful
    ends = (amount.positions,) if is_kept else ()
    return _doubtful(changing | frozenset(amount.positions), tree, [amount], ends)


def _changing_before(tree: DependencyTree, before: Sequence[int], amount: Amount) -> FrozenSet[int]:
    """Return the words before an amount that change it; ``before`` is in reverse order."""
    if before and _is_written_on(tree, before[0], amount.positions[0], before[0]):
        return frozenset([before[0]])
    said = _without_hedges(tree, before)
    if not said or not _is_close(tree, said[0], before, amount.positions[0]):
        return frozenset()
    word = tree.word(said[0])
    form = word.said
    before_it = tree.word(said[1]).said if len(said) > 1 else ""
    if (before_it, form) in _BOUNDS_BEFORE:
        return frozenset(said[:2])
    if {tree.word(index).said for index in said[:3]} >= _NO_MORE_THAN:
        return frozenset(said[:3])
    is_a_noun = form == "point" and any(child.deprel == "det" for child in tree.children(word.index))
    if (form in _BEFORE and not is_a_noun) or is_number(tree, word.index) or _is_mark_of_arithmetic(word.form):
        return frozenset(said[:1])
    is_numeral = word.upos in ("NUM", "SYM") and word.form not in _MARKS
    return frozenset(said[:1]) if is_numeral else frozenset()


def _changing_behind(tree: DependencyTree, behind: Sequence[int], amount: Amount) -> FrozenSet[int]:
    """Return the words after an amount that change it."""
    last = amount.positions[-1]
    if behind and _is_written_on(tree, last, behind[0], behind[0]):
        return frozenset([behind[0]])
    said = [index for index in behind if index not in tree.fillers]
    if not said or not _is_close(tree, last, behind, said[0]):
        return frozenset()
    word = tree.word(said[0])
    form = word.said
    if not amount.unit and _counts_units(tree, last):
        return frozenset([tree.word(last).head])
    is_counted = counts_things(tree, amount) or is_iteration(tree, last)
    forms = tuple(tree.word(index).said for index in said[:3])
    for more in _MORE_BEHIND:
        if forms[: len(more)] == more:
            return frozenset(said[: len(more)])
    if is_number(tree, word.index) or (form in _BEHIND and (amount.unit or not is_counted)):
        return frozenset(said[:1])
    if not amount.unit and word.upos != "VERB" and find_unit(form) and unit_at(tree, word.index):
        return frozenset(said[:1])
    return frozenset(said[:1]) if word.upos == "SYM" and word.form not in _MARKS else frozenset()


def _counts(tree: DependencyTree, first: Amount, second: Amount) -> bool:
    """Whether a number counts the unit of another amount, separated from it: "two left turns"."""
    word = tree.word(first.positions[-1])
    return not first.unit and word.deprel == "nummod" and word.head in second.positions


def _counts_units(tree: DependencyTree, index: int) -> bool:
    """Whether a number counts a later word that is a unit in this context: "one left turn"."""
    word = tree.word(index)
    return word.deprel == "nummod" and word.head > index and unit_at(tree, word.head) is not None


def _without_hedges(tree: DependencyTree, positions: Sequence[int]) -> List[int]:
    return [
        index
        for index in positions
        if index not in tree.fillers and tree.word(index).said not in _AROUND | {"oh", "a", "an", "the"}
    ]


def _is_close(tree: DependencyTree, first: int, between: Sequence[int], second: int) -> bool:
    """Whether only abandoned words and words in ``between`` stand between a word and an amount."""
    seen = set(between)
    return all(index in seen or index in tree.abandoned for index in range(min(first, second) + 1, max(first, second)))


def _is_mark_of_arithmetic(form: str) -> bool:
    return form in ("-", "/", "+", "*", "=", "±", "~", "#", "$", "x")


def _is_written_on(tree: DependencyTree, first: int, second: int, other: int) -> bool:
    """Whether a word touches an amount without a blank: "e" in "e5", "-ish" in "45-ish"."""
    form = tree.word(other).form
    return tree.is_glued(first, second) and form not in _MARKS and not form.startswith(("'", "’"))
