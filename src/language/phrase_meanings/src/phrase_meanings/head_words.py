"""Reads the words around the head of a phrase: how many things it names, and which properties they have."""

import re
from dataclasses import dataclass
from typing import FrozenSet, Iterable, List, Optional, Tuple

from phrase_meanings.meaning_file import measure_of, shipped_meanings
from spoken_quantities import find_whole_number
from typed_arguments import Modifier
from utterance_passes.phrases.amounts import read_amounts
from utterance_passes.trees.tree import NOUNS, QUOTED, DependencyTree, Word
from word_classes import word_class, word_list

#: Heads that stand for a kind of thing that was said before: "the red one".
ONES = word_class("noun_standins")
_ORDINAL_IN_DIGITS = re.compile(r"(\d{1,3})[nrst][dht]")
#: Nouns that stand for a number: "a couple of beers".
_COUPLES = frozenset(["couple"])
_LAST = word_class("last_ordinals")
_NEGATIONS = word_class("negations")
_PLACE_PREPOSITIONS = word_class("place_prepositions")
_POSTURES = word_class("posture_verbs")
_PRESENT_TENSE = frozenset(["VBP", "VBZ"])
_SIDES = word_class("sides")
#: Ordinal words in their order, from 1.
_ORDINALS = word_list("ordinals")


@dataclass(frozen=True)
class Quantity:
    """How many things a phrase names."""

    quantifier: str = ""
    count: Optional[int] = None
    bound: str = ""


def is_plural(word: Word) -> bool:
    """Whether a noun is plural."""
    return "Number=Plur" in word.feats or word.xpos in ("NNS", "NNPS")


def is_side_of_something(tree: DependencyTree, index: int) -> bool:
    """Whether a word is a side of a thing and not a direction: "the left of the table"."""
    return tree.word(index).said in _SIDES and any(
        child.deprel.startswith("nmod") and any(inner.said == "of" for inner in tree.prepositions(child.index))
        for child in tree.children(index)
    )


def chosen_from(tree: DependencyTree, head: int, own: FrozenSet[int]) -> Optional[Tuple[Quantity, int]]:
    """Return the quantity and the noun of "all of the mugs" and "two of them"; None for other phrases."""
    word = tree.word(head)
    quantifier = shipped_meanings().quantifiers.get(word.said, "")
    count = _number(word.form) if word.upos == "NUM" else None
    is_couple = word.said in _COUPLES and any(child.said == "a" for child in tree.children(head))
    if is_couple:
        count = _number(f"a {word.said}")
    elif not (quantifier or count is not None) or word.upos in NOUNS:
        return None
    for child in tree.children(head):
        if child.deprel.startswith("nmod") and child.index in own and tree.preposition(child.index) == "of":
            return Quantity(quantifier, count), child.index
    return None


def quantity(tree: DependencyTree, head: int, children: Iterable[Word]) -> Quantity:
    """Return what the words before a head say of the number of things."""
    spoken = shipped_meanings().quantifiers
    # "Everything" is a quantifier and its noun in one word.
    form = tree.word(head).said
    quantifier = spoken[form] if form in spoken and tree.word(head).upos == "PRON" else ""
    count, bound = None, ""
    for child in children:
        form = child.said
        if child.deprel in ("det", "det:predet", "amod") and form in spoken:
            asked = any(inner.said == "how" for inner in tree.children(child.index))
            named = f"how_{form}" if asked else spoken[form]
            # "All the mugs" are all, "a few mugs" are few.
            quantifier = named if quantifier in ("", "the", "a") else quantifier
        elif child.deprel == "nummod" and child.index < head:
            count = _count(tree, child)
            bound = _bound(tree, child)
    if count is None:
        count = {"both": 2, "no": 0}.get(quantifier)
    return Quantity(quantifier, count, bound)


def _count(tree: DependencyTree, numeral: Word) -> Optional[int]:
    amounts = read_amounts(tree, sorted(tree.subtree(numeral.index)))
    number = amounts[-1].amount if amounts else None
    return int(number) if number is not None and 0 <= number < 2**31 and number == int(number) else None


def _number(form: str) -> Optional[int]:
    number = find_whole_number(form)
    return number if number is not None and 0 <= number < 2**31 else None


def _bound(tree: DependencyTree, numeral: Word) -> str:
    inside = sorted(index for index in tree.subtree(numeral.index) if index < numeral.index)
    first = numeral.index - 1
    before = [tree.word(index).said for index in (inside or ([first] if first > 0 else []))]
    return shipped_meanings().bound(before)


