"""Gives one verb to two phrases: "go to the office and then to the kitchen", "turn left then right"."""

from typing import List, Set, Tuple

from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.phrases.clauses import (
    Clause,
    find_clauses,
    has_case,
    is_then,
    may_share_a_verb,
    shares_a_verb,
)
from utterance_passes.trees.tree import ASIDE, NOUNS, VERBS, DependencyTree, Word
from utterance_passes.trees.tree_edits import TreeEdit, mark_sharing_a_verb
from utterance_passes.trees.vocabulary import Vocabulary
from word_classes import word_class

_PAIRS = (word_class("verb_particles"), word_class("all_directions") - {"around"})
_JOINING = frozenset(["and", "then"])
_ORDER = word_class("adverbs_of_order")
_BACK = "back"
_RELATIONS = {"and": "cc", "then": "advmod"}
#: Words before a phrase of what comes later; "there" is where the phrase before leads.
_LATER: Tuple[Tuple[str, ...], ...] = (
    *(("after", word) for word in sorted(word_class("pronouns_of_things"))),
    *(("from", word) for word in sorted(word_class("here_and_there"))),
    (_BACK,),
    *((word,) for word in sorted(_ORDER - _JOINING)),
)


@tree_pass(
    Kind.MEANING,
    Example(
        "go|VERB|0|root to|ADP|3|case Bob|PROPN|1|obl and|CCONJ|6|cc to|ADP|6|case Eve|PROPN|1|conj",
        ("Eve: conj(go) -> obl(go)",),
    ),
    assigns=["obl", "advmod", "compound:prt", "cc", "conj", ASIDE],
)
def shared_verbs(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Attach the second of two phrases that share a verb to the verb, like the first.

    It is marked: ``find_clauses`` turns it into a clause of its own.
    """
    if not may_share_a_verb(tree):
        return tree
    tree = _with_next_phrases_at_verbs(_with_later_phrases(tree))
    edit = TreeEdit(tree)
    sharing: Set[int] = set()
    for clause in find_clauses(tree, vocabulary):
        for first, word in particle_pairs(tree, clause):
            sharing.add(word.index)
            edit.retag(word.index, first.upos)
            edit.rehang(word.index, clause.verb, first.deprel)
            for between in tree.words[first.index : word.index - 1]:
                edit.rehang(between.index, word.index, "cc" if between.said == "and" else "advmod")
        for word in tree.children(clause.verb):
            if word.index not in sharing and shares_a_verb(tree, word):
                sharing.add(word.index)
                if has_case(tree, word):
                    edit.relabel(word.index, "obl")
                else:
                    edit.retag(word.index, "ADV")
                    edit.relabel(word.index, "advmod")
    return mark_sharing_a_verb(edit.tree(), frozenset(sharing))


def _with_later_phrases(tree: DependencyTree) -> DependencyTree:
    """Attach a phrase that comes later to the verb of the phrase before, and its words of order to it: ", *lastly* to
    the hall", "and *after that* to the hall", ", *from there* to the hall", ", then *back* to the hall".
    """
    edit = TreeEdit(tree)
    for word in tree.words:
        cases = tree.prepositions(word.index)
        is_done = word.index in tree.sharing_a_verb
        if is_done or not cases or word.upos not in NOUNS or cases[0].index > word.index:
            continue
        first = cases[0].index
        length = next((len(words) for words in _LATER if _is_said_before(tree, words, first)), 0)
        opening = [tree.word(index) for index in range(first - length, first)]
        while length and opening[0].index > 1 and tree.word(opening[0].index - 1).said in _JOINING:
            opening.insert(0, tree.word(opening[0].index - 1))
        if len(opening) == 1 and _is_behind_source(tree, opening[0]):
            if opening[0].deprel != ASIDE:
                edit.rehang(opening[0].index, word.index, ASIDE)  # "From the hall *back* to the office."
            continue
        verb = tree.verb_above(word) if opening else word
        if any(one.said == _BACK for one in opening) and _has_source(tree, verb):
            continue  # "Go *from* the hall to the office, and then *back to* the hall" is one way.
        # "Go to the hall *and back to* the office twice" is one way.
        joining = {"then"} if any(one.said == _BACK for one in opening) else _JOINING
        is_joined = any(one.said in joining for one in opening)
        is_set_off = is_joined or (opening and tree.word(max(1, opening[0].index - 1)).form == ",")
        if verb.upos != "VERB" or not is_set_off or not _has_phrase(tree, verb, opening[0].index):
            continue
        for other in opening:
            edit.rehang(other.index, word.index, _RELATIONS.get(other.said, ASIDE))
        if word.deprel != "conj" or word.head != verb.index:
            edit.rehang(word.index, verb.index, "conj")
    return edit.tree()


def _has_source(tree: DependencyTree, verb: Word) -> bool:
    children = tree.children(verb.index)
    return any(case.said == "from" for child in children for case in tree.prepositions(child.index))


def _is_behind_source(tree: DependencyTree, word: Word) -> bool:
    before = tree.word(word.index - 1) if word.index > 1 else word
    return before.upos in NOUNS and any(case.said == "from" for case in tree.prepositions(before.index))


def _is_said_before(tree: DependencyTree, words: Tuple[str, ...], place: int) -> bool:
    return place > len(words) and all(tree.word(place - len(words) + at).said == word for at, word in enumerate(words))


def _has_phrase(tree: DependencyTree, verb: Word, end: int) -> bool:
    """Whether a verb has a phrase with a preposition before a place."""
    return any(verb.index < child.index < end and has_case(tree, child) for child in tree.children(verb.index))


def _with_next_phrases_at_verbs(tree: DependencyTree) -> DependencyTree:
    """Attach a phrase with "then" to the verb, not to a noun before it: what comes next is no part of a list."""
    edit = TreeEdit(tree)
    for word in tree.words:
        is_joined = word.deprel == "conj" and word.upos not in VERBS and has_case(tree, word)
        if is_joined and shares_a_verb(tree, word) and any(is_then(child) for child in tree.children(word.index)):
            verb = tree.verb_above(word)
            # "Go to the hall, but before that *go* to the office and then to the yard": the nearest deed.
            inner = [child for child in tree.children(verb.index) if child.deprel == "conj" and child.upos == "VERB"]
            verb = next((one for one in reversed(inner) if one.index < word.index), verb)
            if verb.upos == "VERB" and verb.index < word.index:
                edit.rehang(word.index, verb.index)
    return edit.tree()


def particle_pairs(tree: DependencyTree, clause: Clause) -> List[Tuple[Word, Word]]:
    """Return the pairs of particles that one verb has in turn: "turn the light *on* and *off*"."""
    said = [word for word in tree.words if word.index in clause.positions and word.index > clause.verb]
    found = []
    for place, first in enumerate(said):
        behind = [word for word in said[place + 1 :] if word.said not in _JOINING]
        if not behind or behind[0] is said[place + 1]:
            continue
        second = behind[0]
        is_pair = first.said != second.said and any({first.said, second.said} <= words for words in _PAIRS)
        # "Turn on the light and off the radio" has two objects.
        is_shared = first.index == clause.verb + 1 or behind[1:2] == [] or behind[1].upos in ("PUNCT", "ADV")
        if is_pair and is_shared and first.head == clause.verb:
            found.append((first, second))
    return found
