"""``rfn list --learned``, ``rfn forget --learned`` and ``rfn export-learned``: they work on the file."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from nearest_meaning.learned import KIND, LearnedUnit, text_with_frame
from nearest_meaning.learned_file import LearnedFile
from roboframenet_tools.cli import main
from semantic_frames import load_frame, load_lexical_units

NAME = "make_your_way.going"


@pytest.fixture
def path(tmp_path: Path) -> str:
    path = str(tmp_path / "learned.sqlite")
    file = LearnedFile(path)
    for name, said in ((NAME, "make your way"), ("zip.going", "zip")):
        text = f"- frame_name: going\n  verb: {said}\n"
        file.add(LearnedUnit(name, said, "go", "going", text, "anna", 0.0, "Make your\nway home."))
    file.close()
    return path


def test_what_is_learned_is_listed_with_who_when_and_from_which_sentence(path: str, capsys: Any) -> None:
    assert main(["list", "--learned", "--file", path]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "2 learned"
    assert NAME in lines[1] and 'by anna on 1970-01-01 00:00 UTC in "Make your way home."' in lines[1]


def test_one_thing_is_forgotten_by_its_name(path: str, capsys: Any) -> None:
    assert main(["forget", "--learned", NAME, "--file", path]) == 0
    assert [unit.name for unit in LearnedFile(path).units()] == ["zip.going"]
    assert main(["forget", "--learned", NAME, "--file", path]) == 2
    assert "rfn list --learned" in capsys.readouterr().err


def test_the_export_is_a_lexical_unit_file(path: str, tmp_path: Path, capsys: Any) -> None:
    out = tmp_path / "learned.yaml"
    assert main(["export-learned", "--file", path, "--out", str(out)]) == 0
    units = load_lexical_units(out.read_text(encoding="utf-8"), str(out))
    assert [unit.verbs for unit in units] == [("make your way",), ("zip",)]
    assert main(["export-learned", "--file", path]) == 0
    assert capsys.readouterr().out == out.read_text(encoding="utf-8")


SEQUENCE = LearnedUnit(
    "tidy.taught_tidy",
    "tidy",
    "go, then look",
    "taught_tidy",
    text_with_frame("- {frame_name: taught_tidy, remark: tidy}\n", "name: taught_tidy\nchildren: [[{name: going}]]\n"),
    "anna",
    1.0,
    "To tidy ...",
)
MUG = LearnedUnit("mug.kind", "mug", "cup", KIND, "", "anna", 2.0, "A mug is a cup.")


def with_more(path: str) -> str:
    file = LearnedFile(path)
    file.add(SEQUENCE)
    file.add(MUG)
    file.close()
    return path


def test_a_sequence_is_exported_with_its_frame_only(path: str, tmp_path: Path) -> None:
    out, frames = tmp_path / "learned.yaml", tmp_path / "frames"
    assert main(["export-learned", "--file", with_more(path), "--out", str(out)]) == 0
    assert len(load_lexical_units(out.read_text(encoding="utf-8"), str(out))) == 2
    assert main(["export-learned", "--file", path, "--out", str(out), "--frames", str(frames)]) == 0
    assert len(load_lexical_units(out.read_text(encoding="utf-8"), str(out))) == 3
    frame = load_frame((frames / "taught_tidy.yaml").read_text(encoding="utf-8"), "taught_tidy.yaml")
    assert frame.name == "taught_tidy" and len(frame.children) == 1


def test_what_another_robot_was_taught_is_imported_and_the_own_words_stay(
    path: str, tmp_path: Path, capsys: Any
) -> None:
    own = str(tmp_path / "own.sqlite")
    file = LearnedFile(own)
    file.add(replace(MUG, verb="glass"))
    file.close()
    assert main(["import-learned", with_more(path), "--file", own]) == 0
    assert capsys.readouterr().out == "3 imported, 1 not: their words have a meaning already\n"
    units = {unit.name: unit for unit in LearnedFile(own).units()}
    assert units["mug.kind"].verb == "glass" and units["tidy.taught_tidy"] == SEQUENCE and len(units) == 4
    assert main(["list", "--learned", "--file", own]) == 0
    assert '"mug" is a kind of "glass"; taught by anna' in capsys.readouterr().out
    assert main(["import-learned", str(tmp_path / "none"), "--file", own]) == 2


def test_a_missing_file_and_wrong_usage_are_told(tmp_path: Path, capsys: Any) -> None:
    missing = str(tmp_path / "none.sqlite")
    assert main(["list", "--learned", "--file", missing]) == 0
    assert main(["export-learned", "--file", missing]) == 2
    assert main(["forget"]) == 2 == main(["forget", "--world", "--learned", NAME])
    assert not Path(missing).exists()
    assert "nothing is learned" in capsys.readouterr().out
