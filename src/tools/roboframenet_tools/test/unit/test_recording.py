"""Recorded sentences, and how two versions differ about them."""

import json
from dataclasses import replace

import pytest

from roboframenet_tools.cli import main
from roboframenet_tools.recording import Record, RecordingError, is_same, read_records, record_to_json

TURNING = Record(
    text="Turn left 120 degrees.",
    frames=(("turning", (("angle", "120"), ("angle_unit", "degrees"), ("direction", "left"))),),
    outcome="DONE",
    code="DONE",
    sentence="Done.",
)
REFUSED = Record("Fly.", (), "REFUSED", "UNKNOWN_VERB", 'I do not know how to "fly".')


def test_record_is_read_as_it_was_written():
    lines = [record_to_json(TURNING), "", record_to_json(REFUSED)]
    assert read_records(lines, "said.jsonl") == [TURNING, REFUSED]


@pytest.mark.parametrize("line", ["{", "[]", "{}", '{"text": "Fly.", "frames": [], "reply": 1}'])
def test_line_that_is_no_record_is_named(line):
    with pytest.raises(RecordingError, match=r"said\.jsonl:2: "):
        read_records([record_to_json(REFUSED), line], "said.jsonl")


@pytest.mark.parametrize(
    "changes, same",
    [
        ({"outcome": "FAILED", "code": "ALL_CANDIDATES_FAILED"}, True),
        ({"outcome": "REFUSED", "code": "NO_SERVER"}, True),
        ({"outcome": "REFUSED", "code": "NEGATED"}, False),
        ({"frames": (("turning", (("direction", "left"),)),)}, False),
    ],
)
def test_frames_are_compared_and_not_what_the_robot_made_of_them(changes, same):
    assert is_same(replace(TURNING, **changes), TURNING) == same


def test_refusals_are_compared_by_their_code():
    assert is_same(REFUSED, replace(REFUSED, sentence="Another."))
    assert not is_same(REFUSED, replace(REFUSED, code="NO_READING"))


def test_replay_shows_what_differs(tmp_path, capsys):
    said = tmp_path / "said.jsonl"
    said.write_text(record_to_json(TURNING) + "\n", encoding="utf-8")
    assert main(["replay", str(said)]) == 0
    assert capsys.readouterr().out == "1 sentences, 0 differ\n"
    other = json.loads(record_to_json(TURNING))
    other["frames"][0]["frame_elements"][0]["argument"] = "90"
    said.write_text(json.dumps(other), encoding="utf-8")
    assert main(["replay", str(said)]) == 1
    assert "- turning(angle=90, " in capsys.readouterr().out


def test_replay_without_a_file_is_wrong_usage(tmp_path, capsys):
    assert main(["replay", str(tmp_path / "nothing")]) == 2
    assert "nothing" in capsys.readouterr().err
