"""``rfn experience``: lists, explains, exports, imports and resets."""

import argparse
from pathlib import Path

import pytest

from experience import experience_command
from experience.rules import Rule, RuleKind
from experience.store import Store
from experience.trial import Circumstances, Outcome, Trial

TRIAL = Trial("c", "Wave.", 1.0, "waving", "/arm_a", "", Circumstances(place="kitchen"), 2.0, Outcome.SUCCEEDED)
FAILED = Trial("d", "Wave.", 2.0, "waving", "/arm_a", "", TRIAL.circumstances, 2.0, Outcome.FAILED, "aborted: stuck")
RULE = Rule("r", RuleKind.NEVER, "arm_a", said="Never use arm_a.")


@pytest.fixture
def rfn(tmp_path: Path, capsys, monkeypatch):
    path = tmp_path / "experience.sqlite"
    store = Store(str(path))
    store.add([TRIAL, FAILED])
    store.write_rules([RULE])
    store.close()
    monkeypatch.setattr(experience_command, "_reload", lambda: "")

    def run(*words: str, file: Path = path) -> str:
        parser = argparse.ArgumentParser()
        experience_command.add_arguments(parser)
        status = experience_command.run(parser.parse_args(["--file", str(file), *words]))
        out, err = capsys.readouterr()
        return out if status == 0 else f"{status}: {err}"

    return run


def test_list_shows_servers_and_rules(rfn) -> None:
    text = rfn("list")
    assert "2 trials, 1 rules" in text and "1 of 2" in text and "never arm_a" in text


def test_explain_shows_places_and_failures(rfn) -> None:
    text = rfn("explain", "arm_a")
    assert "place kitchen" in text and "it aborted: stuck" in text
    assert "No server" in rfn("explain", "arm_z")


def test_export_and_import_carry_everything_once(rfn, tmp_path: Path) -> None:
    exported, other = tmp_path / "out.jsonl", tmp_path / "other.sqlite"
    assert "3 lines" in rfn("export", str(exported))
    assert "2 trials and 1 rules are added" in rfn("import", str(exported), file=other)
    assert "0 trials" in rfn("import", str(exported), file=other)
    store = Store(str(other))
    assert store.trials() == (TRIAL, FAILED) and store.rules() == (RULE,)


def test_wrong_line_is_named_and_nothing_is_imported(rfn, tmp_path: Path) -> None:
    wrong = tmp_path / "wrong.jsonl"
    wrong.write_text('{"rule": "{}"}\n')
    assert rfn("import", str(wrong)).startswith(f"2: rfn experience: {wrong}:1: ")
    assert "2 trials, 1 rules" in rfn("list")


def test_reset_deletes_everything(rfn) -> None:
    assert rfn("reset") == "2 trials and all rules are deleted.\n"
    assert rfn("list") == "0 trials, 0 rules\n"
