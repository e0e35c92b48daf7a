"""The clauses of a sentence: each verb that asks for something, with the words that belong to it."""

from dataclasses import dataclass, replace
from typing import FrozenSet, List, Optional, Set, Tuple

from stanford_parser_ros.tree import Word

from semantic_framer.lexicon import Lexicon
from semantic_framer.sentence import Sentence

#: Verbs that wrap a request: "I want you to ...", "would you mind ...ing", "could you try to ...".
WRAPPERS = frozenset("want need like mind wish try remember ask love prefer let have help".split())
#: Verbs that only lead to the next one: "go get the mug", "come and help".
_MOTION = frozenset(["go", "come", "try"])
NEGATIONS = frozenset("not never n't no dont don't neither nor nobody noone none nothing".split())
#: Subordinators that make an action depend on something, or put it off.
CONDITIONS = frozenset("if when until till unless once after before while whenever as".split())
#: Joined by one of these a clause is a new one: "I want to go home, *so* open the door".
RENEWING = frozenset(["so", "but"])
#: "Follow me no more."
_NO_MORE = (("no", "more"), ("no", "longer"))
#: What an action is said to be done with, or to, when it is not to be done: "take no box", "take none of the boxes".
_NO_THINGS = frozenset("no none nothing nobody noone neither".split())


@dataclass(frozen=True)
class Clause:
    """One thing that is asked for.

    Attributes:
        verb: index of the verb, from 1; of the form of "be" where that is the verb
        lemma: dictionary form of the verb, lower case
        positions: words of the clause, the verb's included, those of other clauses left out
        is_negated: "don't", "never"
        condition: words of a condition ("when I say so"), empty for none
        condition_positions: of those words
        subject: index of the subject, 0 for none
        sentence: its relations where they are not those of the parse: the verb is said once for two clauses
    """

    verb: int
    lemma: str
    positions: FrozenSet[int]
    is_negated: bool
    condition: str
    condition_positions: FrozenSet[int]
    subject: int = 0
    sentence: Optional[Sentence] = None


def find_clauses(sentence: Sentence, lexicon: Optional[Lexicon] = None) -> Tuple[Clause, ...]:
    """Find what a sentence asks for, in the order in which it was said.

    A verb of several words ("let go of") is one verb where a lexicon is given that has it.

    A sentence whose root is no verb ("three feet", "the office") has no clause.
    """
    found: List[Tuple[int, bool]] = []
    for root in sentence.children(0):
        _collect(sentence, lexicon or Lexicon(), root, False, found)
    verbs = {index for index, _ in found}
    tops = {index: _top(sentence, index) for index in verbs}
    clauses = []
    for index, is_negated in sorted(found):
        others: Set[int] = set()
        for other in verbs - {index}:
            if tops[other] in sentence.subtree(tops[index]):
                others |= sentence.subtree(tops[other])
        positions = set(sentence.subtree(tops[index])) - others - sentence.abandoned
        # The words around a wrapped request ("I want you to ...") belong to it.
        clauses.append(
            clause_of(
                sentence, index, frozenset(positions), is_negated or _is_of_nothing(sentence, frozenset(positions))
            )
        )
    return tuple(piece for clause in clauses for piece in _ungapped(sentence, clause))


def _ungapped(sentence: Sentence, clause: Clause) -> Tuple[Clause, ...]:
    """Return a clause, and one more for each phrase that shares its verb: "go to the office and then to the kitchen"."""
    remnants = [word for word in sentence.children(clause.verb) if _is_remnant(sentence, word)]
    if not remnants:
        return (clause,)
    left_out = frozenset().union(*(sentence.subtree(word.index) for word in remnants))
    shared = frozenset([clause.verb]).union(
        *(sentence.subtree(word.index) for word in sentence.children(clause.verb) if word.deprel == "obj")
    )
    found = [replace(clause, positions=clause.positions - left_out)]
    for word in remnants:
        is_phrase = _has_case(sentence, word)
        moved = replace(word, deprel="obl") if is_phrase else replace(word, upos="ADV", deprel="advmod")
        words = tuple(moved if other.index == word.index else other for other in sentence.tree.words)
        joining = {child.index for child in sentence.children(word.index) if child.deprel == "cc" or _is_then(child)}
        positions = (sentence.subtree(word.index) - joining | shared) & clause.positions
        found.append(replace(clause, positions=positions, sentence=Sentence(replace(sentence.tree, words=words))))
    return tuple(found)


