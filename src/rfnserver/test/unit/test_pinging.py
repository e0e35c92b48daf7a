"""The answer to a ping."""

from rfnserver.pinging import ping_sentence


def test_ping_lists_each_living_server_once() -> None:
    assert ping_sentence([("a", "x", True), ("b", "x", True), ("c", "y", True)]) == "I am alive, with 2 servers: x, y."


def test_ping_names_the_dead() -> None:
    assert ping_sentence([("a", "x", False)]) == "I am alive, with 0 servers: none. Not running: x."
