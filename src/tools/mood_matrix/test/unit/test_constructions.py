"""The 24 rows: units taken to pieces, the sentences that are made of them, and what is right."""

import hashlib
from pathlib import Path
from typing import Any, Dict, List, Mapping, Tuple

import pytest
import yaml

from mood_matrix.constructions import FROZEN, ROWS, Outcome, Sentence, sentences_of
from mood_matrix.english import Predicate
from mood_matrix.mood_command import matrix, sample_of
from mood_matrix.units import Unit, load_frames, load_served, load_units
from roboframenet_testing.workspace import package

DOMAINS = package("roboframenet_domains") / "domains"


@pytest.fixture(scope="module")
def units() -> Tuple[Unit, ...]:
    return load_units(DOMAINS)


def unit_of(tmp_path: Path, unit: Mapping[str, Any], frame: Mapping[str, Any]) -> Tuple[Unit, ...]:
    """Write one frame and one unit, and read them."""
    for folder, content in (("frames", frame), ("lexical_units", unit)):
        path = tmp_path / "moods" / folder / "one.yaml"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(yaml.safe_dump(content, sort_keys=False), encoding="utf-8")
    return load_units(tmp_path)


def said(units: Tuple[Unit, ...], folder: Path) -> Dict[int, Sentence]:
    return {one.row: one for one in sentences_of(units, load_served(load_frames(folder)))}


CLOSING = {
    "frame_name": "closing",
    "verb": ["close", "shut"],
    "examples": {"Please close the door.": {"container_portal": "the door"}},
}


def test_every_row_is_said_as_its_title(tmp_path: Path) -> None:
    rows = said(unit_of(tmp_path, CLOSING, {"name": "closing"}), tmp_path)
    titles = {row.number: row.title for row in ROWS}
    titles[4] = "The door should be closed."
    titles[9] = "What did you close?"
    assert {number: one.text for number, one in rows.items()} == titles


def test_the_rows_of_a_unit_without_an_object(tmp_path: Path) -> None:
    unit = {"frame_name": "docking", "verb": "dock", "examples": ["Dock.", "dock now"]}
    rows = said(unit_of(tmp_path, unit, {"name": "docking"}), tmp_path)
    assert set(rows) == {row.number for row in ROWS} - {4, 9, 20, 24}
    assert rows[15].text == "Are you able to dock?"


def test_what_is_waited_for_and_noted_is_what_the_frame_names_as_its_result(tmp_path: Path) -> None:
    unit = {
        "frame_name": "ironing",
        "verb": "iron",
        "examples": {"Iron the shirt.": {"item": "the shirt"}},
    }
    plain = said(unit_of(tmp_path, unit, {"name": "ironing"}), tmp_path)
    state = {"frame": "condition_of_state", "theme": "item", "state": "folded"}
    result = {"name": "ironing", "results_in": state, "frame_elements": [{"name": "item"}, {"name": "place"}]}
    known = said(unit_of(tmp_path, unit, result), tmp_path)
    outcomes = [plain[row].expected.outcome for row in (17, 20, 23)]
    assert outcomes == [Outcome.CANNOT_NOTICE, Outcome.CANNOT_NOTICE, Outcome.NOTHING_TO_NOTE]
    assert [known[row].expected.outcome for row in (17, 20, 23)] == [Outcome.WAIT, Outcome.WAIT, Outcome.NOTE]
    assert (known[20].expected.things, known[20].expected.states) == (("the shirt",), ("folded", "ironed"))
    smooth = said(unit_of(tmp_path, unit, {**result, "results_in": {**state, "state": "smooth"}}), tmp_path)
    outcomes = [smooth[row].expected.outcome for row in (17, 20, 23)]
    assert outcomes == [Outcome.CANNOT_NOTICE, Outcome.CANNOT_NOTICE, Outcome.NOTE]
    place = {"frame": "condition_of_place", "theme": "item", "location": "place"}
    unsaid = said(unit_of(tmp_path, unit, {**result, "results_in": place}), tmp_path)
    assert unsaid[17].expected.outcome is Outcome.CANNOT_NOTICE


