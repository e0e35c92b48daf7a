"""Turns the words that the robot shall say into a quotation: "say don't worry", "tell her I will not come".

A quotation is one argument: its words negate nothing, and make no condition and no list. It consists of the words that
the verb of saying governs after it, without the addressee and the next command. A verb of saying is the verb of a
lexical unit whose frame has a *Message*, in FrameNet's terms.
"""

from typing import Dict, FrozenSet, Iterable, Sequence, Set, Tuple

from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.phrases.clauses import Clause, find_clauses
from utterance_passes.phrases.phrase_groups import tells_several
from utterance_passes.phrases.times import find_times
from utterance_passes.phrases.verb_matching import Saying, has_verb_of_saying, match_verbs, saying_of, stray_clause
from utterance_passes.trees.formula_file import pattern_of
from utterance_passes.trees.persons import is_person, is_person_or_name
from utterance_passes.trees.tree import QUOTATION_MARKS, QUOTED, DependencyTree, Word
from utterance_passes.trees.tree_edits import TreeEdit
from utterance_passes.trees.vocabulary import Speech, Verbs, Vocabulary
from word_classes import word_class

_AS_SOON_AS = ["as", "soon", "as"]
_AFTER_NO = word_class("after_no")
_COMPARISONS = pattern_of("comparisons")
_CONDITIONS = word_class("conditions")
_NOUNS = frozenset(["NOUN", "PROPN"])
_COURTESIES = word_class("courtesies")
_HARMLESS = word_class("harmless")
_NEGATIONS = word_class("negations")
_NO_PRONOUNS = word_class("no_pronouns")
_PERSONS_TOLD = word_class("persons_told")
_SUBJECTS = word_class("subjects_told")
_QUESTION_WORDS = word_class("question_words")
_TIMES = word_class("iteration_adverbs")
_OTHERWISE = word_class("contrasting_adverbs")
_PLACE_PREPOSITIONS = word_class("place_prepositions")
#: These conjunctions are not quoted: they delay the saying ("tell me when dinner is ready").
_PUTTING_OFF = _CONDITIONS - {"if"}


