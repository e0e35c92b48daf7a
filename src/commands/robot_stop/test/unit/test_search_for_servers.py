"""The search for the servers that a stop cancels: nothing of the graph is read twice, and nothing new is missed."""

from typing import Any, Dict, FrozenSet, List, Set, Tuple
from unittest import mock

import pytest

from roboframenet_ros.ros_master import TimedMaster
from robot_stop import ros_servers
from robot_stop.ros_servers import Servers
from robot_stop.servers import FRAME_GOAL_TYPE

NODE = "/node"


class Master:
    """A master whose graph a test sets; it counts the questions."""

    def __init__(self) -> None:
        self.types: Dict[str, str] = {}
        self.asked: List[str] = []
        self._last: Tuple[object, Any] = (None, None)

    def add(self, server: str, goal_type: str = FRAME_GOAL_TYPE) -> None:
        self.types[f"{server}/goal"] = goal_type

    def drop(self, server: str) -> None:
        del self.types[f"{server}/goal"]

    def getTopicTypes(self, _: str) -> Any:  # noqa: N802 (the name is the master's)
        self.asked.append("types")
        return 1, "", list(self.types.items())

    def getSystemState(self, _: str) -> Any:  # noqa: N802 (the name is the master's)
        self.asked.append("state")
        subscribers = [[topic.replace("/goal", "/cancel"), [NODE]] for topic in self.types]
        if self._last[0] != subscribers:
            self._last = (subscribers, ([], subscribers, []))
        # What has not changed is the same object: see RememberingTransport.
        return 1, "", self._last[1]


@pytest.fixture
def master(monkeypatch: pytest.MonkeyPatch) -> Master:
    made = Master()
    monkeypatch.setattr("xmlrpc.client.ServerProxy", lambda *_, **__: made)
    monkeypatch.setattr(ros_servers, "_Connection", lambda _: mock.Mock())
    return made


def names(servers: Servers) -> Set[str]:
    servers._refresh()
    return {server.name for server in servers._connections}


def made() -> Servers:
    return Servers(also_cancel=(), refresh_period_s=1.0, master_timeout_s=1.0)


def test_graph_that_stays_is_asked_for_only_once(master: Master) -> None:
    servers = made()
    master.add("/turning")
    assert names(servers) == {"/turning"}
    connections = servers._connections
    del master.asked[:]
    for _ in range(3):
        assert names(servers) == {"/turning"}
    assert master.asked == 3 * ["state"]
    assert servers._connections is connections


def test_server_that_comes_or_goes_is_noticed(master: Master) -> None:
    servers = made()
    assert names(servers) == set()
    master.add("/turning")
    assert names(servers) == {"/turning"}
    master.add("/waving")
    assert names(servers) == {"/turning", "/waving"}
    master.drop("/turning")
    assert names(servers) == {"/waving"}


def test_registration_counts_also_when_the_graph_stays(master: Master) -> None:
    servers = made()
    master.add("/driving", "move_base_msgs/MoveBaseActionGoal")
    assert names(servers) == set()
    registered: FrozenSet[str] = frozenset({"/driving"})
    servers.set_registered(registered)
    assert names(servers) == {"/driving"}
    servers.set_registered(frozenset())
    assert names(servers) == set()


def test_connection_that_fails_is_tried_again(master: Master, monkeypatch: pytest.MonkeyPatch) -> None:
    servers = made()
    master.add("/turning")
    monkeypatch.setattr(ros_servers, "_Connection", mock.Mock(side_effect=OSError))
    with pytest.raises(OSError):
        names(servers)
    monkeypatch.setattr(ros_servers, "_Connection", lambda _: mock.Mock())
    assert names(servers) == {"/turning"}


def test_types_are_asked_for_again_when_that_failed(master: Master) -> None:
    graph = TimedMaster(timeout_s=1.0)
    master.add("/turning")
    with mock.patch.object(Master, "getTopicTypes", return_value=(0, "busy", [])), pytest.raises(
        Exception, match="busy"
    ):
        graph.graph()
    assert graph.graph()[1] == {"/turning/goal": FRAME_GOAL_TYPE}