def _is_remnant(sentence: Sentence, word: Word) -> bool:
    """Whether a word is joined to a verb and is none: "to the kitchen", and "left" of "turn right and then left"."""
    children = sentence.children(word.index)
    is_choice = any(child.deprel == "cc" and child.form.lower() != "and" for child in children)
    if is_choice or any(child.deprel == "cop" or child.deprel.startswith("nsubj") for child in children):
        return False
    is_joined = word.deprel == "conj" or (word.deprel == "advmod" and any(_is_then(child) for child in children))
    is_direction = word.form.lower() in ("left", "right") and all(
        child.deprel in ("cc", "advmod", "punct", "discourse") for child in children
    )
    is_phrase = word.deprel == "conj" and word.upos not in ("VERB", "AUX") and _has_case(sentence, word)
    return is_phrase or (is_joined and is_direction)


def _is_then(word: Word) -> bool:
    return word.deprel == "advmod" and word.form.lower() == "then"


def _has_case(sentence: Sentence, word: Word) -> bool:
    return any(child.deprel == "case" and child.index < word.index for child in sentence.children(word.index))


def _top(sentence: Sentence, verb: int) -> int:
    """Return the highest word of a clause: the predicate of a copula, the verb itself else."""
    word = sentence.word(verb)
    return word.head if word.deprel == "cop" else verb


def _collect(sentence: Sentence, lexicon: Lexicon, word: Word, is_negated: bool, found: List[Tuple[int, bool]]) -> None:
    following = [other.form.lower() for other in sentence.tree.words[word.index :]]
    last = word.index + max(1, lexicon.length_of_verb([word.lemma.lower()] + following)) - 1
    # "Go" of "let go of" and "face" of "turn to face" are words of the verb, and no verbs of their own.
    children = tuple(child for child in sentence.children(word.index) if not word.index < child.index <= last)
    is_negated = is_negated or _has_negation(sentence, word)
    copula = next((child for child in children if child.deprel == "cop"), None)
    wrapped = next(
        (child for child in children if child.deprel in ("xcomp", "ccomp") and child.upos in ("VERB", "AUX")), None
    )
    if wrapped is not None and word.lemma.lower() in WRAPPERS:
        _collect(sentence, lexicon, wrapped, is_negated, found)
    elif wrapped is not None and word.lemma.lower() in _MOTION and wrapped.index == word.index + 1:
        _collect(sentence, lexicon, wrapped, is_negated, found)
    elif copula is not None:
        found.append((copula.index, is_negated))
    elif word.upos in ("VERB", "AUX"):
        serial = next(
            (
                child
                for child in children
                if child.deprel == "conj"
                and child.upos == "VERB"
                and word.lemma.lower() in _MOTION
                and child.index - word.index <= 2
                and not any(
                    arc in ("obl", "advmod")
                    for arc in (c.deprel for c in children if c.index < child.index and c.index > word.index)
                )
            ),
            None,
        )
        if serial is None:
            found.append((word.index, is_negated))
    for child in children:
        if _is_purpose(sentence, lexicon, word, child):
            _collect(sentence, lexicon, child, is_negated, found)
        if _is_remnant(sentence, child):
            continue
        if child.deprel in ("conj", "parataxis", "list") and (
            child.upos in ("VERB", "AUX") or any(inner.deprel == "cop" for inner in sentence.children(child.index))
        ):
            # "don't move or speak" negates both; "don't move, just speak" is rare, and not acting is the safe reading.
            # "I can't reach it, so open it" does not.
            is_shared = child.deprel == "conj" and all(
                other.form.lower() not in RENEWING for other in sentence.children(child.index)
            )
            _collect(sentence, lexicon, child, is_negated and is_shared, found)


