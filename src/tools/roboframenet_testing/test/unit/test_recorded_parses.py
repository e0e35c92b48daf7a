"""Recorded parses are found by what was asked, and written so that a change of one is a change of its lines."""

from dataclasses import replace
from typing import List, Sequence

import pytest

from roboframenet_testing.recorded_parses import (
    RECORDING,
    NotRecorded,
    RecordedInference,
    RecordingInference,
    key_of_named_words,
    key_of_text,
    named_words_of,
    read_recording,
    read_shipped_recording,
    render_recording,
)
from utterance_passes.trees.conllu import from_short
from utterance_passes.trees.tree import Alternative, DependencyTree
from utterance_passes.trees.tree_edits import TreeEdit
from utterance_passes.trees.vocabulary import NamedWord

PING = replace(from_short("ping|NOUN|2|compound Bob|PROPN|0|root"), alternatives=(Alternative(1, 0, "root", 0.25),))
GO = from_short("go|VERB|0|root home|ADV|1|advmod")
NAMED = [NamedWord(word=2, length=1, noun=0, verb=1, is_particle=True)]


def as_verb(tree: DependencyTree) -> DependencyTree:
    """The tree with its first word as a verb."""
    edit = TreeEdit(tree)
    edit.tag(1, "VERB", "VB", "Mood=Imp")
    return edit.tree()


class Models:
    """Models that know two texts, and count what they are asked."""

    def __init__(self) -> None:
        self.asked: List[str] = []

    def parse(self, text: str) -> DependencyTree:
        self.asked.append(text)
        return {tree.text: tree for tree in (PING, GO)}[text]

    def with_named_words(self, tree: DependencyTree, named: Sequence[NamedWord]) -> DependencyTree:
        self.asked.append(f"{tree.text} by named words")
        return as_verb(tree)


@pytest.fixture
def recording() -> RecordingInference:
    found = RecordingInference(Models(), {})
    found.parse("ping Bob")
    found.with_named_words(PING, NAMED)
    found.parse("go home")
    return found


def test_what_was_recorded_is_answered(recording: RecordingInference) -> None:
    recorded = RecordedInference(read_recording(render_recording(recording.parses)))
    assert recorded.parse("go home") == GO
    assert recorded.parse("ping Bob") == PING
    assert recorded.parse("ping Bob").alternatives == PING.alternatives
    assert recorded.with_named_words(PING, NAMED) == as_verb(PING)


def test_the_models_are_asked_once_for_each_answer() -> None:
    models = Models()
    again = RecordingInference(models, {})
    for _ in range(2):
        again.parse("ping Bob")
        again.with_named_words(PING, NAMED)
    assert models.asked == ["ping Bob", "ping Bob by named words"]


def test_what_is_known_is_kept_and_not_asked() -> None:
    models = Models()
    more = RecordingInference(models, {key_of_text("go home"): GO})
    more.parse("go home")
    more.parse("ping Bob")
    assert models.asked == ["ping Bob"]
    assert set(more.parses) == {key_of_text("go home"), key_of_text("ping Bob")}


def test_named_words_are_in_the_key() -> None:
    assert named_words_of(key_of_named_words(PING, NAMED)) == tuple(NAMED)
    assert named_words_of(key_of_text("ping Bob")) == ()


def test_the_order_of_questions_does_not_matter(recording: RecordingInference) -> None:
    turned = dict(reversed(list(recording.parses.items())))
    assert list(turned) != list(recording.parses)
    assert render_recording(turned) == render_recording(recording.parses)


def test_a_missing_parse_names_the_command_that_records_it(recording: RecordingInference) -> None:
    recorded = RecordedInference(recording.parses)
    with pytest.raises(NotRecorded, match=r"no parse of 'go away' is recorded: 'make record'"):
        recorded.parse("go away")
    with pytest.raises(NotRecorded, match=r"'go home' with the named words home is recorded: 'make record'"):
        recorded.with_named_words(GO, NAMED)


def test_no_boundary_turns_a_missing_parse_into_a_reply() -> None:
    assert not issubclass(NotRecorded, Exception)


def test_the_shipped_recording_is_as_it_would_be_written() -> None:
    """A recording that was merged by hand can have blocks twice or in another order."""
    parses = read_shipped_recording()
    assert parses
    assert render_recording(parses) == RECORDING.read_text(encoding="utf-8"), "'make record' writes it anew"
    assert all(
        key in (key_of_text(tree.text), key_of_named_words(tree, named_words_of(key))) for key, tree in parses.items()
    )
