"""When an action server counts as connected."""

from types import SimpleNamespace

import pytest

from roboframenet_ros.ros_action_connection import ActionConnection


def connected(*, status_socket: object, hears_result: bool = True) -> ActionConnection:
    """A connection whose server is connected in all other ways."""
    link = SimpleNamespace(callerid_pub="/ping", socket=status_socket, endpoint_id="http://127.0.0.1:45949/")
    publisher = SimpleNamespace(impl=SimpleNamespace(has_connection=lambda node: node == "/ping"))
    subscriber = SimpleNamespace(impl=SimpleNamespace(connections=[link]))
    deaf = SimpleNamespace(impl=SimpleNamespace(connections=[]))
    connection = ActionConnection.__new__(ActionConnection)
    connection._status = subscriber  # type: ignore[assignment]
    connection._client = SimpleNamespace(  # type: ignore[assignment]
        last_status_msg=SimpleNamespace(_connection_header={"callerid": "/ping"}),
        pub_goal=publisher,
        pub_cancel=publisher,
        result_sub=subscriber if hears_result else deaf,
        feedback_sub=subscriber,
    )
    return connection


def test_server_is_ready_when_all_is_connected() -> None:
    connection = connected(status_socket=object())
    assert connection.is_ready()
    assert connection.node_uri() == "http://127.0.0.1:45949/"


@pytest.mark.parametrize("gone", [{"status_socket": None}, {"status_socket": object(), "hears_result": False}])
def test_server_that_is_dying_is_not_ready(gone: dict) -> None:
    """A goal that is sent then would be expected of the process that takes its place."""
    assert not connected(**gone).is_ready()
