"""The orders of words of a question inside other words: "I want to know where the mug is"."""

from typing import Iterator, List, Sequence, Tuple

from semantic_framer.kinds.question_words import length_in_front, phrases_of
from utterance_passes.trees.tree import Word
from word_classes import word_class

_OPENINGS = phrases_of("question_openings")
_BE = word_class("forms_of_be")
_INVERTED = _BE | word_class("forms_of_have")
_DO = word_class("forms_of_do")
_WHETHER = word_class("whether_words")
_ASKING = word_class("question_words")
#: "Is it true that the door is open."
_THAT = "that"
#: A question word and its noun have at most so many words: "in which of the rooms".
_LONGEST_FRONT = 4


def length_of_opening(forms: Sequence[str]) -> int:
    """Return the number of words in front of an indirect question: 4 for "i want to know"; 0 for none."""
    return length_in_front(_OPENINGS, forms)


def direct_orders(words: Sequence[Word]) -> Iterator[Tuple[Word, ...]]:
    """Yield the words of an indirect question in the orders that a direct one may have: "where the mug is" as it is,
    and "where is the mug".
    """
    for order in orders_of([word.said for word in words]):
        yield tuple(words[place] for place in order)


def orders_of(forms: Sequence[str]) -> Iterator[Tuple[int, ...]]:
    """Yield the places of the words of an indirect question, in lower case, in the orders of a direct one."""
    places = tuple(range(len(forms)))
    if not forms:
        return
    if forms[0] in _WHETHER or forms[0] == _THAT:
        verbs = [place for place, form in enumerate(forms) if form in _INVERTED | _DO]
        for place in verbs[:1]:
            yield _moved(places[1:], place - 1, 0)
        return
    yield places
    for place in range(2, len(forms)):
        if forms[place] in _BE and forms[place - 1] in ("there", "it"):
            yield _moved(places, place, place - 1)
    for place in range(len(forms) - 1, 1, -1):
        if forms[place] in _BE:
            for front in range(1, min(_LONGEST_FRONT, place) + 1):
                yield _moved(places, place, front)
    if forms[0] not in _ASKING:
        # "Do you think the door is open" leaves out "that".
        for place in [place for place, form in enumerate(forms) if place and form in _INVERTED][:1]:
            yield _moved(places, place, 0)


def _moved(places: Sequence[int], place: int, to: int) -> Tuple[int, ...]:
    kept: List[int] = [*places[:place], *places[place + 1 :]]
    return (*kept[:to], places[place], *kept[to:])
