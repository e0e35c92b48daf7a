"""Connections that are kept for the next goal, and made beforehand."""

import threading
import time
from typing import Callable, ClassVar, Dict, FrozenSet, List

import pytest

pytest.importorskip("actionlib")

from executor import ros_action_clients
from executor.absences import Absences
from executor.ros_absent_servers import AbsentServers
from executor.ros_action_clients import ActionClients
from roboframenet_testing import Clock


class Connection:
    """A connection whose server lives as long as ``alive`` says; it is made when ``master`` answers."""

    alive: ClassVar[Dict[str, bool]] = {}
    closed: ClassVar[List[str]] = []
    master = threading.Event()

    def __init__(self, server: str, _action_type: object) -> None:
        self.master.wait(60.0)
        self.server = server

    def is_ready(self) -> bool:
        return self.alive[self.server]

    def close(self) -> None:
        self.closed.append(self.server)


@pytest.fixture()
def make_clients(monkeypatch: pytest.MonkeyPatch) -> Callable[[int], ActionClients]:
    Connection.closed = []
    Connection.master.set()
    monkeypatch.setattr(ros_action_clients, "ActionConnection", Connection)

    def make(max_kept: int) -> ActionClients:
        clients = ActionClients(max_kept=max_kept)
        monkeypatch.setattr(clients, "_close_later", clients._close_all)
        return clients

    return make


def until(is_true: Callable[[], bool]) -> bool:
    end_s = time.monotonic() + 30.0
    while not is_true() and time.monotonic() < end_s:
        time.sleep(0.01)
    return is_true()


def connected(clients: ActionClients) -> FrozenSet[str]:
    return frozenset(clients._connections)


def test_servers_that_are_gone_are_let_go_unless_a_goal_uses_them(make_clients: Callable[[int], ActionClients]) -> None:
    everybody = frozenset(("here", "gone", "used"))
    Connection.alive = dict.fromkeys(everybody, True)
    clients = make_clients(9)
    for name in Connection.alive:
        assert clients.get(name, timeout_s=60.0) is not None
    for name in ("here", "gone"):
        clients.release(name)
    clients.hear_living(everybody)
    assert Connection.closed == []
    Connection.alive = {"here": True, "gone": False, "used": False}
    clients.hear_living(frozenset(("here",)))
    assert Connection.closed == ["gone"]
    clients.release("used")
    clients.hear_living(frozenset(("here",)))
    assert Connection.closed == ["gone", "used"]


def test_connection_to_a_server_that_may_be_starting_is_kept_for_the_next_command(
    make_clients: Callable[[int], ActionClients], monkeypatch: pytest.MonkeyPatch
) -> None:
    clock = Clock()
    Connection.alive = {"killed": False}
    clients = make_clients(9)
    monkeypatch.setattr(clients, "absent", AbsentServers(Absences(now=clock)))
    clients.absent.hear_vain("killed")
    kept = clients.get("killed", timeout_s=60.0)
    for _ in range(9):
        clients.release("killed")
        clock.now_s += 0.5
        assert clients.get("killed", timeout_s=60.0) is kept
    assert Connection.closed == []
    clock.now_s += 0.5
    clients.release("killed")
    assert Connection.closed == ["killed"]


def test_as_many_servers_that_live_are_connected_beforehand_as_are_kept(
    make_clients: Callable[[int], ActionClients],
) -> None:
    Connection.alive = dict.fromkeys(("one", "two", "three"), True)
    clients = make_clients(2)
    clients.hear_living(frozenset(Connection.alive))
    assert until(lambda: not clients._is_preparing)
    assert len(connected(clients)) == 2
    clients.hear_living(frozenset(Connection.alive))
    assert until(lambda: not clients._is_preparing)
    assert len(connected(clients)) == 2
    assert Connection.closed == []


def test_connection_that_the_master_delays_is_kept_and_made_once(make_clients: Callable[[int], ActionClients]) -> None:
    Connection.alive = {"late": True}
    clients = make_clients(1)
    Connection.master.clear()
    assert [clients.get("late", timeout_s=0.05) for _ in range(3)] == [None] * 3
    Connection.master.set()
    assert until(lambda: connected(clients) == {"late"} and len(Connection.closed) == 2)
    kept = clients.get("late", timeout_s=60.0)
    assert kept is clients.get("late", timeout_s=60.0)
    # Three goals gave up, and two use it: no count is left of the former.
    assert clients._users == {"late": 2}
