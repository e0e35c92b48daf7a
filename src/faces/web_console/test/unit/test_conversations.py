"""Past conversations: found again, judged by a person, and written as files for other programs."""

import json

import pytest
import yaml

from roboframenet_ros.sqlite_file import StoreError
from web_console.conversations import (
    RIGHT,
    WRONG,
    Conversation,
    ConversationFile,
    as_list,
    as_records,
    as_sentences,
    as_teaching,
    teaching,
)
from web_console.past import Past

GO = (("navigating_to_location", (("goal", "the hall"),)),)
SAID = (
    Conversation("a-1", 10.0, "Go to the hall.", GO, "DONE", "DONE", "Done."),
    Conversation("a-2", 20.0, "Off to the hall!", (), "REFUSED", "UNKNOWN_VERB", 'I do not know "off".'),
    Conversation("a-3", 30.0, "Thank you.", (), "REFUSED", "TALK", "You are welcome."),
)


def kept(path=":memory:", said=SAID, **settings):
    file = ConversationFile(str(path), **settings)
    for one in said:
        file.keep(one)
    return file


def ids(found):
    return [one.id for one in found]


def test_what_was_said_is_found_again_in_another_run(tmp_path):
    kept(tmp_path / "said.sqlite").close()
    assert ConversationFile(str(tmp_path / "said.sqlite")).find() == SAID[::-1]


@pytest.mark.parametrize(
    ("words", "found"),
    [
        ("", ["a-3", "a-2", "a-1"]),
        ("HALL", ["a-2", "a-1"]),
        ("hall off", ["a-2"]),
        ("welcome", ["a-3"]),
        ("a-3", ["a-3"]),
        ("%", []),
        ("kitchen", []),
        (":wrong", ["a-2"]),
        (":right hall", ["a-1"]),
        ("charger", ["a-2"]),
    ],
)
def test_search(words, found):
    file = kept()
    assert file.judge("a-1", RIGHT, "") and file.judge("a-2", WRONG, "Go to the charger.")
    assert ids(file.find(words)) == found


def test_list_goes_back_in_time():
    file = kept()
    newest = file.find(most=2)
    assert json.loads(as_list(newest, most=1))["more"]
    assert ids(file.find(before_s=newest[-1].stamp_s)) == ["a-1"]
    listed = json.loads(as_list(file.find(), most=30))
    assert [one["text"] for one in listed["said"]] == ["Thank you.", "Off to the hall!", "Go to the hall."]
    assert not listed["more"]


def test_the_oldest_are_forgotten():
    file = kept(said=[Conversation(str(number), number, "x", (), "DONE", "DONE", "") for number in range(20)], most=5)
    assert ids(file.find()) == ["19", "18", "17", "16", "15"]


def test_verdict_about_what_is_not_there():
    assert not kept().judge("b-1", RIGHT, "")


def test_verdict_can_be_taken_back():
    file = kept()
    file.judge("a-1", WRONG, "Go home.")
    file.judge("a-1", "", "")
    assert file.find() == SAID[::-1]


def test_a_broken_file_is_set_aside(tmp_path):
    path = tmp_path / "said.sqlite"
    path.write_bytes(b"no database" * 100)
    file = kept(path)
    assert "kept as" in file.problems[0]
    assert ids(file.find()) == ["a-3", "a-2", "a-1"]


def test_judged_sentences_are_a_file_for_rfn_test():
    """``tests/unit/test_files_of_the_page.py`` reads such a file with ``rfn test`` itself."""
    file = kept()
    file.judge("a-1", RIGHT, "")
    file.judge("a-2", WRONG, "Go to the hall.")
    file.judge("a-3", RIGHT, "")
    file.keep(Conversation("a-4", 40.0, "Say hello.", (), "DONE", "DONE", "Done.", WRONG))
    text = as_sentences(file.find())
    assert yaml.safe_load(text) == [
        {"text": "Thank you.", "code": "TALK"},
        {"text": "Off to the hall!", "means": "Go to the hall."},
        {"text": "Go to the hall.", "frames": [{"navigating_to_location": {"goal": "the hall"}}]},
    ]
    assert '# wrong, and nobody has said what is right: "Say hello."' in text


def test_the_newest_verdict_about_a_sentence_counts():
    said = [Conversation(str(at), float(at), "Go  to the Hall.", GO, "DONE", "DONE", "Done.", RIGHT) for at in (1, 2)]
    file = kept(said=said)
    file.judge("2", WRONG, "Go to the kitchen.")
    entries = yaml.safe_load(as_sentences(file.find()))
    assert entries == [{"text": "Go  to the Hall.", "means": "Go to the kitchen."}]


def test_record_has_a_line_for_each_sentence_in_their_order():
    lines = [json.loads(line) for line in as_records(kept().find()).splitlines()]
    assert [line["text"] for line in lines] == [one.text for one in SAID]
    assert lines[0]["reply"] == {"outcome": "DONE", "code": "DONE", "sentence": "Done."}


def test_what_was_meant_is_taught_once():
    assert teaching("Off to the hall!", "Go to the hall.") == "When I say off to the hall, go to the hall."
    file = kept()
    file.judge("a-2", WRONG, "Go to the hall.")
    file.keep(Conversation("a-5", 50.0, "Off to the hall.", (), "REFUSED", "NO_VERB", "", WRONG, "Go to the hall!"))
    assert as_teaching(file.find()) == "When I say off to the hall, go to the hall.\n"


def test_thread_keeps_finds_and_judges(tmp_path):
    problems = []
    past = Past(str(tmp_path / "said.sqlite"), on_problem=problems.append)
    for one in SAID:
        past.keep(one)
    past.judge("a-2", WRONG, "Go to the hall.")
    listed = json.loads(past.text("past.json", "off", 0.0).result(timeout=10))
    assert [(one["id"], one["verdict"], one["teaching"]) for one in listed["said"]] == [
        ("a-2", "wrong", "When I say off to the hall, go to the hall.")
    ]
    assert "means: Go to the hall." in past.text("sentences.yaml", "", 0.0).result(timeout=10)
    past.close()
    assert not problems


def test_without_a_place_for_the_file_conversations_last_as_long_as_the_node(tmp_path):
    (tmp_path / "file").write_text("")
    problems = []
    past = Past(str(tmp_path / "file" / "said.sqlite"), on_problem=problems.append)
    past.keep(SAID[0])
    assert json.loads(past.text("past.json", "", 0.0).result(timeout=10))["said"]
    assert len(problems) == 1
    past.close()
    with pytest.raises(StoreError):
        ConversationFile(str(tmp_path / "file" / "said.sqlite"))
