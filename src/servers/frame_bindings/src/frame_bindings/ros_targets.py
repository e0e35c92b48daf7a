"""The targets of bindings: action servers, services, topics."""

import queue
import threading
import time
from typing import Any, Callable, Optional

import rosgraph
import roslib.message
import rospy
import rosservice
from actionlib_msgs.msg import GoalStatus

from frame_bindings.binding_file import Binding, Kind
from rfnserver.results import plan_result
from rfnserver.ros_goal_forwarding import POLL_S, ForwardedEnd, ForwardingDeadlines, GoalForwarder, read_end
from rfnserver.ros_goal_messages import fields_of, goal_type_of
from roboframenet_ros.ros_service import ServiceError, call_service

IsToEnd = Callable[[], bool]


class UnknownType(ValueError):
    """A type is not built in this workspace."""


class ActionTarget:
    """An action server of any type."""

    def __init__(self, binding: Binding) -> None:
        """
        Raises:
            UnknownType: the type of the action is not built here
            ResultError: its result lacks fields that the binding names
        """
        self._binding = binding
        action_type = _message_class(binding.type_name)
        self.message_type = goal_type_of(action_type)
        self._forwarder = GoalForwarder(
            binding.target,
            action_type,
            ForwardingDeadlines(
                server_s=binding.server_timeout_s, goal_s=binding.goal_timeout_s, preempt_s=binding.preempt_timeout_s
            ),
            result_names=binding.result_names,
        )

    def live_type(self) -> Optional[str]:
        """Return the present type of the server; None while it is missing."""
        # The server publishes its results. The topic of goals has the type of its last client, such as this one.
        result_type = _topic_type(self._binding.target + "/result", is_published=True)
        return result_type[: -len("Result")] if result_type else None

    def carry_out(self, message: Any, is_to_end: IsToEnd, on_feedback: Callable[[Any], None]) -> ForwardedEnd:
        """Send the goal and wait for its end."""
        return self._forwarder.carry_out(message, is_to_end=is_to_end, on_feedback=on_feedback)


class ServiceTarget:
    """A service. It is called once, and its answer ends the goal."""

    def __init__(self, binding: Binding) -> None:
        """
        Raises:
            UnknownType: the type of the service is not built here
            ResultError: its response lacks fields that the binding names
        """
        self._binding = binding
        self._type = roslib.message.get_service_class(binding.type_name)
        if self._type is None:
            raise UnknownType(f"there is no service type {binding.type_name}")
        self.message_type = self._type._request_class
        self._results = plan_result(fields_of(self._type._response_class), binding.result_names)

    def live_type(self) -> Optional[str]:
        """Return the present type of the service; None while it is missing."""
        try:
            return rosservice.get_service_type(rospy.resolve_name(self._binding.target))
        except rosservice.ROSServiceException:
            return None

    def carry_out(self, message: Any, is_to_end: IsToEnd, on_feedback: Callable[[Any], None]) -> ForwardedEnd:
        """Call the service. A call cannot be cancelled: after a preemption it continues."""
        answers: queue.Queue[Any] = queue.Queue()

        def call() -> None:
            try:
                answers.put(
                    call_service(
                        self._binding.target,
                        self._type,
                        timeout_s=self._binding.server_timeout_s,
                        answer_timeout_s=self._binding.goal_timeout_s,
                        message=message,
                    )
                )
            except ServiceError as error:
                answers.put(error)

        # A daemon, because the call may outlast the goal; the call has its own deadlines.
        threading.Thread(target=call, name=f"binding of {self._binding.target}", daemon=True).start()
        while True:
            try:
                response = answers.get(timeout=POLL_S)
                break
            except queue.Empty:
                if is_to_end():
                    return ForwardedEnd(GoalStatus.PREEMPTED, f"the service {self._binding.target} may still be at it")
        if isinstance(response, ServiceError):
            return ForwardedEnd(GoalStatus.ABORTED, str(response))
        target = f"the service {self._binding.target}"
        return read_end(GoalStatus.SUCCEEDED, "", response, self._results, target)


class TopicTarget:
    """A topic. One message is published; its effect is unknown."""

    def __init__(self, binding: Binding) -> None:
        """
        Raises:
            UnknownType: the type of the topic is not built here
        """
        self._binding = binding
        self.message_type = _message_class(binding.type_name)
        self._publisher = rospy.Publisher(binding.target, self.message_type, queue_size=10)

    def live_type(self) -> Optional[str]:
        """Return the type that other nodes use on the topic; None without other nodes."""
        return _topic_type(self._binding.target)

    def carry_out(self, message: Any, is_to_end: IsToEnd, on_feedback: Callable[[Any], None]) -> ForwardedEnd:
        """Publish when there is a subscriber."""
        end_s = time.monotonic() + self._binding.server_timeout_s
        while self._publisher.get_num_connections() == 0:
            if is_to_end():
                return ForwardedEnd(GoalStatus.PREEMPTED, "")
            if time.monotonic() >= end_s:
                return ForwardedEnd(
                    GoalStatus.ABORTED,
                    f"nobody listens to {self._binding.target} (waited {self._binding.server_timeout_s:g} s)",
                )
            time.sleep(0.01)
        self._publisher.publish(message)
        return ForwardedEnd(GoalStatus.SUCCEEDED, "")


TARGET_OF_KIND = {Kind.ACTION: ActionTarget, Kind.SERVICE: ServiceTarget, Kind.TOPIC: TopicTarget}


def _message_class(type_name: str) -> Any:
    message_class = roslib.message.get_message_class(type_name)
    if message_class is None:
        raise UnknownType(f"there is no message type {type_name}; is its package built and sourced?")
    return message_class


def _topic_type(topic: str, *, is_published: bool = False) -> Optional[str]:
    """Return the type of a topic that other nodes use, or publish; None without such nodes."""
    wanted = rospy.resolve_name(topic)
    published, subscribed, _ = rosgraph.Master(rospy.get_name()).getSystemState()
    ends = published if is_published else published + subscribed
    others = {node for name, nodes in ends if name == wanted for node in nodes if node != rospy.get_name()}
    if not others:
        return None
    return dict(rosgraph.Master(rospy.get_name()).getTopicTypes()).get(wanted)
