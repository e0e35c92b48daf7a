"""Runs the passes of the table, in order."""

from typing import AbstractSet, FrozenSet, List, Optional, Sequence, Set, Tuple

from utterance_passes.spelling import Spelling, as_said
from utterance_passes.trace import Trace
from utterance_passes.tree import DependencyTree
from utterance_passes.tree_edits import NotATree
from utterance_passes.utterance_pass import (
    CutPass,
    Retag,
    Surroundings,
    SurroundingsPass,
    TagPass,
    TextPass,
    TreePass,
    WordPass,
)
from utterance_passes.vocabulary import Verbs, Vocabulary

NONE: FrozenSet[str] = frozenset()


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
            made = one.run(spelling)
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
            made = one.run(spelling, vocabulary)
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
        around = one.run(spelling, vocabulary) if one.name not in without else None
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
    for one in passes:
        for position in one.run(forms, tags, vocabulary) if one.name not in without else ():
            if trace is not None:
                trace.add(one.name, forms[position - 1], "", "begins a command, parsed alone", [position])
            found.add(position)
    return tuple(sorted(found))


def run_tag_passes(
    forms: Sequence[str],
    tags: Sequence[str],
    vocabulary: Vocabulary,
    passes: Sequence[TagPass],
    *,
    without: AbstractSet[str] = NONE,
    trace: Optional[Trace] = None,
) -> Tuple[Retag, ...]:
    """Return the corrected tags of a sentence; each pass sees the tags from the passes before it."""
    found: List[Retag] = []
    tags = list(tags)
    for one in passes:
        for retag in one.run(forms, tags, vocabulary) if one.name not in without else ():
            if trace is not None:
                position = retag.position
                trace.add(one.name, forms[position - 1], tags[position - 1], f"{retag.upos}, parsed again", [position])
            tags[retag.position - 1] = retag.upos
            found.append(retag)
    return tuple(found)


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
    """
    for one in passes:
        if one.name in without:
            continue
        try:
            made = one.run(tree, vocabulary)
        except NotATree as error:
            made = tree
            if trace is not None:
                trace.add(one.name, after=f"left as it was: {error}")
        if trace is not None and made is not tree:
            trace.add_changes(one.name, tree, made)
        tree = made
    return tree
