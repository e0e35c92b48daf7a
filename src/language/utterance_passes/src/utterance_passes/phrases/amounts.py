"""Finds amounts in the words of a sentence, not in its tree: the parser attaches the same words in many ways.

An amount is read from the characters as they were said: the hyphen joins words in "forty-five", is a sign in "-2", and
is neither in "2 - 3". A word beside an amount that changes it, but was not read, makes it doubtful
(:mod:`utterance_passes.phrases.measures`).
"""

import math
import re
from dataclasses import dataclass
from typing import List, Optional, Sequence, Tuple

from spoken_quantities import QuantityError, Unit, find_unit, number_words, parse_measure, parse_number
from utterance_passes.trees.tree import NOUNS, DependencyTree
from word_classes import word_class

#: The most words of an amount ("one hundred and twenty - five and a half feet and six inches").
LONGEST = 16
#: Alone, these words are places in a row ("the third door"); after an article or a number, they are shares ("a third").
_ORDINALS = frozenset("third fourth fifth sixth seventh eighth ninth tenth".split())
#: Words that people say inside a number: "one oh five", "two point five".
_EMPHASIS = frozenset("full whole complete entire more further additional extra".split())
_INSIDE = frozenset("a an and of oh point - / , .".split()) | _EMPHASIS
#: Words that can begin a number.
SIGNS = frozenset(["minus", "negative", "plus"])
_NUMBER_WORDS = frozenset(number_words()) - _INSIDE - SIGNS
_PLACE_IN_ROW = re.compile(r"\d+(st|nd|rd|th)")
_ARTICLES = frozenset(["a", "an"])
_FRACTION = re.compile(r"half|halves|quarters?|thirds?|fourths?|fifths?|eighths?|\d\s*/\s*\d")
_DIRECTIONS = word_class("all_directions")
#: Units that can also be verbs: "turn left ninety turn right" has no unit.
_TURNS = frozenset(["turn", "circle"])

#: "Another metre" is one metre.
ANOTHER = "another"
_MAY_BE_INSIDE = _INSIDE | SIGNS | _ORDINALS | {ANOTHER, "couple", "few", "+"}
_ONE = (["a"], ["an"], [ANOTHER])


@dataclass(frozen=True)
class Amount:
    """A number in a tree, and its unit if one was said.

    Attributes:
        positions: positions of its words, including the unit
        amount: the number; NaN if the amount is doubtful
        unit: the unit as it was said, "feet"; empty for a bare number
        quantity: length, angle, duration or number
        si_amount: the amount in metres, radians or seconds, or the bare number
        numeral: the number as it was said, "minus two"
        unit_position: position of the unit; 0 if there is none
        is_doubtful: whether the words say more than the amount that was read; the robot must not act on it
        ends: for a doubtful amount, the words of each amount that a person can choose: "two or three metres"
        is_of_noun: whether it names the noun before it, replaces a noun, or says how often: "room 5", "the next
            one", "5 times"
        is_assumed: whether the words have no number, and the amount is a stated default: "a bit"
    """

    positions: Tuple[int, ...]
    amount: float
    unit: str
    quantity: str
    si_amount: float
    numeral: str
    unit_position: int = 0
    is_doubtful: bool = False
    ends: Tuple[Tuple[int, ...], ...] = ()
    is_of_noun: bool = False
    is_assumed: bool = False

    def digits(self) -> str:
        """Return the number in digits, without needless zeros; a number that is not finite stays as it was said."""
        return f"{self.amount:.12g}" if math.isfinite(self.amount) else self.numeral

    @property
    def is_share(self) -> bool:
        """Whether it is a fraction of something that nobody named: "half"."""
        return not self.unit and _FRACTION.search(self.numeral.lower()) is not None


def read_amounts(tree: DependencyTree, spoken: Sequence[int]) -> Tuple[Amount, ...]:
    """Read the amounts among some words; ignore the words beside them.

    Args:
        tree: the sentence
        spoken: positions of the words to search, in order
    Returns:
        amounts that do not overlap; where they could overlap, the longest wins; infinite amounts are included
    """
    found: List[Amount] = []
    start = 0
    while start < len(spoken):
        amount = None
        for length in range(_longest_window(tree, spoken, start), 0, -1):
            amount = _amount(tree, spoken[start : start + length])
            if amount is not None:
                break
        if amount is None:
            start += 1
        else:
            found.append(amount)
            start += len(amount.positions)
    return tuple(found)


