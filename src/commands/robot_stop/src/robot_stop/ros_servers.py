"""Connections to the action servers that a stop cancels, made before they are needed."""

import threading
import time
from typing import Dict, FrozenSet, List, Mapping, Optional, Tuple

import rospy
from actionlib_msgs.msg import GoalID, GoalStatus, GoalStatusArray

from roboframenet_ros.ros_master import SystemState, TimedMaster
from roboframenet_ros.ros_publishing import unregister
from robot_stop.braking import LiveGoal, StopOrder
from robot_stop.servers import Server, find_servers

_LIVE = frozenset({GoalStatus.PENDING, GoalStatus.ACTIVE, GoalStatus.PREEMPTING, GoalStatus.RECALLING})
# By then, a server that was found has published the status of its goals.
_CONNECT_S = 0.5


class _Connection:
    """The cancel publisher of one server, and the last status that it published."""

    def __init__(self, server: Server) -> None:
        self.server = server
        self._publisher = rospy.Publisher(server.cancel_topic, GoalID, queue_size=50, tcp_nodelay=True)
        self._last: Optional[GoalStatusArray] = None
        self._read: Optional[GoalStatusArray] = None
        self._goals: Tuple[LiveGoal, ...] = ()
        # No AnyMsg, although most messages are never read: in one process, rospy gives the action clients of the
        # executor what the first subscriber of a topic asked for.
        self._subscriber = rospy.Subscriber(
            server.status_topic, GoalStatusArray, self._hear, queue_size=1, tcp_nodelay=True
        )

    def _hear(self, message: GoalStatusArray) -> None:
        self._last = message

    def cancel(self, goal_id: GoalID) -> bool:
        """Publish one cancel; returns whether the server is connected."""
        try:
            self._publisher.publish(goal_id)
        except rospy.ROSException:
            # The refresh thread has just closed the publisher because the server is gone.
            return False
        return self._publisher.get_num_connections() > 0

    def goals(self) -> Tuple[LiveGoal, ...]:
        """The goals that had not ended in its last status; none for a server that is gone. For one thread."""
        if self._subscriber.get_num_connections() == 0:
            self._last = None
        last = self._last
        if last is not self._read:
            self._goals = () if last is None else self._live_goals(last)
            self._read = last
        return self._goals

    def _live_goals(self, message: GoalStatusArray) -> Tuple[LiveGoal, ...]:
        return tuple(
            LiveGoal(self.server, status.goal_id.id, status.goal_id.stamp.to_nsec())
            for status in message.status_list
            if status.status in _LIVE
        )

    def close(self) -> None:
        """Disconnect."""
        unregister(self._publisher)
        unregister(self._subscriber)


class Servers:
    """Keeps a connection to each action server that a stop cancels; a thread updates them.

    A stop uses the existing connections and never asks the master. Connections survive an absence of the master.
    """

    def __init__(self, *, also_cancel: Tuple[str, ...], refresh_period_s: float, master_timeout_s: float) -> None:
        """Start without connections.

        Args:
            also_cancel: resolved names of servers to cancel although they take no frames
            refresh_period_s: time between two searches for servers, seconds
            master_timeout_s: how long the master may take to answer, seconds
        """
        self._also_cancel = also_cancel
        self._refresh_period_s = refresh_period_s
        self._master = TimedMaster(timeout_s=master_timeout_s)
        self._registered: FrozenSet[str] = frozenset()
        # Replaced as a whole, never modified: a stop reads it without a lock.
        self._connections: Mapping[Server, _Connection] = {}
        # What the servers were found in: while it is the same, so are they.
        self._found_in: Optional[Tuple[SystemState, FrozenSet[str]]] = None
        self._looked_s: Optional[float] = None
        self._told_count = 0
        self._is_closing = threading.Event()
        self._wake = threading.Event()
        self._thread = threading.Thread(target=self._refresh_on, name="stoppable_servers", daemon=True)

    def start(self) -> None:
        """Start the thread that searches for servers."""
        self._thread.start()

    def close(self, *, timeout_s: float) -> None:
        """End the thread."""
        self._is_closing.set()
        self._wake.set()
        self._thread.join(timeout_s)

    def set_registered(self, servers: FrozenSet[str]) -> None:
        """Set the servers that registered for frames, of any goal type, by their resolved names."""
        self._registered = servers

    def refresh_soon(self) -> None:
        """Search for servers now instead of at the next period; returns at once."""
        self._wake.set()

    @property
    def is_complete(self) -> bool:
        """Whether the graph has been read, and the servers found in it have had time to connect."""
        return self._looked_s is not None and time.monotonic() - self._looked_s >= _CONNECT_S

    def cancel(self, goal_id: GoalID, order: StopOrder) -> List[str]:
        """Publish one cancel to every server that the order covers.

        Returns:
            names of the servers that were connected
        """
        return sorted(
            server.name
            for server, connection in self._connections.items()
            if order.covers(server) and connection.cancel(goal_id)
        )

    def cancel_live(self, goal_id: GoalID) -> None:
        """Publish one cancel to every server that has goals. For one thread."""
        for connection in self._connections.values():
            if connection.goals():
                connection.cancel(goal_id)

    def goals(self) -> Tuple[LiveGoal, ...]:
        """The goals of all servers that had not ended in their last status. For one thread."""
        return tuple(goal for connection in self._connections.values() for goal in connection.goals())

    def _refresh_on(self) -> None:
        while not self._is_closing.is_set():
            try:
                self._refresh()
            except Exception as error:  # boundary: an absent master shows in any error of XML-RPC and HTTP
                rospy.logwarn_throttle(30.0, f"the graph cannot be read, the known servers stay: {error}")
            self._wake.wait(self._refresh_period_s)
            self._wake.clear()

    def _refresh(self) -> None:
        registered = self._registered
        state, types = self._master.graph()
        if self._found_in is not None and state is self._found_in[0] and registered == self._found_in[1]:
            self._tell_count()
            return
        servers = find_servers(
            types,
            state.subscribers,
            registered=registered,
            others=self._also_cancel,
            namespace=rospy.get_namespace(),
        )
        kept: Dict[Server, _Connection] = {
            server: connection for server, connection in self._connections.items() if server in servers
        }
        dropped = [connection for server, connection in self._connections.items() if server not in servers]
        for server in servers - kept.keys():
            kept[server] = _Connection(server)
            rospy.logdebug("a stop can cancel %s", server.name)
        self._connections = kept
        self._found_in = (state, registered)
        if self._looked_s is None:
            self._looked_s = time.monotonic()
        for connection in dropped:
            connection.close()

    def _tell_count(self) -> None:
        """Log how many servers there are, once their number has settled."""
        count = len(self._connections)
        if count != self._told_count:
            self._told_count = count
            rospy.loginfo("a stop can cancel %d action servers", count)
