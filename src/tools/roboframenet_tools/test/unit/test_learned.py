"""``rfn list --learned``, ``rfn forget --learned`` and ``rfn export-learned``: they work on the file."""

from pathlib import Path
from typing import Any

import pytest

from nearest_meaning.learned import LearnedUnit
from nearest_meaning.learned_file import LearnedFile
from roboframenet_tools.cli import main
from semantic_frames import load_lexical_units

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


def test_a_missing_file_and_wrong_usage_are_told(tmp_path: Path, capsys: Any) -> None:
    missing = str(tmp_path / "none.sqlite")
    assert main(["list", "--learned", "--file", missing]) == 0
    assert main(["export-learned", "--file", missing]) == 2
    assert main(["forget"]) == 2 == main(["forget", "--world", "--learned", NAME])
    assert not Path(missing).exists()
    assert "nothing is learned" in capsys.readouterr().out
