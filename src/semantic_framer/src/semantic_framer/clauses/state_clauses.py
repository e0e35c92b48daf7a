"""Reads clauses that say or ask how things are: where they are, in which state, how many there are, and whose.

"Be" and its like evoke a frame of state by the type of their complement, whatever the mood. A question asks for one
element of that frame.
"""

from typing import Dict, FrozenSet, List, Optional

from phrase_meanings.head_words import is_superlative
from phrase_meanings.meaning_file import measure_of
from semantic_framer.clauses.state_phrases import (
    BELONGING,
    COLOURED,
    COUNT,
    EXISTING,
    FOREMOST,
    HAVING,
    HERE,
    IN_STATE,
    LOCATED,
    MEASURED,
    PERSON,
    PRESENT,
    THAN,
    THING,
    THINGS_ASKED,
    US,
    WHETHER,
    WHICH,
    WHO,
    Positions,
    StateClause,
    StatePhrases,
)
from semantic_framer.kinds.clause_features import Aspect, ClauseFeatures
from semantic_framer.values.sentence import Sentence
from utterance_passes.trees.tree import NOMINALS, PHRASE_HEADS, Word
from word_classes import word_class

_PERSON_NOUNS = word_class("general_person_nouns")
_WHERE, _WHOSE, _HOW, _FROM, _OR = "where", "whose", "how", "from", "or"
#: Which of two is asked for.
WHICH_OF = "which"
_NUMBER, _OWN, _BELONG = "number", "own", "belong"
_HOLDING = ("hold", "carry")
_PLACE_NOUNS = word_class("general_place_nouns")
_STATES = word_class("state_particles")
_POSTURES = word_class("posture_verbs")
_COLOURS = word_class("colour_nouns")
_SEEN = word_class("finding_verbs") - {"find", "meet"}
_KNOWN, _BEEN = "know", "been"
_FOUND = word_class("verbs_of_whereabouts")
_GONE = word_class("verbs_of_going")


def state_clause(
    sentence: Sentence, features: ClauseFeatures, words: FrozenSet[int], *, is_asked: bool = True
) -> Optional[StateClause]:
    """Return what a clause says of a state; None for other clauses, and where a word is left over.

    Args:
        sentence: the sentence
        features: of the clause
        words: positions of the words that count
        is_asked: whether somebody asks it; a condition also says where "you" are, and that "somebody" is there
    """
    for kind in (_OfBe, _OfVerb):
        reader = kind(sentence, features, words, is_asked)
        found = reader.read()
        if found is not None:
            # "How tall is the ball" asks for what no element of a state holds.
            is_lost = bool(features.asked) and found.asked == WHETHER
            return found if not is_lost and reader.has_all_words(found) else None
    return None


