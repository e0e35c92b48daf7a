"""Gives one verb to two groups of phrases: "put the mug on the table and the plate in the sink".

A parser trained on text attaches the second group to the noun before it, so that the plate becomes a place, or the
robot puts the mug twice. The shape of the phrases shows the groups: phrase by phrase, the second group matches the end
of the first.
"""

from typing import FrozenSet, List, Optional, Sequence, Tuple

from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.phrases.clauses import Clause, find_clauses
from utterance_passes.phrases.phrase_groups import (
    JOINING,
    Group,
    Phrase,
    PhraseKind,
    groups_of,
    tells_several,
    with_names_apart,
)
from utterance_passes.trees.tree import DependencyTree, Word
from utterance_passes.trees.tree_edits import TreeEdit, mark_argument_clusters
from utterance_passes.trees.vocabulary import Verbs, Vocabulary
from word_classes import word_class, word_list

#: "Go back one foot and six inches *now*" is one way.
_DIRECTIONS = word_class("left_and_right") | word_class("forward_and_backward")
_TURNS = tuple([side] for side in word_list("left_and_right"))
_BEFORE_AN_OBJECT = frozenset(["DET", "ADJ", "NUM", "NOUN", "PROPN", "SYM"])


@tree_pass(
    Kind.MEANING,
    Example(
        "put|VERB|0|root mugs|NOUN|1|obj on|ADP|4|case tables|NOUN|1|obl and|CCONJ|6|cc plates|NOUN|4|conj "
        "in|ADP|8|case sinks|NOUN|1|obl",
        (
            "plates: conj(tables) -> obj(put)",
            "mugs on tables: a clause of its own",
            "and plates in sinks: a clause of its own",
        ),
        Verbs(frozenset(["put"])),
    ),
    assigns=["dep", "obj", "iobj", "obl", "obl:unmarked", "advmod", "compound:prt", "nmod"],
)
def argument_clusters(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Turn each group of phrases that share a verb into a clause.

    They become phrases of the verb, and the groups are marked: ``find_clauses`` turns each into a clause. If
    groups end alike but differ before that, their phrases get the relation ``dep``, which no unit knows.
    """
    if not any(word.said in JOINING for word in tree.words):
        return tree
    edit = TreeEdit(tree)
    clusters: List[Tuple[int, FrozenSet[int]]] = []
    for clause in find_clauses(tree, vocabulary):
        speech = vocabulary.speech_of(clause.lemma)
        if clause.lemma != "be" and (speech is None or tells_several(tree, clause, speech)):
            clusters += _expand(tree, clause, edit)
    return mark_argument_clusters(edit.tree(), tuple(clusters))


def _expand(tree: DependencyTree, clause: Clause, edit: TreeEdit) -> List[Tuple[int, FrozenSet[int]]]:
    for index in _particles_behind_and(tree, clause):
        # No unit takes it, so that "turn on the light and off the radio" does not turn both off.
        edit.rehang(index, clause.verb, "dep")
        return []
    pieces = groups_of(tree, clause)
    if pieces is None or len(pieces) < 2:
        return []
    if all(_is_turn(group) for group in pieces):
        for (phrase,) in pieces:
            edit.rehang(phrase.head, clause.verb, "obj")
        return [(clause.verb, frozenset([phrase.head])) for (phrase,) in pieces]
    groups = _ways(tree, pieces) or with_names_apart(pieces) or _with_lists_as_one(pieces)
    first, others = groups[0], groups[1:]
    length = len(others[0]) if others else 0
    if length < 2 or len(first) < length:
        return []
    model = first[-length:]
    behind: Group = ()
    if not all(len(group) == length and _ends_alike(model, group) for group in others):
        # "On the table *in front of the window*" is one place.
        model, behind = first[:length], first[length:]
        is_place = all(phrase.kind is PhraseKind.PREPOSITION for phrase in (model[-1], *behind))
        if not is_place or not all(one.is_like(other) for group in others for one, other in zip(model, group)):
            return []
    if not all(one.is_like(other) for group in others for one, other in zip(model, group)):
        for group in others:
            for phrase in group:
                edit.rehang(phrase.head, clause.verb, "dep")
        return []
    _hang(tree, clause, model, model, edit)
    for phrase in behind:
        edit.rehang(phrase.head, model[-1].head, "nmod")
    for group in others:
        _hang(tree, clause, model, group, edit)
    return [(clause.verb, frozenset(phrase.head for phrase in group)) for group in (model, *others)]


def _is_turn(group: Group) -> bool:
    """Whether a group is a side and nothing else: "take *a left* and then *a right*"."""
    words = [word.said for phrase in group for word in phrase.words]
    return len(group) == 1 and words[:1] == ["a"] and words[1:] in _TURNS


def _particles_behind_and(tree: DependencyTree, clause: Clause) -> List[int]:
    """Return the particles that begin another group with an object of its own."""
    return [
        index
        for index in sorted(clause.positions)
        if (tree.word(index).deprel == "compound:prt" or _is_particle_of_verb(tree, clause, tree.word(index)))
        and index > clause.verb + 1
        and tree.word(index - 1).said == "and"
        and index + 1 in clause.positions
        and tree.word(index + 1).upos in _BEFORE_AN_OBJECT
    ]


def _is_particle_of_verb(tree: DependencyTree, clause: Clause, word: Word) -> bool:
    """Whether the parser takes a particle for a preposition, though the verb has a particle: "on ... and *off*"."""
    has_particle = any(child.deprel == "compound:prt" for child in tree.children(clause.verb))
    return has_particle and word.deprel == "case" and word.xpos == "RP"


def _ends_alike(model: Group, group: Group) -> bool:
    """Whether all phrases are alike, or the last ones have the same preposition: "to the kitchen with the cup and the
    bathroom with the plate".
    """
    if all(one.is_like(other) for one, other in zip(model, group)):
        return True
    return bool(group[-1].preposition) and group[-1].preposition == model[-1].preposition


def _hang(tree: DependencyTree, clause: Clause, model: Group, group: Group, edit: TreeEdit) -> None:
    """Attach the phrases of a group in the same way as those of the first group."""
    nouns = [phrase for phrase in model if phrase.kind is PhraseKind.NOUN]
    for like, phrase in zip(model, group):
        head = tree.word(like.head)
        if phrase.kind is PhraseKind.NOUN and len(nouns) == 2:
            deprel = "iobj" if like is nouns[0] and not _is_measure(tree, nouns[1]) else "obj"
        elif phrase.kind is PhraseKind.NOUN:
            deprel = "obj"
        elif phrase.kind is PhraseKind.PREPOSITION:
            deprel = "obl"
        else:
            deprel = head.deprel if head.deprel == "compound:prt" else "advmod"
        if phrase.kind is PhraseKind.NOUN and _is_measure(tree, phrase):
            deprel = "obl:unmarked"
        governor = clause.verb
        # If "the mug on the table" was one phrase, it stays one.
        if phrase.kind is PhraseKind.PREPOSITION and like is not model[0] and head.head == model[0].head:
            governor, deprel = group[0].head, "nmod"
        inside = {word.index for word in phrase.words}
        for word in phrase.words:
            if word.index != phrase.head and word.head not in inside:
                edit.rehang(word.index, phrase.head)
        edit.rehang(phrase.head, governor, deprel)


def _ways(tree: DependencyTree, groups: Sequence[Group]) -> Optional[List[Group]]:
    """Return groups of a way and its measure, all in one order: "*two metres forward*, *left 90 degrees*"; None if one
    of them is something else."""
    ordered = [group[::-1] if group[0].kind is PhraseKind.NOUN else group for group in groups]
    is_way = all(
        [phrase.kind for phrase in group] == [PhraseKind.ADVERB, PhraseKind.NOUN]
        and tree.word(group[0].head).said in _DIRECTIONS
        and _is_measure(tree, group[1])
        for group in ordered
    )
    return ordered if is_way else None


def _is_measure(tree: DependencyTree, phrase: Phrase) -> bool:
    return tree.word(phrase.head).deprel == "obl:unmarked"


def _with_lists_as_one(groups: Sequence[Group]) -> List[Group]:
    """Join a lone noun to the group after it: "the mug and the fork on the table"."""
    found: List[Group] = []
    waiting: List[Word] = []
    for group in groups:
        if waiting and group[0].kind is PhraseKind.NOUN:
            group = (Phrase(PhraseKind.NOUN, (*waiting, *group[0].words)), *group[1:])
            waiting = []
        if len(group) == 1 and group[0].kind is PhraseKind.NOUN:
            waiting = list(group[0].words)
        else:
            found.append(group)
    return found if not waiting else [*found, (Phrase(PhraseKind.NOUN, tuple(waiting)),)]
