"""The reliability campaign counts right: trials are repeatable, a cut one goes on, and what fails is in the table."""

import random
import sys
import time
from pathlib import Path
from typing import Any, Dict, List, Sequence, Tuple

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from campaign import __main__ as program
from campaign.demand import Demand, Figure, Trial, at_most, chance_of, none_of, quantile
from campaign.demands import DEMANDS
from campaign.reply_counts import count_replies
from campaign.suite import mutant
from campaign.table import TrialFile, figures_of, markdown
from campaign.words import malformed, odd_text

SOURCE = """
LIMIT = 3


def is_long(words: "List[str]" = ()) -> bool:
    if len(words) > 3:
        return True
    return False
"""


class Draws(Demand):
    """Draws a number; the trial with the number 2 breaks."""

    name, title, counts = "R0", "draws", (4, 8, 16)

    def trial(self, number: int, chance: random.Random) -> Dict[str, Any]:
        if number == 2:
            raise ValueError("as asked for")
        return {"drawn": chance.randrange(1000), "s": number / 10.0}

    def figures(self, trials: Sequence[Trial]) -> List[Figure]:
        return [at_most("time", trials, "s", 0.2), none_of("lost", trials, "lost")]


def test_every_demand_has_a_name_a_title_and_more_trials_in_longer_forms() -> None:
    assert {name.split("-")[0] for name in DEMANDS} == {f"R{number}" for number in range(1, 19)}
    for name, demand in DEMANDS.items():
        assert demand.name == name and demand.title
        assert 0 < demand.count("short") <= demand.count("standard") <= demand.count("full")


def test_a_campaign_that_was_cut_goes_on_with_the_same_trials(tmp_path: Path) -> None:
    program.make_trials(Draws(), "short", 7, tmp_path / "whole")
    whole = (tmp_path / "whole" / "R0.jsonl").read_text()
    cut = tmp_path / "cut" / "R0.jsonl"
    cut.parent.mkdir()
    # The second line was being written when the process was killed.
    cut.write_text(whole.splitlines(keepends=True)[0] + '{"number": 1, "dra')
    program.make_trials(Draws(), "short", 7, tmp_path / "cut")
    drawn = [
        [trial.get("drawn") for trial in TrialFile(tmp_path / name / "R0.jsonl").trials] for name in ("whole", "cut")
    ]
    assert drawn[0] == drawn[1]
    assert len(drawn[0]) == 4
    assert chance_of(7, "R0", 1).random() != chance_of(8, "R0", 1).random()


def test_what_fails_breaks_or_is_missing_is_in_the_table(tmp_path: Path) -> None:
    program.make_trials(Draws(), "short", 7, tmp_path)
    figures = figures_of(Draws(), TrialFile(tmp_path / "R0.jsonl").trials, wanted_count=5)
    assert [(figure.name, figure.holds) for figure in figures] == [
        ("time", False),
        ("lost", True),
        ("trials", False),
        ("trials that broke", False),
    ]
    assert "as asked for" in figures[-1].found
    table = markdown({"R0": figures}, {"R0": "draws"}, {"Form": "short"})
    assert table.count("**no**") == 3
    assert "| R0 | draws | time |" in table


def test_quantiles_are_numbers_that_were_measured() -> None:
    assert quantile([3.0, 1.0, 2.0], 0.5) == 2.0
    assert quantile([3.0, 1.0, 2.0], 0.99) == 3.0


def test_a_mutant_differs_in_one_token_of_the_logic() -> None:
    changes = set()
    for seed in range(40):
        line, old, new, text = mutant(SOURCE, random.Random(seed))
        assert line in (6, 7, 8)
        assert old != new
        assert sum(one != other for one, other in zip(SOURCE.splitlines(), text.splitlines())) == 1
        compile(text, "mutant", "exec")
        changes.add((old, new))
    assert changes == {(">", ">="), ("3", "4"), ("True", "False"), ("False", "True")}


def test_odd_words_and_files_are_the_same_for_the_same_seed() -> None:
    examples = ("Turn left.", "Go to the kitchen.")
    texts = [[odd_text(examples, random.Random(seed)) for seed in range(200)] for _ in range(2)]
    assert texts[0] == texts[1]
    assert len(set(texts[0])) > 100
    assert all(len(text) <= 1500 for text in texts[0])
    files = {malformed(SOURCE, random.Random(seed)) for seed in range(50)}
    assert len(files) > 20


def test_tests_begin_behind_what_is_measured_without_them(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    ended: List[str] = []

    def run(command: Sequence[str], **_: object) -> None:
        # What was begun too early would end first.
        time.sleep(0.2 if command[-1] == "R4" else 0.0)
        ended.append(command[-1])

    monkeypatch.setattr(program.subprocess, "run", run)
    for names in (("R1", "R4", "R14"), ("R14",), ("R1", "R14")):
        ended.clear()
        program.run([DEMANDS[name] for name in names], "short", 7, tmp_path, tmp_path)
        assert sorted(ended) == sorted(names)
        assert "R4" not in names or ended[0] == "R4"


@pytest.mark.parametrize(
    ("replies", "counts"),
    [
        ([("Ping.", "1"), ("Ping.", "2"), ("Halt.", "3")], (0, 0)),
        ([("Ping.", "1"), ("Halt.", "3")], (1, 0)),
        ([("Ping.", "1"), ("Ping.", "1"), ("Halt.", "3")], (1, 1)),
        ([("Ping.", "1"), ("Ping.", "2"), ("Halt.", "3"), ("Halt.", "4")], (0, 1)),
        ([("Ping.", "1"), ("Ping.", "2"), ("Ping.", "2"), ("Halt.", "3")], (0, 1)),
        ([("Go.", "5")], (3, 1)),
    ],
)
def test_replies_are_counted_by_text_and_id(replies: List[Tuple[str, str]], counts: Tuple[int, int]) -> None:
    assert count_replies({"Ping.": 2, "Halt.": 1}, replies) == counts