class _OfBe(StatePhrases):
    """Reads "be" with what it says of its subject, and "the colour of the mug", which says it of none."""

    def read(self) -> Optional[StateClause]:
        """Return what the clause says; None if its verb is another."""
        if self._subject is None:
            return self._of_phrase()
        return None if self._features.modal else self._of_be()

    def _of_be(self) -> Optional[StateClause]:
        assert self._subject is not None
        subject, top = self._subject, self._top
        if self._lemma == "be" and not self._is_predicate:
            return self._of_existence(subject)
        if self._is_predicate:
            return self._of_predicate(subject)
        is_state = self._features.is_passive or top.xpos in ("VBG", "VBN")
        helped = any(child.deprel.startswith("aux") and child.lemma.lower() == "be" for child in self._children)
        if not is_state or not helped:
            return None
        if self._lemma in _HOLDING:
            return self._of_holding(subject)
        if self._lemma in _POSTURES and (place := self._place_of(top)) is not None and not self._asked_of(subject):
            return self._located(subject, place)
        return self._in_state(subject)

    def _of_existence(self, subject: Word) -> Optional[StateClause]:
        if not any(child.deprel == "expl" for child in self._children):
            return None
        place = self._place_of(self._top) or self._place_of(subject)
        compared = self._more_than(subject, place)
        if compared is not None:
            return compared
        if place is None:
            asked = self._asked_of(subject)
            theme = self._theme(subject, self._left(subject))
            return StateClause(EXISTING, asked or WHETHER, theme) if theme else None
        return self._located(subject, place)

    def _of_predicate(self, subject: Word) -> Optional[StateClause]:
        top, form = self._top, self._top.said
        # "Which rooms have you *been* to" asks for what it did.
        is_over = self._features.aspect in (Aspect.DONE, Aspect.EVER_DONE)
        if is_over and subject.said in US and any(child.said == _BEEN for child in self._children):
            return None
        if form == _WHERE:
            return self._where(subject)
        if form in WHO and subject.said in HERE:
            return StateClause(LOCATED, PERSON, {"location": (subject.index,)})
        owner = next((child for child in self._children if child.said == _WHOSE), None)
        if owner is not None:
            self._asking = frozenset([owner.index])
            return StateClause(BELONGING, "owner", {"theme": self._phrase(top, self._asking | self._own(top))})
        if form == _WHOSE:
            return StateClause(BELONGING, "owner", {"theme": self._phrase(subject)})
        if self._lemma in _COLOURS and self._asked_of(top):
            return StateClause(COLOURED, "colour", {"theme": self._phrase(subject)})
        if form in WHICH | WHO:
            return self._of_noun(subject)
        behind = next((c for c in self._children if c.deprel == "case" and c.said in _STATES), None)
        if behind is not None and behind.index > top.index:
            # "Is the radio in the kitchen on": the parser takes "on" for a preposition of the kitchen.
            outside = self._own(top) | {behind.index}
            elements = {**self._theme(subject), "state": (behind.index,), "location": self._phrase(top, outside)}
            return StateClause(IN_STATE, self._asked_of(subject) or WHETHER, elements)
        if self._is_place(top) and (top.upos != "ADJ" or not self._is_asked):
            if self._asked_of(top):
                return None if self._asked_of(top) != THING else self._in_which_place(subject)
            return self._located(subject, top)
        if top.upos in PHRASE_HEADS:
            return None
        if is_superlative(top):
            return self._foremost(subject)
        return self._measured(subject) or self._in_state(subject)

    def _in_which_place(self, subject: Word) -> Optional[StateClause]:
        return self._where(subject) if self._top.lemma.lower() in _PLACE_NOUNS else None

    def _where(self, subject: Word) -> Optional[StateClause]:
        if subject.said in US:
            return StateClause(LOCATED, "own_place", {})
        if subject.said in self._no_themes:
            return None
        return StateClause(LOCATED, "location", {"theme": self._phrase(subject)})

    def _of_noun(self, subject: Word) -> Optional[StateClause]:
        """Read "what is the colour of the mug", "what is the biggest thing"."""
        children = self._sentence.children(subject.index)
        owner = next((child for child in children if child.deprel.startswith("nmod")), None)
        if subject.lemma.lower() in _COLOURS and owner is not None:
            return StateClause(COLOURED, "colour", {"theme": self._phrase(owner, self._cases(owner))})
        if subject.lemma.lower() == _NUMBER and owner is not None:
            return self._counted(subject, owner)
        if owner is not None and measure_of(subject.lemma.lower()):
            elements = {"theme": self._phrase(owner, self._cases(owner)), "attribute": (subject.index,)}
            return StateClause(MEASURED, "measure", elements)
        if any(is_superlative(child) for child in children):
            here = next((child for child in self._children if child.said in HERE), None)
            known = next((child for child in children if child.lemma.lower() in _SEEN | {_KNOWN}), None)
            # "The biggest thing *you know of* in the hall."
            outside = frozenset() if known is None else self._sentence.subtree(known.index)
            place = here if known is None else self._place_of(known)
            self._asking = outside
            return StateClause(FOREMOST, "theme", self._at(place, {"theme": self._phrase(subject, outside)}))
        return None

    def _counted(self, number: Word, things: Word) -> Optional[StateClause]:
        """Read "what is the number of lamps in the kitchen"."""
        self._asking = frozenset([number.index])
        place = self._place_of(things) or next(
            (c for c in self._sentence.children(number.index) if c is not things and self._is_place(c)), None
        )
        outside = frozenset() if place is None else self._sentence.subtree(place.index)
        theme = {"theme": self._phrase(things, outside | self._cases(things))}
        return StateClause(LOCATED, COUNT, self._at(place, theme))

    def _measured(self, subject: Word) -> Optional[StateClause]:
        """Read "how tall is the fridge", "how far is the hall from here", "is the sofa bigger than the bed", "which is
        taller, the fridge or the shelf".
        """
        asked = self._asked_of(subject)
        if self._top.xpos == "JJR":
            subjects = [c for c in self._children if c.deprel == "nsubj" and c is not subject] if asked else [subject]
            found = self._of_two(subjects[0]) if len(subjects) == 1 else {}
            if found:
                self._asking = frozenset(self._phrase(subject)) if asked else frozenset()
                return StateClause(MEASURED, WHICH_OF, {"attribute": (self._top.index,), **found})
        is_how = any(child.said == _HOW for child in self._children)
        standard = self._behind(_FROM if is_how else THAN, self._children)
        is_thing = subject.upos in NOMINALS and subject.said not in self._no_themes
        if not (is_how or standard) or not is_thing or asked:
            return None
        elements = {"theme": self._phrase(subject), "attribute": (self._top.index,)}
        if standard is not None:
            elements["standard"] = self._phrase(standard, self._cases(standard))
        return StateClause(MEASURED, "measure" if is_how else WHETHER, elements)

    def _of_two(self, one: Word) -> Dict[str, Positions]:
        """Return two things of which one is asked for: "the fridge or the shelf"; none if there are no two.

        The parser hangs the second on the first, or on what they are compared by.
        """
        around = (*self._sentence.children(one.index), *self._children)
        items = [c for c in around if c.deprel in ("conj", "nsubj") and c.index > one.index]
        inner = [c for item in items for c in self._sentence.children(item.index)]
        joints = [c for c in (*inner, *self._children) if c.deprel == "cc"]
        if len(items) != 1 or [joint.said for joint in joints] != [_OR]:
            return {}
        without = self._sentence.subtree(items[0].index)
        other = self._phrase(items[0], frozenset([joints[0].index]))
        return {"theme": self._phrase(one, without), "alternative": other}

    def _foremost(self, subject: Word) -> Optional[StateClause]:
        theme = self._theme(subject)
        near = next((child for child in self._children if child.said in US and self._cases(child)), None)
        if near is not None:  # "Which door is nearest *to you*?"
            self._asking = self._sentence.subtree(near.index)
        if not self._asked_of(subject) or not theme:
            return None
        places = [child.index for child in self._children if child.deprel == "amod"]
        return StateClause(FOREMOST, "theme", {**theme, "rank": (*places, self._top.index)})

    def _located(self, subject: Word, place: Word) -> Optional[StateClause]:
        form = subject.said
        if form in self._no_themes:
            return None
        if self._is_hand(place):
            return self._in_hand(subject, place)
        if not self._is_asked and place.said in HERE - {"there"}:
            return StateClause(PRESENT, WHETHER, {"theme": self._phrase(subject)})
        outside = self._sentence.subtree(place.index) if place.index != self._top.index else frozenset()
        words = self._with_alternative({}, "location", place)
        asked = self._asked_of(subject)
        if asked == PERSON or (asked == THING and subject.lemma.lower() in _PERSON_NOUNS):
            return StateClause(LOCATED, PERSON, words)
        if not asked and form in _PERSON_NOUNS and self._is_asked:
            return StateClause(LOCATED, PERSON, words)
        is_plain = not any(child.deprel == "amod" for child in self._sentence.children(subject.index))
        if not asked and form in THINGS_ASKED and is_plain and self._is_asked:
            return StateClause(LOCATED, THING, words)
        theme = self._theme(subject, outside | self._left(subject))
        theme.pop("location", None)
        return StateClause(LOCATED, asked or WHETHER, {**theme, **words})

    def _in_state(self, subject: Word) -> Optional[StateClause]:
        form, top = subject.said, self._top
        # "It is raining" says nothing of a thing.
        if form in self._no_themes or (form == "it" and top.xpos == "VBG"):
            return None
        state = top
        if top.said == "left" and top.deprel != "advmod":
            if not any(child.said in _STATES or child.upos == "ADJ" for child in self._children):
                asked = self._asked_of(subject)
                return StateClause(EXISTING, asked or WHETHER, self._theme(subject))
        if top.xpos == "VBN":  # "Is the radio left *on*?"
            found = [child for child in self._children if child.deprel in ("compound:prt", "advmod", "xcomp", "obl")]
            state = next((child for child in found if child.said in _STATES or child.upos == "ADJ"), top)
        elements = self._with_alternative({}, "state", state)
        if len(elements["state"]) != 1:
            return None
        place = self._place_of(top)
        if place is not None and place is not state:
            elements["location"] = self._phrase(place)
        asked = self._asked_of(subject)
        return StateClause(
            IN_STATE, THING if asked == PERSON else asked or WHETHER, {**self._theme(subject), **elements}
        )

    def _of_phrase(self) -> Optional[StateClause]:
        """Read "the colour of the mug", which asks for it where something is asked for."""
        owner = next((child for child in self._children if child.deprel == "nmod"), None)
        if self._lemma not in _COLOURS or owner is None:
            return None
        return StateClause(COLOURED, "colour", {"theme": self._phrase(owner, self._cases(owner))})


