"""Questions inside other words: "I want to know where the mug is", "tell Anna how many chairs there are"."""

from typing import Iterator, List, Sequence, Tuple

from utterance_passes.tree import QUOTED, DependencyTree, Word
from utterance_passes.tree_edits import NotATree, TreeEdit
from word_classes import word_class

_OPENINGS = tuple(tuple(opening.split()) for opening in sorted(word_class("question_openings"), key=len, reverse=True))
_BE = word_class("forms_of_be")
_INVERTED = _BE | word_class("forms_of_have")
_DO = word_class("forms_of_do")
_WHETHER = word_class("whether_words")
#: A question word and its noun have at most so many words: "in which of the rooms".
_LONGEST_FRONT = 4
_NOUNS = frozenset(["NOUN", "PROPN"])
#: Relations of the words before a noun, by their part of speech.
_BEFORE_NOUN = {"DET": "det", "ADJ": "amod", "NUM": "nummod", "PRON": "nmod:poss", "NOUN": "compound", "PROPN": "compound"}


def length_of_opening(forms: Sequence[str]) -> int:
    """Return the number of words in front of an indirect question: 4 for "i want to know"; 0 for none."""
    return next((len(opening) for opening in _OPENINGS if tuple(forms[: len(opening)]) == opening), 0)


def direct_orders(words: Sequence[Word]) -> Iterator[Tuple[Word, ...]]:
    """Yield the words of an indirect question in the orders that a direct one may have: "where the mug is" as it is,
    and "where is the mug".
    """
    forms = [word.form.lower() for word in words]
    if not forms:
        return
    if forms[0] in _WHETHER:
        verbs = [place for place, form in enumerate(forms) if form in _INVERTED | _DO]
        for place in verbs[:1]:
            yield _moved(words[1:], place - 1, 0)
        return
    yield tuple(words)
    for place in range(2, len(forms)):
        if forms[place] in _BE and forms[place - 1] in ("there", "it"):
            yield _moved(words, place, place - 1)
    for place in range(len(forms) - 1, 1, -1):
        if forms[place] in _BE:
            for front in range(1, min(_LONGEST_FRONT, place) + 1):
                yield _moved(words, place, front)


def _moved(words: Sequence[Word], place: int, to: int) -> Tuple[Word, ...]:
    kept: List[Word] = [*words[:place], *words[place + 1 :]]
    return (*kept[:to], words[place], *kept[to:])


def unquoted(tree: DependencyTree, positions: Sequence[int]) -> DependencyTree:
    """Return a tree in which the noun phrases of quoted words have their relations again: a quotation has none."""
    edit = TreeEdit(tree)
    whole = 0
    words = [tree.word(position) for position in positions if tree.word(position).deprel == QUOTED]
    for first, word in enumerate(words):
        rest = words[first:]
        if first and words[first - 1].upos in _BEFORE_NOUN and words[first - 1].index == word.index - 1:
            continue  # in the middle of a phrase
        preposition = word if word.upos == "ADP" else None
        phrase = _noun_phrase(rest[1:] if preposition else rest)
        if not phrase:
            continue
        head = phrase[-1].index
        edit.relabel(head, "nsubj")
        for before, after in zip(phrase, phrase[1:]):
            if after.upos == "PART":
                edit.rehang(before.index, head, "nmod:poss")
                edit.rehang(after.index, before.index, "case")
            elif before.upos != "PART":
                edit.rehang(before.index, head, _BEFORE_NOUN[before.upos])
        if preposition is not None:
            edit.rehang(preposition.index, head, "case")
            if whole:
                edit.rehang(head, whole, "nmod")
        whole = head
    try:
        return edit.tree()
    except NotATree:
        return tree


def _noun_phrase(words: Sequence[Word]) -> List[Word]:
    """Return the noun phrase that some words begin with, up to its last noun."""
    found: List[Word] = []
    for word in words:
        is_next = not found or word.index == found[-1].index + 1
        if not is_next or not (word.upos in _BEFORE_NOUN or (word.upos == "PART" and word.form.lower() in ("'s", "\u2019s"))):
            break
        found.append(word)
    while found and found[-1].upos not in _NOUNS:
        found.pop()
    return found
