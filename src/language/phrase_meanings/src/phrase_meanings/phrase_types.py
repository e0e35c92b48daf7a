"""The semantic types of phrases: of their head noun, with compounds, names, pronouns and measures."""

from typing import Dict, Iterator, Sequence, Tuple

from phrase_meanings.head_words import shares_noun
from semantic_frames.semantic_type import with_parents
from semantic_types import UNTYPED, Fit, Likelihoods, WordTypes
from semantic_types.likelihood import UNLIKELY, combined, of_names, of_weights
from utterance_passes.trees.tree import DependencyTree, Word
from word_classes import word_class

_DEGREES = word_class("degrees")
_MEASURE_NOUNS = word_class("measure_nouns")
_PRONOUNS = word_class("pronouns")
_PERSONS = word_class("pronouns_of_persons")
_PERSONS_OR_THINGS = word_class("pronouns_of_persons_or_things")
_TITLES = word_class("titles")
_SEVERAL = "ones"
#: Words of these parts of speech may be nouns, also when the tagger erred.
_WITH_TYPES = frozenset(["NOUN", "PROPN", "ADJ", "VERB", "X"])
#: Relations of words inside a name or a compound to the head.
_IN_NAMES = frozenset(["compound", "amod", "flat", "nummod", "nmod", "goeswith"])
#: Longest compound or name, in words.
_LONGEST = 4
_PERSON = of_names(["Human"])
_QUANTITY = of_names(["Quantity"])
_OPEN_TYPES = frozenset(["Physical_object", "Human"])
_PERSON_OR_THING = of_weights({"Physical_object": 3.0, "Human": 1.0})
#: A bare proper noun that no dictionary knows is rarely anything but a person; a capital makes it surer: "take Bill".
_NAMED = of_weights({"Human": 5.0, "Location": 1.0})
_NAME_WITH_CAPITAL = 0.85
_NAME_WITHOUT_CAPITAL = 0.5
#: Many places have the name of a person; few other things have.
_PLACE = 0.5
_KNOWN = 0.7
#: "A cup of coffee" is coffee rather than a cup.
_OF_COMPLEMENT = 0.6


