"""Finds the clauses of a sentence: each verb that asks for something, with its words."""

from dataclasses import dataclass, replace
from typing import FrozenSet, List, Optional, Set, Tuple

from spoken_quantities import find_unit
from utterance_passes.trees.clause_tops import top_of, tops_of
from utterance_passes.trees.tree import VERBS, DependencyTree, Word
from utterance_passes.trees.vocabulary import Verbs, Vocabulary
from word_classes import word_class

_CONDITIONS = word_class("conditions")
_HEARERS = word_class("hearers")
#: Tags of the words between "make sure" and the "not" of what the hearer shall not do.
_BEFORE_NOT = frozenset(["SCONJ", "AUX", "PART", "ADP"])
_CERTAIN = word_class("certain_adjectives")
_LEADING_VERBS = word_class("leading_verbs")
_STEPS = frozenset(["step"])
_WAYS = word_class("verbs_of_arriving") - word_class("causative_verbs") | {"leave"}
_LEFT_AND_RIGHT = word_class("left_and_right")
_NEGATIONS = word_class("negations")
_OF_NEGATIONS = frozenset(["advmod", "aux", "det", "discourse", "mark", "cc", "cc:preconj", "dep"])
_COMPARATIVES = ("JJR", "RBR")
_ORDER = word_class("adverbs_of_order")
_JOINING = _ORDER | {"and"}
_NO_THINGS = word_class("no_pronouns") | {"no"}
_REQUEST_VERBS = word_class("request_verbs")
#: Words that forbid behind "make sure"; "make sure *nobody* comes in" says how things shall be.
_FORBIDDING = _NEGATIONS - _NO_THINGS
_WHETHER = word_class("whether_words")
#: Relations of clauses that state something inside an order.
_STATING = ("ccomp", "advcl", "acl", "csubj")


@dataclass(frozen=True)
class Clause:
    """One thing that the speaker asks for.

    Attributes:
        verb: index of the verb, from 1; a copula is the verb of its clause
        lemma: dictionary form of the verb, lower case
        positions: words of the clause, including the verb, without the words of other clauses
        is_negated: whether the clause is negated: "don't", "never"
        condition: words of a condition ("when I say so"); empty if there is none
        condition_positions: positions of those words
        subject: index of the subject; 0 if there is none
    """

    verb: int
    lemma: str
    positions: FrozenSet[int]
    is_negated: bool
    condition: str
    condition_positions: FrozenSet[int]
    subject: int = 0

    def __post_init__(self) -> None:
        """
        Raises:
            ValueError: it has no words
        """
        if not self.positions:
            raise ValueError(f'the clause of "{self.lemma}" has no words')


def find_clauses(tree: DependencyTree, vocabulary: Vocabulary = Verbs()) -> Tuple[Clause, ...]:
    """Find what a sentence asks for, in the order in which it was said.

    A verb of several words ("let go of") is one verb if the vocabulary has it. A sentence whose root is not a verb
    ("three feet", "the office") has no clause.
    """
    found: List[Tuple[int, bool]] = []
    for root in tree.children(0):
        _collect(tree, vocabulary, root, False, found)
    found = [(index, is_negated) for index, is_negated in found if index not in tree.abandoned]
    verbs = {index for index, _ in found}
    tops = tops_of(tree, verbs)
    clauses = []
    for index, is_negated in sorted(found):
        others: Set[int] = set()
        for other in verbs - {index}:
            if tops[other] in tree.subtree(tops[index]):
                others |= tree.subtree(tops[other])
        positions = set(tree.subtree(tops[index])) - others - tree.abandoned
        # The words around a wrapped request ("I want you to ...") belong to it.
        own = frozenset(positions)
        clauses.append(clause_of(tree, index, own, is_negated or _is_of_nothing(tree, index, own)))
    return tuple(
        piece
        for clause in clauses
        for cluster in _expand_clusters(tree, clause)
        for piece in _expand_shared_verb(tree, cluster)
    )


