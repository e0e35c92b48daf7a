"""Finds who is told something: the addressee between a verb of telling and the message, "tell *Bob* to come"."""

from typing import Dict, FrozenSet, Iterable, Tuple

from utterance_passes.trees.persons import is_person, is_person_or_name
from utterance_passes.trees.tree import NOUNS, VERBS, DependencyTree, Word
from word_classes import word_class

_QUESTION_WORDS = word_class("question_words")
_SUBJECTS = word_class("subject_pronouns") - word_class("relative_pronouns")


def has_verb(tree: DependencyTree, positions: Iterable[int]) -> bool:
    """Whether there is a verb among some words."""
    return any(tree.word(index).upos in VERBS for index in positions)


class Addressee:
    """The addressee right behind a verb of telling.

    Attributes:
        moved: correct head and relation of words that the parser attached wrongly
        is_all_behind: whether all words behind the addressee are the message
        behind: where the message begins
    """

    def __init__(self, tree: DependencyTree, verb: int, start: int, end: int) -> None:
        """
        Args:
            tree: the sentence
            verb: position of the verb of telling
            start: where the words behind it begin
            end: behind the last of them
        """
        self._tree, self._verb, self._start, self._end = tree, verb, start, end
        self.moved: Dict[int, Tuple[int, str]] = {}
        self.is_all_behind = False
        told = self._told()
        self.behind = max(told) + 1 if told else start

    def _told(self) -> FrozenSet[int]:
        """Return the words of the addressee: "tell *Bob* to come", "tell *my wife* dinner is ready"; none for none."""
        children = [child for child in self._tree.children(self._verb) if child.index >= self._start]
        is_clause = any(
            child.deprel in ("ccomp", "xcomp", "parataxis", "advcl") and child.index < self._end for child in children
        )
        told: FrozenSet[int] = frozenset()
        for child in children:
            # "Tell *what day* it is to Bob": the object is a part of the message.
            is_asked = self._tree.word(self._start).said in _QUESTION_WORDS
            is_person = not is_asked and (child.deprel == "iobj" or (child.deprel == "obj" and is_clause))
            if is_person and self._tree.phrase_start(child.index) == self._start:
                told = self._tree.subtree(child.index)
                if self._is_everything(told):
                    told = self._told_before_question() or self._told_before_noun_phrase() or told
                self.moved.update({} if child.deprel == "iobj" else {child.index: (self._verb, "iobj")})
                break
        owner = self._tree.word(self._start) if self._start < self._end - 2 else None
        person = self._tree.word(self._start + 1) if owner is not None else None
        if (
            not told
            and owner is not None
            and owner.xpos == "PRP$"
            and person is not None
            and person.deprel == "compound"
        ):
            told = frozenset([owner.index, person.index])
            self.moved[person.index] = (self._verb, "iobj")
            self.moved[owner.index] = (person.index, "nmod:poss")
        if (
            not told
            and owner is not None
            and owner.said == "her"
            and has_verb(self._tree, range(self._start, self._end))
        ):
            told = frozenset([owner.index])
            self.moved[owner.index] = (self._verb, "iobj")
        return told or self._told_before_question() or self._told_before_clause() or self._told_before_noun_phrase()

    def _is_everything(self, told: FrozenSet[int]) -> bool:
        """Whether the addressee has all words: "tell *the man raising his arm dinner is ready*"."""
        words = self._tree.words[self._start - 1 : self._end - 1]
        return all(one.index in told or one.upos == "PUNCT" for one in words)

    def _told_before_question(self) -> FrozenSet[int]:
        """Return the words of a person before an indirect question: "tell *the man at the door* what day it is"."""
        words = self._tree.words[self._start - 1 : self._end - 1]
        question = next((word.index for word in words if word.said in _QUESTION_WORDS), 0)
        before = [word for word in words if word.index < question]
        person = next((word for word in before if is_person(word) and word.head == self._verb), None)
        is_told = person is not None and before[0].upos in ("DET", "NOUN", "PROPN", "PRON")
        if person is None or not is_told or not has_verb(self._tree, range(question, self._end)):
            return frozenset()
        self.moved[person.index] = (self._verb, "iobj")
        self.is_all_behind = self._is_everything(self._tree.subtree(person.index))
        return frozenset(word.index for word in before)

    def _told_before_clause(self) -> FrozenSet[int]:
        """Return a person whom the parser takes for a part of the subject behind: "tell *Anna* dinner is ready"."""
        words = self._tree.words[self._start - 1 : self._end - 1]
        place = next((place for place, word in enumerate(words) if is_person_or_name(word)), None)
        following = [word.said for word in words[place + 1 : place + 2]] if place is not None else []
        if place is not None and following == ["'s"]:
            # "Bob's *mother*"
            place = next((p for p, word in enumerate(words) if p > place + 1 and is_person(word)), None)
        if place is None or not words[place].head:
            return frozenset()
        person, subject = words[place], self._tree.governor(words[place])
        is_inside = subject.deprel.startswith("nsubj") and person.index < subject.index < self._end
        is_part = person.deprel.split(":")[0] in ("compound", "nmod", "flat")
        is_named = bool(self._tree.prepositions(person.index))
        if not is_inside or not is_part or subject.upos == "PROPN" or is_named:
            return frozenset()
        told = frozenset(range(self._start, person.index + 1))
        self._hang_on_person(person, told)
        return told

    def _begins_message(self, word: Word) -> bool:
        """Whether a word right behind a noun begins what is told: an article, a subject, or "that" before these."""
        if word.said == "that":
            following = self._tree.word(word.index + 1) if word.index + 1 < self._end else word
            return following.upos == "DET" or following.said in _SUBJECTS
        return word.upos == "DET" or word.said in _SUBJECTS

    def _hang_on_person(self, person: Word, told: FrozenSet[int]) -> None:
        self.moved[person.index] = (self._verb, "iobj")
        for index in told - {person.index}:
            word = self._tree.word(index)
            if word.head not in told:
                self.moved[index] = (person.index, "nmod" if word.upos in NOUNS else word.deprel)

    def _told_before_noun_phrase(self) -> FrozenSet[int]:
        """Return the words of a described person before another noun phrase: "tell *the man waving in the hall* the
        time"."""
        words = self._tree.words[self._start - 1 : self._end - 1]
        front = next((place for place, word in enumerate(words) if word.upos in NOUNS), None)
        if front is None or not is_person(words[front]) or words[front].head != self._verb:
            return frozenset()
        if any(word.upos not in ("DET", "ADJ", "NUM") for word in words[:front]):
            return frozenset()
        person = words[front]
        bounds = zip(words[front:], words[front + 1 :])
        behind = next((word for before, word in bounds if before.upos in NOUNS and self._begins_message(word)), None)
        if behind is None:
            return frozenset()
        told = frozenset(word.index for word in words if word.index < behind.index)
        self._hang_on_person(person, told)
        self.is_all_behind = True
        return told
