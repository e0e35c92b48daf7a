"""Passes that look only at sentences with certain relations or words lose nothing by that: all sentences of tables."""

import re
from typing import Iterator, Tuple

from talking_table import TABLES, read_table

from offline_pipeline.pipeline import Pipeline
from semantic_framer.units.framed_lexicon import FramedLexicon
from stanford_parser_ros.model import UnparsableText
from utterance_passes.engine.pass_needs import TreeRun
from utterance_passes.engine.utterance_pass import TreePass, Uncertain
from utterance_passes.table import FRAMER_TREE_PASSES
from utterance_passes.trees.tree import DependencyTree
from utterance_passes.trees.tree_edits import NotATree
from utterance_passes.trees.vocabulary import Vocabulary


def texts() -> Iterator[str]:
    for table in sorted(TABLES.glob("*.tsv")):
        for line in read_table(table.stem):
            yield from (text for text in line.said if re.search(r"\w", text))


def result(run: TreeRun, tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    try:
        return run(tree, vocabulary)
    except NotATree:
        return tree


def check(one: TreePass, tree: DependencyTree, vocabulary: Vocabulary) -> Tuple[DependencyTree, bool]:
    """Return the tree after a pass, and whether the pass did not look at it although it looks at others."""
    made = result(one.run, tree, vocabulary)
    everywhere = getattr(one.run, "__wrapped__", None)
    if everywhere is None:
        return made, False
    assert result(everywhere, tree, vocabulary) == made, f'{one.name} loses "{tree.text}"'
    return made, made is tree


def test_no_pass_loses_anything(pipeline: Pipeline) -> None:
    known = FramedLexicon(pipeline.knowledge.lexicon, pipeline.knowledge.frames)
    spared = 0
    for text in dict.fromkeys(texts()):
        try:
            tree = pipeline.parse(text)
            for one in FRAMER_TREE_PASSES:
                tree, is_spared = check(one, tree, known)
                spared += is_spared
        except (UnparsableText, Uncertain):
            continue
    assert spared > 1000
