"""The table of passes: each does what its example says, stands in the table once, and calls no other."""

import ast
import importlib
import pkgutil
from pathlib import Path
from typing import Dict, List, Optional, Tuple

import pytest

import utterance_passes
from utterance_passes.engine.running import (
    run_cut_passes,
    run_surroundings_passes,
    run_text_passes,
    run_tree_passes,
    run_word_passes,
)
from utterance_passes.engine.trace import Trace
from utterance_passes.engine.utterance_pass import (
    CutPass,
    Example,
    Kind,
    Pass,
    SurroundingsPass,
    TextPass,
    TreePass,
    WordPass,
    text_pass,
    tree_pass,
)
from utterance_passes.table import NODES, PASSES, TEXT_PASSES
from utterance_passes.trees.conllu import from_short
from utterance_passes.trees.spelling import Spelling, as_said
from utterance_passes.trees.tree import DependencyTree
from utterance_passes.trees.vocabulary import Vocabulary


def test_names_are_told_apart() -> None:
    assert len({one.name for one in PASSES}) == len(PASSES)


def test_the_passes_of_the_parser_come_first() -> None:
    nodes = [NODES[one.name] for one in PASSES]
    assert nodes == sorted(nodes, key=["stanford_parser_ros", "semantic_framer"].index)


@pytest.mark.parametrize("one", PASSES, ids=lambda one: one.name)
def test_a_pass_says_what_it_does_in_one_sentence(one: Pass) -> None:
    assert one.what.endswith(".") and one.what[0].isupper() and ". " not in one.what.replace("...", "")


def tagged(said: str) -> Tuple[List[str], List[str]]:
    """The words and the tags of "open|VERB it|PRON"."""
    words = [item.split("|") for item in said.split()]
    return [word[0] for word in words], [word[1] for word in words]


def result(one: Pass, passes: Tuple[Pass, ...]) -> List[str]:
    """What passes make of the example of a pass."""
    example = one.example
    if isinstance(one, WordPass):
        spelling = as_said(example.said)
        return [run_word_passes(spelling, example.vocabulary, [w for w in passes if isinstance(w, WordPass)]).text]
    if isinstance(one, TextPass):
        return [run_text_passes(example.said, [each for each in passes if isinstance(each, TextPass)]).text]
    if isinstance(one, SurroundingsPass):
        surrounding = [each for each in passes if isinstance(each, SurroundingsPass)]
        around = run_surroundings_passes(as_said(example.said), example.vocabulary, surrounding)
        assert around is not None
        return [around.command.text, *(f"{word.form}: {word.deprel}" for word in around.words)]
    if isinstance(one, CutPass):
        forms, tags = tagged(example.said)
        cutting = [each for each in passes if isinstance(each, CutPass)]
        return [str(position) for position in run_cut_passes(forms, tags, example.vocabulary, cutting)]
    trace = Trace()
    trees = [each for each in passes if isinstance(each, TreePass)]
    run_tree_passes(from_short(example.said), example.vocabulary, trees, trace=trace)
    assert trace.rules <= {one.name}
    return [str(line).partition(": ")[2] for line in trace.lines]


@pytest.mark.parametrize("one", PASSES, ids=lambda one: one.name)
def test_example(one: Pass) -> None:
    assert result(one, (one,)) == list(one.example.expected)


@pytest.mark.parametrize("one", PASSES, ids=lambda one: one.name)
def test_switched_off_by_name(one: Pass) -> None:
    trace = Trace()
    example = one.example
    if isinstance(one, TextPass):
        assert run_text_passes(example.said, [one], without={one.name}, trace=trace).text == example.said
    elif isinstance(one, SurroundingsPass):
        said = as_said(example.said)
        assert run_surroundings_passes(said, example.vocabulary, [one], without={one.name}, trace=trace) is None
    elif isinstance(one, CutPass):
        forms, tags = tagged(example.said)
        assert not run_cut_passes(forms, tags, example.vocabulary, [one], without={one.name}, trace=trace)
    elif isinstance(one, TreePass):
        tree = from_short(example.said)
        assert run_tree_passes(tree, example.vocabulary, [one], without={one.name}, trace=trace) is tree
    assert not trace.lines


def test_text_is_parted_before_blanks_are_counted() -> None:
    assert run_text_passes(" go <pause> 3ft -2 ", TEXT_PASSES).text == "go 3 ft minus 2"


def passes_by_module() -> Dict[str, List[Pass]]:
    """The passes that each module of the package names, but for the table."""
    found = {}
    for module in pkgutil.walk_packages(utterance_passes.__path__, "utterance_passes."):
        names = vars(importlib.import_module(module.name))
        found[module.name] = [value for value in names.values() if isinstance(value, Pass)]
    del found["utterance_passes.table"]
    return found


def test_each_pass_is_in_the_table_once() -> None:
    written = [one for passes in passes_by_module().values() for one in passes]
    assert sorted(one.name for one in written) == sorted(one.name for one in PASSES)
    assert {id(one) for one in written} == {id(one) for one in PASSES}


def test_no_module_imports_a_pass_of_another() -> None:
    for module, passes in passes_by_module().items():
        for one in passes:
            made_of = one.run  # type: ignore[attr-defined]
            assert made_of.__module__ == module, f"{module} imports {one.name}"
            assert made_of.__name__ == one.name


def test_no_pass_runs_another() -> None:
    for module, passes in passes_by_module().items():
        tree = ast.parse(Path(str(importlib.import_module(module).__file__)).read_text(encoding="utf-8"))
        runs = [node.lineno for node in ast.walk(tree) if isinstance(node, ast.Attribute) and node.attr == "run"]
        assert not passes or not runs, f"{module}.py:{runs[:1]}"


@pytest.mark.parametrize(
    "written, what",
    [
        ("Say it once. Then no more.", "Say it once."),
        ('Set aside "if you ... please", and *only* that', None),
        ('Set aside\n    "if you ... please", and *only* that.', 'Set aside "if you ... please", and only that.'),
        ('Write "minus".\n\n    Args:', 'Write "minus".'),
        (None, None),
    ],
)
def test_what_a_pass_does_is_the_first_sentence_of_its_docstring(written: Optional[str], what: Optional[str]) -> None:
    def unchanged(spelling: Spelling) -> Spelling:
        return spelling

    unchanged.__doc__ = written
    make = text_pass(Kind.SPELLING, Example("", ("",)))
    if what is None:
        with pytest.raises(ValueError, match="the docstring of unchanged begins with no sentence"):
            make(unchanged)
    else:
        assert make(unchanged) == TextPass("unchanged", what, Example("", ("",)), Kind.SPELLING, unchanged)


def test_a_relation_that_does_not_exist_is_found_when_the_pass_is_made() -> None:
    def unchanged(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
        """Do nothing."""
        return tree

    made = tree_pass(Kind.MEANING, Example("", ()), requires=["acl:relcl"], assigns=["obj"])(unchanged)
    assert (made.requires, made.assigns) == ({"acl:relcl"}, {"obj"})
    with pytest.raises(ValueError, match="unchanged names relations that do not exist: advlc"):
        tree_pass(Kind.MEANING, Example("", ()), requires=["advlc", "conj"])(unchanged)
