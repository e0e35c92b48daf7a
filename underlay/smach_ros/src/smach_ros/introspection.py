"""Introspection: publishes the structure and the status of the containers of a machine."""

import threading
from typing import Any, Iterable, List, Optional

import rospy
from smach_msgs.msg import SmachContainerInitialStatusCmd, SmachContainerStatus, SmachContainerStructure
from std_msgs.msg import Header

import smach
from smach_ros.local_data import from_json, to_json, to_pickle

STATUS_TOPIC = "/smach/container_status"
INIT_TOPIC = "/smach/container_init"
STRUCTURE_TOPIC = "/smach/container_structure"

# How often status and structure are repeated for late subscribers.
REPEAT_PERIOD_S = 2.0

# What a status says when a command has set the initial state.
INITIAL_STATE_SET = "REMOTE_INIT"


class ContainerProxy:
    """Publishes the structure and the status of one container and lets its initial state be set.

    Publishes:
        server_name/smach/container_structure (smach_msgs/SmachContainerStructure), repeated
        server_name/smach/container_status (smach_msgs/SmachContainerStatus), at changes and repeated
    Subscribes:
        server_name/smach/container_init (smach_msgs/SmachContainerInitialStatusCmd)

    Args:
        server_name: name that the topics begin with
        container: the container to show
        path: where it is in the tree
        update_rate: time between repetitions
    """

    def __init__(
        self,
        server_name: str,
        container: smach.Container,
        path: str,
        update_rate: rospy.Duration = rospy.Duration(REPEAT_PERIOD_S),
    ) -> None:
        self._path = path
        self._container = container
        self._period_s = update_rate.to_sec()
        self._stopped = threading.Event()
        self._thread: Optional[threading.Thread] = None
        self._publish_lock = threading.Lock()
        self._status_pub = rospy.Publisher(server_name + STATUS_TOPIC, SmachContainerStatus, queue_size=10)
        self._structure_pub = rospy.Publisher(server_name + STRUCTURE_TOPIC, SmachContainerStructure, queue_size=10)
        self._init_cmd_sub = rospy.Subscriber(
            server_name + INIT_TOPIC, SmachContainerInitialStatusCmd, self._init_cmd_cb
        )
        container.register_start_cb(self._start_cb)
        container.register_transition_cb(self._transition_cb)
        container.register_termination_cb(self._termination_cb)

    def start(self) -> None:
        """Begin to publish."""
        self._thread = threading.Thread(target=self._repeat, name=f"smach_introspection_{self._path}", daemon=True)
        self._thread.start()

    def stop(self) -> None:
        """Stop publishing and listening."""
        # With the lock, so that nothing is being published while the topics are closed.
        with self._publish_lock:
            self._stopped.set()
        if self._thread is not None and self._thread is not threading.current_thread():
            self._thread.join(5.0)
        self._init_cmd_sub.unregister()
        self._status_pub.unregister()
        self._structure_pub.unregister()

    def _repeat(self) -> None:
        while not self._stopped.is_set() and not rospy.is_shutdown():
            self._publish_structure()
            self._publish_status("HEARTBEAT")
            self._stopped.wait(self._period_s)

    def _publish(self, publisher: rospy.Publisher, message: Any) -> None:
        with self._publish_lock:
            if self._stopped.is_set():
                return
            try:
                publisher.publish(message)
            except rospy.ROSException as error:
                # At shutdown the topic may be closed between the check and the call.
                rospy.logdebug("introspection of %s: %s", self._path, error)

    def _publish_structure(self) -> None:
        message = SmachContainerStructure(header=Header(stamp=rospy.Time.now()), path=self._path)
        message.children = list(self._container.get_children())
        for outcome, label, target in self._container.get_internal_edges():
            message.internal_outcomes.append(str(outcome))
            message.outcomes_from.append(str(label))
            # Viewers know the text "None" and can hide these transitions.
            message.outcomes_to.append(str(target))
        message.container_outcomes = list(self._container.get_registered_outcomes())
        self._publish(self._structure_pub, message)

    def _publish_status(self, info_str: str = "") -> None:
        message = SmachContainerStatus(header=Header(stamp=rospy.Time.now()), path=self._path, info=info_str)
        message.initial_states = list(self._container.get_initial_states())
        message.active_states = list(self._container.get_active_states())
        message.local_data = to_pickle(self._container.userdata)
        self._publish(self._status_pub, message)

    def _init_cmd_cb(self, msg: SmachContainerInitialStatusCmd) -> None:
        """Set the initial state, if the command is for this container and says something it can do."""
        if msg.path != self._path:
            return
        unknown = [label for label in msg.initial_states if label not in self._container.get_children()]
        if unknown:
            rospy.logerr(
                "introspection of %s: initial states %s refused, there are: %s",
                self._path,
                unknown,
                sorted(self._container.get_children()),
            )
            return
        userdata = smach.UserData()
        try:
            for key, value in from_json(msg.local_data).items():
                userdata[key] = value
            self._container.set_initial_state(list(msg.initial_states), userdata)
        except (ValueError, RecursionError, smach.SmachError) as error:
            rospy.logerr("introspection of %s: initial status refused: %s", self._path, error)
            return
        self._publish_status(INITIAL_STATE_SET)

    def _start_cb(self, userdata: Any, initial_states: List[str], *args: Any) -> None:
        self._publish_structure()
        self._publish_status("Container started")

    def _transition_cb(self, userdata: Any, active_states: List[str], *args: Any) -> None:
        self._publish_status("Transition to " + ", ".join(active_states))

    def _termination_cb(self, userdata: Any, terminal_states: List[str], outcome: Optional[str], *args: Any) -> None:
        self._publish_status(f"Terminated {', '.join(terminal_states)} with outcome {outcome}")


