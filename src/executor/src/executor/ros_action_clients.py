"""Connections to action servers, kept while they are in use."""
import threading
from collections import OrderedDict
from typing import Callable, List, Optional

import actionlib
import rosgraph.names
import rospy
from actionlib_msgs.msg import GoalID, GoalStatusArray
from roboframenet_msgs.msg import FilledSemanticFrame, FilledSemanticFrameAction, FilledSemanticFrameGoal


class SentGoal:
    """A goal on its way. actionlib forgets a goal whose handle nobody keeps: keep this object."""

    def __init__(self, handle: actionlib.ClientGoalHandle, goal_id: str) -> None:
        self.handle = handle
        self.goal_id = goal_id


class ServerConnection:
    """The client of one action server. Callbacks run in threads of rospy and must only enqueue."""

    def __init__(self, server: str) -> None:
        """Connect; asks the master and may therefore take long when the master does.

        Raises:
            ValueError: not a name for a topic
        """
        if not rosgraph.names.is_legal_name(server):
            # rospy only warns of such a name, and then waits for a topic that cannot be.
            raise ValueError("it is not a legal name")
        self.server = server
        self._client = actionlib.ActionClient(server, FilledSemanticFrameAction)
        self._listeners: List[Callable[[], None]] = []
        self._status = rospy.Subscriber(
            rospy.remap_name(server) + "/status", GoalStatusArray, self._tell_listeners, queue_size=10)

    def close(self) -> None:
        """Disconnect."""
        self._status.unregister()
        self._client.stop()

    def is_ready(self) -> bool:
        """Whether the server has said something and is connected both ways; unlike actionlib's wait, at once."""
        status = self._client.last_status_msg
        if status is None:
            return False
        server_node = status._connection_header["callerid"]
        return (self._client.pub_goal.impl.has_connection(server_node)
                and self._client.pub_cancel.impl.has_connection(server_node)
                and self._hears(self._client.result_sub, server_node)
                and self._hears(self._client.feedback_sub, server_node))

    @staticmethod
    def _hears(subscriber: rospy.Subscriber, server_node: str) -> bool:
        return any(connection.callerid_pub == server_node for connection in subscriber.impl.connections)

    def listen(self, on_sign: Callable[[], None]) -> None:
        """Have `on_sign` called for each status message."""
        self._listeners = self._listeners + [on_sign]

    def unlisten(self, on_sign: Callable[[], None]) -> None:
        """End `listen`."""
        self._listeners = [listener for listener in self._listeners if listener is not on_sign]

    def _tell_listeners(self, _: GoalStatusArray) -> None:
        for listener in self._listeners:
            listener()

    def send(self, frame: FilledSemanticFrame, *, on_transition: Callable[[actionlib.ClientGoalHandle], None],
             on_feedback: Callable[[], None]) -> SentGoal:
        """Send a goal."""
        handle = self._client.send_goal(
            FilledSemanticFrameGoal(frame=frame), transition_cb=on_transition,
            feedback_cb=lambda _handle, _feedback: on_feedback())
        return SentGoal(handle, handle.comm_state_machine.action_goal.goal_id.id)

    def cancel(self, goal: SentGoal) -> None:
        """Send one cancel.

        Not by the handle: its second cancel would turn a goal that has just ended into one that waits for ever.
        """
        self._client.pub_cancel.publish(GoalID(id=goal.goal_id))


class ActionClients:
    """Connections by name of the server, the ones used last."""

    def __init__(self, *, max_kept: int) -> None:
        """Start with none.

        Args:
            max_kept: how many connections stay when no goal uses them
        """
        self._max_kept = max_kept
        self._lock = threading.Lock()
        self._connections: "OrderedDict[str, ServerConnection]" = OrderedDict()

    def get(self, server: str, *, timeout_s: float) -> Optional[ServerConnection]:
        """The connection to a server, made if need be.

        Returns:
            None when the master did not answer in time

        Raises:
            ValueError: the name cannot be that of an action server
        """
        with self._lock:
            known = self._connections.get(server)
            if known is not None:
                self._connections.move_to_end(server)
                return known
        made: List[ServerConnection] = []
        faults: List[Exception] = []

        def connect() -> None:
            try:
                made.append(ServerConnection(server))
            except Exception as error:  # boundary: the master or the name may be at fault in many ways
                faults.append(error)

        # rospy knows no deadline for the master: a thread of its own waits for it.
        thread = threading.Thread(target=connect, name=f"connect_{server}", daemon=True)
        thread.start()
        thread.join(timeout_s)
        if faults:
            raise ValueError(str(faults[0])) from faults[0]
        if not made:
            return None
        with self._lock:
            self._connections[server] = made[0]
            dropped = []
            while len(self._connections) > self._max_kept:
                dropped.append(self._connections.popitem(last=False)[1])
        for connection in dropped:
            connection.close()
        return made[0]

    def close(self) -> None:
        """Close all connections."""
        with self._lock:
            connections = list(self._connections.values())
            self._connections.clear()
        for connection in connections:
            connection.close()
