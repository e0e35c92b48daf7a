"""Units are found by the words that their patterns demand, and none is overlooked."""

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from offline_pipeline.knowledge import load_knowledge, shipped_domains
from semantic_framer.kinds.question_words import compiled
from semantic_framer.units.pattern_index import PatternIndex, demanded_words
from semantic_frames.lexical_unit import LexicalUnit, WordPattern

UNITS = load_knowledge([shipped_domains()]).lexicon.units
PATTERNS = [pattern for unit in UNITS for pattern in (*unit.questions, *unit.remarks)]


@pytest.mark.parametrize(
    "pattern,words",
    [
        ("<theme> (reach|enter) <goal>", {"reach", "enter"}),
        ("<theme> (get|come)( back)? home", {"home"}),
        ("<theme> arrive( here| there)?", {"arrive"}),
        ("(?!you )<theme> (step|walk up) (to|into) <goal>", {"step", "walk"}),
        ("what can i (say|ask)( (to )?you)?", {"what"}),
        ("doors?", set()),
        ("you are|we are", set()),
        ("(very )?<state>", set()),
        ("lamp(s)? shine", {"shine"}),
    ],
)
def test_words_that_every_fitting_text_has(pattern: str, words: set) -> None:
    assert demanded_words(pattern) == words


@settings(max_examples=600, deadline=None, suppress_health_check=list(HealthCheck))
@given(st.data())
def test_what_fits_a_shipped_pattern_has_a_demanded_word(data: st.DataObject) -> None:
    pattern = data.draw(st.sampled_from(PATTERNS))
    text = data.draw(st.from_regex(compiled(pattern.text), fullmatch=True))
    demanded = demanded_words(pattern.text)
    assert not demanded or demanded & set(text.split(" ")), (pattern.text, text)


def test_most_shipped_patterns_demand_a_word() -> None:
    assert sum(bool(demanded_words(pattern.text)) for pattern in PATTERNS) > 0.9 * len(PATTERNS)


def test_units_are_found_in_their_order_and_once() -> None:
    def unit(name: str, *patterns: str) -> LexicalUnit:
        return LexicalUnit(frame_name=name, verbs=(), relations=(), questions=tuple(map(WordPattern, patterns)))

    units = [unit("a", "<x> ring", "<x> ring again"), unit("b", "<x:word>"), unit("c", "<x> open"), unit("d")]
    index = PatternIndex(units, lambda one: one.questions)
    assert [one.frame_name for one in index.may_fit("the bell ring again".split())] == ["a", "b"]
    assert [one.frame_name for one in index.may_fit("it open".split())] == ["b", "c"]