def _expand_clusters(tree: DependencyTree, clause: Clause) -> Tuple[Clause, ...]:
    """Return a clause, or one for each group of phrases that shares its verb; words outside the groups go to each."""
    groups = [heads for verb, heads in tree.clusters if verb == clause.verb]
    if not groups:
        return (clause,)
    below = [frozenset().union(*map(tree.subtree, heads)) for heads in groups]
    joining = {
        child.index
        for heads in groups
        for head in heads
        for child in tree.children(head)
        if child.index < head and (child.deprel in ("cc", "punct") or is_then(child))
    }
    return tuple(
        replace(clause, positions=clause.positions - frozenset().union(*below).difference(own) - joining)
        for own in below
    )


def _expand_shared_verb(tree: DependencyTree, clause: Clause) -> Tuple[Clause, ...]:
    """Return a clause, and one for each phrase that shares its verb: "go to the office and then to the kitchen"."""
    # A phrase of a group is in a clause of its own already: "turn left 90 degrees, then *right* 45 degrees".
    grouped = frozenset().union(*(heads for verb, heads in tree.clusters if verb == clause.verb))
    sharing = [word for word in tree.children(clause.verb) if word.index in tree.sharing_a_verb - grouped]
    if not sharing:
        return (clause,)
    own = {word.index: tree.subtree(word.index) | _amount_behind(tree, clause, word) for word in sharing}
    left_out = frozenset().union(*own.values())
    shared = frozenset([clause.verb]).union(
        *(tree.subtree(word.index) for word in tree.children(clause.verb) if word.deprel == "obj")
    )
    found = [replace(clause, positions=clause.positions - left_out)]
    for word in sharing:
        joining = {child.index for child in tree.children(word.index) if child.deprel == "cc" or is_then(child)}
        positions = (own[word.index] - joining | shared) & clause.positions
        found.append(replace(clause, positions=positions))
    return tuple(found)


def _amount_behind(tree: DependencyTree, clause: Clause, word: Word) -> FrozenSet[int]:
    """Return the amount right behind a phrase that shares a verb: in "turn right, then left *45 degrees*", it is that
    of the second turn."""
    behind = tree.phrase_end(word.index) + 1
    amounts = [
        tree.subtree(child.index)
        for child in tree.children(clause.verb)
        if child.upos == "NUM" or any(inner.deprel == "nummod" for inner in tree.children(child.index))
    ]
    return next((amount for amount in amounts if min(amount) == behind), frozenset())


def may_share_a_verb(tree: DependencyTree) -> bool:
    """Whether a sentence has any word that joins; without one, no two phrases share a verb."""
    return any(word.deprel == "conj" or word.said in _JOINING for word in tree.words)


def shares_a_verb(tree: DependencyTree, word: Word) -> bool:
    """Whether a word that is not a verb is joined to a verb: "to the kitchen", "left" in "turn right and then left"."""
    children = tree.children(word.index)
    is_choice = any(child.deprel == "cc" and child.said != "and" for child in children)
    if is_choice or any(child.deprel == "cop" or child.deprel.startswith("nsubj") for child in children):
        return False
    is_joined = word.deprel == "conj" or (word.deprel == "advmod" and any(is_then(child) for child in children))
    is_direction = word.said in _LEFT_AND_RIGHT and all(
        child.deprel in ("cc", "advmod", "punct", "discourse") for child in children
    )
    is_next = word.deprel == "obl" and (any(is_then(child) for child in children) or _is_listed(tree, word))
    is_phrase = (word.deprel == "conj" or is_next) and word.upos not in VERBS and has_case(tree, word)
    return is_phrase or (is_joined and is_direction)


def _is_listed(tree: DependencyTree, word: Word) -> bool:
    """Whether a phrase stands between two with its preposition: "to the kitchen, *to the office*, and to Bob"."""
    first = tree.phrase_start(word.index)
    if first < 2 or "," not in (tree.word(first).form, tree.word(first - 1).form):
        return False
    cases = {case.said for case in tree.prepositions(word.index)}
    alike = [
        other.index
        for other in tree.children(word.head)
        if other.deprel in ("obl", "conj")
        if cases & {case.said for case in tree.prepositions(other.index)}
    ]
    return bool(alike) and min(alike) < word.index < max(alike)


