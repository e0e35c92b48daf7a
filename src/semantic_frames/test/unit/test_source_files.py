"""Finding and reading files."""

import pytest

from semantic_frames import FileRefused, Problem
from semantic_frames.source_files import FRAMES_FOLDER, read_text, replace_problems, yaml_files


def test_yaml_files_of_folders_with_that_name_only(tmp_path) -> None:
    for name in (
        "moving/frames/b.yaml",
        "moving/frames/a.yaml",
        "moving/lexical_units/c.yaml",
        "moving/frames/readme.txt",
    ):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("")
    found = yaml_files([str(tmp_path), str(tmp_path / "single.yaml")], FRAMES_FOLDER)
    assert [path.rsplit("/", 1)[1] for path in found] == ["a.yaml", "b.yaml", "single.yaml"]


def test_missing_file_is_refused(tmp_path) -> None:
    with pytest.raises(FileRefused, match="UNREADABLE"):
        read_text(str(tmp_path / "no.yaml"))


def test_file_that_is_not_utf8_is_refused(tmp_path) -> None:
    (tmp_path / "x.yaml").write_bytes(b"name: \xff")
    with pytest.raises(FileRefused, match="NOT_UTF8"):
        read_text(str(tmp_path / "x.yaml"))


def test_mended_file_has_no_problems() -> None:
    old = Problem("A", "x.yaml", 1, "k", "f", "e")
    other = Problem("B", "y.yaml", 1, "k", "f", "e")
    assert replace_problems([old, other], "x.yaml", []) == (other,)
