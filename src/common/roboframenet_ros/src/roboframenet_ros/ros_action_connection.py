"""The client of one action server of any type."""

import threading
import weakref
from typing import Any, Callable, List, MutableMapping, NamedTuple, Tuple

import actionlib
import rosgraph.names
import rospy
from actionlib.action_client import CommStateMachine, GoalManager
from actionlib_msgs.msg import GoalID, GoalStatus, GoalStatusArray

from roboframenet_ros.ros_master import is_process_gone
from roboframenet_ros.ros_publishing import unregister
from roboframenet_ros.ros_server_links import ServerLinks, newest_link

#: How long a process may take to say that it lives, seconds.
_LIFE_TIMEOUT_S = 1.0


class SentGoal:
    """A goal that was sent. actionlib drops a goal whose handle is not kept: keep this object."""

    def __init__(self, handle: actionlib.ClientGoalHandle, goal_id: str) -> None:
        self.handle = handle
        self.goal_id = goal_id


class _Statuses(NamedTuple):
    """What a goal reads of a ``GoalStatusArray``, which takes far longer to make."""

    status_list: Tuple[GoalStatus, ...]


class _GoalManager(GoalManager):
    """Tells each goal what is said about it.

    actionlib's manager gives each message to all goals, and each of them looks for itself in it: a status message of a
    hundred goals is ten thousand comparisons.
    """

    def __init__(self, action_type: Any) -> None:
        super().__init__(action_type)
        self._by_id: MutableMapping[str, CommStateMachine] = weakref.WeakValueDictionary()

    def init_goal(self, *args: Any, **kwargs: Any) -> actionlib.ClientGoalHandle:
        """Send a goal, and follow it while its handle is kept."""
        handle = super().init_goal(*args, **kwargs)
        self._by_id[handle.comm_state_machine.action_goal.goal_id.id] = handle.comm_state_machine
        return handle

    def update_statuses(self, status_array: GoalStatusArray) -> None:
        """Tell each goal its own status, or that it has none any more."""
        by_id = {status.goal_id.id: status for status in status_array.status_list}
        with self.list_mutex:
            self.statuses = [known for known in self.statuses if known()]
        for goal in self._get_live_statuses():
            status = by_id.get(goal.action_goal.goal_id.id)
            goal.update_status(_Statuses(() if status is None else (status,)))

    def update_feedbacks(self, action_feedback: Any) -> None:
        """Tell a goal its feedback."""
        goal = self._by_id.get(action_feedback.status.goal_id.id)
        if goal is None:
            # It may be being sent just now.
            super().update_feedbacks(action_feedback)
        else:
            goal.update_feedback(action_feedback)


class _Client(actionlib.ActionClient):
    """Keeps the stamp of the last feedback, which actionlib does not pass on."""

    feedback_stamp = rospy.Time()

    def __init__(self, server: str, action_type: Any) -> None:
        super().__init__(server, action_type)
        self.manager = _GoalManager(action_type)
        self.manager.register_send_goal_fn(self.pub_goal.publish)
        self.manager.register_cancel_fn(self.pub_cancel.publish)

    def _feedback_cb(self, msg: Any) -> None:
        # rospy calls this from one thread for each topic, and actionlib calls the callbacks of goals from here.
        self.feedback_stamp = msg.header.stamp
        super()._feedback_cb(msg)