def _is_shared(tree: DependencyTree, word: Word) -> bool:
    return word.index in tree.sharing_a_verb or shares_a_verb(tree, word)


def is_then(word: Word) -> bool:
    """Whether a word puts what follows behind what came before."""
    return word.deprel == "advmod" and word.said in _ORDER


def has_case(tree: DependencyTree, word: Word) -> bool:
    """Whether a word has a preposition before it."""
    return any(child.index < word.index for child in tree.prepositions(word.index))


def _collect(
    tree: DependencyTree, vocabulary: Vocabulary, word: Word, is_negated: bool, found: List[Tuple[int, bool]]
) -> None:
    following = [other.said for other in tree.words[word.index :]]
    last = word.index + max(1, vocabulary.length_of_verb([word.lemma.lower()] + following)) - 1
    # "Go" in "let go of" and "face" in "turn to face" are words of the verb, not separate verbs.
    children = tuple(child for child in tree.children(word.index) if not word.index < child.index <= last)
    is_negated = is_negated or _has_negation(tree, word) or _assures_not(tree, word)
    copula = next((child for child in children if child.deprel == "cop"), None)
    wrapped = next((child for child in children if child.deprel in ("xcomp", "ccomp") and child.upos in VERBS), None)
    assured = _assured(tree, word)
    if assured is not None:
        # "Make sure to open the door" asks for the door, and "make sure not to open it" forbids it.
        _collect(tree, vocabulary, assured, is_negated, found)
        return
    wraps = word.lemma.lower() in _REQUEST_VERBS and not _asks_somebody_else(vocabulary, word, children)
    wraps = wraps and not (wrapped is not None and _asks_about_others(tree, wrapped))
    if (wrapped is not None and wraps) or (
        wrapped is not None and word.lemma.lower() in _LEADING_VERBS and wrapped.index == word.index + 1
    ):
        _collect(tree, vocabulary, wrapped, is_negated, found)
    elif copula is not None:
        found.append((copula.index, is_negated))
    elif word.upos in VERBS:
        serial = next(
            (
                child
                for child in children
                if child.deprel == "conj"
                and child.upos == "VERB"
                and word.lemma.lower() in _LEADING_VERBS
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
        if _is_purpose(tree, vocabulary, word, child):
            _collect(tree, vocabulary, child, is_negated, found)
        if _is_shared(tree, child):
            continue
        if child.deprel in ("conj", "parataxis", "list") and (
            child.upos in VERBS or any(inner.deprel == "cop" for inner in tree.children(child.index))
        ):
            # "Don't move or speak" negates both verbs; "don't move, just speak" is rare, and it is safe not to act.
            _collect(tree, vocabulary, child, is_negated and child.deprel == "conj", found)


def _asks_about_others(tree: DependencyTree, clause: Word) -> bool:
    """Whether a clause asks about somebody else: "ask *whether anybody is hungry*" wraps no request."""
    children = tree.children(clause.index)
    subjects = [child for child in children if child.deprel.startswith("nsubj")]
    is_question = any(child.said in _WHETHER for child in children)
    return is_question and bool(subjects) and all(one.said not in _HEARERS for one in subjects)


def _assured(tree: DependencyTree, verb: Word) -> Optional[Word]:
    """Return what somebody is to make sure to do: "open" in "make sure to open the door"; None for other sentences."""
    # Beside another verb, "sure" has been set aside.
    beside = (child for child in tree.children(verb.index) if child.index == verb.index + 1)
    sure = next((child for child in beside if child.said in _CERTAIN), None)
    if sure is None:
        return None
    for child in tree.children(sure.index) + tree.children(verb.index):
        marks = [mark.said for mark in tree.children(child.index) if mark.deprel == "mark"]
        if child.upos in VERBS and child.deprel in ("ccomp", "xcomp", "advcl") and "to" in marks:
            return child
    return None


def _assures_not(tree: DependencyTree, verb: Word) -> bool:
    """Whether somebody is to make sure not to do something, whatever the parser takes it for: "make sure *not to*
    desist", "be sure that *you do not* move"."""
    behind = tree.words[verb.index :]
    if not behind or behind[0].said not in _CERTAIN:
        return False
    for word in behind[1:]:
        if word.said in _FORBIDDING:
            return True
        if word.upos not in _BEFORE_NOT and word.said not in _HEARERS:
            return False
    return False


def _asks_somebody_else(vocabulary: Vocabulary, verb: Word, children: Tuple[Word, ...]) -> bool:
    """Whether a verb is a command to ask another person: "ask Alice to wait". "I ask you to wait" wraps a request."""
    objects = [child for child in children if child.deprel in ("obj", "iobj")]
    subjects = [child.said for child in children if child.deprel.startswith("nsubj")]
    is_known = verb.lemma.lower() in vocabulary.verbs_beginning_with(verb.lemma.lower())
    is_asked = is_known and _HEARERS.issuperset(subjects)
    return is_asked and any(child.said not in _HEARERS for child in objects)


def _is_purpose(tree: DependencyTree, vocabulary: Vocabulary, verb: Word, child: Word) -> bool:
    """Whether a verb names the final task: "go to the kitchen to get the mug".

    The purpose of a thing is not a task of the robot: "bring me a cloth to clean the table". In "turn left to face the
    door", "to face" is a part of the verb if the lexicon has "turn to face".
    """
    objects = [other for other in tree.children(verb.index) if other.deprel in ("obj", "iobj")]
    # "Cross the hall *to face the window*", "take a step *to face me*": only the robot gets anywhere by that.
    is_way = verb.lemma.lower() in _WAYS or any(other.lemma.lower() in _STEPS for other in objects)
    return (
        child.deprel == "advcl"
        and child.index > verb.index
        and (is_way or not objects)
        and verb.lemma.lower() not in _REQUEST_VERBS
        and tree.is_infinitive(child.index)
        and bool(vocabulary.verbs_beginning_with(child.lemma.lower()))
        and f"{verb.lemma} to {child.lemma}".lower() not in vocabulary.verbs_beginning_with(verb.lemma.lower())
    )


def _has_negation(tree: DependencyTree, word: Word) -> bool:
    return any(
        child.said in _NEGATIONS or child.lemma.lower() in _NEGATIONS
        for child in tree.children(word.index)
        if child.deprel in _OF_NEGATIONS or (child.deprel.startswith("nsubj") and child.said in _NEGATIONS)
    )


def _is_of_nothing(tree: DependencyTree, verb: int, positions: FrozenSet[int]) -> bool:
    """Whether a clause names no thing, or excludes one: "take no box", "none of the boxes", "not the plate".

    In "say no", the word is quoted and negates nothing; in "make sure that nobody is in", it negates another verb.
    """
    words = [tree.word(index) for index in sorted(positions - tree.quoted - _said_of_others(tree, verb, positions))]
    forms = [word.said for word in words]
    # "No more than three cups" is a bound.
    bounds = {place for place, form in enumerate(forms) if form == "no" and forms[place + 2 : place + 3] == ["than"]}
    words = [word for place, word in enumerate(words) if place not in bounds]
    forms = [form for place, form in enumerate(forms) if place not in bounds]
    if any(first.said == "no" and second.xpos in _COMPARATIVES for first, second in zip(words, words[1:])):
        return True
    counted = [tree.governor(word) for word in words if word.said == "zero" and word.head > word.index]
    if any(things.xpos == "NNS" and find_unit(things.form) is None for things in counted):
        return True
    # "Go to the office and not to the kitchen", "turn right then not left": a part of the clause is forbidden.
    if any(_is_excluded(tree, word) for word in words):
        return True
    return any(
        form in _NO_THINGS
        and word.upos != "INTJ"
        and (word.deprel == "det" or word.deprel.split(":")[0] in ("obj", "iobj", "obl", "nsubj", "conj"))
        for word, form in zip(words, forms)
    )


def _is_excluded(tree: DependencyTree, word: Word) -> bool:
    """Whether a part of a clause is forbidden: "and not to the kitchen"; "not before noon" says when."""
    is_part = _has_negation(tree, word) and (word.deprel == "conj" or _is_shared(tree, word))
    return is_part and not _is_time(tree, word)


def excluded_phrase(tree: DependencyTree, clause: Clause) -> FrozenSet[int]:
    """Return the words of a clause that only exclude something: "go to the office, but *not through the hall*"."""
    if _has_negation(tree, tree.word(top_of(tree, clause.verb))):
        return frozenset()
    parts = (index for index in clause.positions if index != clause.verb and _is_excluded(tree, tree.word(index)))
    found = frozenset().union(*(tree.subtree(index) for index in parts)) & clause.positions
    return frozenset(index for index in found if tree.word(index).upos not in ("PUNCT", "CCONJ"))


def _is_time(tree: DependencyTree, word: Word) -> bool:
    """Whether a preposition of time stands before a word: "before noon"."""
    return any(child.said in _CONDITIONS for child in tree.prepositions(word.index))


def _said_of_others(tree: DependencyTree, verb: int, positions: FrozenSet[int]) -> FrozenSet[int]:
    """Return the words of clauses that tell how things are: "make sure that *nobody is in the garage*".

    What the hearer shall do or leave is the order itself: "make sure *you* touch nothing".
    """
    found: Set[int] = set()
    for index in positions - {verb, top_of(tree, verb)}:
        word = tree.word(index)
        if word.deprel.split(":")[0] not in _STATING or verb in tree.subtree(index):
            continue
        subject = tree.subject(index)
        if subject is not None and subject.said != "you":
            found |= tree.subtree(index)
    return frozenset(found)


def whole_sentence(tree: DependencyTree, verb: int) -> Clause:
    """Return a sentence as one clause: the parser found no verb, but the lexicon knows the first word as one."""
    positions = frozenset(word.index for word in tree.words) - tree.abandoned
    own = positions - _said_of_others(tree, verb, positions)
    is_negated = any(_has_negation(tree, tree.word(index)) for index in own)
    clause = clause_of(tree, verb, positions, is_negated or _is_of_nothing(tree, verb, positions))
    return replace(clause, lemma=tree.word(verb).said, subject=0)


def clause_of(tree: DependencyTree, verb: int, positions: FrozenSet[int], is_negated: bool) -> Clause:
    """Return the clause of a verb, made of the words at some positions."""
    condition = _condition(tree, top_of(tree, verb), positions)
    subject = next((child.index for child in tree.children(top_of(tree, verb)) if child.deprel.startswith("nsubj")), 0)
    return Clause(
        verb=verb,
        lemma=tree.word(verb).lemma.lower(),
        positions=positions,
        is_negated=is_negated,
        condition=tree.text_of(sorted(condition)) if condition else "",
        condition_positions=condition,
        subject=subject,
    )


def shared_subject(tree: DependencyTree, verb: int) -> int:
    """Return the subject of the verb that this verb is joined to: "could you go there and take the mug"; 0 if none."""
    word = tree.word(verb)
    seen: Set[int] = set()
    while word.deprel == "conj" and word.index not in seen:
        seen.add(word.index)
        word = tree.governor(word)
        for child in tree.children(word.index):
            if child.deprel.startswith("nsubj"):
                return child.index
    return 0


def _condition(tree: DependencyTree, top: int, positions: FrozenSet[int]) -> FrozenSet[int]:
    """Find a condition among the words of a clause."""
    for index in sorted(positions):
        word = tree.word(index)
        if word.deprel.startswith("advcl") or word.deprel == "mark":
            clause = word.index if word.deprel.startswith("advcl") else word.head
            marks = [child.said for child in tree.children(clause) if child.deprel in ("mark", "advmod")]
            if any(mark in _CONDITIONS for mark in marks):
                return tree.subtree(clause) if clause != top else frozenset([index])
    return frozenset()
