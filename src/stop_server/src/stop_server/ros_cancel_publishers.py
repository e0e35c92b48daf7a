"""Publishers that can cancel every goal at once, made before they are needed."""
import http.client
import threading
import xmlrpc.client
from typing import Dict, FrozenSet, List, Mapping, Tuple

import rosgraph
import rospy
from actionlib_msgs.msg import GoalID

from stop_server.cancel_topics import cancel_topic, find_servers


class _TimedTransport(xmlrpc.client.Transport):
    """HTTP that gives up on a silent host."""

    def __init__(self, timeout_s: float) -> None:
        super().__init__()
        self._timeout_s = timeout_s

    def make_connection(self, host: str) -> http.client.HTTPConnection:
        """Connect with the timeout."""
        connection = super().make_connection(host)
        connection.timeout = self._timeout_s
        return connection


class CancelPublishers:
    """One cancel publisher for each action server of the graph, kept up to date by a thread.

    A stop only publishes on what is there; it never asks the master. When the master is away the publishers stay.
    """

    def __init__(self, *, also_cancel: Tuple[str, ...], refresh_period_s: float, master_timeout_s: float) -> None:
        """Start with no publishers.

        Args:
            also_cancel: resolved names of servers whose goals are no filled frames
            refresh_period_s: time between two looks at the graph, seconds
            master_timeout_s: how long the master may take, seconds
        """
        self._also_cancel = also_cancel
        self._refresh_period_s = refresh_period_s
        self._master = xmlrpc.client.ServerProxy(
            rosgraph.get_master_uri(), transport=_TimedTransport(master_timeout_s))
        self._registered: FrozenSet[str] = frozenset()
        # Replaced as a whole, never changed: a stop reads it without a lock.
        self._publishers: Mapping[str, rospy.Publisher] = {}
        self._is_closing = threading.Event()
        self._wake = threading.Event()
        self._thread = threading.Thread(target=self._refresh_on, name="cancel_publishers", daemon=True)

    def start(self) -> None:
        """Begin to look at the graph."""
        self._thread.start()

    def close(self, *, timeout_s: float) -> None:
        """End the thread."""
        self._is_closing.set()
        self._wake.set()
        self._thread.join(timeout_s)

    def set_registered(self, servers: FrozenSet[str]) -> None:
        """Name the servers that registered for frames, whatever the type of their goals; resolved names."""
        self._registered = servers

    def refresh_soon(self) -> None:
        """Look at the graph now rather than at the next turn; returns at once."""
        self._wake.set()

    def cancel(self, goal_id: GoalID, *, except_server: str = "") -> List[str]:
        """Publish one cancel to every server but one.

        Returns:
            names of the servers that were connected
        """
        reached = []
        for server, publisher in self._publishers.items():
            if server == except_server:
                continue
            try:
                publisher.publish(goal_id)
            except rospy.ROSException as error:
                # The refreshing thread has just closed it: the server is gone.
                rospy.logdebug("no cancel to %s: %s", server, error)
                continue
            if publisher.get_num_connections() > 0:
                reached.append(server)
        return sorted(reached)

    def _refresh_on(self) -> None:
        while not self._is_closing.is_set():
            try:
                self._refresh()
            except Exception as error:  # boundary: the master may be away in any way that XML-RPC and HTTP know
                rospy.logwarn_throttle(30.0, "the graph cannot be read, the known servers stay: %s" % error)
            self._wake.wait(self._refresh_period_s)
            self._wake.clear()

    def _refresh(self) -> None:
        caller = rospy.get_name()
        code, message, types = self._master.getTopicTypes(caller)
        if code != 1:
            raise RuntimeError(f"master: {message}")
        code, message, (_, subscriptions, _) = self._master.getSystemState(caller)
        if code != 1:
            raise RuntimeError(f"master: {message}")
        servers = find_servers(dict(types), {topic for topic, nodes in subscriptions if nodes},
                               self._also_cancel + tuple(self._registered))
        kept: Dict[str, rospy.Publisher] = {
            server: publisher for server, publisher in self._publishers.items() if server in servers}
        dropped = [publisher for server, publisher in self._publishers.items() if server not in servers]
        for server in servers - kept.keys():
            kept[server] = rospy.Publisher(cancel_topic(server), GoalID, queue_size=50)
            rospy.loginfo("stop_server can cancel %s", server)
        self._publishers = kept
        for publisher in dropped:
            publisher.unregister()