class PhraseTypes:
    """The types of the phrases of one sentence; each phrase is looked up once."""

    def __init__(self, tree: DependencyTree, words: WordTypes) -> None:
        self._tree = tree
        self._words = words
        self._of: Dict[int, Likelihoods] = {}
        self._fits: Dict[Tuple[int, Tuple[str, ...]], Fit] = {}

    def of(self, head: int) -> Likelihoods:
        """Return the types of a phrase, the likeliest first; none if nothing is known about it.

        Args:
            head: index of its head word
        """
        if head not in self._of:
            self._of[head] = self._find(head)
        return self._of[head]

    def likeliest(self, head: int) -> str:
        """Return the likeliest type of a phrase; empty if nothing is known about it."""
        return self.of(head).likeliest()

    def fit(self, head: int, accepted: Sequence[str]) -> Fit:
        """Return how well a phrase fits some types; of a list ("the mug and Anna"), the item that fits worst counts.

        Args:
            head: index of the head word
            accepted: types; something of a type below them fits, too
        """
        key = (head, tuple(accepted))
        if key not in self._fits:
            self._fits[key] = max(self._fit(item, accepted) for item in self.items(head))
        return self._fits[key]

    def _fit(self, item: int, accepted: Sequence[str]) -> Fit:
        fit = self.of(item).fit(accepted)
        is_open = fit is Fit.WRONG and self._tree.word(item).said in _PERSONS_OR_THINGS
        # "Iron them": what they are was said before.
        return Fit.UNKNOWN if is_open and any(with_parents(one) & _OPEN_TYPES for one in accepted) else fit

    def items(self, head: int) -> Tuple[int, ...]:
        """Return the heads of the items of a list; of any other phrase, its head."""
        joined = [child.index for child in self._tree.children(head) if child.deprel == "conj"]
        return (head, *(index for index in joined if not shares_noun(self._tree, index, head)))

    def is_name_of_being(self, index: int) -> bool:
        """Whether a word is the name of a person or an animal, if anything is known about it."""
        is_name = self._tree.word(index).upos == "PROPN"
        likeliest = self.likeliest(index) if is_name else ""
        return bool(likeliest) and "Sentient" in with_parents(likeliest)

    def word(self, index: int) -> str:
        """Return a word as it was said."""
        return self._tree.word(index).form

    def _find(self, head: int) -> Likelihoods:
        word = self._tree.word(head)
        for text in self._texts_around(head) if self._words.names else ():
            types = self._words.of_name(text)
            if types.types:
                return types
        form = word.said
        if form in _PERSONS:
            return _PERSON
        # "Leave the heavy ones": several are persons or things, and no place.
        if form in _PERSONS_OR_THINGS or form == _SEVERAL:
            return _PERSON_OR_THING
        if self._has_title(word):
            return _PERSON
        if word.upos not in _WITH_TYPES or form in _PRONOUNS:
            return UNTYPED
        types = _QUANTITY if self._is_degree(word) else self._of_noun(word)
        # An unknown word with a capital is a name, whatever the tagger says.
        is_name = word.upos == "NOUN" and word.index > 1 and word.form.istitle() and not types.types
        if word.upos == "PROPN" or is_name:
            types = self._of_proper_noun(word, types)
        complement = self._complement(word, types)
        if complement and word.upos == "ADJ":
            # "The largest of the cups" is a cup.
            types = self.of(complement)
        elif complement:
            types = combined(((self.of(complement), _OF_COMPLEMENT), (types, 1.0 - _OF_COMPLEMENT)))
        return types

    def _has_title(self, word: Word) -> bool:
        """Whether a name begins with a title: "Mrs. Miller", "Dr. Chen"; the head of the name may be its title."""
        near = [word, *(self._tree.word(index) for index in (word.index - 2, word.index - 1) if index > 0)]
        title = next((one for one in near if one.said.rstrip(".") in _TITLES), None)
        if title is None or title.index == len(self._tree.words):
            return False
        name = self._tree.word(title.index + 1)
        name = self._tree.word(title.index + 2) if name.form == "." and name.index < len(self._tree.words) else name
        is_inside = name.index == word.index or name.head in (title.index, word.index)
        return name.form[:1].isalpha() and is_inside and name.upos in _WITH_TYPES

    def _is_degree(self, word: Word) -> bool:
        """Whether a noun says how much, "a bit"; "the bit" is a tool."""
        before = [child.said for child in self._tree.children(word.index) if child.deprel == "det"]
        return word.said in _DEGREES and before == ["a"]

    def _texts_around(self, head: int) -> Iterator[str]:
        """Return the texts that may be the name at a head: "coffee corner", "Anna Smith", and the head alone."""
        inside = {child.index for child in self._tree.children(head) if child.deprel.split(":")[0] in _IN_NAMES} | {
            head
        }
        first = last = head
        while first - 1 in inside:
            first -= 1
        while last + 1 in inside:
            last += 1
        spans = [(begin, end) for begin in range(first, head + 1) for end in range(head, last + 1)]
        for begin, end in sorted(spans, key=lambda span: span[0] - span[1]):
            if end - begin < _LONGEST:
                yield self._tree.text_of(range(begin, end + 1))
        yield self._tree.word(head).lemma

    def _of_noun(self, word: Word) -> Likelihoods:
        """Return the types of a common noun: of the longest compound that is known, "coffee cup" before "cup"."""
        first = word.index
        while word.index - first < _LONGEST - 1 and self._is_before_noun(first - 1, word.index):
            first -= 1
        for begin in range(first, word.index + 1):
            before = [self._tree.word(index) for index in range(begin, word.index)]
            types = self._words.of_noun(
                " ".join([*(other.form for other in before), spelling]) for spelling in (word.said, word.lemma.lower())
            )
            # "Cold water" is a figure of speech in the dictionary, "hot dog" is not.
            is_described = any(other.deprel == "amod" for other in before)
            if types.types and not (is_described and types.fit(["Physical_entity"]) is not Fit.LIKELY):
                return types
        return UNTYPED

    def _is_before_noun(self, index: int, noun: int) -> bool:
        return (
            index > 0 and self._tree.word(index).head == noun and self._tree.word(index).deprel in ("compound", "amod")
        )

    def _of_proper_noun(self, word: Word, as_common: Likelihoods) -> Likelihoods:
        """Return the types of a proper noun; with a determiner it is none: "the TV"."""
        children = self._tree.children(word.index)
        is_plural = word.xpos == "NNPS"
        if is_plural or not word.form.isalpha() or any(child.deprel in ("det", "nmod:poss") for child in children):
            return as_common
        known = self._words.of_noun([word.form], is_name=True)
        if known.types:
            # "Jordan" is a country, and a person's name.
            share = _PLACE if known.fit(["Location"]) is Fit.LIKELY else _KNOWN
            return combined(((known, share), (_NAMED, 1.0 - share)))
        share = _NAME_WITH_CAPITAL if word.form[:1].isupper() else _NAME_WITHOUT_CAPITAL
        return combined(((_NAMED, share), (as_common, 1.0 - share)))

    def _complement(self, word: Word, types: Likelihoods) -> int:
        """Return the head of the of-phrase of a measure or of an adjective: "coffee" in "a cup of coffee", "cups" in
        "the largest of the cups"; 0 if there is none."""
        is_measure = types.share(["Quantity"]) >= UNLIKELY or word.lemma.lower() in _MEASURE_NOUNS
        if not is_measure and word.upos != "ADJ":
            return 0
        for child in self._tree.children(word.index):
            if child.deprel in ("nmod", "obl") and self._tree.said_prepositions(child.index) == ["of"]:
                return child.index
        return 0