def _is_purpose(sentence: Sentence, lexicon: Lexicon, verb: Word, child: Word) -> bool:
    """Whether a verb says what shall be done in the end: "go to the kitchen to get the mug".

    What a thing is wanted for is no task of the robot: "bring me a cloth to clean the table". In "turn left to face the
    door" it is a part of the verb, where the lexicon has "turn to face".
    """
    has_object = any(other.deprel in ("obj", "iobj") for other in sentence.children(verb.index))
    return (
        child.deprel == "advcl"
        and child.index > verb.index
        and not has_object
        and verb.lemma.lower() not in WRAPPERS
        and any(mark.deprel == "mark" and mark.form.lower() == "to" for mark in sentence.children(child.index))
        and bool(lexicon.verbs_beginning_with(child.lemma.lower()))
        and f"{verb.lemma} to {child.lemma}".lower() not in lexicon.verbs_beginning_with(verb.lemma.lower())
    )


def _has_negation(sentence: Sentence, word: Word) -> bool:
    return any(
        child.form.lower() in NEGATIONS or child.lemma.lower() in NEGATIONS
        for child in sentence.children(word.index)
        if child.deprel in ("advmod", "aux", "det", "discourse", "mark", "cc", "cc:preconj", "dep")
        or (child.deprel.startswith("nsubj") and child.form.lower() in NEGATIONS)
    )


def _is_of_nothing(sentence: Sentence, positions: FrozenSet[int]) -> bool:
    """Whether a clause speaks of what is not there or not meant: "take no box", "none of the boxes", "not the plate".

    "Say no" says a word.
    """
    words = [sentence.word(index) for index in sorted(positions - sentence.quoted)]
    if any((word.form.lower(), after.form.lower()) in _NO_MORE for word, after in zip(words, words[1:])):
        return True
    # "Go to the office and not to the kitchen", "turn right then not left": what is not to be done is said as well.
    if any((word.deprel == "conj" or _is_remnant(sentence, word)) and _has_negation(sentence, word) for word in words):
        return True
    return any(
        word.form.lower() in _NO_THINGS
        and word.upos != "INTJ"
        and (word.deprel == "det" or word.deprel.split(":")[0] in ("obj", "iobj", "obl", "nsubj", "conj"))
        for word in words
    )


def whole_sentence(sentence: Sentence, verb: int) -> Clause:
    """Return the clause of a sentence without verbs that begins with a word which the lexicon takes for one."""
    positions = frozenset(word.index for word in sentence.tree.words) - sentence.abandoned
    is_negated = any(_has_negation(sentence, sentence.word(index)) for index in positions)
    clause = clause_of(sentence, verb, positions, is_negated or _is_of_nothing(sentence, positions))
    return replace(clause, lemma=sentence.word(verb).form.lower(), subject=0)


def clause_of(sentence: Sentence, verb: int, positions: FrozenSet[int], is_negated: bool) -> Clause:
    """Return the clause of a verb that is made of some words."""
    condition = _condition(sentence, _top(sentence, verb), positions)
    subject = next(
        (child.index for child in sentence.children(_top(sentence, verb)) if child.deprel.startswith("nsubj")), 0
    )
    return Clause(
        verb=verb,
        lemma=sentence.word(verb).lemma.lower(),
        positions=positions,
        is_negated=is_negated,
        condition=sentence.text(sorted(condition)) if condition else "",
        condition_positions=condition,
        subject=subject,
    )


def shared_subject(sentence: Sentence, verb: int) -> int:
    """Return the subject of the verb that a verb is joined to, 0 for none: "could you go there and take the mug"."""
    word = sentence.word(verb)
    seen: Set[int] = set()
    while word.deprel == "conj" and word.index not in seen:
        seen.add(word.index)
        word = sentence.word(word.head)
        for child in sentence.children(word.index):
            if child.deprel.startswith("nsubj"):
                return child.index
    return 0


def _condition(sentence: Sentence, top: int, positions: FrozenSet[int]) -> FrozenSet[int]:
    """Find a condition among the words of a clause."""
    for index in sorted(positions):
        word = sentence.word(index)
        if word.deprel.startswith("advcl") or word.deprel == "mark":
            clause = word.index if word.deprel.startswith("advcl") else word.head
            marks = [child.form.lower() for child in sentence.children(clause) if child.deprel in ("mark", "advmod")]
            if any(mark in CONDITIONS for mark in marks):
                return sentence.subtree(clause) if clause != top else frozenset([index])
    return frozenset()
