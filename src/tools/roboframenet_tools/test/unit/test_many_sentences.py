"""Sentences for ``rfn sentences``: read from files and folders, and mixed."""

from pathlib import Path

from roboframenet_tools.sentences import mixed, read_sentences


def test_the_last_column_of_each_line_is_a_sentence(tmp_path: Path) -> None:
    (tmp_path / "b.tsv").write_text("source\tGo left.\n\nsource\tGo right.\n", encoding="utf-8")
    (tmp_path / "a.txt").write_text("Wait.\n", encoding="utf-8")
    (tmp_path / "README.md").write_text("Nothing.\n", encoding="utf-8")
    assert list(read_sentences(tmp_path)) == ["Wait.", "Go left.", "Go right."]
    assert list(read_sentences(tmp_path / "a.txt")) == ["Wait."]


def test_the_same_seed_mixes_the_same_sentences() -> None:
    said = ["Go to the kitchen.", "Wait.", "Turn left and wave."]
    made = mixed(said, 30, 7)
    assert made == mixed(said, 30, 7)
    assert made != mixed(said, 30, 8)
    words = {word.strip(" .,") for text in said for word in text.split()} | {"and", "then"}
    assert len(made) == 30
    assert all({word.strip(" .,") for word in text.split()} <= words and text for text in made)
