"""The table of passes: each does what its example says, the order is the one written here, no pass calls another."""

import ast
from pathlib import Path
from typing import List, Tuple

import pytest

from utterance_passes.conllu import from_short
from utterance_passes.running import (
    run_cut_passes,
    run_surroundings_passes,
    run_text_passes,
    run_tree_passes,
    run_word_passes,
)
from utterance_passes.spelling import as_said
from utterance_passes.table import PASSES
from utterance_passes.text_table import TEXT_PASSES
from utterance_passes.trace import Trace
from utterance_passes.utterance_pass import (
    CutPass,
    Pass,
    Stage,
    SurroundingsPass,
    TextPass,
    TreePass,
    WordPass,
)

PACKAGE = Path(__file__).resolve().parents[2] / "src" / "utterance_passes"


def test_names_are_told_apart() -> None:
    assert len({one.name for one in PASSES}) == len(PASSES)


def test_the_passes_of_the_parser_come_first() -> None:
    stages = [one.stage for one in PASSES]
    assert stages == sorted(stages, key=[Stage.PARSER, Stage.FRAMER].index)


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


#: Functions of the modules that hold passes are called by the table alone.
RUNS = {
    (one.run.__module__.rsplit(".", 1)[-1], one.run.__name__)  # type: ignore[attr-defined]
    for one in PASSES
    if not isinstance(one, TextPass)
}


def test_no_pass_calls_another() -> None:
    names = {name for _, name in RUNS}
    for path in PACKAGE.glob("*.py"):
        if not path.name.endswith("table.py"):
            tree = ast.parse(path.read_text(encoding="utf-8"))
            used = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
            used |= {node.attr for node in ast.walk(tree) if isinstance(node, ast.Attribute)}
            assert not used & names, path.name


def test_the_modules_of_passes_import_no_module_of_another_pass() -> None:
    modules = {module for module, _ in RUNS} | {"spelling"}
    # What finds times and clauses looks at a tree and changes none, and a spelling is a value.
    looking = {"times": {"find_times"}, "spelling": {"Spelling"}}
    for module in modules:
        tree = ast.parse((PACKAGE / f"{module}.py").read_text(encoding="utf-8"))
        for node in ast.walk(tree):
            if isinstance(node, ast.ImportFrom) and node.module and node.module.startswith("utterance_passes."):
                other = node.module.split(".")[1]
                if other in modules:
                    assert {alias.name for alias in node.names} <= looking.get(other, set()), (module, other)
