"""Rewrites words that a speaker says again with more precision, before the parse.

"Turn left turn left thirty degrees" is one turn, and "two beers, one for me and one for Dave" are two beers in all.
"""

import re
from typing import List

from semantic_types.parts_of_speech import ADJECTIVE, NOUN, parts_of_speech
from spoken_quantities import find_number, find_whole_number, number_words
from utterance_passes.engine.utterance_pass import Example, Kind, text_pass, word_pass
from utterance_passes.trees.formula_file import any_of, shipped_formulas
from utterance_passes.trees.spelling import Spelling
from utterance_passes.trees.vocabulary import Verbs
from word_classes import word_class

_SAID = re.compile(r"[\w']+")
_NUMBER = f"(?:\\d+|{'|'.join(number_words())})"
#: A number of things, and how many of them each person or place gets.
_ALL = re.compile(
    rf"\b(?P<all>a couple of|{_NUMBER}) (?P<things>[a-z]+(?: [a-z]+){{0,2}}), (?P<shares>{_NUMBER} .+)", re.IGNORECASE
)
_BEHIND = "|".join(sorted(word_class("place_prepositions") | word_class("to_prepositions") | {"for"}))
_SHARE = re.compile(rf"(?:^|(?<=, )|(?<=and ))(?P<number>{_NUMBER})(?= (?:{_BEHIND})\b)", re.IGNORECASE)
_DETERMINER = "|".join(sorted(word_class("determiners_and_possessives")))
_FILLER = any_of(shipped_formulas()["fillers"]).pattern
_BROKEN_PHRASE = re.compile(
    rf"\b(?P<article>{_DETERMINER}) (?P<property>\w+),? (?:{_FILLER}),? (?P<again>(?P=article) \w+)", re.IGNORECASE
)
_BORDERS = frozenset([",", ".", "!", "?", ";", ":"])
_JOINING = word_class("clause_borders")
_SAYING = word_class("saying_verbs")


@text_pass(
    Kind.MEANING, Example("bring two cups, one for me and one for Bob", ("bring one cup for me and one cup for Bob",))
)
def shares(spelling: Spelling) -> Spelling:
    """Name the things in each share: "two beers, one for me and one for Dave" becomes "one beer for me and one beer for
    Dave". The shares must be all of the things.
    """
    match = _ALL.search(spelling.text)
    if match is None:
        return spelling
    total = find_whole_number("two" if match.group("all").lower() == "a couple of" else match.group("all"))
    shares = list(_SHARE.finditer(match.group("shares")))
    counts = [find_whole_number(share.group("number")) or 0 for share in shares]
    if len(shares) < 2 or shares[0].start() or sum(counts) != total:
        return spelling
    first, offset = match.start(), match.start("shares")
    text, origins = spelling.text[:first], list(spelling.origins[:first])
    position = offset
    for share, count in zip(shares, counts):
        end = offset + share.end()
        named = " " + (_singular(match.group("things")) if count == 1 else match.group("things"))
        text += spelling.text[position:end] + named
        origins += [*spelling.origins[position:end], *[spelling.origins[end]] * len(named)]
        position = end
    return Spelling(text + spelling.text[position:], (*origins, *spelling.origins[position:]))


@text_pass(Kind.DISFLUENCY, Example("bring the blue, uh, the green cup", ("bring the green cup",)))
def half_phrases(spelling: Spelling) -> Spelling:
    """Remove a phrase that breaks off before its noun when it is begun again behind a filler: "the blue, uh, *the green
    mug*"."""
    for match in _BROKEN_PHRASE.finditer(spelling.text):
        if ADJECTIVE in parts_of_speech(match.group("property").lower()):
            return spelling.without(match.start(), match.start("again"))
    return spelling


def _singular(things: str) -> str:
    """Return a noun phrase for one of some things: "red cups" becomes "red cup"."""
    ends = (("ies", "y"), ("ses", "s"), ("shes", "sh"), ("ches", "ch"), ("xes", "x"), ("s", ""))
    bases = (things[: -len(end)] + base for end, base in ends if things.endswith(end))
    return next((base for base in bases if NOUN in parts_of_speech(base.split()[-1])), things)


@word_pass(
    Kind.DISFLUENCY, Example("turn left turn left two degrees", ("turn left two degrees",), Verbs(frozenset(["turn"])))
)
def less_precise(spelling: Spelling, vocabulary: Verbs) -> Spelling:
    """Remove a command that the speaker says again at once, with an amount: "turn left *turn left thirty degrees*".

    Nothing stands between both, and the second has all words of the first in their order.
    """
    words = list(_SAID.finditer(spelling.text))
    forms = [word.group().lower() for word in words]
    if _SAYING & frozenset(forms):
        return spelling
    for second in range(1, len(forms)):
        first = next((at for at in range(second - 1, -1, -1) if forms[at] == forms[second]), None)
        if first is None or forms[first] not in vocabulary.words or second - first < 2:
            continue
        before = spelling.text[words[first].start() : words[second].start()]
        end = _end_of_command(spelling.text, words, second)
        said, again = forms[first:second], forms[second:end]
        if _BORDERS & frozenset(before) or _JOINING & frozenset(said) or not _is_in_order(said, again):
            continue
        if any(find_number(form) is not None for form in said) or all(find_number(form) is None for form in again):
            continue
        return spelling.without(words[first].start(), words[second].start())
    return spelling


def _end_of_command(text: str, words: List["re.Match[str]"], first: int) -> int:
    """Return the place behind the last word of a command that begins at a place among the words."""
    for place in range(first + 1, len(words)):
        between = text[words[place - 1].end() : words[place].start()]
        if _BORDERS & frozenset(between) or words[place].group().lower() in _JOINING:
            return place
    return len(words)


def _is_in_order(some: List[str], of: List[str]) -> bool:
    """Whether words occur among others in the same order."""
    left = iter(of)
    return len(some) < len(of) and all(word in left for word in some)
