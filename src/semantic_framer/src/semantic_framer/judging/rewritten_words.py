"""Finds the words of a text that the tree does not have: passes took them out, or wrote others for them."""

import re
import unicodedata
from dataclasses import dataclass
from difflib import SequenceMatcher
from typing import AbstractSet, List, Sequence, Set, Tuple

from semantic_framer.judging.unread_words import shipped_unread_words
from semantic_types.parts_of_speech import NOUN, base_forms
from utterance_passes.trees.formula_file import WRITTEN_OUT, is_filler, pattern_of, shipped_formulas
from utterance_passes.trees.tree import DependencyTree, Word

#: A letter, a digit, or a sign of either.
RUN = re.compile(r"[^\W_]+")
_HESITATION = pattern_of("phrases_of_hesitation")
_BROKEN_OFF = re.compile(r"-,?\s")
_GROUP = re.compile(r"\\\d")
#: Of two spellings of one word: "rihgt" and "right".
_LEAST_LIKENESS = 0.5
_SENTENCE = re.compile(r"(?<=[.!?] )[^.!?]+[.!?]*|^[^.!?]+[.!?]*")


@dataclass(frozen=True)
class SaidWord:
    """A word of the text: letters and digits without a mark between them."""

    form: str
    start: int
    end: int

    def is_at(self, word: Word) -> bool:
        """Whether a word of the tree stands in this place of the text."""
        is_inside = word.start_character <= self.start and self.end <= word.end_character
        return is_inside or word.start_character == self.start


def lost_in_rewriting(
    tree: DependencyTree, understood: AbstractSet[int], named: AbstractSet[int], lemmas: AbstractSet[str]
) -> List[SaidWord]:
    """Return the words of the text that passes took out, or wrote in a way that means nothing.

    Args:
        tree: the sentence, with its text as it was said
        understood: positions of the words that readings, corrections and exclusions account for
        named: positions of the words that readings name
        lemmas: of the things that readings name
    """
    said = said_words(tree.text)
    written = [(part, word.index) for word in tree.words for part in RUN.findall(_plain(word.form))]
    matcher = SequenceMatcher(None, [one.form for one in said], [form for form, _ in written], autojunk=False)
    gone: List[SaidWord] = []
    new: List[Tuple[str, int]] = []
    for tag, first, last, begin, end in matcher.get_opcodes():
        if tag == "equal":
            continue
        block, words = said[first:last], written[begin:end]
        if "".join(one.form for one in block) == "".join(form for form, _ in words):
            continue
        is_meant = any(index in understood for _, index in words)
        if block and is_meant and tag == "replace":
            places = {tree.word(index) for _, index in words}
            beyond = _beyond(block, [form for form, _ in words])
            gone += [one for one in beyond if not any(one.is_at(word) for word in places)]
            continue
        new += words
        if block and not _is_taken_back(tree.text, said, first, last):
            gone += block
    moved = [form for form, _ in new]
    left = []
    for one in gone:
        if one.form in moved:
            moved.remove(one.form)
        else:
            left.append(one)
    spans = _spans_written_out(tree, named) if left else ()
    left = [one for one in left if not any(start <= one.start < end for start, end in spans)]
    things = {place for place, one in enumerate(said) if lemmas & set(base_forms(one.form, NOUN))}
    told = {said[place].start for thing in things for place in (thing - 1, thing) if place >= 0}
    # "*Two bottles*, one of water and one of milk" are one bottle of water and one bottle of milk.
    return _not_unread([one for one in left if one.start not in told], said)


def _spans_written_out(tree: DependencyTree, named: AbstractSet[int]) -> List[Tuple[int, int]]:
    """Return the parts of the text that are written in other words, if these words are understood: "*off of*" is
    "off"."""
    forms = {_plain(tree.word(index).form) for index in named if 0 < index <= len(tree.words)}
    texts = [(0, tree.text.lower())]
    texts += [(part.start(), part.group().lower().rstrip()) for part in _SENTENCE.finditer(tree.text)]
    return [
        (start + match.start(), start + match.end())
        for formula in shipped_formulas()[WRITTEN_OUT]
        if forms & set(RUN.findall(_GROUP.sub(" ", formula.written)))
        for start, text in texts
        for match in formula.pattern.finditer(text)
    ]


def _plain(text: str) -> str:
    return unicodedata.normalize("NFKC", text).lower()


def said_words(text: str) -> List[SaidWord]:
    """Return the words of a text, in order."""
    return [SaidWord(_plain(match.group()), *match.span()) for match in RUN.finditer(text)]


def _beyond(said: Sequence[SaidWord], written: Sequence[str]) -> List[SaidWord]:
    """Return the words for which none is written: a written word stands for the one that it is most like, if any."""
    left = list(said)
    for form in written:
        alike = [(SequenceMatcher(None, one.form, form, autojunk=False).ratio(), one) for one in left]
        likeness, nearest = max(alike, key=lambda pair: pair[0], default=(0.0, None))
        if nearest is not None and likeness >= _LEAST_LIKENESS:
            left.remove(nearest)
    return left


def _is_taken_back(text: str, said: Sequence[SaidWord], first: int, last: int) -> bool:
    """Whether words that were taken out were broken off, said for thinking, or are said again."""
    block = [one.form for one in said[first:last]]
    if block == [one.form for one in said[last : last + len(block)]]:
        return True
    if block == [one.form for one in said[max(0, first - len(block)) : first]]:
        return True
    # "Turn left turn forty degrees left": all words are said again, in their order.
    left = iter([one.form for one in said[last:]])
    if last < len(said) and len(block) > 1 and block[0] == said[last].form and all(form in left for form in block):
        return True
    is_broken_off = any(_BROKEN_OFF.match(text, one.end) for one in said[first:last])
    return is_broken_off or any(is_filler(form) for form in block)


def _not_unread(words: List[SaidWord], said: Sequence[SaidWord]) -> List[SaidWord]:
    """Return the words that may not go unread where they stand in the text."""
    forms = [one.form for one in said]
    unread: Set[int] = set()
    for place in range(len(said)):
        length = max(unread_length(forms[place:]), _hesitation_length(forms[place:]))
        unread.update(one.start for one in said[place : place + length])
    return [one for one in words if one.start not in unread]


def unread_length(forms: Sequence[str]) -> int:
    """Return the number of words at the front that may go unread."""
    if not forms:
        return 0
    length = shipped_unread_words().at(forms)[1]
    return length or int(is_filler(forms[0]))


def _hesitation_length(forms: Sequence[str]) -> int:
    """Return the number of words at the front that are only said for thinking: "you know", "like"."""
    lengths = (length for length in (2, 1) if _HESITATION.fullmatch(" ".join(forms[:length])))
    return next(lengths, int(forms[:1] == ["like"]))
