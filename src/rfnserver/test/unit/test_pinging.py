"""The answer to a ping."""

from rfnserver.pinging import living_and_dead, ping_sentence


def test_each_server_counts_once() -> None:
    callbacks = [("a", "x", True), ("b", "x", True), ("c", "y", True), ("c", "z", False)]
    assert living_and_dead(callbacks) == (["x", "y"], ["z"])


def test_ping_counts_the_programs() -> None:
    assert ping_sentence(["x", "y"], []) == "I am alive, and all 2 of my programs run."
    assert ping_sentence(["x"], []) == "I am alive, and my only program runs."
    assert ping_sentence(["x"], ["y"]) == "I am alive, but 1 of my 2 programs does not run."
    assert ping_sentence([], ["x", "y"]) == "I am alive, but 2 of my 2 programs do not run."