class IntrospectionServer:
    """Shows a machine, with every container in it, on the introspection topics.

    Args:
        server_name: name that the topics begin with
        state: the machine
        path: name of the machine as the root of the tree, for example "/SM_ROOT" or "/"
    """

    def __init__(self, server_name: str, state: smach.State, path: str) -> None:
        self._server_name = server_name
        self._state = state
        self._path = path
        self._proxies: List[ContainerProxy] = []

    def start(self) -> None:
        """Begin to publish."""
        self.construct(self._server_name, self._state, self._path)

    def stop(self) -> None:
        """Stop publishing."""
        for proxy in self._proxies:
            proxy.stop()
        self._proxies = []

    def clear(self) -> None:
        """Stop publishing, as stop()."""
        self.stop()

    def construct(self, server_name: str, state: smach.State, path: str) -> None:
        """Show a container and those in it; a state that is no container is not shown."""
        if not isinstance(state, smach.Container):
            return
        # The root comes first, because a viewer needs it to place the rest.
        proxy = ContainerProxy(server_name, state, path)
        self._proxies.append(proxy)
        proxy.start()
        for label, child in state.get_children().items():
            self.construct(server_name, child, f"{path.rstrip('/')}/{label}")


class IntrospectionClient:
    """Finds introspection servers and sets initial states through them."""

    def get_servers(self) -> List[str]:
        """Names of the introspection servers that publish now."""
        topics = [name for name, _ in rospy.get_published_topics()]
        return sorted({name[: -len(STATUS_TOPIC)] for name in topics if name.endswith(STATUS_TOPIC)})

    def set_initial_state(
        self,
        server: str,
        path: str,
        initial_states: Iterable[str],
        initial_userdata: Optional[smach.UserData] = None,
        timeout: Optional[rospy.Duration] = None,
    ) -> bool:
        """Set the initial state of a container and wait until it says so.

        Args:
            server: name of the introspection server
            path: where the container is in the tree
            initial_states: labels to start with
            initial_userdata: values to add to the userdata; what JSON can say
            timeout: how long to wait; 10 s when not given

        Returns:
            whether the container was seen with these initial states in time
        """
        wanted = list(initial_states)
        command = SmachContainerInitialStatusCmd(path=path, initial_states=wanted)
        command.local_data = to_json(initial_userdata if initial_userdata is not None else smach.UserData())
        confirmed = threading.Event()

        def see(status: SmachContainerStatus) -> None:
            if status.path == path and status.info == INITIAL_STATE_SET and status.initial_states == wanted:
                confirmed.set()

        publisher = rospy.Publisher(server + INIT_TOPIC, SmachContainerInitialStatusCmd, queue_size=1)
        subscriber = rospy.Subscriber(server + STATUS_TOPIC, SmachContainerStatus, see)
        try:
            wait_s = 10.0 if timeout is None else timeout.to_sec()
            for _ in range(max(1, int(wait_s / 0.5))):
                # Repeated, because a topic that has just been advertised may lose its first message.
                publisher.publish(command)
                if confirmed.wait(0.5) or rospy.is_shutdown():
                    break
            return confirmed.is_set()
        finally:
            subscriber.unregister()
            publisher.unregister()