def _longest_window(tree: DependencyTree, spoken: Sequence[int], start: int) -> int:
    """Return the number of consecutive words, from a start, that can be part of an amount."""
    length = 0
    while (
        start + length < len(spoken)
        and length < LONGEST
        and (not length or is_beside(tree, spoken[start + length - 1], spoken[start + length]))
        and (_may_be_inside(tree, spoken[start + length]) or unit_at(tree, spoken[start + length]))
    ):
        length += 1
    return length


def is_beside(tree: DependencyTree, first: int, second: int) -> bool:
    """Whether only abandoned words stand between two words."""
    return all(index in tree.abandoned for index in range(first + 1, second))


def counts_things(tree: DependencyTree, amount: Amount) -> bool:
    """Whether a number precedes the noun that it counts: "two eggs"; "to three left" counts nothing."""
    numeral = tree.word(amount.positions[-1])
    noun = tree.governor(numeral)
    between = [tree.word(index) for index in range(numeral.index + 1, noun.index)]
    is_counted = numeral.deprel == "nummod" and noun.index > numeral.index and noun.upos in NOUNS
    is_next = all(word.upos in ("ADJ", "NOUN", "PROPN") for word in between)
    is_thing = noun.lemma.lower() != "time" and noun.said not in _DIRECTIONS
    return is_counted and is_next and not amount.unit and not find_unit(noun.form) and is_thing


def is_number(tree: DependencyTree, index: int) -> bool:
    """Whether a word is a number, or a part of one that has no other meaning (unlike articles, "and" and signs)."""
    word = tree.word(index)
    form = word.said
    before = tree.word(index - 1).said if index > 1 else ""
    if form in _ORDINALS or form in ("couple", "few"):
        return before in _ARTICLES | {"one", "-"}
    if form == "one":
        return word.upos == "NUM" or _begins_range(tree, index)
    if _PLACE_IN_ROW.fullmatch(form):
        return False
    parts = form.split("-") if form != "-" else [form]
    return form[:1].isdigit() or (form[1:2].isdigit() and form[0] in ".+-") or all(p in _NUMBER_WORDS for p in parts)


def _begins_range(tree: DependencyTree, index: int) -> bool:
    """Whether "one" is the first of two numbers: "one to about three radians"; "the red one" is a thing."""
    following = [word for word in tree.words[index : index + 3] if word.upos != "ADV"]
    is_joined = bool(following) and following[0].said in ("to", "or")
    is_alone = not any(child.deprel in ("det", "amod") for child in tree.children(index))
    return is_alone and is_joined and len(following) > 1 and following[1].upos == "NUM"


def unit_at(tree: DependencyTree, index: int) -> Optional[Unit]:
    """Return the unit that a word names; None if it names none here: "in" and "second" have other uses too."""
    word = tree.word(index)
    unit = find_unit(word.form)
    if unit is None:
        return None
    if word.said == "in" and word.deprel == "case" and word.head > index:
        # "70 in backwards" means inches; "two in the hall" does not.
        is_glued_on = index > 1 and tree.is_glued(index - 1, index)
        return unit if is_glued_on or tree.governor(word).upos == "ADV" else None
    if unit.name == "second" and word.upos == "ADJ":
        return None
    if unit.is_assumed and (word.upos != "NOUN" or _is_place(tree, word.index)):
        # "Step back", "the book on two steps".
        return None
    if word.form in ("'", '"'):
        marks = sum(1 for other in tree.words[: index - 1] if other.form == word.form)
        return unit if index > 1 and tree.is_glued(index - 1, index) and marks % 2 == 0 else None
    return unit


def _is_place(tree: DependencyTree, index: int) -> bool:
    """Whether a noun has a preposition or a determiner that no amount has: "on a step", "the three steps"."""
    children = tree.children(index)
    has_place = any(child.deprel == "case" and child.said not in ("by", "of") for child in children)
    return has_place or any(child.deprel == "det" and child.said not in _ARTICLES for child in children)


def _may_be_inside(tree: DependencyTree, index: int) -> bool:
    return tree.word(index).said in _MAY_BE_INSIDE or is_number(tree, index)


