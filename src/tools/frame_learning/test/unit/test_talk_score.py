"""``rfn score talk``: sentences of a treebank that command nothing."""

import json
from pathlib import Path
from typing import Any

import pytest

from frame_learning.annotated_commands import CorpusError
from frame_learning.talk_score import ASKED, DONE, LEARNED, REFUSED, read_talk
from roboframenet_tools.cli import main

TREEBANK = """# text = The door is nice.
1 The the DET DT _ 2 det _ _
2 door door NOUN NN _ 4 nsubj _ _
3 is be AUX VBZ _ 4 cop _ _
4 nice nice ADJ JJ _ 0 root _ SpaceAfter=No
5 . . PUNCT . _ 4 punct _ _

# text = Acquire the ball.
1 Acquire acquire NOUN NN _ 0 root _ _
2 the the DET DT _ 3 det _ _
3 ball ball NOUN NN _ 1 compound _ SpaceAfter=No
4 . . PUNCT . _ 1 punct _ _

# text = Yes.
1 Yes yes INTJ UH _ 0 root _ SpaceAfter=No
2 . . PUNCT . _ 1 punct _ _

# text = Go home!
1 Go go VERB VB Mood=Imp|VerbForm=Fin 0 root _ _
2 home home ADV RB _ 1 advmod _ SpaceAfter=No
3 ! ! PUNCT . _ 1 punct _ _

# text = Turn left!
1 Turn turn VERB _ _ 0 root _ _
2 left left ADV _ _ 1 advmod _ SpaceAfter=No
3 ! ! PUNCT _ _ 1 punct _ _

# text = Could you turn?
1 Could could AUX MD _ 3 aux _ _
2 you you PRON PRP _ 3 nsubj _ _
3 turn turn VERB VB _ 0 root _ SpaceAfter=No
4 ? ? PUNCT . _ 3 punct _ _
"""
NOTHING = ["The door is nice.", "Acquire the ball.", "Yes."]


def treebank(folder: Path) -> str:
    (folder / "a").mkdir()
    text = "\n".join("\t".join(line.split()) if line[:1].isdigit() else line for line in TREEBANK.splitlines())
    (folder / "a" / "x-test.conllu").write_text(text + "\n", encoding="utf-8")
    (folder / "a" / "x-train.conllu").write_text("no treebank\n", encoding="utf-8")
    return str(folder)


def test_commands_and_requests_are_left_out_and_the_test_part_is_read(tmp_path: Path) -> None:
    assert read_talk(treebank(tmp_path), 10) == NOTHING
    assert read_talk(str(tmp_path), 1) == NOTHING[:1]


def test_what_becomes_of_them_is_counted_and_an_answer_among_them_teaches(
    tmp_path: Path, monkeypatch: Any, capsys: Any
) -> None:
    monkeypatch.setattr("nearest_meaning.likeness.made_folder", lambda: tmp_path / "none")
    assert main(["score", "talk", treebank(tmp_path), "--json"]) == 0
    counts = json.loads(capsys.readouterr().out)
    assert counts["sentences"] == 3
    assert (counts[LEARNED], counts[ASKED], counts[REFUSED] + counts[DONE]) == (1, 1, 1)
    assert main(["score", "talk", str(tmp_path), "--failures"]) == 0
    assert "\tAcquire the ball.\t" in capsys.readouterr().out


def test_a_folder_without_a_treebank_and_a_broken_one_are_named(tmp_path: Path, capsys: Any) -> None:
    with pytest.raises(CorpusError, match="no treebank"):
        read_talk(str(tmp_path), 1)
    (tmp_path / "b.conllu").write_text("1\tx\n", encoding="utf-8")
    assert main(["score", "talk", str(tmp_path)]) == 2
    assert "b.conllu" in capsys.readouterr().err
