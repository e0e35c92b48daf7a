"""Phrase trees: projected, flattened, rebuilt."""

import pytest
from roboframenet_msgs.msg import Command
from stanford_parser_msgs.msg import Parse

from stanford_parser_ros import unsquash_tree
from stanford_parser_ros.phrase_tree import constant_of_tag, from_brackets, phrase_tree, squash, unsquash
from stanford_parser_ros.ros_messages import to_command_parse, to_parse, to_tree
from utterance_passes.trees.conllu import from_conllu
from utterance_passes.trees.tree import DependencyTree

TREE = from_conllu(
    "1 Go go VERB VB _ 0 root _ _\n2 to to ADP IN _ 4 case _ _\n3 the the DET DT _ 4 det _ _"
    "\n4 office office NOUN NN _ 1 obl _ _"
)
BRACKETS = "(ROOT (S (VP (VB Go) (PP (IN to) (NP (DT the) (NN office))))))"


def test_phrases_are_projected_by_their_heads() -> None:
    assert repr(phrase_tree(TREE)) == BRACKETS


def test_flattened_tree_is_rebuilt() -> None:
    assert repr(unsquash(squash(phrase_tree(TREE)), ("ROOT", "Go", "to", "the", "office"))) == BRACKETS


def test_message_is_rebuilt_as_in_2012() -> None:
    assert repr(unsquash_tree(to_parse(TREE))) == BRACKETS


def test_message_points_straight_into_the_words() -> None:
    parse = to_parse(TREE)
    (to_office,) = [dependency for dependency in parse.dependencies if dependency.relation == "prep_to"]
    assert (parse.words[to_office.governor_index], parse.words[to_office.dependent_index]) == ("Go", "office")
    assert len(parse.words) == len(parse.tags) == 5


def test_tree_survives_the_message() -> None:
    assert to_tree(TREE.text, to_command_parse(Command(), TREE).words) == TREE


@pytest.mark.parametrize(
    "tag, name", [("PRP$", "PRP_S"), ("-TMP", "_TMP"), ("NN", "NN"), (".", "SYM"), ("-LRB-", "_LRB_")]
)
def test_constant_of_tag(tag: str, name: str) -> None:
    assert constant_of_tag(tag) == name


def test_message_without_a_tree_is_refused() -> None:
    with pytest.raises(ValueError):
        unsquash_tree(Parse())


def test_tree_of_a_constituency_parser_is_taken_as_it_is() -> None:
    given = "(ROOT (S (VP (VB Go) (ADVP (RB home)))))"
    tree = phrase_tree(DependencyTree(text="Go home", words=(), brackets=given))
    assert repr(tree) == given
    assert [node.word_index for node in squash(tree) if node.word_index > 0] == [1, 2]


@pytest.mark.parametrize("text", ["(ROOT (S", "(ROOT))", "(A a) (B b)", "()", ""])
def test_brackets_that_do_not_match_are_refused(text: str) -> None:
    with pytest.raises(ValueError):
        from_brackets(text)
