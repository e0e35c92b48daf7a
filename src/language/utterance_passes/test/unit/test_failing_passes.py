"""A pass that raises an error: one that only repairs the parse is skipped, any other fails with its name."""

import logging
from dataclasses import replace
from typing import Tuple

import pytest

from utterance_passes.engine.running import run_cut_passes, run_text_passes, run_tree_passes
from utterance_passes.engine.trace import Trace
from utterance_passes.engine.utterance_pass import Example, Kind, PassFailed, TreePass
from utterance_passes.phrases.clauses import Clause
from utterance_passes.table import CUT_PASSES, PASSES, TEXT_PASSES
from utterance_passes.trees.conllu import from_short
from utterance_passes.trees.tree import DependencyTree
from utterance_passes.trees.vocabulary import Verbs, Vocabulary

TREE = from_short("turn|VERB|0|root left|ADV|1|advmod")


def failing(*_: object) -> Tuple[()]:
    raise IndexError("no such word")


def first_last(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    return replace(tree, text="turned")


def test_a_repair_that_fails_is_skipped(caplog: pytest.LogCaptureFixture) -> None:
    trace = Trace()
    example = Example("", ("",))
    passes = (
        TreePass("broken", "Fail.", example, Kind.REPAIR, failing),  # type: ignore[arg-type]
        TreePass("whole", "Turn.", example, Kind.REPAIR, first_last),
    )
    with caplog.at_level(logging.ERROR):
        made = run_tree_passes(TREE, Verbs(), passes, trace=trace)
    assert made.text == "turned"
    assert 'the pass "broken" failed: IndexError: no such word' in caplog.text
    assert str(trace).startswith('broken: skipped: the pass "broken" failed')


def test_a_meaning_that_fails_is_named() -> None:
    one = TreePass("broken", "Fail.", Example("", ("",)), Kind.MEANING, failing)  # type: ignore[arg-type]
    with pytest.raises(PassFailed, match='the pass "broken" failed: IndexError: no such word'):
        run_tree_passes(TREE, Verbs(), (one,))


def test_each_kind_of_pass_keeps_to_this() -> None:
    forms, tags = ("turn", "left"), ("VERB", "ADV")
    assert run_cut_passes(forms, tags, Verbs(), (replace(CUT_PASSES[0], run=failing),)) == ()
    with pytest.raises(PassFailed, match=TEXT_PASSES[0].name):
        run_text_passes("turn left", (replace(TEXT_PASSES[0], run=failing),))  # type: ignore[arg-type]


def test_some_passes_only_repair_the_parse() -> None:
    repairs = [one.name for one in PASSES if one.kind is Kind.REPAIR]
    assert "run_ons" in repairs and "quotations" not in repairs and "objection" not in repairs


def test_a_clause_has_words() -> None:
    with pytest.raises(ValueError, match='the clause of "turn" has no words'):
        Clause(1, "turn", frozenset(), False, "", frozenset())
