"""Finds the phrases of a clause that says or asks how things are: its theme, its place, and what is asked of each."""

from dataclasses import dataclass
from typing import Dict, FrozenSet, Mapping, Optional, Sequence, Tuple

from semantic_framer.kinds.clause_features import ClauseFeatures, children_of_clause
from semantic_framer.values.sentence import Sentence
from utterance_passes.trees.tree import Word
from word_classes import word_class

#: The frames of states.
LOCATED, PRESENT, IN_STATE, EXISTING = "being_located", "being_present", "being_in_state", "existing"
HAVING, HOLDING, BELONGING = "having", "holding", "belonging"
COLOURED, FOREMOST, MEASURED = "being_coloured", "being_foremost", "being_of_measure"
#: What may be asked for beside an element.
WHETHER, THING, PERSON, COUNT = "whether", "thing", "person", "count"
MANY = "many"
_HEARERS = word_class("hearers")
#: Words that mean the robot or the speaker, that ask for things and persons, and that stand for a place.
US = word_class("hearers") | word_class("speaker_subjects")
THINGS_ASKED = word_class("things_asked")
WHO = word_class("question_words") & word_class("pronouns_of_persons")
WHICH = word_class("question_words") - word_class("relative_adverbs") - WHO - {"how", "whose"}
_PLACES = word_class("place_prepositions") | word_class("to_prepositions")
HERE = word_class("place_adverbs") | word_class("forward_and_backward") | {"around", "nearby"}
_LEFT = word_class("padding_of_states")
_POINTING = word_class("pronouns_of_things") - {"it"}
_NO_THEMES_ASKED = _POINTING | US
THAN = "than"
#: The type of what a robot holds things with.
_HAND = "Body_part"
#: Relations of words that only make a clause.
FUNCTION = frozenset(["aux", "cop", "punct", "mark", "expl", "cc", "discourse", "vocative"])
Positions = Tuple[int, ...]


@dataclass(frozen=True)
class StateClause:
    """What a clause says of a state.

    Attributes:
        frame: of the state
        asked: what is asked for: whether, an element, a thing, a person, or a count
        elements: the positions of the words of each element that is named
    """

    frame: str
    asked: str
    elements: Mapping[str, Positions]