class _OfVerb(StatePhrases):
    """Reads "have", "hold", "own", "see" and their like."""

    def read(self) -> Optional[StateClause]:
        """Return what the clause says; None if its verb is another."""
        if self._subject is None or (self._features.modal and self._lemma not in _SEEN | _FOUND):
            return None
        return self._of_verb()

    def _of_verb(self) -> Optional[StateClause]:
        assert self._subject is not None
        subject = self._subject
        if self._features.asked and self._sentence.word(self._features.asked).said == _WHERE:
            return self._whereabouts(subject)
        has = any(child.lemma.lower() == "have" for child in self._children if child.deprel == "aux")
        if self._lemma == "have" or (self._lemma == "get" and has):
            return self._of_having(subject)
        if self._lemma in _HOLDING:
            return self._of_holding(subject)
        if self._lemma in (_OWN, _BELONG):
            return self._of_belonging(subject)
        if self._is_asked and self._lemma in _SEEN | {_KNOWN} and subject.said in US:
            return self._of_perceiving()
        return None

    def _whereabouts(self, subject: Word) -> Optional[StateClause]:
        """Read "where can I find the mug", "where did the mug go", "where did I leave the mug"."""
        thing = self._object()
        if thing is not None and subject.said in US and self._lemma in _FOUND | _SEEN:
            return StateClause(LOCATED, "location", {"theme": self._phrase(thing)})
        if thing is None and self._lemma in _GONE and subject.said not in self._no_themes:
            return StateClause(LOCATED, "location", {"theme": self._phrase(subject)})
        return None

    def _of_having(self, subject: Word) -> Optional[StateClause]:
        thing = self._object()
        if thing is None:
            return None
        hand = next((child for child in self._children if self._is_hand(child)), None)
        hand = hand or next((child for child in self._sentence.children(thing.index) if self._is_hand(child)), None)
        if hand is not None:
            self._asking = self._sentence.subtree(hand.index)
            return self._of_holding(subject)
        if thing.lemma.lower() in _COLOURS and self._asked_of(thing):
            self._asking = self._sentence.subtree(thing.index)
            return StateClause(COLOURED, "colour", {"theme": self._phrase(subject)})
        is_ours, asked = subject.said in US, self._asked_of(thing)
        if asked == COUNT:
            theme = self._theme(thing)
            place = self._place_of(self._top)
            where = subject if not is_ours else place
            return StateClause(LOCATED, COUNT, self._at(where, theme))
        if self._asked_of(subject) == PERSON:
            return StateClause(LOCATED, "location", {"theme": self._phrase(thing)})
        if asked:
            return None if is_ours else StateClause(HAVING, "possession", {"owner": self._phrase(subject)})
        if is_ours and self._is_asked:
            return self._more_than(thing, self._place_of(self._top)) or StateClause(
                EXISTING, WHETHER, {"theme": self._phrase(thing, self._left(thing))}
            )
        return self._held(subject, thing)

    def _of_belonging(self, subject: Word) -> Optional[StateClause]:
        thing = self._object()
        if self._lemma == _OWN:
            if thing is None:
                return None
            if self._asked_of(subject) == PERSON:
                return StateClause(BELONGING, "owner", {"theme": self._phrase(thing)})
            return (
                StateClause(HAVING, "possession", {"owner": self._phrase(subject)}) if self._asked_of(thing) else None
            )
        owner: List[Word] = [child for child in self._children if child.deprel == "obl"]
        if owner and self._asked_of(owner[0]) == PERSON:
            return StateClause(BELONGING, "owner", {"theme": self._phrase(subject)})
        if owner and self._asked_of(subject) == THING:
            return StateClause(HAVING, "possession", {"owner": self._phrase(owner[0], self._cases(owner[0]))})
        return None

    def _of_perceiving(self) -> Optional[StateClause]:
        thing = self._object()
        if thing is None or (self._features.agent and self._sentence.word(self._features.agent).said not in US):
            return None
        place = self._place_of(self._top) or self._place_of(thing)
        outside = frozenset() if place is None else self._sentence.subtree(place.index)
        where = {} if place is None else {"location": self._phrase(place)}
        asked = self._asked_of(thing)
        theme = self._theme(thing, outside)
        theme.pop("location", None)
        if asked == COUNT:
            return StateClause(LOCATED, COUNT, {**theme, **where})
        if asked and not where:
            return StateClause(EXISTING, THING, theme) if theme else None
        if asked:
            return StateClause(LOCATED, asked, {**theme, **where})
        if self._lemma == _KNOWN:
            return None
        compared = self._more_than(thing, place)
        if compared is not None:
            return compared
        if self._features.aspect in (Aspect.DONE, Aspect.EVER_DONE) and not where:
            return StateClause(LOCATED, "location", {"theme": self._phrase(thing)})
        return StateClause(LOCATED if where else EXISTING, WHETHER, {"theme": self._phrase(thing, outside), **where})
