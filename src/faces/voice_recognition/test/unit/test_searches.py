"""The grammar and the class trigram that are made from a language."""

import math
from collections import defaultdict
from typing import Dict, List, Tuple

import pytest

from semantic_frames import load_frame, load_lexical_units
from semantic_types import shipped_types
from voice_recognition.class_ngram import write_ngram
from voice_recognition.grammar import write_grammar, write_phrases
from voice_recognition.spoken_language import SpokenLanguage, make_language

FRAME = """
name: turning
frame_elements:
  - {name: direction, is_core: True, values: [left, right]}
  - {name: angle, quantity: angle, unit_element: angle_unit}
  - {name: angle_unit}
"""
UNITS = """
- frame_name: turning
  verb: [turn]
  frame_element_grammatical_relations:
    - {name: direction, relation: advmod}
  examples:
    - {text: Turn left., frame_elements: {direction: left}}
    - {text: turn right 90 degrees, frame_elements: {direction: right, angle: '90', angle_unit: degrees}}
"""


@pytest.fixture(name="language")
def _language() -> SpokenLanguage:
    frame = load_frame(FRAME, "turning.yaml")
    return make_language(
        {"turning": frame}, load_lexical_units(UNITS, "turn.yaml"), frozenset(["turning"]), {}, shipped_types()
    )


def test_the_grammar_has_rules_for_slots_and_no_rule_calls_itself(language: SpokenLanguage) -> None:
    rules = dict(
        line.rstrip(";").replace("public ", "", 1).split(" = ", 1)
        for line in write_grammar(language).splitlines()
        if " = " in line
    )
    assert rules["<command>"].startswith("turn ")
    assert "left" in rules["<class0>"] and "right" in rules["<class0>"]
    calls = {name: {other for other in rules if other in body} for name, body in rules.items()}
    reached, level = set(), {"<said>"}
    for _ in rules:
        level = {other for name in level for other in calls[name]}
        assert "<said>" not in level
        reached |= level
    assert not level and reached == set(rules) - {"<said>"}


def test_words_that_nobody_can_pronounce_are_left_out(language: SpokenLanguage) -> None:
    assert "left" in write_grammar(language)
    assert "left" not in write_grammar(language, without=frozenset(["left"]))
    assert " left" not in write_ngram(language, ["talk"], without=frozenset(["left"]))


def test_phrases_share_their_beginnings() -> None:
    assert "stop [ now ]" in write_phrases([("stop",), ("stop", "now")])


def probabilities(arpa: str) -> Tuple[Dict[Tuple[str, ...], float], Dict[Tuple[str, ...], float]]:
    found: Dict[Tuple[str, ...], float] = {}
    backoffs: Dict[Tuple[str, ...], float] = {}
    order = 0
    for line in arpa.splitlines():
        if line.endswith("-grams:"):
            order = int(line[1])
            continue
        fields: List[str] = line.split()
        if order and len(fields) > order:
            gram = tuple(fields[1 : order + 1])
            found[gram] = 10 ** float(fields[0])
            backoffs[gram] = 10 ** float(fields[order + 1]) if len(fields) > order + 1 else 1.0
    return found, backoffs


def test_after_every_history_the_probabilities_add_up_to_one(language: SpokenLanguage) -> None:
    arpa = write_ngram(language, ["coffee", "weather"])
    found, backoffs = probabilities(arpa)
    words = [gram[0] for gram in found if len(gram) == 1 and gram != ("<s>",)]

    def probability(gram: Tuple[str, ...]) -> float:
        if gram in found:
            return found[gram]
        return backoffs.get(gram[:-1], 1.0) * probability(gram[1:])

    histories = defaultdict(int)
    for gram in found:
        if len(gram) > 1:
            histories[gram[:-1]] += 1
    assert len(histories) > 10
    for history in [(), *histories]:
        assert math.isclose(sum(probability((*history, word)) for word in words), 1.0, abs_tol=0.002), history
    stated = [int(line.partition("=")[2]) for line in arpa.splitlines() if line.startswith("ngram ")]
    assert stated == [sum(len(gram) == order for gram in found) for order in (1, 2, 3)]


def test_talk_is_possible(language: SpokenLanguage) -> None:
    found, _ = probabilities(write_ngram(language, ["weather"]))
    assert found[("weather",)] > 0.0
    assert found[("turn", "left")] > found[("left",)]