def test_a_state_that_a_server_sees_is_waited_for(tmp_path: Path) -> None:
    rows = said(unit_of(tmp_path, CLOSING, {"name": "closing"}), tmp_path)
    assert rows[20].expected.outcome is Outcome.WAIT
    assert rows[17].expected.outcome is Outcome.CANNOT_NOTICE


def test_dont_move_is_a_stop(tmp_path: Path) -> None:
    folder = tmp_path / "moods"
    unit = {"frame_name": "navigating_to_location", "verb": "move", "examples": ["Move."]}
    units = unit_of(tmp_path, unit, {"name": "navigating_to_location"})
    folder.rename(tmp_path / "moving")
    (moving,) = load_units(tmp_path)
    assert units[0].domain == "moods"
    assert said((moving,), tmp_path)[6].expected.outcome is Outcome.STOP


def test_a_unit_is_left_out_without_a_server_or_an_example_in_the_imperative(tmp_path: Path) -> None:
    assert not unit_of(tmp_path, {**CLOSING, "frame_name": "flying"}, {"name": "flying"})
    assert not unit_of(tmp_path, {**CLOSING, "examples": ["The door is closed."]}, {"name": "closing"})
    composed = {"name": "flying", "children": [[{"name": "opening"}, {"name": "closing"}]]}
    assert unit_of(tmp_path, {**CLOSING, "frame_name": "flying"}, composed)


@pytest.mark.parametrize(
    "frame, predicate",
    [
        ("giving_drink", Predicate("pour", receiver="me", object="a beer")),
        ("switching_device", Predicate("turn", "on", object="the light")),
        ("pointing", Predicate("point", rest="at the door")),
        ("moving", Predicate("move", rest="forward 3 feet")),
        ("requesting", Predicate("ask", object="Alice", rest="to wait")),
        ("finding_out", Predicate("figure", "out", rest="where I left my keys")),
        ("laundering", Predicate("take", "care of", object="the laundry")),
    ],
)
def test_a_shipped_example_is_taken_to_pieces(frame: str, predicate: Predicate, units: Tuple[Unit, ...]) -> None:
    assert predicate in [unit.predicate for unit in units if unit.frame == frame]


def test_the_matrix_is_large_and_its_rows_for_scoring_are_a_third() -> None:
    sentences = matrix(DOMAINS)
    assert len(sentences) >= 4900
    assert len({one.text for one in sentences}) == len(sentences)
    assert {one.row for one in sentences} == set(range(1, 25))
    frozen = [one for one in sentences if one.is_frozen]
    assert {one.row for one in frozen} == FROZEN == {4, 9, 11, 13, 16, 19, 21, 24}
    assert 0.25 < len(frozen) / len(sentences) < 0.4


def test_sentences_are_chosen_by_row_and_domain() -> None:
    chosen = matrix(DOMAINS, rows=[8, 22], domains=["devices"])
    assert {one.row for one in chosen} == {8, 22}
    assert {one.domain for one in chosen} == {"devices"}


def test_a_sample_depends_on_its_seed_and_hardly_on_other_sentences() -> None:
    sentences = matrix(DOMAINS)
    sample = sample_of(sentences, 300, 0)
    assert len(sample) == 300
    assert sample == sample_of(sentences, 300, 0) != sample_of(sentences, 300, 1)
    less = sample_of(sentences[:-200], 300, 0)
    assert len({one.text for one in sample} & {one.text for one in less}) > 250


def test_the_sentences_are_those_of_the_frozen_form() -> None:
    """The wording of the rows does not change once rules are written: the sentences of one unit are pinned."""
    units = [unit for unit in load_units(DOMAINS) if unit.predicate.base() in ("lock the door", "give me the mug")]
    found: List[str] = [one.text for one in sentences_of(units, load_served(load_frames(DOMAINS)))]
    assert len(found) == 48
    assert hashlib.sha256("\n".join(found).encode()).hexdigest()[:16] == "71819a6e150b2c72"
