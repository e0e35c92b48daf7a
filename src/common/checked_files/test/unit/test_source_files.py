"""Finding and reading files."""

import os
import threading

import pytest

from checked_files import FileRefused, Problem, source_files
from checked_files.marked_yaml import Reader
from checked_files.source_files import FRAMES_FOLDER, read_text, replace_problems, yaml_files


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


@pytest.mark.parametrize("path", ["/dev/zero", "/dev/full", "/", "a\x00b.yaml", "a\nb.yaml", "\ud800.yaml"])
def test_path_from_the_wire_that_is_no_file_is_refused_unread(path: str) -> None:
    with pytest.raises(FileRefused, match="UNREADABLE"):
        read_text(path)


def test_pipe_without_writer_is_refused_and_nothing_waits(tmp_path) -> None:
    pipe = str(tmp_path / "pipe.yaml")
    os.mkfifo(pipe)
    refused = []

    def read() -> None:
        with pytest.raises(FileRefused, match=r"UNREADABLE.*regular file"):
            read_text(pipe)
        refused.append(pipe)

    reader = threading.Thread(target=read, daemon=True)
    reader.start()
    reader.join(60.0)
    assert refused == [pipe]


def test_file_that_is_too_large_is_refused_by_its_size(tmp_path, monkeypatch) -> None:
    large = tmp_path / "large.yaml"
    with large.open("wb") as file:
        file.truncate(1_000_000_000)
    monkeypatch.setattr(source_files.os, "open", lambda *_: pytest.fail("the file is opened"))
    with pytest.raises(FileRefused, match=r"TOO_LARGE.*1000000000 bytes"):
        read_text(str(large))


def test_file_that_grows_while_it_is_read_is_refused(tmp_path, monkeypatch) -> None:
    monkeypatch.setattr(source_files, "LARGEST_FILE_BYTES", 10)
    monkeypatch.setattr(source_files, "_check_kind", lambda *_: None)
    (tmp_path / "x.yaml").write_text("name: longer than ten bytes")
    with pytest.raises(FileRefused, match="TOO_LARGE"):
        read_text(str(tmp_path / "x.yaml"))


def test_problem_does_not_publish_the_content_of_a_file() -> None:
    secret = "root:x:0:0:root:/root:/bin/bash\n" * 100
    problem = Problem("WRONG_TYPE", "x.yaml", 1, "file", f"'{secret}'", "a mapping")
    assert len(problem.found) == 80
    assert problem.found.endswith("...")


def test_problem_is_one_line_that_moves_no_cursor() -> None:
    problem = Problem("UNKNOWN_KEY", "x.yaml", 1, "a\nb", "\x1b[2J\x07'ä'", "a key")
    assert str(problem) == r"x.yaml:1: UNKNOWN_KEY a\nb: found \x1b[2J\x07'ä', expected a key"


def test_file_with_ten_thousand_mistakes_tells_the_first_ones() -> None:
    text = "name: waving\n" + "".join(f"no_key_{number}: 1\n" for number in range(10_000))
    reader = Reader("x.yaml")
    with pytest.raises(FileRefused) as refused:
        reader.mapping(reader.compose(text, "a mapping"), "", ["name"])
    problems = refused.value.problems
    assert [problem.line for problem in problems[:20]] == list(range(2, 22))
    assert [problem.code for problem in problems[20:]] == ["MORE_PROBLEMS"]


def test_problems_of_the_files_that_were_refused_last_are_kept(monkeypatch) -> None:
    monkeypatch.setattr(source_files, "MOST_KEPT_PROBLEMS", 2)
    problems = ()
    for name in "abc":
        problems = replace_problems(problems, name, [Problem("A", name, 1, "k", "f", "e")])
    assert [problem.path for problem in problems] == ["b", "c"]
