"""The file of experience: bounded, whole after a kill, set aside when it cannot be read, and deleted by one call."""

import os
import signal
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from experience.rules import Rule, RuleKind
from experience.store import Store
from experience.trial import Circumstances, Judgement, Outcome, Trial

WRITER = Path(__file__).resolve().parent.parent / "trial_writer.py"
ABOUT = Circumstances("theme=cup", "theme=cup_1", "kitchen", "alpha")
TRIAL = Trial("c1", "Take the cup.", 12.5, "taking", "/left_arm", "taking by /left_arm", ABOUT, 3.5, Outcome.SUCCEEDED)
FAILED = replace(TRIAL, server="/right_arm", outcome=Outcome.FAILED, reason="aborted: it slipped")
RULE = Rule("r1", RuleKind.NEVER, "left arm", "", "glass", False, "Never use the left arm for glasses.", 3.0)


def opened(tmp_path: Path, **limits: int) -> Store:
    return Store(str(tmp_path / "new" / "experience.sqlite"), **limits)


def test_what_was_written_is_read_again(tmp_path: Path) -> None:
    store = opened(tmp_path)
    store.add([TRIAL, FAILED])
    store.write_rules([RULE])
    store.close()
    again = opened(tmp_path)
    assert again.trials() == (TRIAL, FAILED)
    assert again.rules() == (RULE,)
    again.write_rules((), ["r1"])
    assert again.rules() == ()


def test_oldest_trials_are_deleted(tmp_path: Path) -> None:
    store = opened(tmp_path, most_trials=5)
    for number in range(8):
        store.add([replace(TRIAL, command_id=f"c{number}")])
    assert [trial.command_id for trial in store.trials()] == ["c3", "c4", "c5", "c6", "c7"]


def test_person_judges_what_succeeded(tmp_path: Path) -> None:
    store = opened(tmp_path)
    store.add([FAILED, TRIAL])
    store.judge("c1", Judgement.WRONG)
    failed, succeeded = store.trials()
    assert failed == FAILED
    assert succeeded.judgement is Judgement.WRONG and not succeeded.is_success


def test_delete_everything_leaves_no_word_in_the_file(tmp_path: Path) -> None:
    store = opened(tmp_path)
    store.add([TRIAL])
    store.write_rules([RULE])
    store.delete_everything()
    assert store.trials() == () and store.rules() == ()
    contents = b"".join(path.read_bytes() for path in (tmp_path / "new").iterdir())
    assert b"left_arm" not in contents and b"cup" not in contents


@pytest.mark.parametrize("content", [b"no database, " * 500, b"SQLite format 3\0" + b"\xff" * 5000])
def test_file_that_cannot_be_read_is_set_aside(content: bytes, tmp_path: Path) -> None:
    path = tmp_path / "experience.sqlite"
    path.write_bytes(content)
    store = Store(str(path))
    assert "unreadable.1" in store.problems[0]
    assert (tmp_path / "experience.sqlite.unreadable.1").read_bytes() == content
    store.add([TRIAL])
    assert store.trials() == (TRIAL,)


def test_wrong_entries_are_left_out_by_name(tmp_path: Path) -> None:
    store = opened(tmp_path)
    store.add([TRIAL])
    store.write_rules([RULE])
    store._file.connection.execute("UPDATE trials SET outcome = 9")
    store._file.connection.execute("UPDATE rules SET entry = '{}'")
    assert store.trials() == () and store.rules() == ()
    assert "trial 1 " in store.problems[0] and "'r1'" in store.problems[1]


def test_killed_writer_loses_nothing_that_it_wrote(tmp_path: Path) -> None:
    path, known = tmp_path / "experience.sqlite", 0
    for moment in range(5):
        writer = subprocess.Popen([sys.executable, str(WRITER), str(path)], stdout=subprocess.PIPE)
        assert writer.stdout is not None
        for _ in range(1 + (moment * 7919) % 23):
            assert writer.stdout.readline()
        os.kill(writer.pid, signal.SIGKILL)
        # The last line may have been cut by the kill.
        known += 1 + (moment * 7919) % 23 + len(writer.stdout.read().decode().split("\n")) - 1
        writer.wait()
        store = Store(str(path))
        assert not store.problems
        assert len(store.trials()) >= known
        known = len(store.trials())
        store.close()
