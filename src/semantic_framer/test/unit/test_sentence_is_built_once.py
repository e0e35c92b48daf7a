"""One view of one tree: nothing rewrites the tree, or looks at another one, after the passes."""

import ast
from pathlib import Path
from typing import Any, List

import pytest

from semantic_framer import framer
from semantic_framer.values.sentence import Sentence
from semantic_types import WordTypes
from utterance_passes.trees.tree import DependencyTree


@pytest.mark.parametrize(
    "text",
    [
        "Turn left 120 degrees.",
        "Go to the kitchen and say hello.",
        "Tell her lunch is ready, then go to the office and then to the kitchen.",
        "turn left no right",
        "I was wondering if you could bring me the mug, if you don't mind",
        "Turn left or go back.",
        "Go to the kitchen, sorry, to the office or to the kitchen.",
    ],
)
def test_one_sentence_for_each_tree(understand: Any, monkeypatch: pytest.MonkeyPatch, text: str) -> None:
    built: List[DependencyTree] = []

    class Counted(Sentence):
        def __init__(self, tree: DependencyTree, words: WordTypes, **others: Any) -> None:
            built.append(tree)
            super().__init__(tree, words, **others)

    monkeypatch.setattr(framer, "Sentence", Counted)
    # Other trees of the sentence, which are read where the parser's may be wrong, have sentences of their own.
    monkeypatch.setattr(framer, "best_of_trees", lambda _tree, heard, *_: heard)
    understand(text)
    assert len(built) <= 1


def test_no_other_module_builds_one() -> None:
    folder = Path(framer.__file__).resolve().parent
    builders = {
        path.name
        for path in folder.glob("**/*.py")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "Sentence"
    }
    # Links are set aside, a fragment is read behind the last verb, "coffee please" behind a verb of its own, and what
    # the robot knows attaches places otherwise.
    changing = {"linked_sentence.py", "fragment_phrases.py", "beginnings.py", "things_asked_for.py"}
    assert builders == {"framer.py", "sentence.py"} | changing


def test_a_sentence_is_a_view_of_its_tree(parser: Any) -> None:
    tree = parser.parse("go up to the desk")
    assert Sentence(tree).tree is tree
