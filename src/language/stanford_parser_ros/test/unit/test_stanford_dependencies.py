"""From Universal to Stanford dependencies: one sentence for each rule."""

from typing import List, Set, Tuple

import pytest

from stanford_parser_ros.stanford_dependencies import RULES, arcs, basic, collapsed
from utterance_passes.trees.conllu import from_conllu, to_conllu
from utterance_passes.trees.tree import DependencyTree, Word


def tree_of(*rows: str) -> DependencyTree:
    """Rows are "form upos head deprel [lemma]"."""
    lines = []
    for index, row in enumerate(rows, start=1):
        form, upos, head, deprel, *lemma = row.split()
        lines.append(f"{index} {form} {lemma[0] if lemma else form.lower()} {upos} X _ {head} {deprel} _ _")
    return from_conllu("\n".join(lines))


def names(tree: DependencyTree, governor: str, dependent: str) -> Set[str]:
    """Every name of the relations between two words."""
    index = {word.form: word.index for word in tree.words}
    return {
        name
        for arc in arcs(tree)
        if (arc.governor, arc.dependent) == (index[governor], index[dependent])
        for name in arc.relations
    }


def collapsed_of(tree: DependencyTree) -> Set[Tuple[str, str, str]]:
    return {
        (
            dependency.relation,
            tree.word(dependency.governor).form if dependency.governor else "ROOT",
            tree.word(dependency.dependent).form,
        )
        for dependency in collapsed(tree)
    }


GO = tree_of("Go VERB 0 root", "to ADP 4 case", "the DET 4 det", "office NOUN 1 obl")
GIVE = tree_of("Give VERB 0 root", "Bill PROPN 1 iobj", "the DET 4 det", "ball NOUN 1 obj")


@pytest.mark.parametrize("relation", sorted(set(RULES) - {"root", "case", "mark", "conj"}))
def test_each_rule_gives_all_its_names(relation: str) -> None:
    tree = tree_of("Do VERB 0 root", f"thing NOUN 1 {relation}")
    assert names(tree, "Do", "thing") >= {relation, relation.split(":")[0], *RULES[relation]}
    assert (RULES[relation][0], "Do", "thing") in collapsed_of(tree) or relation == "cc"


def test_preposition_becomes_part_of_the_name() -> None:
    assert names(GO, "Go", "office") >= {"obl", "obl:to", "prep_to", "prep"}
    assert ("prep_to", "Go", "office") in collapsed_of(GO)


def test_basic_dependencies_keep_the_preposition_as_a_word() -> None:
    found = {(dependency.relation, dependency.governor, dependency.dependent) for dependency in basic(GO)}
    assert found == {("root", 0, 1), ("prep", 1, 2), ("pobj", 2, 4), ("det", 4, 3)}


def test_objects() -> None:
    assert "iobj" in names(GIVE, "Give", "Bill") and names(GIVE, "Give", "ball") == {"obj", "dobj"}


def test_measure_has_the_names_of_every_scheme() -> None:
    tree = tree_of("Move VERB 0 root", "3 NUM 3 nummod", "feet NOUN 1 obl:unmarked")
    assert names(tree, "Move", "feet") >= {"tmod", "npadvmod", "dobj", "obl:unmarked"}
    assert "num" in names(tree, "feet", "3")


def test_preposition_of_several_words() -> None:
    tree = tree_of(
        "Put VERB 0 root", "it PRON 1 obj", "next ADP 6 case", "to ADP 3 fixed", "the DET 6 det", "lamp NOUN 1 obl"
    )
    assert "prep_next_to" in names(tree, "Put", "lamp")


def test_preposition_around_a_noun() -> None:
    tree = tree_of(
        "Go VERB 0 root", "in ADP 3 case", "front NOUN 1 obl", "of ADP 6 case", "the DET 6 det", "fridge NOUN 3 nmod"
    )
    assert "prep_in_front_of" in names(tree, "Go", "fridge")


def test_conjuncts_share_the_role_of_the_first() -> None:
    tree = tree_of(
        "Take VERB 0 root", "the DET 3 det", "mug NOUN 1 obj", "and CCONJ 6 cc", "the DET 6 det", "plate NOUN 3 conj"
    )
    assert "dobj" in names(tree, "Take", "plate") and "conj_and" in names(tree, "mug", "plate")


def test_conjoined_verb_gets_the_subject() -> None:
    tree = tree_of("you PRON 2 nsubj", "go VERB 0 root", "and CCONJ 4 cc", "sit VERB 2 conj")
    assert "nsubj" in names(tree, "sit", "you")


def test_coordinator_of_a_list_stands_at_its_end() -> None:
    tree = tree_of("Take VERB 0 root", "mugs NOUN 1 obj", "cups NOUN 2 conj", "or CCONJ 5 cc", "pots NOUN 2 conj")
    assert "conj_or" in names(tree, "mugs", "cups")


def test_prepositional_predicate_hangs_on_the_copula() -> None:
    tree = tree_of(
        "the DET 2 det", "cup NOUN 6 nsubj", "is AUX 6 cop be", "on ADP 6 case", "the DET 6 det", "table NOUN 0 root"
    )
    assert "prep_on" in names(tree, "is", "table") and "nsubj" in names(tree, "is", "cup")


@pytest.mark.parametrize("form, lemma", [("n't", "not"), ("never", "never")])
def test_negation(form: str, lemma: str) -> None:
    assert "neg" in names(tree_of(f"{form} PART 2 advmod {lemma}", "move VERB 0 root"), "move", form)


def test_infinitive_marker_is_an_auxiliary() -> None:
    assert "aux" in names(tree_of("want VERB 0 root", "to PART 3 mark", "go VERB 1 xcomp"), "go", "to")


def test_possessor() -> None:
    tree = tree_of("Roger PROPN 3 nmod:poss", "'s PART 1 case", "office NOUN 0 root")
    assert "poss" in names(tree, "office", "Roger") and "possessive" in names(tree, "Roger", "'s")


def test_agent() -> None:
    tree = tree_of("seen VERB 0 root", "by ADP 3 case", "Bob PROPN 1 obl:agent")
    assert "agent" in names(tree, "seen", "Bob")


def test_conllu_comes_back_as_it_was() -> None:
    assert from_conllu(to_conllu(GO)) == GO


@pytest.mark.parametrize(
    "text, words, is_told",
    [
        ("don't  go", [("do", 0, 2), ("n't", 2, 5), ("go", 7, 9)], True),
        ("gonna go", [("going", 0, 5), ("to", 0, 5), ("go", 6, 8)], False),
        ("go, now", [("go", 0, 2), ("then", 4, 4), ("now", 4, 7)], False),
    ],
)
def test_places_of_words_come_back_as_they_were(text: str, words: List[Tuple[str, int, int]], is_told: bool) -> None:
    tree = DependencyTree(
        text,
        tuple(
            Word(index, form, form, "X", "", "", index - 1, "dep", start, end)
            for index, (form, start, end) in enumerate(words, start=1)
        ),
    )
    assert from_conllu(to_conllu(tree)) == tree
    assert ("start_char=" not in to_conllu(tree)) is is_told


def test_conllu_with_too_few_columns_is_refused() -> None:
    with pytest.raises(ValueError, match="line 2"):
        from_conllu("# a comment\n1 Go go")
