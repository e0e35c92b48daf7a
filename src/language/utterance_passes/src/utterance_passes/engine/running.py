"""Runs the passes of the table, in order."""

import logging
from functools import partial
from typing import AbstractSet, Callable, FrozenSet, Optional, Sequence, Set, Tuple, TypeVar

from utterance_passes.engine.trace import Trace
from utterance_passes.engine.utterance_pass import (
    CutPass,
    Kind,
    Pass,
    PassFailed,
    Surroundings,
    SurroundingsPass,
    TextPass,
    TreePass,
    Uncertain,
    WordPass,
)
from utterance_passes.trees.spelling import Spelling, as_said
from utterance_passes.trees.tree import DependencyTree
from utterance_passes.trees.tree_edits import NotATree
from utterance_passes.trees.vocabulary import Verbs, Vocabulary

NONE: FrozenSet[str] = frozenset()
_LOG = logging.getLogger(__name__)
Result = TypeVar("Result")


def _result(one: Pass, run: Callable[[], Result], unchanged: Result, trace: Optional[Trace]) -> Result:
    """Return what a pass makes of its input; the input unchanged if it only repairs the parse, and fails.

    Raises:
        Uncertain: a person must say what the sentence means
        NotATree: what it makes is no tree
        PassFailed: any other pass raised an error
    """
    try:
        return run()
    except (NotATree, Uncertain):
        raise
    except Exception as error:  # boundary: a sentence that a pass does not expect still gets its reply
        failed = PassFailed(one.name, error)
        if one.kind is not Kind.REPAIR:
            raise failed from error
        _LOG.error("%s; the sentence is read without it", failed, exc_info=True)
        if trace is not None:
            trace.add(one.name, after=f"skipped: {failed}")
        return unchanged


def run_text_passes(
    text: str, passes: Sequence[TextPass], *, without: AbstractSet[str] = NONE, trace: Optional[Trace] = None
) -> Spelling:
    """Rewrite a text.

    Args:
        text: the text as it was said
        passes: the passes to run, in order
        without: names of passes that are switched off
        trace: records each change; None for no trace
    """
    spelling = as_said(text)
    for one in passes:
        if one.name not in without:
            made = _result(one, partial(one.run, spelling), spelling, trace)
            if trace is not None and made.text != spelling.text:
                trace.add(one.name, before=repr(spelling.text), after=repr(made.text))
            spelling = made
    return spelling


def run_word_passes(
    spelling: Spelling,
    vocabulary: Verbs,
    passes: Sequence[WordPass],
    *,
    without: AbstractSet[str] = NONE,
    trace: Optional[Trace] = None,
) -> Spelling:
    """Rewrite words by the words that the robot knows."""
    for one in passes:
        if one.name not in without:
            made = _result(one, partial(one.run, spelling, vocabulary), spelling, trace)
            if trace is not None and made.text != spelling.text:
                trace.add(one.name, before=repr(spelling.text), after=repr(made.text))
            spelling = made
    return spelling


def run_surroundings_passes(
    spelling: Spelling,
    vocabulary: Vocabulary,
    passes: Sequence[SurroundingsPass],
    *,
    without: AbstractSet[str] = NONE,
    trace: Optional[Trace] = None,
) -> Optional[Surroundings]:
    """Return the result of the first pass that finds words around a command; None if no pass does."""
    for one in passes:
        run = partial(one.run, spelling, vocabulary)
        around = _result(one, run, None, trace) if one.name not in without else None
        if around is not None:
            if trace is not None:
                trace.add(one.name, before=repr(spelling.text), after=f"{around.command.text!r}, parsed alone")
            return around
    return None


def run_cut_passes(
    forms: Sequence[str],
    tags: Sequence[str],
    vocabulary: Vocabulary,
    passes: Sequence[CutPass],
    *,
    without: AbstractSet[str] = NONE,
    trace: Optional[Trace] = None,
) -> Tuple[int, ...]:
    """Return the positions of the words that begin further commands."""
    found: Set[int] = set()
    nothing: Tuple[int, ...] = ()
    for one in passes:
        run = partial(one.run, forms, tags, vocabulary)
        for position in _result(one, run, nothing, trace) if one.name not in without else ():
            if trace is not None:
                trace.add(one.name, forms[position - 1], "", "begins a command, parsed alone", [position])
            found.add(position)
    return tuple(sorted(found))


def run_tree_passes(
    tree: DependencyTree,
    vocabulary: Vocabulary,
    passes: Sequence[TreePass],
    *,
    without: AbstractSet[str] = NONE,
    trace: Optional[Trace] = None,
) -> DependencyTree:
    """Run tree passes on a tree; a pass whose result is not a tree changes nothing.

    Raises:
        Uncertain: a person must say what the sentence means
        PassFailed: a pass that does not only repair the parse raised an error
    """
    for one in passes:
        if one.name in without:
            continue
        try:
            made = _result(one, partial(one.run, tree, vocabulary), tree, trace)
        except NotATree as error:
            made = tree
            if trace is not None:
                trace.add(one.name, after=f"left as it was: {error}")
        if trace is not None and made is not tree:
            trace.add_changes(one.name, tree, made)
        tree = made
    return tree
