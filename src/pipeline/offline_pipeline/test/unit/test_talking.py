"""Utterances as people make them: fragments, small talk, clusters, and sentences with the marks of speech.

Each line of a table says what must come out. A third of the lines was set aside until the rules were written.
"""

from typing import Dict, Iterator, List, Optional, Tuple

import pytest
from talking_table import Line, described, is_right, outcome_of, read_table

from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.pipeline import Parameters, Pipeline
from semantic_framer.filling import matching
from semantic_framer.units.required_relations import lacks_all_required
from semantic_framer.values.outcome import MEANING_ONLY
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from semantic_frames.lexical_unit import LexicalUnit

#: The least number of lines of each table that are right. The others ask or refuse.
LEAST_RIGHT: Dict[str, int] = {"first_words": 50, "fragments": 76, "small_talk": 69, "clusters": 41, "spoken": 60}


@pytest.fixture(scope="module")
def pipeline() -> Pipeline:
    knowledge = load_knowledge([shipped_domains()])
    pretend_servers(knowledge.graph)
    return Pipeline(knowledge, parameters=Parameters(policy=MEANING_ONLY))


@pytest.fixture(scope="module", autouse=True)
def spared() -> Iterator[List[Tuple[Sentence, LexicalUnit, Optional[Reading]]]]:
    """Units that would not be tried, because a sentence has nothing of what they require; and their readings."""
    found: List[Tuple[Sentence, LexicalUnit, Optional[Reading]]] = []

    class Filling(matching._Filling):
        def reading(self) -> Optional[Reading]:
            reading = super().reading()
            tried = self._tried
            if lacks_all_required(tried.sentence, tried.unit):
                found.append((tried.sentence, tried.unit, reading))
                return None
            return reading

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(matching, "lacks_all_required", lambda sentence, unit: False)
        patch.setattr(matching, "_Filling", Filling)
        yield found


@pytest.mark.parametrize("name", LEAST_RIGHT)
def test_a_third_was_set_aside(name: str) -> None:
    lines = read_table(name)
    assert len(lines) >= 40
    assert 3 * sum(line.is_held_out for line in lines) >= len(lines) - 3


@pytest.mark.parametrize("name", LEAST_RIGHT)
def test_table(pipeline: Pipeline, name: str) -> None:
    right, wrong = 0, []
    for line in read_table(name):
        understanding = outcome_of(pipeline, line.said)
        if is_right(understanding, line.expected):
            right += 1
        elif understanding.reply.outcome == "DONE" and understanding.readings:
            wrong.append(f"{line}: {described(understanding)}")
    assert not wrong, "acts wrongly"
    assert right >= LEAST_RIGHT[name]


@pytest.mark.parametrize("line", read_table("rules"), ids=str)
def test_rules(pipeline: Pipeline, line: Line) -> None:
    understanding = outcome_of(pipeline, line.said)
    assert is_right(understanding, line.expected), described(understanding)


def test_the_person_sees_what_a_typo_was_taken_for(pipeline: Pipeline) -> None:
    (reading,) = pipeline.understand("Go to the kichen.").readings
    assert reading.clause_text == "Go to the kitchen (said: kichen)"


def test_a_unit_that_is_not_tried_would_not_fit(
    spared: List[Tuple[Sentence, LexicalUnit, Optional[Reading]]], pipeline: Pipeline
) -> None:
    """The run of the tables above has tried what is spared otherwise."""
    if not spared:  # this test runs alone
        for name in LEAST_RIGHT:
            test_table(pipeline, name)
    assert len(spared) > 1000
    assert [(one.tree.text, unit.frame_name) for one, unit, reading in spared if reading is not None] == []
