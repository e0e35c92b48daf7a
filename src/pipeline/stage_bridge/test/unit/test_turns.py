"""One command at a time is outside."""

from typing import List

from stage_bridge.turns import Turns


def sent(turns: "Turns[str]", *times_s: float) -> List[str]:
    return [command for command in (turns.next(now_s) for now_s in times_s) if command is not None]


def test_the_next_one_waits_for_the_answer() -> None:
    turns: Turns[str] = Turns(answer_timeout_s=5.0, most_waiting=2)
    assert turns.come("one") and turns.come("two") and not turns.come("three")
    assert sent(turns, 0.0, 0.0) == ["one"]
    assert (turns.answered(), sent(turns, 1.0), turns.answered()) == ("one", ["two"], "two")


def test_an_answer_that_nobody_asked_for_belongs_to_nobody() -> None:
    turns: Turns[str] = Turns(answer_timeout_s=5.0, most_waiting=2)
    assert turns.answered() is None
    turns.come("one")
    assert turns.answered() is None


def test_silence_ends_a_turn() -> None:
    turns: Turns[str] = Turns(answer_timeout_s=5.0, most_waiting=2)
    turns.come("one")
    turns.come("two")
    assert turns.rest_s(0.0) is None
    assert sent(turns, 0.0) == ["one"]
    assert (turns.rest_s(1.0), turns.silent(4.9), turns.silent(5.0)) == (4.0, [], ["one"])
    # What comes late belongs to nobody, until the next one is sent.
    assert turns.answered() is None
    assert sent(turns, 5.0) == ["two"]