def _amount(tree: DependencyTree, window: Sequence[int]) -> Optional[Amount]:
    """Read all of some words as one amount."""
    forms = [tree.word(index).said for index in window]
    if not _is_written_so(tree, window, forms):
        return None
    unit = unit_at(tree, window[-1]) if len(window) > 1 else None
    numeral = window[:-1] if unit else window
    if any(unit_at(tree, index) and not is_number(tree, index) for index in numeral):
        return _sum(tree, window)
    is_one = unit is not None and [form for form in forms[:-1] if form not in SIGNS | _EMPHASIS] in _ONE
    if ANOTHER in forms and not is_one:
        return None
    if not is_one and not any(is_number(tree, index) for index in numeral):
        return None
    if forms[len(numeral) - 1] == "and" or (unit is None and forms[0] in _ARTICLES):
        return None
    spoken = _said(tree, numeral)
    try:
        if unit is None:
            number = parse_number(spoken)
            is_of_noun = _is_of_noun(tree, window[-1])
            return Amount(tuple(window), number, "", "number", number, spoken, is_of_noun=is_of_noun)
        said = _said(tree, window)
        measure = parse_measure(f"a{said[len(ANOTHER) :]}" if forms[0] == ANOTHER else said)
    except QuantityError as error:
        if error.code != "NOT_FINITE":
            return None
        return Amount(
            positions=tuple(window),
            amount=math.inf,
            unit=tree.word(window[-1]).form if unit else "",
            quantity=unit.quantity if unit else "number",
            si_amount=math.inf,
            numeral=spoken,
            unit_position=window[-1] if unit else 0,
        )
    if spoken.lower() in ("half", "quarter", "a", "an", ANOTHER) and forms[-1].endswith("s"):
        # "Quarter turns" and "a turns" do not say how many turns.
        return None
    turn = tree.word(window[-1])
    if turn.said in _TURNS and (measure.amount > 1.0 or (turn.upos == "VERB" and not _FRACTION.search(spoken))):
        return None
    return Amount(
        tuple(window), measure.amount, turn.form, measure.quantity, measure.si_amount, spoken, unit_position=window[-1]
    )


def _is_written_so(tree: DependencyTree, window: Sequence[int], forms: Sequence[str]) -> bool:
    """Whether the marks among some words are written as in a single number: "forty-five", "1,000", "-2"."""
    if forms[0] in ("and", "of", "oh", "/", ",", ".") or (forms[0] in SIGNS and len(forms) == 1):
        return False
    if forms[0] == "point" and _has_determiner(tree, window[0]):
        return False
    for number, form in enumerate(forms):
        before = number > 0 and tree.is_glued(window[number - 1], window[number])
        after = number + 1 < len(forms) and tree.is_glued(window[number], window[number + 1])
        if form in ("-", "+") and number == 0:
            # A dash between blanks is not a sign.
            is_free = window[0] == 1 or not tree.is_glued(window[0] - 1, window[0])
            if not (after and is_free):
                return False
        elif form in ("-", "+", ",", ".") and not (before and after):
            return False
    return True


def _has_determiner(tree: DependencyTree, index: int) -> bool:
    return any(child.deprel in ("det", "nmod:poss", "amod") for child in tree.children(index))


def _is_of_noun(tree: DependencyTree, index: int) -> bool:
    word = tree.word(index)
    noun = tree.governor(word)
    is_behind = noun.index < index and noun.upos in NOUNS
    is_name = (
        is_behind
        and not find_unit(noun.form)
        and word.deprel in ("nummod", "compound", "flat", "appos", "nmod:unmarked")
    )
    # "One left turn" is as many turns.
    is_count = word.deprel == "nummod" and noun.index > index
    return is_name or (word.said == "one" and not is_count) or is_iteration(tree, index)


def is_iteration(tree: DependencyTree, index: int) -> bool:
    """Whether a number says how often: "5 times"."""
    return index < len(tree.words) and tree.word(index + 1).said in ("time", "times")


def _said(tree: DependencyTree, window: Sequence[int]) -> str:
    """Return words as they were written, with a blank before a unit."""
    text = ""
    for number, index in enumerate(window):
        form = tree.word(index).form
        is_unit = unit_at(tree, index) is not None and not is_number(tree, index)
        if is_unit and text.endswith("-"):
            text = text[:-1]
        is_joined = number > 0 and tree.is_glued(window[number - 1], index) and not is_unit
        text += form if is_joined or not text else " " + form
    return text


def _sum(tree: DependencyTree, window: Sequence[int]) -> Optional[Amount]:
    """Return an amount in several units, such as "5 feet 6 inches", converted to its first unit."""
    first = tree.word(window[0]).said
    if not is_number(tree, window[0]) and first not in _ARTICLES | SIGNS | {"-"}:
        return None
    if not unit_at(tree, window[-1]) and window[-1] < len(tree.words):
        # "5 feet 6 times" and "2 metres 90 degrees" are two amounts.
        following = tree.word(window[-1] + 1)
        if find_unit(following.form) or following.upos in ("NOUN", "PROPN", "ADJ", "NUM"):
            return None
    said = _said(tree, window)
    try:
        measure = parse_measure(said)
    except QuantityError:
        return None
    position = next(index for index in window[1:] if unit_at(tree, index))
    unit = tree.word(position).form
    return Amount(tuple(window), measure.amount, unit, measure.quantity, measure.si_amount, said, position)
