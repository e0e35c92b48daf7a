"""What rfn say prints and returns."""

import json
from dataclasses import replace

import pytest

from roboframenet_tools.cli import COMMANDS, main
from roboframenet_tools.saying import (
    EXIT_STATUS,
    NO_REPLY,
    Answer,
    Outcome,
    Stage,
    format_answer,
    format_stage,
    is_news,
)

ANSWER = Answer(
    id="1",
    text="Fly.",
    outcome=Outcome.REFUSED,
    stage="semantic_framer",
    code="UNKNOWN_VERB",
    sentence='I do not know "fly".',
)


def test_only_done_exits_with_zero() -> None:
    assert {outcome for outcome in Outcome if EXIT_STATUS[outcome] == 0} == {Outcome.DONE}


def test_exit_statuses_are_distinct() -> None:
    assert len(set(EXIT_STATUS.values())) == len(Outcome)


def test_answer_names_code_and_stage() -> None:
    assert format_answer(ANSWER, as_json=False) == 'refused: I do not know "fly". [UNKNOWN_VERB in semantic_framer]'


def test_answer_to_thanks_is_no_refusal_for_a_person():
    answer = replace(ANSWER, code="TALK", sentence="You are welcome.")
    assert format_answer(answer, as_json=False) == "heard: You are welcome. [TALK in semantic_framer]"


def test_json_answer_is_one_object() -> None:
    assert json.loads(format_answer(ANSWER, as_json=True))["reply"]["outcome"] == "REFUSED"


def test_json_stage_is_one_object() -> None:
    assert json.loads(format_stage(Stage("executor", "goal sent"), as_json=True)) == {
        "event": {"stage": "executor", "sentence": "goal sent"}
    }


def test_help_lists_every_command(capsys: pytest.CaptureFixture) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["--help"])
    assert ended.value.code == 0
    printed = capsys.readouterr().out
    assert all(name in printed for name, _, _ in COMMANDS)


def test_passing_time_is_no_news() -> None:
    running = Stage("executor", 'Doing "turn left" (1 s).')
    assert is_news(running, None)
    assert not is_news(Stage("executor", 'Doing "turn left" (2 s).'), running)
    assert is_news(Stage("executor", 'Doing "go ahead" (2 s).'), running)
    assert is_news(Stage("arbitrator", running.sentence), running)


def test_without_a_master_it_ends_with_the_reason(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture
) -> None:
    # The discard port: nobody listens there.
    monkeypatch.setenv("ROS_MASTER_URI", "http://127.0.0.1:9")
    assert main(["say", "--wait", "0.1", "Turn left."]) == NO_REPLY
    assert "no ROS master at http://127.0.0.1:9" in capsys.readouterr().err
