"""Connections to this node that do not wait for each other."""

import functools
import socket
import threading
from typing import Any, Callable, Tuple

from rospy.impl import tcpros_base

#: Who connects says at once what for; one that is stopped in between is closed after this time, seconds.
_HEADER_TIMEOUT_S = 10.0

#: Takes a connection, and the address from which it comes.
_Handler = Callable[[Any, socket.socket, Tuple[Any, ...]], None]


def accept_in_threads() -> None:
    """Give each connection to this node a thread until it is agreed; call it before ``rospy.init_node``, or later.

    rospy reads what a subscriber or a client of a service wants in the one thread that accepts connections, without a
    limit of time. One process that is stopped, or lost its machine, between the two keeps everybody out who comes
    later: the node lives, and nobody hears it.
    """
    handler = tcpros_base.TCPROSServer._tcp_server_callback
    if not hasattr(handler, "__wrapped__"):
        tcpros_base.TCPROSServer._tcp_server_callback = _in_thread(handler)
    server = tcpros_base._tcpros_server
    if server is not None and server.tcp_ros_server is not None:
        server.tcp_ros_server.inbound_handler = server._tcp_server_callback


def _in_thread(handler: _Handler) -> _Handler:
    """Return a handler that leaves a connection to a thread of its own as soon as it is accepted."""

    def handle(server: Any, connection: socket.socket, address: Tuple[Any, ...]) -> None:
        if _begins(connection):
            handler(server, connection, address)
        else:
            connection.close()

    @functools.wraps(handler)
    def begin(server: Any, connection: socket.socket, address: Tuple[Any, ...]) -> None:
        # A daemon: it holds nothing but the connection.
        thread = threading.Thread(target=handle, args=(server, connection, address), name="connection", daemon=True)
        thread.start()

    return begin


def _begins(connection: socket.socket) -> bool:
    """Return whether a connection says something, or ends, in time; what it says stays to be read."""
    connection.settimeout(_HEADER_TIMEOUT_S)
    try:
        connection.recv(1, socket.MSG_PEEK)
    except OSError:
        return False
    # What rospy reads and writes afterwards may take any time.
    connection.settimeout(None)
    return True
