"""Trees come of trees in one place, and what comes of an edit is a tree."""

import ast
from dataclasses import replace
from pathlib import Path
from typing import Iterator, List, Tuple

import pytest

from utterance_passes.trees.conllu import from_short
from utterance_passes.trees.tree import DependencyTree
from utterance_passes.trees.tree_edits import NotATree, TreeEdit, behind_verb, set_aside

SOURCES = next(one for one in Path(__file__).resolve().parents if one.name == "src")
TREE = from_short("take|VERB|0|root the|DET|3|det mug|NOUN|1|obj")
#: They read trees that come from elsewhere: the parser, a message, a file.
# conditions.py and held_states.py give arguments other words; an argument has a head as a word has.
READERS = {
    # The form of a clause, and no word.
    "clause_features.py",
    "deed_questions.py",
    "conllu.py",
    "inference.py",
    "ros_messages.py",
    "conditions.py",
    "held_states.py",
}
FIELDS = {"form", "upos", "xpos", "feats", "head", "deprel", "words", "times", "sharing_a_verb", "clusters", "brackets"}


def test_edits_take_effect_together() -> None:
    edit = TreeEdit(TREE)
    edit.rehang(3, 0, "root")
    edit.rehang(1, 3, "acl")
    edit.retag(1, "NOUN", "NN")
    edit.respell(1, "use")
    tree = edit.tree()
    assert [(word.head, word.deprel) for word in tree.words] == [(3, "acl"), (3, "det"), (0, "root")]
    assert (tree.word(1).form, tree.word(1).lemma, tree.word(1).upos, tree.word(1).xpos) == ("use", "use", "NOUN", "NN")
    assert TREE.word(1).head == 0


def test_nothing_changed_is_the_same_tree() -> None:
    edit = TreeEdit(TREE)
    edit.rehang(3, 1)
    assert edit.tree() is TREE


@pytest.mark.parametrize("index, head", [(1, 3), (3, 3), (3, 0)])
def test_what_is_no_tree_is_refused(index: int, head: int) -> None:
    edit = TreeEdit(TREE)
    edit.rehang(index, head)
    with pytest.raises(NotATree):
        edit.tree()


def test_children_are_those_before_the_edit() -> None:
    edit = TreeEdit(TREE)
    edit.rehang(3, 0, "root")
    edit.rehang(1, 3)
    edit.rehang_children(3, 1)
    assert [word.head for word in edit.tree().words] == [3, 1, 0]


def test_words_set_aside_leave_a_tree() -> None:
    tree = set_aside(TREE, {1}, "reparandum", lambda word: False)
    assert [(word.head, word.deprel) for word in tree.words] == [(3, "reparandum"), (3, "det"), (0, "root")]


def calls(path: Path) -> Iterator[Tuple[str, List[str]]]:
    """Each call of a plain name in a module, with the keywords that it is given."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"), str(path))):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            yield node.func.id, [keyword.arg or "" for keyword in node.keywords]


def makes_trees(path: Path) -> bool:
    return any(
        name in ("DependencyTree", "Word") or (name == "replace" and FIELDS & set(keywords))
        for name, keywords in calls(path)
    )


def test_no_other_module_makes_trees() -> None:
    packages = ("utterance_passes", "stanford_parser_ros", "semantic_framer", "roboframenet_tools")
    makers = {
        path.name
        for package in packages
        for path in SOURCES.glob(f"**/{package}/src/{package}/**/*.py")
        if makes_trees(path)
    }
    assert makers == READERS | {"tree_edits.py"}


def test_the_check_itself_finds_an_edit_by_hand(tmp_path: Path) -> None:
    module = tmp_path / "pass_by_hand.py"
    module.write_text("def hang(word):\n    return replace(word, head=1)\n", encoding="utf-8")
    assert makes_trees(module)


def test_a_fragment_stands_behind_a_verb() -> None:
    words = from_short("and|CCONJ|4|cc now|ADV|4|advmod ten|NUM|4|nummod more|ADJ|0|root").words
    starts = (0, 4, 8, 12)
    placed = (replace(word, start_character=at, end_character=at + len(word.form)) for word, at in zip(words, starts))
    fragment = DependencyTree("and now ten more", tuple(placed))
    tree = behind_verb(fragment, ["pick", "up"], {3, 4}, "feet")
    assert tree.text == "pick up and now ten more feet"
    assert [tree.text[word.start_character : word.end_character] for word in tree.words] == tree.text.split()
    assert [(word.head, word.deprel) for word in tree.words] == [
        (0, "root"),
        (1, "compound:prt"),
        (1, "discourse:aside"),
        (1, "discourse:aside"),
        (6, "nummod"),
        (1, "advmod"),
        (1, "obj"),
    ]


@pytest.mark.parametrize(
    "fragment, relation",
    [
        ("to|ADP|3|case the|DET|3|det left|NOUN|0|root", "obl"),
        ("the|DET|2|det office|NOUN|0|root", "obj"),
        ("faster|ADV|0|root", "advmod"),
    ],
)
def test_the_form_of_a_fragment_decides_its_relation(fragment: str, relation: str) -> None:
    tree = from_short(fragment)
    behind = behind_verb(tree, ["go"], {word.index for word in tree.words})
    assert [word.deprel for word in behind.children(1)] == [relation]
