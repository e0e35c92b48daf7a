"""Tree passes on all recorded parses: they keep to what they declare, and neither undo nor repeat each other."""

from dataclasses import dataclass, field
from typing import Dict, FrozenSet, List, Set, Tuple

import pytest

from offline_pipeline.pipeline import Pipeline
from roboframenet_testing.recorded_parses import read_shipped_recording
from semantic_framer.units.framed_lexicon import FramedLexicon
from utterance_passes.engine.pass_needs import TreeRun
from utterance_passes.engine.utterance_pass import TreePass, Uncertain
from utterance_passes.table import FRAMER_TREE_PASSES
from utterance_passes.trees.tree import DependencyTree, Word
from utterance_passes.trees.tree_edits import NotATree
from utterance_passes.trees.vocabulary import Vocabulary

#: Passes that change a sentence again when all of them run again. This list only gets shorter.
CHANGING_AGAIN = {
    "argument_clusters": "Switch on and off the light.",
    "mentioned_words": 'Don\'t say "open the door".',
    "persons_told": "Tell what day tomorrow is to Jamie at the couch.",
    "quotations": "Ask Anna her name and Ben his age.",
    # It follows argument_clusters, which reads "back" only when it has been set aside.
    "shared_verbs": "... and from the kitchen back to the bathroom, again and again.",
}
#: Passes that change the same word of a sentence. This list only gets shorter.
CHANGING_ONE_WORD = {
    ("not_only", "meant_instead"): "Bring not only the cup but also the plate.",
}


@dataclass
class Runs:
    """What the passes do with the recorded parses.

    Attributes:
        lost: passes that would change a sentence at which they do not look
        spared: how often a pass need not look at a sentence
        undeclared: relations that a pass gives and does not declare
        one_word: the passes that change one word of a sentence, in their order
        again: passes that change what they, or others, have changed before
    """

    lost: Set[str] = field(default_factory=set)
    spared: int = 0
    undeclared: Set[Tuple[str, str]] = field(default_factory=set)
    one_word: Dict[Tuple[str, ...], str] = field(default_factory=dict)
    again: Dict[str, str] = field(default_factory=dict)


def result(run: TreeRun, tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    try:
        return run(tree, vocabulary)
    except NotATree:
        return tree


def changed(before: DependencyTree, after: DependencyTree) -> List[Tuple[Word, Word]]:
    return [(old, new) for old, new in zip(before.words, after.words) if old != new]


def undeclared(one: TreePass, before: DependencyTree, after: DependencyTree) -> FrozenSet[str]:
    """Return the relations that a pass gives to words, but for those declared, and those that it passes on."""
    pairs = changed(before, after)
    passed_on = {old.deprel for old, _ in pairs} | {before.word(old.head).deprel for old, _ in pairs if old.head}
    return frozenset(new.deprel for old, new in pairs if new.deprel != old.deprel) - one.assigns - passed_on


def run_all(found: Runs, tree: DependencyTree, known: Vocabulary) -> None:
    said = tree
    changing: Dict[int, List[str]] = {}
    for one in FRAMER_TREE_PASSES:
        made = result(one.run, tree, known)
        everywhere = getattr(one.run, "__wrapped__", None)
        if everywhere is not None and made is tree:
            found.spared += 1
            if result(everywhere, tree, known) != tree:
                found.lost.add(one.name)
        if made is tree:
            continue
        found.undeclared.update((one.name, relation) for relation in undeclared(one, tree, made))
        for old, _ in changed(tree, made):
            changing.setdefault(old.index, []).append(one.name)
        tree = made
    found.one_word.update((tuple(names), tree.text) for names in changing.values() if len(names) > 1)
    # What no pass changes, none changes the second time.
    for one in FRAMER_TREE_PASSES if tree is not said else ():
        made = result(one.run, tree, known)
        if made != tree:
            found.again[one.name] = tree.text
        tree = made


@pytest.fixture(scope="module")
def runs(pipeline: Pipeline) -> Runs:
    known = FramedLexicon(pipeline.knowledge.lexicon, pipeline.knowledge.frames)
    found = Runs()
    for tree in read_shipped_recording().values():
        try:
            run_all(found, tree, known)
        except Uncertain:  # a person must say what is meant
            continue
    return found


def test_no_pass_would_change_a_sentence_at_which_it_does_not_look(runs: Runs) -> None:
    assert runs.spared > 10000
    assert not runs.lost


def test_passes_give_no_relation_that_they_do_not_declare(runs: Runs) -> None:
    assert not runs.undeclared


def test_no_two_passes_change_the_same_word(runs: Runs) -> None:
    assert set(runs.one_word) == set(CHANGING_ONE_WORD), runs.one_word


def test_passes_that_run_again_change_nothing(runs: Runs) -> None:
    assert set(runs.again) == set(CHANGING_AGAIN), runs.again
