"""ServiceState: calls a service."""

import time
from typing import Any, Callable, Iterable, Mapping, Optional

import genpy
import rospy

import smach
from smach_ros.message_mapping import MessageSink, MessageSource

# How often a state that waits for its service asks whether it has to stop.
STOP_POLL_S = 0.5


class ServiceState(smach.State):
    """Ends with succeeded when the service answered, with aborted when it failed or did not appear.

    A request to stop is answered (preempted) until the service is called; a call cannot be taken back. A callback that
    raises or returns something that is not allowed aborts the state, as does a key without a value; it is logged.

    Args:
        service_name: name of the service
        service_spec: its type, for example Empty
        request: the request, when it is known now, or the value of its only field; None for an empty one
        request_cb: called with the userdata and the request so far; changes the request or returns another one
        request_cb_args: more positional arguments of `request_cb`
        request_cb_kwargs: more keyword arguments of `request_cb`
        request_key: userdata key of a whole request
        request_slots: fields of the request that are read from userdata keys of the same names
        response_cb: called with the userdata and the response; returns an outcome, or None for succeeded
        response_cb_args: more positional arguments of `response_cb`
        response_cb_kwargs: more keyword arguments of `response_cb`
        response_key: userdata key under which the whole response is put, after `response_cb`
        response_slots: fields of the response that are put under userdata keys of the same names, after `response_cb`
        input_keys: userdata that the callbacks read
        output_keys: userdata that the callbacks write
        outcomes: more outcomes, which `response_cb` may return
        server_wait_timeout: time that the service gets to appear, after which the state aborts; None for no limit

    Raises:
        InvalidStateError: the request or a field of it does not belong to the service
    """

    def __init__(
        self,
        service_name: str,
        service_spec: type,
        request: Any = None,
        request_cb: Optional[Callable[..., Any]] = None,
        request_cb_args: Iterable[Any] = (),
        request_cb_kwargs: Optional[Mapping[str, Any]] = None,
        request_key: Optional[str] = None,
        request_slots: Iterable[str] = (),
        response_cb: Optional[Callable[..., Optional[str]]] = None,
        response_cb_args: Iterable[Any] = (),
        response_cb_kwargs: Optional[Mapping[str, Any]] = None,
        response_key: Optional[str] = None,
        response_slots: Iterable[str] = (),
        input_keys: Iterable[str] = (),
        output_keys: Iterable[str] = (),
        outcomes: Iterable[str] = (),
        server_wait_timeout: Optional[rospy.Duration] = rospy.Duration(60.0),
    ) -> None:
        smach.State.__init__(
            self, outcomes=["succeeded", "aborted", "preempted"], input_keys=input_keys, output_keys=output_keys
        )
        self.register_outcomes(outcomes)
        self._request_source = MessageSource(
            "request",
            service_spec._request_class,
            request,
            request_key,
            request_slots,
            request_cb,
            request_cb_args,
            request_cb_kwargs,
            takes_values=True,
        )
        self._response_sink = MessageSink(
            "response",
            service_spec._response_class,
            response_key,
            response_slots,
            response_cb,
            response_cb_args,
            response_cb_kwargs,
        )
        self._request_source.register(self)
        self._response_sink.register(self)
        self._service_name = service_name
        self._service_spec = service_spec
        self._server_wait_timeout_s = None if server_wait_timeout is None else server_wait_timeout.to_sec()

    def execute(self, ud: Any) -> str:
        """Wait for the service, call it and hand on its response."""
        is_there = self._wait_for_service()
        if self.preempt_requested():
            self.service_preempt()
            return "preempted"
        if not is_there:
            rospy.logwarn("Service state aborts: no service '%s'", self._service_name)
            return "aborted"
        try:
            request = self._request_source.build(ud)
            response = rospy.ServiceProxy(self._service_name, self._service_spec)(request)
            return self._response_sink.store(self, ud, response) or "succeeded"
        except (
            rospy.ServiceException,
            rospy.ROSException,
            genpy.SerializationError,
            smach.InvalidUserCodeError,
        ) as error:
            rospy.logerr("The state of the service '%s' aborts: %s", self._service_name, error)
            return "aborted"

    def _wait_for_service(self) -> bool:
        """Wait until the service is there, the time is over, or somebody asks the state to stop."""
        started_at = time.monotonic()
        while not self.preempt_requested() and not rospy.is_shutdown():
            try:
                rospy.wait_for_service(self._service_name, timeout=STOP_POLL_S)
                return True
            except rospy.ROSException:
                if self._server_wait_timeout_s is not None and (
                    time.monotonic() - started_at >= self._server_wait_timeout_s
                ):
                    break
        return False
