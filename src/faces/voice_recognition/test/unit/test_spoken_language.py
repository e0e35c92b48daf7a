"""What can be said to the robot is made from the examples of its lexical units."""

from typing import FrozenSet, Mapping

import pytest

from offline_pipeline.knowledge import Knowledge, load_knowledge, shipped_domains
from semantic_frames import load_frame, load_lexical_units
from semantic_types import shipped_types
from voice_recognition.offers import OfferFinder
from voice_recognition.spoken_language import (
    SpokenLanguage,
    grounded_frames,
    make_language,
    sentences,
    spoken_words,
)

NAMES: Mapping[str, "tuple[str, ...]"] = {"kitchen": ("Room",), "Alice": ("Human",), "Anna's office": ("Room",)}


@pytest.fixture(scope="module", name="knowledge")
def _knowledge() -> Knowledge:
    return load_knowledge([shipped_domains()])


def language_of(knowledge: Knowledge, served: FrozenSet[str]) -> SpokenLanguage:
    grounded = grounded_frames(knowledge.frames, served)
    return make_language(knowledge.frames, knowledge.lexicon.units, grounded, NAMES, knowledge.types)


def offer(language: SpokenLanguage, words: str):
    return OfferFinder(language).find(tuple(words.split()))


def test_examples_get_slots(knowledge: Knowledge) -> None:
    other = offer(language_of(knowledge, frozenset(["turning"])), "turn left one hundred and twenty degrees")
    assert other is not None
    assert other.frame == "turning"
    assert dict(other.elements)["angle"] == "120" and dict(other.elements)["direction"] == "left"
    assert other.text == "turn left 120 degrees"


def test_only_what_the_robot_can_do_is_in_the_language(knowledge: Knowledge) -> None:
    assert offer(language_of(knowledge, frozenset(["turning"])), "follow me") is None
    assert offer(language_of(knowledge, frozenset(["following"])), "follow me") is not None


def test_a_frame_is_grounded_by_the_servers_of_its_children(knowledge: Knowledge) -> None:
    assert "turning_around" in grounded_frames(knowledge.frames, frozenset(["turning"]))
    assert "fetching" not in grounded_frames(knowledge.frames, frozenset(["taking"]))


def test_names_that_the_robot_knows_can_be_said(knowledge: Knowledge) -> None:
    language = language_of(knowledge, frozenset(["navigating_to_location"]))
    for words in ("go to the kitchen", "go to anna's office"):
        found = offer(language, words)
        assert found is not None and found.frame == "navigating_to_location", words
    assert offer(language, "go to alice's kitchen") is None


def test_a_new_ability_can_be_said(knowledge: Knowledge) -> None:
    frame = load_frame("name: juggling\nframe_elements:\n  - name: item\n    is_core: True\n", "juggling.yaml")
    units = load_lexical_units(
        "- frame_name: juggling\n  verb: [juggle]\n  frame_element_grammatical_relations:\n"
        "    - {name: item, relation: dobj, argument: phrase}\n"
        "  examples:\n    - {text: Juggle the balls., frame_elements: {item: the balls}}\n",
        "juggle.yaml",
    )
    language = make_language({"juggling": frame}, units, frozenset(["juggling"]), {}, shipped_types())
    found = offer(language, "please juggle the balls")
    assert found is not None and found.question == "Shall I juggle the balls?"


@pytest.mark.parametrize(
    "text, words",
    [
        ("Turn left 120 degrees.", "turn left one hundred twenty degrees"),
        ("back up two feet", "back up two feet"),
        ("Go to Roger's office!", "go to roger's office"),
        ("forty-five", "forty five"),
    ],
)
def test_words_are_those_that_are_said(text: str, words: str) -> None:
    assert spoken_words(text) == tuple(words.split())


def test_a_clause_is_no_filler_and_a_number_is_no_word(knowledge: Knowledge) -> None:
    language = language_of(knowledge, frozenset(["telling", "turning"]))
    assert offer(language, "notify my wife that the meeting") is None
    assert offer(language, "pull a one hundred eighty") is None


def test_every_sentence_of_the_language_is_read(knowledge: Knowledge) -> None:
    language = language_of(knowledge, frozenset(knowledge.frames))
    finder = OfferFinder(language)
    count = 0
    for template, _, words in sentences(language):
        count += 1
        assert finder.find(words) is not None, template
    assert count > 2000


@pytest.mark.parametrize(
    "words, question",
    [
        ("turn left ninety degrees", "Shall I turn left 90 degrees?"),
        ("make a left", "Shall I turn left?"),
        ("follow me", "Shall I follow you?"),
        ("could you please turn around", "Shall I turn around?"),
    ],
)
def test_the_question_names_the_frame(knowledge: Knowledge, words: str, question: str) -> None:
    found = offer(language_of(knowledge, frozenset(["turning", "following"])), words)
    assert found is not None and found.question == question


def test_the_same_command_in_other_words_means_the_same(knowledge: Knowledge) -> None:
    language = language_of(knowledge, frozenset(["turning"]))
    one, other = offer(language, "turn left"), offer(language, "make a left")
    assert one is not None and other is not None and one.means_the_same(other)
    right = offer(language, "turn right")
    assert right is not None and not one.means_the_same(right)
