"""Turns the words that the robot shall say into a quotation: "say don't worry", "tell her I will not come".

A quotation is one argument: its words negate nothing, and make no condition and no list. It consists of the words that
the verb of saying governs after it, without the addressee and the next command. A verb of saying is the verb of a
lexical unit whose frame has a *Message*, in FrameNet's terms.
"""

from typing import Dict, FrozenSet, Sequence, Set, Tuple

from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.messages.addressees import Addressee, has_verb
from utterance_passes.phrases.clauses import Clause, find_clauses
from utterance_passes.phrases.phrase_groups import tells_several
from utterance_passes.phrases.times import find_times
from utterance_passes.phrases.verb_matching import Saying, has_verb_of_saying, match_verbs, saying_of, stray_clause
from utterance_passes.trees.formula_file import pattern_of
from utterance_passes.trees.persons import is_person_or_name
from utterance_passes.trees.tree import NOUNS, QUOTATION_MARKS, QUOTED, VERBS, DependencyTree, Word
from utterance_passes.trees.tree_edits import TreeEdit
from utterance_passes.trees.vocabulary import Speech, Verbs, Vocabulary
from word_classes import word_class

_AS_SOON_AS = ["as", "soon", "as"]
_AFTER_NO = word_class("more_words") | word_class("noun_standins") | {"word"}
_COMPARISONS = pattern_of("comparisons")
_CONDITIONS = word_class("conditions")
_COURTESIES = word_class("greetings") | word_class("thanks")
_HARMLESS = word_class("harmless")
_NEGATIONS = word_class("negations")
_NO_PRONOUNS = word_class("no_pronouns")
_PERSONS_TOLD = word_class("pronouns_of_persons")
_QUESTION_WORDS = word_class("question_words")
_TIMES = word_class("iteration_adverbs")
_OTHERWISE = word_class("words_between_commands") - word_class("linking_conjunctions")
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
            addressee = Addressee(tree, self._verb, self._start, self._end)
            self._moved.update(addressee.moved)
            self._start, self._is_all_behind = addressee.behind, addressee.is_all_behind

    def tree(self) -> DependencyTree:
        """Return the sentence with the quotation as one object; unchanged if nothing is quoted."""
        tree = self._tree
        if self._requested:
            edit = TreeEdit(tree)
            edit.rehang(self._requested, self._verb, "xcomp")
            for child in tree.children(self._verb):
                # "Tell Bob *not* to come": Bob is told.
                if child.said in _NEGATIONS and self._start <= child.index < self._requested:
                    edit.rehang(child.index, self._requested, "advmod")
            return edit.tree()
        inside = self._without_addressee(self._between_marks() or self._without_condition(self._governed()))
        if not inside or not inside <= self._tree.subtree(self._verb) or _is_of_nothing(self._tree, inside):
            return tree
        # "Inform Bob as soon *as possible*" has no message.
        behind = [word.said for word in tree.words[self._start - 1 : max(inside)]]
        if any(_COMPARISONS.fullmatch(" ".join(behind[first:])) for first in range(len(behind) - len(inside) + 1)):
            return tree
        counts = [word.index for word in tree.words[self._verb :] if word.said in _TIMES]
        if len(counts) > 1 and not inside.isdisjoint(counts):
            return tree  # "Say hello twice and goodbye *once*": nobody says "goodbye once" twice.
        edit = TreeEdit(tree)
        head = self._head(inside)
        first = self._tree.word(min(inside))
        is_asked = self._tree.is_infinitive(head.index)  # "Tell Bob *when to come*."
        if first.said in _PUTTING_OFF and has_verb(self._tree, inside) and not is_asked:
            edit.relabel(head.index, "advcl")
            return edit.tree()
        is_phrase = inside == self._tree.subtree(head.index) and head.deprel in ("obj", "ccomp")
        if is_phrase and not self._moved and not any(_is_more_than_a_name(self._tree, index) for index in inside):
            return tree
        is_mark = first.deprel in ("mark", "det") or self._is_all_behind
        if first.said == "that" and is_mark and has_verb(self._tree, inside):
            self._moved[first.index] = (head.index, "mark")
        for word in tree.words:
            if word.index in self._names:
                edit.retag(word.index, "PROPN", "NNP")
            if word.index in self._moved:
                governor, relation = self._moved[word.index]
                edit.rehang(word.index, governor, relation)
            elif word.index == head.index:
                edit.rehang(word.index, self._verb, "obj")
                if word.said in _NEGATIONS:
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
                and not _name_taken_for_a_verb(self._tree, word)
                and self._tree.is_infinitive(word.index)
                # "Tell Bob *how to come*" says something.
                and self._tree.word(self._tree.phrase_start(word.index)).said not in _QUESTION_WORDS
            ),
            0,
        )

    def _next_command(self, clauses: Sequence[Clause], vocabulary: Vocabulary) -> int:
        """Return the position where the next command begins, its joining words included: "say hello and turn left"."""
        for child in self._tree.children(self._verb):
            spoken = (self._tree.word(index) for index in sorted(self._tree.subtree(child.index)))
            first_word = next((word for word in spoken if word.upos != "PUNCT"), child)
            is_other = child.deprel == "ccomp" and first_word.said in _OTHERWISE
            if is_other and first_word.index > self._start:
                # "Say yes, *otherwise say no*": the second verb is no part of what is said.
                self._moved[child.index] = (self._verb, "parataxis")
                return first_word.index
        for clause in clauses:
            word = self._tree.word(clause.verb)
            first = self._tree.phrase_start(word.index)
            is_joined = word.head == self._verb and word.deprel in ("conj", "parataxis", "list")
            before = first
            while before > self._start and _is_joint(self._tree.word(before - 1)):
                before -= 1
            is_parted = before < first or _is_joint(self._tree.word(first))
            if is_joined and is_parted and before > self._start and not clause.subject:
                if match_verbs(self._tree, clause, vocabulary):
                    return before
        return len(self._tree.words) + 1

    def _as_soon_as(self) -> int:
        """Return where a condition begins behind words without a verb: "say hello *as soon as the bell rings*"."""
        forms = [word.said for word in self._tree.words]
        starts = range(self._start, len(forms) - 2)
        found = next((place for place in starts if forms[place : place + 3] == _AS_SOON_AS), len(forms))
        return found + 1 if not has_verb(self._tree, range(self._start, found + 1)) else len(forms) + 1

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
            if has_verb(self._tree, before):
                break
            if word.said not in _CONDITIONS or word.deprel not in ("mark", "advmod"):
                continue
            behind = inside - before
            top = self._tree.governor(word)
            while top.head in behind:
                top = self._tree.governor(top)
            has_subject = self._tree.subject(top.index) is not None
            if top.index in behind and has_subject and has_verb(self._tree, behind):
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
            return any(other.said == "but" for other in self._tree.children(child.index))
        if child.said in _HARMLESS and relation in ("discourse", "vocative", "advmod"):
            is_last = child.index == self._end - 1
            return child.said not in _COURTESIES and (bool(inside) or not is_last)
        # In "say what day it is to Bob" the parser may take Bob for a predicate.
        if any(inner.deprel == "cop" for inner in self._tree.children(child.index)):
            return False
        is_phrase = relation in ("obl", "nmod", "advmod") and child.said not in _NEGATIONS
        return self._tree.preposition(child.index) == "to" or (is_phrase and not has_verb(self._tree, inside))

    def _without_addressee(self, inside: FrozenSet[int]) -> FrozenSet[int]:
        """Remove "to Bob" from the message; a place after it says where Bob is."""
        for index in sorted(inside):
            word = self._tree.word(index)
            cases = [child.index for child in self._tree.prepositions(index)]
            name = _name_taken_for_a_verb(self._tree, word)
            if name:
                self._moved[name] = (index, "case")
                self._names.add(index)
                cases = [name]
            phrase = frozenset(i for i in self._tree.subtree(index) if not cases or i >= cases[0])
            is_to = bool(name) or self._tree.preposition(index) == "to"
            is_end = max(phrase & inside) == max(inside) and phrase < inside
            is_somebody = name or word.said in _PERSONS_TOLD or is_person_or_name(word)
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
        tops = [w for w in self._tree.children(self._verb) if self._tree.preposition(w.index) and w.index not in inside]
        for person, place in zip(tops, tops[1:]):
            is_next = self._tree.is_next(place.index, person.index)
            if (
                self._tree.preposition(person.index) == "to"
                and is_next
                and self._tree.preposition(place.index) in _PLACE_PREPOSITIONS
            ):
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
                if child.upos in NOUNS and self._tree.preposition(child.index) in _PLACE_PREPOSITIONS
            ),
            0,
        )

    def _head(self, inside: FrozenSet[int]) -> Word:
        """Return the word that will govern the others: one whose head is outside, an object if possible."""
        words = [self._tree.word(index) for index in sorted(inside)]
        tops = [word for word in words if word.head not in inside and word.upos != "PUNCT"]
        ranks = {"obj": 0, "ccomp": 1, "xcomp": 2, "parataxis": 3, "conj": 4}
        return min(tops or words, key=lambda word: ranks.get(word.deprel, 5))


def _is_joint(word: Word) -> bool:
    return word.deprel == "cc" or word.upos == "PUNCT" or word.said == "then"


def _name_taken_for_a_verb(tree: DependencyTree, word: Word) -> int:
    """Return the position of "to" before an unknown name that the parser takes for a verb: "what day it is to
    *Hayden*"; 0 for other words."""
    children = tree.children(word.index)
    to = next((child.index for child in children if child.deprel == "mark" and child.said == "to"), 0)
    is_predicate = any(child.deprel == "cop" and child.index < to for child in children)
    return to if to == word.index - 1 and word.form[:1].isupper() and is_predicate else 0


def _is_of_nothing(tree: DependencyTree, inside: FrozenSet[int]) -> bool:
    forms = [tree.word(index).said for index in sorted(inside)]
    is_no_thing = forms[0] == "no" and len(forms) > 1 and forms[1] in _AFTER_NO
    return not has_verb(tree, inside) and (forms[0] in _NO_PRONOUNS or is_no_thing)


def _is_more_than_a_name(tree: DependencyTree, index: int) -> bool:
    word = tree.word(index)
    is_verb = word.upos in VERBS
    return is_verb or word.deprel in ("conj", "mark") or word.said in _NEGATIONS | _CONDITIONS
