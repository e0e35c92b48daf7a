"""When an action server counts as connected."""

from types import SimpleNamespace
from typing import Any

import pytest

from roboframenet_ros import ros_server_links
from roboframenet_ros.ros_action_connection import ActionConnection
from roboframenet_ros.ros_server_links import ServerLinks
from roboframenet_testing import comes_true, wait_until

URI = "http://127.0.0.1:45949/"
LINKS = {(f"/pinging/{topic}", "/unnamed") for topic in ("status", "result", "feedback")}


def connected(*, status_socket: object, hears_result: bool = True) -> ActionConnection:
    """A connection whose server is connected in all other ways, as far as this side can see."""
    link = SimpleNamespace(callerid_pub="/ping", socket=object(), endpoint_id=URI)
    status = SimpleNamespace(callerid_pub="/ping", socket=status_socket, endpoint_id=URI)

    def subscriber(topic: str, *links: object) -> Any:
        return SimpleNamespace(resolved_name=f"/pinging/{topic}", impl=SimpleNamespace(connections=list(links)))

    publisher = SimpleNamespace(impl=SimpleNamespace(has_connection=lambda node: node == "/ping"))
    connection: Any = ActionConnection.__new__(ActionConnection)
    connection.server = "pinging"
    connection._status = subscriber("status", status)
    connection._client = SimpleNamespace(
        last_status_msg=SimpleNamespace(_connection_header={"callerid": "/ping"}),
        result_sub=subscriber("result", *[link] * hears_result),
        feedback_sub=subscriber("feedback", link),
    )
    connection._links = ServerLinks(
        publishers=(publisher,), subscribers=(connection._client.result_sub, connection._client.feedback_sub)
    )
    return connection  # type: ignore[no-any-return]


def test_server_is_ready_when_it_has_said_so(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its result would be lost before."""
    links = {link for link in LINKS if "result" not in link[0]}
    monkeypatch.setattr(ros_server_links, "listeners_of", lambda uri, timeout_s: links)
    connection = connected(status_socket=object())
    assert not comes_true(connection.is_ready, 0.3)
    links |= LINKS
    wait_until(connection.is_ready)
    assert connection.node_uri() == URI


def test_server_that_says_nothing_is_believed(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(uri: str, timeout_s: float) -> None:
        raise ConnectionResetError(uri)

    monkeypatch.setattr(ros_server_links, "listeners_of", refuse)
    wait_until(connected(status_socket=object()).is_ready)


@pytest.mark.parametrize("gone", [{"status_socket": None}, {"status_socket": object(), "hears_result": False}])
def test_server_that_is_dying_is_not_ready(gone: dict, monkeypatch: pytest.MonkeyPatch) -> None:
    """A goal that is sent then would be expected of the process that takes its place."""
    monkeypatch.setattr(ros_server_links, "listeners_of", lambda uri, timeout_s: LINKS)
    assert not comes_true(connected(**gone).is_ready, 0.3)
