"""XML-RPC with a deadline, and with a memory."""

import threading
import xmlrpc.client
from contextlib import contextmanager
from typing import Any, Callable, Iterator
from xmlrpc.server import SimpleXMLRPCServer

import pytest

from roboframenet_ros.timed_transport import RememberingTransport, TimedTransport


@contextmanager
def serving(answer: Callable[[], Any]) -> Iterator[str]:
    """A server with one function; returns its address."""
    with SimpleXMLRPCServer(("127.0.0.1", 0), logRequests=False) as server:
        server.register_function(answer, "answer")
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_address[1]}/"
        server.shutdown()


def test_the_same_answer_is_parsed_once() -> None:
    # Long enough to be compressed for whoever accepts it.
    state = [["/topic", ["/node"] * 500]]
    with serving(lambda: [1, "", state]) as uri:
        proxy = xmlrpc.client.ServerProxy(uri, transport=RememberingTransport(60.0))
        first, second = proxy.answer(), proxy.answer()
        assert first is second
        assert first == [1, "", state]
        state.append(["/other", ["/node"]])
        assert proxy.answer() == [1, "", state]


def test_only_the_last_answers_are_kept() -> None:
    numbers = iter(range(100))
    with serving(lambda: [next(numbers)]) as uri:
        transport = RememberingTransport(60.0)
        proxy = xmlrpc.client.ServerProxy(uri, transport=transport)
        assert [proxy.answer() for _ in range(20)] == [[number] for number in range(20)]
        assert len(transport._answers) < 10


def test_errors_are_raised_each_time() -> None:
    def fail() -> None:
        raise ValueError("no")

    with serving(fail) as uri:
        proxy = xmlrpc.client.ServerProxy(uri, transport=RememberingTransport(60.0))
        for _ in range(2):
            with pytest.raises(xmlrpc.client.Fault, match="no"):
                proxy.answer()


@pytest.mark.parametrize("kind", [TimedTransport, RememberingTransport])
def test_a_host_that_does_not_answer_is_given_up(kind: Any) -> None:
    is_over = threading.Event()
    with serving(lambda: is_over.wait(60.0)) as uri:
        proxy = xmlrpc.client.ServerProxy(uri, transport=kind(0.1))
        with pytest.raises(OSError):
            proxy.answer()
        is_over.set()
