"""Connections that are kept for the next goal."""

from typing import ClassVar, Dict, List

import pytest

pytest.importorskip("actionlib")

from executor import ros_action_clients
from executor.ros_action_clients import ActionClients


class Connection:
    """A connection whose server lives as long as ``alive`` says."""

    alive: ClassVar[Dict[str, bool]] = {}
    closed: ClassVar[List[str]] = []

    def __init__(self, server: str, _action_type: object) -> None:
        self.server = server

    def is_ready(self) -> bool:
        return self.alive[self.server]

    def close(self) -> None:
        self.closed.append(self.server)


def test_servers_that_are_gone_are_let_go_unless_a_goal_uses_them(monkeypatch: pytest.MonkeyPatch) -> None:
    Connection.alive, Connection.closed = dict.fromkeys(("here", "gone", "used"), True), []
    monkeypatch.setattr(ros_action_clients, "ActionConnection", Connection)
    clients = ActionClients(max_kept=9)
    monkeypatch.setattr(clients, "_close_later", clients._close_all)
    for name in Connection.alive:
        assert clients.get(name, timeout_s=60.0) is not None
    for name in ("here", "gone"):
        clients.release(name)
    clients.close_gone()
    assert Connection.closed == []
    Connection.alive = {"here": True, "gone": False, "used": False}
    clients.close_gone()
    assert Connection.closed == ["gone"]
    clients.release("used")
    clients.close_gone()
    assert Connection.closed == ["gone", "used"]
