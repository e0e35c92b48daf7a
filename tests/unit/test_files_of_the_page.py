"""What the page writes of past conversations is read by the programs that it is for."""

from pathlib import Path

from roboframenet_tools.cli import main
from roboframenet_tools.recording import read_records
from roboframenet_tools.sentence_file import load_sentences
from web_console.conversations import RIGHT, WRONG, Conversation, as_records, as_sentences

TURN = (("turning", (("direction", "left"),)),)
SAID = (
    Conversation("a-3", 30.0, "Thank you.", (), "REFUSED", "TALK", "You are welcome.", RIGHT),
    Conversation("a-2", 20.0, "Close the door.", (), "REFUSED", "TALK", "No.", WRONG, "Close the door"),
    Conversation("a-1", 10.0, "Turn left.", TURN, "DONE", "DONE", "Done.", WRONG, "Turn right."),
    Conversation("a-0", 5.0, "Turn left", TURN, "DONE", "DONE", "Done."),
)


def test_judged_sentences_are_read_by_rfn_test(tmp_path: Path, capsys) -> None:
    path = tmp_path / "sentences.yaml"
    path.write_text(as_sentences(SAID), encoding="utf-8")
    assert [(one.text, one.code, one.means) for one in load_sentences(path.read_text(), "s")] == [
        ("Thank you.", "TALK", ""),
        ("Close the door.", "", "Close the door"),
        ("Turn left.", "", "Turn right."),
    ]
    assert main(["test", str(path)]) == 1
    assert capsys.readouterr().out.endswith("3 sentences, 1 differ\n")


def test_record_is_that_of_rfn_record() -> None:
    records = read_records(as_records(SAID).splitlines(), "said.jsonl")
    assert [(one.text, one.frames, one.code) for one in records] == [
        (one.text, one.frames, one.code) for one in reversed(SAID)
    ]
