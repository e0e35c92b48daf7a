"""``rfn passes --gold``: what tree passes change in a treebank."""

from pathlib import Path
from typing import Dict

import pytest

from roboframenet_tools.cli import main

TREEBANK = """# text = Go to the kitchen at noon
1\tGo\tgo\tVERB\tVB\tMood=Imp|VerbForm=Fin\t0\troot\t_\t_
2\tto\tto\tADP\tIN\t_\t4\tcase\t_\t_
3\tthe\tthe\tDET\tDT\t_\t4\tdet\t_\t_
4\tkitchen\tkitchen\tNOUN\tNN\tNumber=Sing\t1\tobl\t_\t_
5\tat\tat\tADP\tIN\t_\t6\tcase\t_\t_
6\tnoon\tnoon\tNOUN\tNN\tNumber=Sing\t1\tobl\t_\t_

# text = Birds sing
1\tBirds\tbird\tNOUN\tNNS\tNumber=Plur\t2\tnsubj\t_\t_
2\tsing\tsing\tVERB\tVBP\tMood=Ind|VerbForm=Fin\t0\troot\t_\t_
"""


def changes(said: str) -> Dict[str, int]:
    """The number of trees that each pass changes, by its name."""
    rows = [line.split() for line in said.splitlines() if line][2:]
    return {name: int(count) for name, count, *_ in rows}


def test_the_trees_of_a_treebank_that_each_pass_changes(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "two.conllu"
    path.write_text(TREEBANK, encoding="utf-8")
    assert main(["passes", "--gold", str(path)]) == 0
    said = capsys.readouterr().out
    assert said.startswith("2 trees\n")
    # A time is marked in a right tree, too; nothing else is found in these.
    assert {name for name, count in changes(said).items() if count} == {"times"}
    assert changes(said)["times"] == 1


@pytest.mark.parametrize("text", [None, "1\tGo\tgo\n"])
def test_a_treebank_that_cannot_be_read_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str], text: str) -> None:
    path = tmp_path / "none.conllu"
    if text is not None:
        path.write_text(text, encoding="utf-8")
    assert main(["passes", "--gold", str(path)]) == 2
    assert "rfn passes: " in capsys.readouterr().err
