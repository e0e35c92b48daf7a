"""A unit that is not tried because nothing has a relation that it requires would not fit a sentence of the tables."""

import re
from typing import List

import pytest
from talking_table import TABLES, outcome_of, read_table

from offline_pipeline.pipeline import Pipeline
from semantic_framer.filling import matching
from semantic_framer.units.required_relations import lacks_all_required
from semantic_framer.values.sentence import Sentence
from semantic_frames.lexical_unit import LexicalUnit


def readings(pipeline: Pipeline) -> List[str]:
    """What each line of the tables leads to, with the readings as the trace has them."""
    lines = [line for table in sorted(TABLES.glob("*.tsv")) for line in read_table(table.stem)]
    found = [outcome_of(pipeline, line.said) for line in lines if re.search(r"\w", line.said[-1])]
    return [f"{one.text}: {one.reply} {' '.join(map(str, one.readings))}" for one in found]


def test_no_reading_is_lost(pipeline: Pipeline, monkeypatch: pytest.MonkeyPatch) -> None:
    spared: List[LexicalUnit] = []

    def noted(sentence: Sentence, unit: LexicalUnit) -> bool:
        if lacks_all_required(sentence, unit):
            spared.append(unit)
        return False

    expected = readings(pipeline)
    monkeypatch.setattr(matching, "lacks_all_required", noted)
    assert readings(pipeline) == expected
    assert len(spared) > 1000
