"""``rfn unknown`` and ``rfn test``: what was not understood, by its nearest unit, and files of sentences."""

from pathlib import Path
from typing import Any, List

import pytest
import yaml

from checked_files import FileRefused
from roboframenet_tools.cli import main
from roboframenet_tools.recording import Record, record_to_json
from roboframenet_tools.sentence_file import ExpectedReading, load_sentences, sentence_in_file

ACQUIRE = Record("Acquire the ball.", (), "REFUSED", "UNKNOWN_VERB", 'I do not know how to "acquire".')
TURN = Record("Turn left.", (), "REFUSED", "UNKNOWN_VERB", 'I do not know how to "turn".')
TALK = Record("Thank you.", (), "REFUSED", "TALK", "You are welcome.")
HUM = Record("Hum.", (), "REFUSED", "UNKNOWN_VERB", 'I do not know how to "hum".')
BEAM = Record("Beam.", (("beaming", (("theme", "x"),)),), "REFUSED", "NO_SERVER", "Nothing can do beaming.")
GUESS = Record(
    "acquire the ball",
    (),
    "NEEDS_INFORMATION",
    "CONFIRM",
    'By "acquire the ball", do you mean "get the ball"?',
)


@pytest.fixture
def no_encoder(monkeypatch: Any, tmp_path: Path) -> None:
    """What is near does not depend on whether the encoder was made."""
    monkeypatch.setattr("nearest_meaning.likeness.made_folder", lambda: tmp_path / "none")


def recorded(path: Path, records: List[Record]) -> str:
    path.write_text("\n".join(map(record_to_json, records)) + "\n", encoding="utf-8")
    return str(path)


@pytest.mark.usefixtures("no_encoder")
def test_what_was_not_understood_is_counted_by_the_nearest_unit(tmp_path: Path, capsys: Any) -> None:
    said = recorded(tmp_path / "said.jsonl", [HUM, ACQUIRE, TURN, TALK, GUESS, BEAM])
    assert main(["unknown", said]) == 0
    out = capsys.readouterr().out
    groups = [line.split(maxsplit=1) for line in out.splitlines() if line[4:5].isdigit()]
    assert groups == [["2", "taking (get)"], ["1", "nothing near"], ["1", "no server for beaming"]]
    assert '2  "acquire the ball" -> "get the ball"' in out
    assert out.endswith("6 sentences, 4 not understood, 1 understood now\n")


@pytest.mark.usefixtures("no_encoder")
def test_the_export_fails_as_a_test_until_the_unit_is_there(tmp_path: Path, capsys: Any) -> None:
    said = recorded(tmp_path / "said.jsonl", [ACQUIRE, HUM])
    out = str(tmp_path / "sentences.yaml")
    assert main(["unknown", said, "--out", out]) == 0
    entries = yaml.safe_load(Path(out).read_text(encoding="utf-8"))
    assert entries[0] == {"text": "Acquire the ball.", "frames": [{"taking": {"theme": "the ball"}}]}
    assert entries[1] == {"text": "Hum.", "code": "UNKNOWN_VERB"}
    capsys.readouterr()
    assert main(["test", out]) == 1
    told = capsys.readouterr().out
    assert '"Acquire the ball."\n  - taking(theme=the ball)\n  + CONFIRM: ' in told
    assert told.endswith("2 sentences, 1 differ\n")
    units = tmp_path / "mine" / "lexical_units"
    units.mkdir(parents=True)
    (units / "acquire.yaml").write_text("frame_name: taking\nverb: acquire\n", encoding="utf-8")
    assert main(["test", out, "--with", str(tmp_path / "mine")]) == 0
    assert capsys.readouterr().out == "2 sentences, 0 differ\n"


def test_what_means_another_sentence_is_read_as_that(tmp_path: Path, capsys: Any) -> None:
    path = tmp_path / "sentences.yaml"
    lines = ("- {text: Close the door., means: Close the door}", "- {text: Turn left., means: Turn right.}")
    path.write_text("\n".join((*lines, "- {text: Hum., means: Hum.}")), encoding="utf-8")
    assert main(["test", str(path)]) == 1
    told = capsys.readouterr().out
    assert told.endswith("3 sentences, 2 differ\n")
    assert '"Turn left."\n  - as "Turn right.": turning(' in told
    # What is not understood itself says nothing about another sentence.
    assert '"Hum."\n  - as "Hum.": NOT UNDERSTOOD' in told


def test_what_cannot_be_read_is_told(tmp_path: Path, capsys: Any) -> None:
    (tmp_path / "bad").write_text("{", encoding="utf-8")
    for command in ("unknown", "test"):
        for path in (tmp_path / "bad", tmp_path / "none"):
            assert main([command, str(path)]) == 2
            assert str(path) in capsys.readouterr().err


def test_a_file_of_sentences_is_read_as_it_was_written() -> None:
    said = (
        ExpectedReading("Turn 'left': now.", (("turning", (("angle", "90"), ("direction", "left"))),)),
        ExpectedReading("Dance.", (), "UNKNOWN_VERB"),
        ExpectedReading("Go.", (("going", ()),), "MISSING_ELEMENT"),
    )
    text = "".join(sentence_in_file(one, "2 times:\nrefused") for one in said)
    read = load_sentences(text, "s.yaml")
    assert [(one.text, one.frames, one.code) for one in read] == [(one.text, one.frames, one.code) for one in said]
    assert read[0].line == 2


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("- text: Go.\n", "EMPTY"),
        ("- frames: [{going: {}}]\n", "MISSING_KEY"),
        ("- text: Go.\n  means: Leave.\n  code: NO_VERB\n", "TWO_READINGS"),
        ("- text: Go.\n  reading: x\n", "UNKNOWN_KEY"),
        ("- text: Go.\n  frames: going\n", "WRONG_TYPE"),
        ("- text: Go.\n  frames: [{going: [here]}]\n", "WRONG_TYPE"),
        ("", "EMPTY"),
        ("a: [\n", "NOT_YAML"),
    ],
)
def test_mistakes_in_a_file_of_sentences_are_told(text: str, problem: str) -> None:
    with pytest.raises(FileRefused) as refused:
        load_sentences(text, "s.yaml")
    assert refused.value.problems[0].code == problem
