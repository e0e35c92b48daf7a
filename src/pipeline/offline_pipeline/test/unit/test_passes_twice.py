"""Passes that run again on their own result find nothing more to do."""

from typing import Set

from offline_pipeline.pipeline import Pipeline
from roboframenet_testing.recorded_parses import read_shipped_recording
from semantic_framer.units.framed_lexicon import FramedLexicon
from utterance_passes.engine.running import run_tree_passes
from utterance_passes.engine.trace import Trace
from utterance_passes.engine.utterance_pass import Uncertain
from utterance_passes.table import FRAMER_TREE_PASSES, REPHRASING_PASSES

#: They change some tree again. This list only gets shorter.
AGAIN = frozenset(["argument_clusters", "persons_told", "quotations"])


def test_passes_that_run_twice_change_nothing_more(pipeline: Pipeline) -> None:
    known = FramedLexicon(pipeline.knowledge.lexicon, pipeline.knowledge.frames)
    found: Set[str] = set()
    for tree in read_shipped_recording().values():
        try:
            once = run_tree_passes(tree, known, FRAMER_TREE_PASSES)
            trace = Trace()
            run_tree_passes(once, known, REPHRASING_PASSES, trace=trace)
        except Uncertain:  # a person must say what is meant
            continue
        found |= trace.rules
    assert found == AGAIN