class ActionConnection:
    """The client of one action server. Callbacks run in threads of rospy and must only enqueue."""

    def __init__(self, server: str, action_type: Any) -> None:
        """Connect. This calls the master, without a deadline.

        Args:
            server: name of the action server
            action_type: class of its action

        Raises:
            ValueError: not a legal name of a topic
        """
        if not rosgraph.names.is_legal_name(server):
            # rospy only warns of such a name, and then waits for a topic that cannot exist.
            raise ValueError("it is not a legal name")
        self.server = server
        self._client = _Client(server, action_type)
        self._listeners: List[Callable[[], None]] = []
        self._links = ServerLinks(
            publishers=(self._client.pub_goal, self._client.pub_cancel),
            subscribers=(self._client.result_sub, self._client.feedback_sub),
        )
        self._sending = threading.Lock()
        self._status = rospy.Subscriber(
            rospy.remap_name(server) + "/status", GoalStatusArray, self._tell_listeners, queue_size=10
        )

    def close(self) -> None:
        """Disconnect."""
        client = self._client
        for end in (client.pub_goal, client.pub_cancel, client.result_sub, client.feedback_sub):
            unregister(end)
        # The one topic that has two subscribers here.
        unregister(client.status_sub)
        unregister(self._status)

    @property
    def feedback_stamp(self) -> rospy.Time:
        """Stamp of the feedback; to be asked in the callback that gets the feedback."""
        return self._client.feedback_stamp

    def is_ready(self) -> bool:
        """Whether the server has published its status and is connected both ways; returns at once."""
        return self._links.are_complete(self._node(), self.node_uri())

    def node_uri(self) -> str:
        """Return the XML-RPC address of the server's node; empty when it is not connected."""
        node = self._node()
        return newest_link(self._status, node)[1] if node else ""

    def _node(self) -> str:
        status = self._client.last_status_msg
        return "" if status is None else str(status._connection_header["callerid"])

    @staticmethod
    def ask_whether_gone(uri: str, on_gone: Callable[[], None]) -> None:
        """Ask in a thread whether the process of a node has ended.

        Args:
            uri: from `node_uri`; to be noted while the server is connected
            on_gone: called from the thread if it has
        """

        def ask() -> None:
            if is_process_gone(uri, timeout_s=_LIFE_TIMEOUT_S):
                on_gone()

        if uri:
            threading.Thread(target=ask, name="ask_life", daemon=True).start()

    def listen(self, on_sign: Callable[[], None]) -> None:
        """Call `on_sign` for each status message from now on."""
        with self._sending:
            self._listeners = self._listeners + [on_sign]

    def unlisten(self, on_sign: Callable[[], None]) -> None:
        """End `listen`."""
        with self._sending:
            self._listeners = [listener for listener in self._listeners if listener is not on_sign]

    def _tell_listeners(self, _: GoalStatusArray) -> None:
        for listener in self._listeners:
            listener()

    def is_gone(self) -> bool:
        """Whether the server has no subscriber for goals any more: its process has ended."""
        return self._client.pub_goal.get_num_connections() == 0

    def send(
        self,
        goal: Any,
        *,
        header_text: str = "",
        earliest_stamp_ns: int = 0,
        on_transition: Callable[[actionlib.ClientGoalHandle], None],
        on_feedback: Callable[[Any], None],
    ) -> SentGoal:
        """Send a goal.

        Args:
            goal: of the server's type
            header_text: for ``header.frame_id`` of the message around the goal
            earliest_stamp_ns: the goal is not stamped earlier, nanoseconds of ROS time
            on_transition: called with the handle whenever its state changes
            on_feedback: called with each feedback
        """
        # actionlib makes the message around the goal anew for each goal, and this function publishes it.
        with self._sending:
            self._client.manager.register_send_goal_fn(
                lambda message: self._publish(message, header_text, earliest_stamp_ns)
            )
            handle = self._client.send_goal(
                goal, transition_cb=on_transition, feedback_cb=lambda _handle, feedback: on_feedback(feedback)
            )
        return SentGoal(handle, handle.comm_state_machine.action_goal.goal_id.id)

    def _publish(self, message: Any, header_text: str, earliest_stamp_ns: int) -> None:
        message.header.frame_id = header_text
        if message.goal_id.stamp.to_nsec() < earliest_stamp_ns:
            message.goal_id.stamp = rospy.Time(*divmod(earliest_stamp_ns, 1_000_000_000))
        self._client.pub_goal.publish(message)

    def cancel(self, goal: SentGoal) -> None:
        """Send one cancel.

        Not through the handle: a second cancel of the handle turns a goal that has just ended into one that never ends.
        """
        self._client.pub_cancel.publish(GoalID(id=goal.goal_id))