@tree_pass(
    Kind.MEANING,
    Example(
        "tell|VERB|0|root her|PRON|3|nmod:poss|her|PRP$ lunch|NOUN|5|nsubj is|AUX|5|cop|be ready|ADJ|1|ccomp",
        (
            "her: nmod:poss(lunch) -> iobj(tell)",
            "lunch: nsubj(ready) -> flat:quoted(ready)",
            "is: cop(ready) -> flat:quoted(ready)",
            "ready: ccomp(tell) -> obj(tell)",
        ),
        Verbs(frozenset(["tell"]), speech={"tell": Speech.TOLD}),
    ),
    assigns=[QUOTED, "obj", "iobj", "xcomp", "ccomp", "advcl", "advmod", "parataxis", "mark", "nmod", "nmod:poss"],
)
def quotations(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Turn the words that the robot shall say into one object."""
    if not has_verb_of_saying(tree, vocabulary):
        return tree
    behind = 0
    while True:
        clauses = find_clauses(tree, vocabulary)
        saying = next(
            (
                saying
                for clause in clauses
                if clause.verb > behind
                for saying in [saying_of(tree, clause, vocabulary)]
                if saying is not None
                # "Tell Anna the time and Ben the weather" tells two persons something each.
                if not tells_several(tree, clause, saying.speech)
            ),
            None,
        )
        if saying is None:
            return tree
        behind = saying.clause.verb
        stray = stray_clause(tree, saying)
        if stray:
            edit = TreeEdit(tree)
            edit.rehang(stray, behind, "ccomp")
            tree = edit.tree()
            clauses = find_clauses(tree, vocabulary)
        tree = _Quotation(tree, saying, clauses, vocabulary).tree()


class _Quotation:
    """The quotation of one verb of saying."""

    def __init__(self, tree: DependencyTree, saying: Saying, clauses: Sequence[Clause], vocabulary: Vocabulary) -> None:
        self._tree = tree
        self._verb = saying.clause.verb
        self._start = saying.last + 1
        #: Correct head and relation of words that the parser attached wrongly.
        self._moved: Dict[int, Tuple[int, str]] = {}
        #: Names that the parser takes for verbs.
        self._names: Set[int] = set()
        #: Whether all words behind the addressee are the message.
        self._is_all_behind = False
        self._end = min(self._next_command(clauses, vocabulary), self._as_soon_as())
        #: Verb of what somebody is asked to do; it is no quotation.
        self._requested = self._infinitive() if saying.speech is Speech.TOLD else 0
        if saying.speech is Speech.TOLD:
            self._skip_addressee()

    def tree(self) -> DependencyTree:
        """Return the sentence with the quotation as one object; unchanged if nothing is quoted."""
        tree = self._tree
        if self._requested:
            edit = TreeEdit(tree)
            edit.rehang(self._requested, self._verb, "xcomp")
            for child in tree.children(self._verb):
                # "Tell Bob *not* to come": Bob is told.
                if child.form.lower() in _NEGATIONS and self._start <= child.index < self._requested:
                    edit.rehang(child.index, self._requested, "advmod")
            return edit.tree()
        inside = self._without_addressee(self._between_marks() or self._without_condition(self._governed()))
        if not inside or not inside <= self._tree.subtree(self._verb) or self._is_of_nothing(inside):
            return tree
        # "Inform Bob as soon *as possible*" has no message.
        behind = [word.form.lower() for word in tree.words[self._start - 1 : max(inside)]]
        if any(_COMPARISONS.fullmatch(" ".join(behind[first:])) for first in range(len(behind) - len(inside) + 1)):
            return tree
        counts = [word.index for word in tree.words[self._verb :] if word.form.lower() in _TIMES]
        if len(counts) > 1 and not inside.isdisjoint(counts):
            return tree  # "Say hello twice and goodbye *once*": nobody says "goodbye once" twice.
        edit = TreeEdit(tree)
        head = self._head(inside)
        first = self._tree.word(min(inside))
        is_asked = self._tree.is_infinitive(head.index)  # "Tell Bob *when to come*."
        if first.form.lower() in _PUTTING_OFF and self._has_verb(inside) and not is_asked:
            edit.relabel(head.index, "advcl")
            return edit.tree()
        is_phrase = inside == self._tree.subtree(head.index) and head.deprel in ("obj", "ccomp")
        if is_phrase and not self._moved and not any(self._is_more_than_a_name(index) for index in inside):
            return tree
        is_mark = first.deprel in ("mark", "det") or self._is_all_behind
        if first.form.lower() == "that" and is_mark and self._has_verb(inside):
            self._moved[first.index] = (head.index, "mark")
        for word in tree.words:
            if word.index in self._names:
                edit.retag(word.index, "PROPN", "NNP")
            if word.index in self._moved:
                governor, relation = self._moved[word.index]
                edit.rehang(word.index, governor, relation)
            elif word.index == head.index:
                edit.rehang(word.index, self._verb, "obj")
                if word.form.lower() in _NEGATIONS:
                    edit.retag(word.index, "INTJ")
            elif word.index in inside:
                edit.rehang(word.index, head.index, QUOTED)
            elif word.head in inside:
                edit.rehang(word.index, self._verb)
        return edit.tree()

    def _infinitive(self) -> int:
        """Return the verb of what the addressee is asked to do: "tell Bob to *come*"; 0 if there is none."""
        objects = [child for child in self._tree.children(self._verb) if child.deprel in ("obj", "iobj")]
        if len(objects) != 1 or objects[0].index < self._start:
            return 0
        # "Tell the man *waiting* at the door to come."
        described = [child.index for child in self._tree.children(objects[0].index) if child.deprel == "acl"]
        heads = (self._verb, objects[0].index, *described)
        return next(
            (
                word.index
                for word in reversed(self._tree.words[objects[0].index : self._end - 1])
                if word.head in heads
                and word.deprel in ("xcomp", "advcl", "ccomp", "acl")
                and not self._name_taken_for_a_verb(word)
                and self._tree.is_infinitive(word.index)
                # "Tell Bob *how to come*" says something.
                and self._tree.word(min(self._tree.subtree(word.index))).form.lower() not in _QUESTION_WORDS
            ),
            0,
        )

    def _next_command(self, clauses: Sequence[Clause], vocabulary: Vocabulary) -> int:
        """Return the position where the next command begins, its joining words included: "say hello and turn left"."""
        for child in self._tree.children(self._verb):
            spoken = (self._tree.word(index) for index in sorted(self._tree.subtree(child.index)))
            first_word = next((word for word in spoken if word.upos != "PUNCT"), child)
            is_other = child.deprel == "ccomp" and first_word.form.lower() in _OTHERWISE
            if is_other and first_word.index > self._start:
                # "Say yes, *otherwise say no*": the second verb is no part of what is said.
                self._moved[child.index] = (self._verb, "parataxis")
                return first_word.index
        for clause in clauses:
            word = self._tree.word(clause.verb)
            first = min(self._tree.subtree(word.index))
            is_joined = word.head == self._verb and word.deprel in ("conj", "parataxis", "list")
            before = first
            while before > self._start and self._is_joint(self._tree.word(before - 1)):
                before -= 1
            is_parted = before < first or self._is_joint(self._tree.word(first))
            if is_joined and is_parted and before > self._start and not clause.subject:
                if match_verbs(self._tree, clause, vocabulary):
                    return before
        return len(self._tree.words) + 1

    def _as_soon_as(self) -> int:
        """Return where a condition begins behind words without a verb: "say hello *as soon as the bell rings*"."""
        forms = [word.form.lower() for word in self._tree.words]
        starts = range(self._start, len(forms) - 2)
        found = next((place for place in starts if forms[place : place + 3] == _AS_SOON_AS), len(forms))
        return found + 1 if not self._has_verb(range(self._start, found + 1)) else len(forms) + 1

    @staticmethod
    def _is_joint(word: Word) -> bool:
        return word.deprel == "cc" or word.upos == "PUNCT" or word.form.lower() == "then"

    def _skip_addressee(self) -> None:
        """Move the start past the addressee: "tell *Bob* to come", "tell *my wife* dinner is ready"."""
        children = [child for child in self._tree.children(self._verb) if child.index >= self._start]
        is_clause = any(
            child.deprel in ("ccomp", "xcomp", "parataxis", "advcl") and child.index < self._end for child in children
        )
        told: FrozenSet[int] = frozenset()
        for child in children:
            # "Tell *what day* it is to Bob": the object is a part of the message.
            is_asked = self._tree.word(self._start).form.lower() in _QUESTION_WORDS
            is_person = not is_asked and (child.deprel == "iobj" or (child.deprel == "obj" and is_clause))
            if is_person and min(self._tree.subtree(child.index)) == self._start:
                told = self._tree.subtree(child.index)
                if self._is_everything(told):
                    told = self._told_before_question() or self._told_before_noun_phrase() or told
                self._moved.update({} if child.deprel == "iobj" else {child.index: (self._verb, "iobj")})
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
            self._moved[person.index] = (self._verb, "iobj")
            self._moved[owner.index] = (person.index, "nmod:poss")
        if (
            not told
            and owner is not None
            and owner.form.lower() == "her"
            and self._has_verb(range(self._start, self._end))
        ):
            told = frozenset([owner.index])
            self._moved[owner.index] = (self._verb, "iobj")
        told = told or self._told_before_question() or self._told_before_clause() or self._told_before_noun_phrase()
        self._start = max(told) + 1 if told else self._start

    def _is_everything(self, told: FrozenSet[int]) -> bool:
        """Whether the addressee has all words: "tell *the man raising his arm dinner is ready*"."""
        words = self._tree.words[self._start - 1 : self._end - 1]
        return all(one.index in told or one.upos == "PUNCT" for one in words)

    def _told_before_question(self) -> FrozenSet[int]:
        """Return the words of a person before an indirect question: "tell *the man at the door* what day it is"."""
        words = self._tree.words[self._start - 1 : self._end - 1]
        question = next((word.index for word in words if word.form.lower() in _QUESTION_WORDS), 0)
        before = [word for word in words if word.index < question]
        person = next((word for word in before if is_person(word) and word.head == self._verb), None)
        is_told = person is not None and before[0].upos in ("DET", "NOUN", "PROPN", "PRON")
        if person is None or not is_told or not self._has_verb(range(question, self._end)):
            return frozenset()
        self._moved[person.index] = (self._verb, "iobj")
        self._is_all_behind = self._is_everything(self._tree.subtree(person.index))
        return frozenset(word.index for word in before)

    def _told_before_clause(self) -> FrozenSet[int]:
        """Return a person whom the parser takes for a part of the subject behind: "tell *Anna* dinner is ready"."""
        words = self._tree.words[self._start - 1 : self._end - 1]
        place = next((place for place, word in enumerate(words) if is_person_or_name(word)), None)
        following = [word.form.lower() for word in words[place + 1 : place + 2]] if place is not None else []
        if place is not None and following == ["'s"]:
            # "Bob's *mother*"
            place = next((p for p, word in enumerate(words) if p > place + 1 and is_person(word)), None)
        if place is None or not words[place].head:
            return frozenset()
        person, subject = words[place], self._tree.word(words[place].head)
        is_inside = subject.deprel.startswith("nsubj") and person.index < subject.index < self._end
        is_part = person.deprel.split(":")[0] in ("compound", "nmod", "flat")
        is_named = any(child.deprel == "case" for child in self._tree.children(person.index))
        if not is_inside or not is_part or subject.upos == "PROPN" or is_named:
            return frozenset()
        told = frozenset(range(self._start, person.index + 1))
        self._hang_on_person(person, told)
        return told

    def _begins_message(self, word: Word) -> bool:
        """Whether a word right behind a noun begins what is told: an article, a subject, or "that" before these."""
        if word.form.lower() == "that":
            following = self._tree.word(word.index + 1) if word.index + 1 < self._end else word
            return following.upos == "DET" or following.form.lower() in _SUBJECTS
        return word.upos == "DET" or word.form.lower() in _SUBJECTS

    def _hang_on_person(self, person: Word, told: FrozenSet[int]) -> None:
        self._moved[person.index] = (self._verb, "iobj")
        for index in told - {person.index}:
            word = self._tree.word(index)
            if word.head not in told:
                self._moved[index] = (person.index, "nmod" if word.upos in _NOUNS else word.deprel)

    def _told_before_noun_phrase(self) -> FrozenSet[int]:
        """Return the words of a described person before another noun phrase: "tell *the man waving in the hall* the
        time"."""
        words = self._tree.words[self._start - 1 : self._end - 1]
        front = next((place for place, word in enumerate(words) if word.upos in ("NOUN", "PROPN")), None)
        if front is None or not is_person(words[front]) or words[front].head != self._verb:
            return frozenset()
        if any(word.upos not in ("DET", "ADJ", "NUM") for word in words[:front]):
            return frozenset()
        person = words[front]
        bounds = zip(words[front:], words[front + 1 :])
        behind = next((word for before, word in bounds if before.upos in _NOUNS and self._begins_message(word)), None)
        if behind is None:
            return frozenset()
        told = frozenset(word.index for word in words if word.index < behind.index)
        self._hang_on_person(person, told)
        self._is_all_behind = True
        return told

    def _between_marks(self) -> FrozenSet[int]:
        inside: Set[int] = set()
        for quoted in self._tree.between_marks:
            between = self._tree.words[max(inside, default=min(quoted)) : min(quoted) - 1]
            # 'Say "hello" *and* "goodbye".'
            if min(quoted) > self._start and all(word.upos in ("CCONJ", "PUNCT") for word in between):
                inside |= quoted.union(word.index for word in between if word.form not in QUOTATION_MARKS)
        return frozenset(inside)

    def _governed(self) -> FrozenSet[int]:
        """Return the words that the verb governs and that belong to the message."""
        inside: Set[int] = set()
        if self._is_all_behind:
            inside.update(range(self._start, self._end))
        for child in self._tree.children(self._verb):
            positions = {
                index
                for index in self._tree.subtree(child.index) - self._tree.abandoned
                if self._start <= index < self._end and index not in self._moved
            }
            if positions and not self._is_beside(child, inside):
                inside |= positions
        spoken = [index for index in sorted(inside) if self._tree.word(index).upos != "PUNCT"]
        return frozenset(index for index in inside if spoken and spoken[0] <= index <= spoken[-1])

    def _without_condition(self, inside: FrozenSet[int]) -> FrozenSet[int]:
        """Remove a condition behind a message that is complete without it: "say hello *if somebody is in the room*".

        A message with a verb may have a condition of its own: "say that I will come when I can".
        """
        for index in sorted(inside)[1:]:
            word = self._tree.word(index)
            before = frozenset(other for other in inside if other < index)
            if self._has_verb(before):
                break
            if word.form.lower() not in _CONDITIONS or word.deprel not in ("mark", "advmod"):
                continue
            behind = inside - before
            top = self._tree.word(word.head)
            while top.head in behind:
                top = self._tree.word(top.head)
            has_subject = any(child.deprel.startswith("nsubj") for child in self._tree.children(top.index))
            if top.index in behind and has_subject and self._has_verb(behind):
                self._moved[top.index] = (self._verb, "advcl")
                return before
        return inside

    def _is_beside(self, child: Word, inside: Set[int]) -> bool:
        """Whether a phrase says how, when or to whom to say something, and is not a part of the message."""
        relation = child.deprel.split(":")[0]
        if child.deprel == "iobj" or relation in ("punct", "cc", "advcl"):
            return True
        if relation == "conj" and child.upos == "ADV" and inside:
            # "Say hello, *but quietly*".
            return any(other.form.lower() == "but" for other in self._tree.children(child.index))
        if child.form.lower() in _HARMLESS and relation in ("discourse", "vocative", "advmod"):
            is_last = child.index == self._end - 1
            return child.form.lower() not in _COURTESIES and (bool(inside) or not is_last)
        # In "say what day it is to Bob" the parser may take Bob for a predicate.
        if any(inner.deprel == "cop" for inner in self._tree.children(child.index)):
            return False
        is_phrase = relation in ("obl", "nmod", "advmod") and child.form.lower() not in _NEGATIONS
        return self._case(child.index) == "to" or (is_phrase and not self._has_verb(inside))

    def _case(self, index: int) -> str:
        return next((w.form.lower() for w in self._tree.children(index) if w.deprel == "case"), "")

    def _without_addressee(self, inside: FrozenSet[int]) -> FrozenSet[int]:
        """Remove "to Bob" from the message; a place after it says where Bob is."""
        for index in sorted(inside):
            word = self._tree.word(index)
            cases = [child.index for child in self._tree.children(index) if child.deprel == "case"]
            name = self._name_taken_for_a_verb(word)
            if name:
                self._moved[name] = (index, "case")
                self._names.add(index)
                cases = [name]
            phrase = frozenset(i for i in self._tree.subtree(index) if not cases or i >= cases[0])
            is_to = bool(name) or self._case(index) == "to"
            is_end = max(phrase & inside) == max(inside) and phrase < inside
            is_somebody = name or word.form.lower() in _PERSONS_TOLD or is_person_or_name(word)
            has_subject = any(
                self._tree.word(i).deprel.startswith("nsubj") and self._tree.word(i).head != index
                for i in inside - phrase
            )
            behind = self._place_at_end(inside, phrase) if is_to else 0
            if is_to and (is_end or behind) and is_somebody and not has_subject:
                self._moved[index] = (self._verb, "obl")
                inside = inside - phrase
                if behind:
                    self._moved[behind] = (index, "nmod")
                    inside = inside - self._tree.subtree(behind)
                break
        tops = [w for w in self._tree.children(self._verb) if self._case(w.index) and w.index not in inside]
        for person, place in zip(tops, tops[1:]):
            is_next = self._tree.is_next(place.index, person.index)
            if self._case(person.index) == "to" and is_next and self._case(place.index) in _PLACE_PREPOSITIONS:
                if not find_times(self._tree) and inside:
                    self._moved[place.index] = (person.index, "nmod")
        return inside

    def _place_at_end(self, inside: FrozenSet[int], phrase: FrozenSet[int]) -> int:
        """Return the head of a place that is all that is said behind a phrase: "to Bob *at the door*"; 0 if there is
        none."""
        behind = frozenset(index for index in inside if index > max(phrase))
        return next(
            (
                child.index
                for child in self._tree.children(self._verb)
                if behind and self._tree.subtree(child.index) == behind
                if child.upos in _NOUNS and self._case(child.index) in _PLACE_PREPOSITIONS
            ),
            0,
        )

    def _name_taken_for_a_verb(self, word: Word) -> int:
        """Return the position of "to" before an unknown name that the parser takes for a verb: "what day it is to
        *Hayden*"; 0 for other words."""
        children = self._tree.children(word.index)
        to = next((child.index for child in children if child.deprel == "mark" and child.form.lower() == "to"), 0)
        is_predicate = any(child.deprel == "cop" and child.index < to for child in children)
        return to if to == word.index - 1 and word.form[:1].isupper() and is_predicate else 0

    def _has_verb(self, positions: Iterable[int]) -> bool:
        return any(self._tree.word(index).upos in ("VERB", "AUX") for index in positions)

    def _is_of_nothing(self, inside: FrozenSet[int]) -> bool:
        forms = [self._tree.word(index).form.lower() for index in sorted(inside)]
        is_no_thing = forms[0] == "no" and len(forms) > 1 and forms[1] in _AFTER_NO
        return not self._has_verb(inside) and (forms[0] in _NO_PRONOUNS or is_no_thing)

    def _head(self, inside: FrozenSet[int]) -> Word:
        """Return the word that will govern the others: one whose head is outside, an object if possible."""
        words = [self._tree.word(index) for index in sorted(inside)]
        tops = [word for word in words if word.head not in inside and word.upos != "PUNCT"]
        ranks = {"obj": 0, "ccomp": 1, "xcomp": 2, "parataxis": 3, "conj": 4}
        return min(tops or words, key=lambda word: ranks.get(word.deprel, 5))

    def _is_more_than_a_name(self, index: int) -> bool:
        word = self._tree.word(index)
        is_verb = word.upos in ("VERB", "AUX")
        return is_verb or word.deprel in ("conj", "mark") or word.form.lower() in _NEGATIONS | _CONDITIONS