def located_there(tree: DependencyTree, clause: Word) -> int:
    """Return who or what is at the place that a clause describes: "the room *where Anna is*", "the room *Anna is in*".

    Returns:
        the position of the subject; 0 if the clause says something else
    """
    children = tree.children(clause.index)
    subjects = [child.index for child in children if child.deprel == "nsubj"]
    forms = {clause.said, *(child.said for child in children if child.deprel == "advmod")}
    helping = [child.xpos for child in children if child.deprel in ("cop", "aux")]
    is_posture = clause.lemma.lower() in _POSTURES and (bool(helping) or clause.xpos in _PRESENT_TENSE)
    is_there = is_posture or any(child.deprel == "cop" for child in children)
    # Where somebody was, or is not, is another place.
    is_now = all(tag in _PRESENT_TENSE for tag in helping) and not forms & _NEGATIONS
    is_place = "where" in forms or clause.said in _PLACE_PREPOSITIONS
    return subjects[0] if len(subjects) == 1 and is_there and is_now and is_place else 0


def shares_noun(tree: DependencyTree, member: int, head: int) -> bool:
    """Whether a member of a list has no noun but that of the head behind it: "*the red* and the blue cup"."""
    word = tree.word(member)
    return member < head and word.deprel == "conj" and word.upos == "ADJ"


def modifiers(tree: DependencyTree, head: int, children: Iterable[Word], own: FrozenSet[int]) -> Tuple[Modifier, ...]:
    """Return the properties that words of the phrase give to its head."""
    found: List[Modifier] = []
    for child in children:
        form = child.said
        base = child.deprel.split(":")[0]
        kind, number = "", 0
        if base == "appos" and form in ONES:
            # "The mug, the small one" is a small mug.
            found += modifiers(tree, child.index, tree.children(child.index), own)
            continue
        if base in ("amod", "nummod") and _ordinal(form):
            kind, number = "ordinal", _ordinal(form)
        elif base == "amod" and form not in shipped_meanings().quantifiers:
            kind = _kind_of_adjective(child)
        elif base == "compound" and child.index < head:
            kind = "compound"
        elif (
            child.deprel != QUOTED
            and child.index > head
            and (base in ("flat", "compound", "appos") or (base == "nummod" and child.index == head + 1))
        ):
            kind, number = "name", _number(form) or 0
        elif base == "advmod" and child.index < head and child.upos == "ADV" and form not in _NEGATIONS:
            kind = "adverb"
        if not kind:
            continue
        degree = next(
            (inner.said for inner in tree.children(child.index) if inner.deprel == "advmod" and inner.index in own),
            "",
        )
        if kind in ("adjective", "comparative", "superlative"):
            # "The big red mug" is big and red, however deep the parser hangs one below the other.
            found += [
                Modifier("adjective", inner.form, inner.lemma.lower(), position=inner.index)
                for inner in tree.children(child.index)
                if inner.deprel in ("amod", "conj") and inner.upos == "ADJ" and inner.index in own
            ]
        found.append(Modifier(kind, child.form, child.lemma.lower(), degree, number, child.index))
    return tuple(sorted(found, key=lambda modifier: modifier.position))


def property_alone(word: Word) -> Optional[Modifier]:
    """Return the property that an adjective without a noun names: "the *smallest*"; None for another word."""
    form, lemma = word.said, word.lemma.lower()
    # The parser takes some of them for nouns.
    if word.upos != "ADJ" and not is_superlative(word):
        return None
    number = _ordinal(form)
    kind = "ordinal" if number else _kind_of_adjective(word)
    return Modifier(kind, word.form, lemma, number=number, position=word.index)


def is_superlative(word: Word) -> bool:
    """Whether a word asks for the most of something; the parser takes "nearest" for an adjective in its base form."""
    form = word.said
    return word.xpos == "JJS" or (form.endswith("est") and bool(measure_of(form)))


def _kind_of_adjective(word: Word) -> str:
    if is_superlative(word):
        return "superlative"
    return "comparative" if word.xpos == "JJR" else "adjective"


def _ordinal(form: str) -> int:
    """Return the number of an ordinal, -1 for the last; 0 for another word."""
    if form in _LAST:
        return -1
    if form in _ORDINALS:
        return _ORDINALS.index(form) + 1
    digits = _ORDINAL_IN_DIGITS.fullmatch(form)
    return int(digits.group(1)) if digits else 0