class StatePhrases:
    """The phrases of one clause."""

    def __init__(self, sentence: Sentence, features: ClauseFeatures, words: FrozenSet[int], is_asked: bool) -> None:
        self._sentence = sentence
        self._is_asked = is_asked
        self._words = words
        self._features = features
        self._top = sentence.word(features.top)
        self._children = children_of_clause(sentence.tree, features.top)
        #: Words that only ask: "anything".
        self._asking: FrozenSet[int] = frozenset()
        self._subject = next((child for child in self._children if child.deprel.startswith("nsubj")), None)
        self._lemma = self._top.lemma.lower()
        # Only a question about the robot or its speaker is no question about a thing.
        self._no_themes = _NO_THEMES_ASKED if is_asked else _POINTING
        self._is_predicate = any(child.deprel == "cop" for child in self._children)

    def has_all_words(self, clause: StateClause) -> bool:
        """Whether no word of the clause is left over; a question may say when, a condition may not."""
        said = self._asking.union(*clause.elements.values())
        times = [index for time in self._sentence.tree.times for index in time] if self._is_asked else []
        # "Is it open at 18:30" asks about another time than now.
        if any(self._sentence.word(index).upos == "NUM" for index in times):
            return False
        function = FUNCTION if self._is_asked else FUNCTION - {"mark"}
        for index in (self._sentence.subtree(self._top.index) & self._words) - said.union(times):
            word = self._sentence.word(index)
            is_small = word.deprel.split(":")[0] in function | {"det", "case"} or word.said in _LEFT
            is_own = index in (self._top.index, self._features.asked) or word.lemma.lower() in (MANY, "be")
            is_time = self._is_asked and self._sentence.types.likeliest(index) == "Time"
            if not is_small and not is_own and not is_time and word is not self._subject:
                return False
        return True

    def _cases(self, word: Word) -> FrozenSet[int]:
        return frozenset(child.index for child in self._sentence.tree.prepositions(word.index))

    def _phrase(self, word: Word, without: FrozenSet[int] = frozenset()) -> Positions:
        """Return a phrase without what only asks: "which", "how many"."""
        lost = [c for c in self._sentence.children(word.index) if c.deprel == "cop" or c.deprel.startswith("nsubj")]
        inside = self._sentence.subtree(word.index).difference(
            without, *(self._sentence.subtree(c.index) for c in lost)
        )
        asking = frozenset(
            index
            for child in self._sentence.children(word.index)
            for index in self._sentence.subtree(child.index)
            if child.deprel in ("det", "amod", "advmod", "case")
            if self._features.asked in self._sentence.subtree(child.index) and child.index != word.index
        )
        words = sorted((inside - asking) & self._words)
        return tuple(index for index in words if self._sentence.word(index).upos != "PUNCT")

    def _place_of(self, word: Word) -> Optional[Word]:
        """Return the first phrase of place that a word governs."""
        children = self._sentence.children(word.index)
        return next((child for child in children if child.index in self._words and self._is_place(child)), None)

    def _is_place(self, word: Word) -> bool:
        cases = self._sentence.tree.said_prepositions(word.index)
        if word.deprel.split(":")[0] not in ("obl", "nmod", "advmod", "conj") and word.index != self._top.index:
            return False
        is_left = word.said in _LEFT and word.index != self._top.index
        if is_left or any(word.index in time for time in self._sentence.tree.times):
            return False
        if self._sentence.types.likeliest(word.index) == "Time":
            return False  # "at the moment"
        return (bool(cases) and cases[0] in _PLACES and word.upos != "ADJ") or word.said in HERE

    def _asked_of(self, word: Word) -> str:
        """Return what a phrase asks for; empty if it asks for nothing."""
        form = word.said
        asked = self._sentence.word(self._features.asked) if self._features.asked else None
        if form in WHO:
            return PERSON
        inside = self._sentence.subtree(word.index)
        if word.index == self._top.index and self._subject is not None:
            inside = inside - self._sentence.subtree(self._subject.index)
        if asked is None or asked.index not in inside:
            return ""
        if asked.said == "how":
            # "How *many* of the lamps", "how many *lamps*".
            counted = (word, *self._sentence.children(word.index))
            return COUNT if any(one.lemma.lower() == MANY for one in counted) else ""
        return THING if asked.said in WHICH else ""

    def _theme(self, word: Word, without: FrozenSet[int] = frozenset()) -> Dict[str, Positions]:
        """Return the words of a theme, and of its place, if what is asked for is at a place: "doors *in the hall*"."""
        asks = self._asked_of(word)
        form = word.said
        if asks and form in WHO | WHICH | {MANY}:
            inner = next((child for child in self._sentence.children(word.index) if child.deprel == "nmod"), None)
            return {} if inner is None else {"theme": self._bare(inner)}
        place = self._place_of(word) if asks else None
        outside = self._sentence.subtree(place.index) if place is not None else frozenset()
        found = {"theme": self._phrase(word, without | outside)}
        if place is not None:
            found["location"] = self._phrase(place)
        return found

    def _bare(self, word: Word) -> Positions:
        """Return the noun of "which *of the bottles*", without its preposition and its article."""
        left = [child.index for child in self._sentence.children(word.index) if child.deprel in ("case", "det")]
        return tuple(index for index in self._phrase(word) if index not in left)

    def _with_alternative(self, words: Dict[str, Positions], name: str, word: Word) -> Dict[str, Positions]:
        """Return an element, and the alternative to it: "on the table *or in the sink*"."""
        children = self._sentence.children(word.index)
        other = next((child for child in children if child.deprel == "conj" and child.index in self._words), None)
        outside = frozenset() if other is None else self._sentence.subtree(other.index)
        found = {**words, name: self._phrase(word, outside | self._own(word))}
        if other is not None and other.said != "not":
            joints = frozenset(c.index for c in self._sentence.children(other.index) if c.deprel == "cc")
            found["alternative"] = self._phrase(other, joints)
        return found

    def _own(self, word: Word) -> FrozenSet[int]:
        """Return the words that a predicate governs as a clause, and that are no part of its phrase."""
        if word.index != self._top.index:
            return frozenset()
        clause = [
            child
            for child in self._children
            if child.deprel.split(":")[0] in FUNCTION | {"nsubj", "advmod", "obl", "parataxis", "advcl"}
        ]
        return frozenset().union(*(self._sentence.subtree(child.index) for child in clause))

    def _left(self, word: Word) -> FrozenSet[int]:
        """Return the words of "any milk *left*"."""
        return frozenset(child.index for child in self._sentence.children(word.index) if child.said == "left")

    def _object(self) -> Optional[Word]:
        return next((child for child in self._children if child.deprel == "obj"), None)

    def _of_holding(self, subject: Word) -> Optional[StateClause]:
        thing = self._object()
        if thing is None or (subject.said in US - _HEARERS and self._is_asked):
            return None
        if self._asked_of(subject) == PERSON:
            return StateClause(LOCATED, "location", {"theme": self._phrase(thing)})
        agent = {"agent": self._phrase(subject)}
        if thing.said in THINGS_ASKED:
            self._asking |= {thing.index}
        if thing.said in THINGS_ASKED or self._asked_of(thing):
            return StateClause(HOLDING, "theme", agent)
        return self._held(subject, thing)

    def _held(self, subject: Word, thing: Word) -> StateClause:
        """Return that somebody holds a thing; a condition calls them an owner and a possession."""
        who, what = ("agent", "theme") if self._is_asked else ("owner", "possession")
        return StateClause(HOLDING, WHETHER, {who: self._phrase(subject), what: self._phrase(thing)})

    def _is_hand(self, word: Word) -> bool:
        return self._sentence.types.likeliest(word.index) == _HAND

    def _in_hand(self, subject: Word, hand: Word) -> Optional[StateClause]:
        """Read "what is in your hand", "is the mug in your hand"."""
        owners = [child.said for child in self._sentence.children(hand.index) if child.deprel == "nmod:poss"]
        if owners != ["your"]:
            return None
        self._asking = self._sentence.subtree(hand.index)
        if self._asked_of(subject) == THING or subject.said in THINGS_ASKED:
            return StateClause(HOLDING, "theme", {})
        return StateClause(HOLDING, WHETHER, {"theme": self._phrase(subject)})

    def _behind(self, preposition: str, words: Sequence[Word]) -> Optional[Word]:
        """Return the first of some words behind a preposition; None if it stands before none of them."""
        return next((one for one in words if self._sentence.tree.said_prepositions(one.index) == [preposition]), None)

    def _more_than(self, things: Word, place: Optional[Word]) -> Optional[StateClause]:
        """Read "are there *more mugs than plates in the kitchen*"; None for things that are not compared."""
        more = next((child for child in self._sentence.children(things.index) if child.xpos == "JJR"), None)
        other = self._behind(THAN, self._children + self._sentence.children(things.index))
        if more is None or other is None:
            return None
        place = place or self._place_of(other)
        there = self._sentence.subtree(place.index) if place is not None else frozenset()
        elements = {
            "theme": self._phrase(things, there | self._sentence.subtree(other.index) | {more.index}),
            "attribute": (more.index,),
            "standard": self._phrase(other, there | self._cases(other)),
        }
        return StateClause(MEASURED, WHETHER, self._at(place, elements))

    def _at(self, place: Optional[Word], elements: Mapping[str, Positions]) -> Dict[str, Positions]:
        """Return elements with the place that was said, if one was."""
        return {**elements} if place is None else {**elements, "location": self._phrase(place)}
