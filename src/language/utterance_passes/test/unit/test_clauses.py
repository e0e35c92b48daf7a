"""Phrases and clauses of a tree."""

from utterance_passes.phrases.clauses import shares_a_verb
from utterance_passes.trees.conllu import from_conllu


def test_a_place_without_a_preposition_behind_a_mark_is_no_item_of_a_list() -> None:
    """Words in any order: "Turn Turn the, off."."""
    rows = "1 turn turn VERB VB _ 0 root _ _\n2 , , PUNCT , _ 3 punct _ _\n3 off off NOUN NN _ 1 obl _ _"
    tree = from_conllu(rows)
    assert not shares_a_verb(tree, tree.word(3))
