"""A registrar that has just started waits for servers that register again."""

import threading
import time
from typing import List, Sequence, Union

from frame_registrar.beginning import Beginning
from frame_registrar.search import Refusal

MISSING = Refusal("NO_SERVER", "No server is registered.")


def found_while_they_register(names: Sequence[str], *, settle_s: float, pause_s: float) -> Union[str, Refusal]:
    """What a search for the last of some servers returns that register with a pause before each."""
    beginning = Beginning(settle_s)
    registered: List[str] = []

    def register() -> None:
        for name in names:
            time.sleep(pause_s)
            registered.append(name)
            beginning.hear_registration()

    servers = threading.Thread(target=register)
    servers.start()
    found = beginning.search(lambda: names[-1] if names[-1] in registered else MISSING)
    servers.join()
    return found


def test_a_server_that_registers_late_is_found() -> None:
    assert found_while_they_register(["turn", "ping"], settle_s=30.0, pause_s=0.05) == "ping"


def test_each_registration_gives_the_next_one_as_long() -> None:
    # 1.2 s after the start.
    assert found_while_they_register(["turn", "move", "ping"], settle_s=1.0, pause_s=0.4) == "ping"


def test_registrations_without_end_do_not_hold_an_answer_back() -> None:
    beginning = Beginning(settle_s=0.1)
    is_over = threading.Event()

    def register() -> None:
        while not is_over.wait(0.02):
            beginning.hear_registration()

    server = threading.Thread(target=register)
    server.start()
    assert beginning.search(lambda: MISSING) == MISSING
    is_over.set()
    server.join()


def test_a_registration_during_the_search_counts() -> None:
    beginning = Beginning(settle_s=30.0)
    outcomes: List[Union[str, Refusal]] = [MISSING, "ping"]

    def find() -> Union[str, Refusal]:
        beginning.hear_registration()
        return outcomes.pop(0)

    assert beginning.search(find) == "ping"


def test_another_refusal_is_told_at_once() -> None:
    missing_element = Refusal("MISSING_ELEMENT", "Which mug?")
    assert Beginning(settle_s=1000.0).search(lambda: missing_element) == missing_element


def test_when_it_is_over_a_missing_server_is_told_at_once() -> None:
    searches: List[None] = []

    def find() -> Refusal:
        searches.append(None)
        return MISSING

    assert Beginning(settle_s=0.0).search(find) == MISSING
    assert len(searches) == 1
    assert Beginning(settle_s=0.05).search(find) == MISSING
