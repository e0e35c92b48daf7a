"""Whether an action server is connected, as it sees it too."""

import threading
import time
from typing import Any, Sequence, Tuple

import rospy

from roboframenet_ros.ros_master import NO_ANSWER, listeners_of

#: How long a node may take to say to whom it is connected, seconds.
_ANSWER_TIMEOUT_S = 1.0
#: A node that does not say it is believed to be connected after this time, seconds.
_LINK_TIMEOUT_S = 1.0
_LINK_LOOK_S = 0.01
#: What rospy calls a publisher that has not agreed yet.
_UNNAMED = "unknown"


class ServerLinks:
    """The connections to the node of one action server.

    Other nodes hear its topics, too: a connection counts only if it is one of that node. And a node publishes before it
    knows of a connection that this side has made; the result of a short first goal would be lost. So it is asked, once
    for each process.
    """

    def __init__(self, *, publishers: Sequence[rospy.Publisher], subscribers: Sequence[rospy.Subscriber]) -> None:
        """
        Args:
            publishers: of what the server hears
            subscribers: of what it publishes
        """
        self._publishers, self._subscribers = publishers, subscribers
        # Addresses of the process that has said that it is connected, and of the one that is asked.
        self._linked_uri = self._asked_uri = ""

    def are_complete(self, node: str, uri: str) -> bool:
        """Whether a node is connected both ways; returns at once, and asks in a thread.

        When its process dies, rospy notices it in one connection after the other: none of them may be missing.

        Args:
            node: name of the node of the server
            uri: its XML-RPC address; empty if it is not known
        """
        return (
            bool(node and uri)
            and all(publisher.impl.has_connection(node) for publisher in self._publishers)
            and all(newest_link(subscriber, node) != ("", "") for subscriber in self._subscribers)
            and self._is_linked(uri)
        )

    def _is_linked(self, uri: str) -> bool:
        if uri != self._asked_uri:
            self._asked_uri = uri
            threading.Thread(target=self._ask, args=(uri,), name="ask_links", daemon=True).start()
        return uri == self._linked_uri

    def _ask(self, uri: str) -> None:
        wanted = {(subscriber.resolved_name, rospy.get_name()) for subscriber in self._subscribers}
        end_s = time.monotonic() + _LINK_TIMEOUT_S
        while time.monotonic() < end_s:
            try:
                if wanted <= listeners_of(uri, timeout_s=_ANSWER_TIMEOUT_S):
                    break
            except (*NO_ANSWER, IndexError, TypeError) as error:
                rospy.logdebug("%s does not list its subscribers: %s", uri, error)
            time.sleep(_LINK_LOOK_S)
        if uri == self._asked_uri:
            self._linked_uri = uri


def newest_link(subscriber: rospy.Subscriber, node: str = "") -> Tuple[str, str]:
    """Return the name and the XML-RPC address of the node that a subscriber is connected to; both empty for none.

    Args:
        subscriber: of a topic
        node: name of the node, if it is known
    """
    # The newest one counts.
    links = [one for one in list(subscriber.impl.connections) if is_agreed(one) and node in ("", one.callerid_pub)]
    return (str(links[-1].callerid_pub), str(links[-1].endpoint_id)) if links else ("", "")


def is_agreed(link: Any) -> bool:
    """Whether a publisher has agreed to a connection, and it did not break.

    rospy keeps a connection that broke, without a socket, and one that was refused, without the name of the publisher.

    Args:
        link: of a subscriber
    """
    return bool(link.socket) and link.callerid_pub != _UNNAMED
