"""Relations that the arcs around them rule out."""

import pytest

from utterance_passes.clauses import shares_a_verb
from utterance_passes.conllu import from_conllu
from utterance_passes.running import run_tree_passes
from utterance_passes.table import PARSER_TREE_PASSES
from utterance_passes.tree import DependencyTree
from utterance_passes.vocabulary import Verbs

CHECK = (
    "1 check check VERB VB _ 0 root _ _\n2 if if SCONJ IN _ 5 mark _ _\n3 it it PRON PRP _ 5 nsubj _ _\n"
    "4 is be AUX VBZ _ 5 cop _ _\n5 off off ADP RP _ 1 compound:prt _ _"
)
GO_GET = "1 go go VERB VB _ 0 root _ _\n2 get get VERB VB _ 1 compound _ _\n3 it it PRON PRP _ 2 obj _ _"
TO_FACE = "1 turn turn VERB VB _ 0 root _ _\n2 to to PART TO _ 3 mark _ _\n3 face face VERB VB _ 1 conj _ _"
AND_TO_GO = (
    "1 to to PART TO _ 2 mark _ _\n2 stop stop VERB VB _ 0 root _ _\n3 to to PART TO _ 4 mark _ _\n"
    "4 go go VERB VB _ 2 conj _ _"
)
PICK_UP = "1 pick pick VERB VB _ 0 root _ _\n2 up up ADP RP _ 1 compound:prt _ _\n3 it it PRON PRP _ 1 obj _ _"
FIRE_DOOR = "1 fire fire NOUN NN _ 2 compound _ _\n2 door door NOUN NN _ 0 root _ _"


def corrected(tree: DependencyTree) -> DependencyTree:
    return run_tree_passes(tree, Verbs(), PARSER_TREE_PASSES)


@pytest.mark.parametrize("rows, position, relation", [(CHECK, 5, "ccomp"), (GO_GET, 2, "xcomp"), (TO_FACE, 3, "advcl")])
def test_is_corrected(rows: str, position: int, relation: str) -> None:
    before = from_conllu(rows)
    after = corrected(before)
    assert after.word(position).deprel == relation
    assert [word.head for word in after.words] == [word.head for word in before.words]


@pytest.mark.parametrize("rows", [PICK_UP, FIRE_DOOR, AND_TO_GO])
def test_possible_relations_stay(rows: str) -> None:
    tree = from_conllu(rows)
    assert corrected(tree) is tree


def test_particle_before_a_second_object_is_its_preposition() -> None:
    tree = corrected(
        from_conllu(
            "1 pick pick VERB VB _ 0 root _ _\n2 up up ADP RP _ 1 compound:prt _ _\n3 cups cup NOUN NNS _ 1 obj _ _\n"
            "4 off off ADP RP _ 1 compound:prt _ _\n5 the the DET DT _ 6 det _ _\n6 bed bed NOUN NN _ 1 obj _ _"
        )
    )
    assert [(word.head, word.deprel) for word in tree.words] == [
        (0, "root"),
        (1, "compound:prt"),
        (1, "obj"),
        (6, "case"),
        (6, "det"),
        (1, "obl"),
    ]


def test_a_place_without_a_preposition_behind_a_mark_is_no_item_of_a_list() -> None:
    """Words in any order: "Turn Turn the, off."."""
    rows = "1 turn turn VERB VB _ 0 root _ _\n2 , , PUNCT , _ 3 punct _ _\n3 off off NOUN NN _ 1 obl _ _"
    tree = from_conllu(rows)
    assert not shares_a_verb(tree, tree.word(3))
