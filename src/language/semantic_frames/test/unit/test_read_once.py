"""Files that come again are not read again."""

from typing import List, Tuple

from checked_files import FileRefused, Problem
from semantic_frames.read_once import ReadOnce


def test_thousand_files_added_one_by_one_are_read_once_each() -> None:
    read: List[str] = []

    def load(text: str, path: str) -> str:
        read.append(path)
        if text == "wrong":
            raise FileRefused([Problem("WRONG", path, 1, "key", "this", "that")])
        return text.upper()

    files = ReadOnce(load)
    message: List[Tuple[str, str]] = []
    for number in range(1000):
        message.append((f"{number}.yaml", "wrong" if number % 100 == 0 else f"unit {number}"))
        contents, refused = files.contents(message)
        assert len(refused) == (number % 100 == 0)
        assert len(contents) == sum(text != "wrong" for _, text in message)
    assert read == [path for path, _ in message]


def test_changed_file_is_read_again_and_a_missing_one_is_forgotten() -> None:
    read: List[Tuple[str, str]] = []

    def load(text: str, path: str) -> str:
        read.append((path, text))
        return text

    files = ReadOnce(load)
    assert files.contents([("a", "1"), ("b", "2")]) == (["1", "2"], [])
    assert files.contents([("b", "2"), ("a", "3")]) == (["2", "3"], [])
    assert files.contents([]) == ([], [])
    assert files.contents([("b", "2")]) == (["2"], [])
    assert read == [("a", "1"), ("b", "2"), ("a", "3"), ("b", "2")]
