"""Service calls with a deadline: those of rospy wait for ever when the other side hangs."""

from typing import Any, Optional

import rosgraph
import rospy

from roboframenet_ros.deadline import NoAnswer, within

# The wait for a service ends this long after its own time-out, unless the master hangs; seconds.
_SLACK_S = 1.0


class ServiceError(RuntimeError):
    """A service was not available, did not answer in time, or failed; the message says which."""


def call_service(
    name: str,
    service_type: Any,
    *,
    timeout_s: float,
    answer_timeout_s: Optional[float] = None,
    message: Any = None,
    **request: Any,
) -> Any:
    """Call a service with a deadline.

    Args:
        name: of the service
        service_type: its class
        timeout_s: how long to wait for the service to exist
        answer_timeout_s: how long to wait for the answer then; ``timeout_s`` by default
        message: the request; None for one that is made of the fields
        request: fields of the request
    Returns:
        the response
    Raises:
        ServiceError: no service, no answer, or an error of the service
    """
    answer_timeout_s = timeout_s if answer_timeout_s is None else answer_timeout_s
    _wait_for(name, timeout_s)

    def call() -> Any:
        proxy = rospy.ServiceProxy(name, service_type)
        return proxy(**request) if message is None else proxy(message)

    try:
        return within(answer_timeout_s, call, name=f"call of {name}")
    except NoAnswer:
        raise ServiceError(f"the service {name} did not answer within {answer_timeout_s:g} s") from None
    except Exception as error:  # boundary: the service, its node and the request may be at fault in many ways
        raise ServiceError(f"the service {name} failed: {error}") from error


def is_offered(name: str, *, beside: str, timeout_s: float) -> bool:
    """Return whether a node offers a service beside another one, which it offers later.

    The master is asked: a busy node may answer too late, and would seem to lack what it offers.

    Args:
        name: of the service
        beside: service that is waited for
        timeout_s: how long to wait for it, and for the master
    Raises:
        ServiceError: that one is not available, or the master does not answer
    """
    _wait_for(beside, timeout_s)
    master = rosgraph.Master(rospy.get_name())

    def look_up() -> bool:
        try:
            return bool(master.lookupService(rospy.resolve_name(name)))
        except rosgraph.MasterError:
            return False

    try:
        return within(timeout_s, look_up, name=f"look-up of {name}")
    except (NoAnswer, OSError, rosgraph.MasterFailure) as error:
        raise ServiceError(f"the master does not answer: {error}") from error


def _wait_for(name: str, timeout_s: float) -> None:
    """Raises ServiceError if the service does not exist after a time in seconds."""
    try:
        # The wait itself calls the master, which may hang.
        within(timeout_s + _SLACK_S, lambda: rospy.wait_for_service(name, timeout=timeout_s), name=f"wait for {name}")
    except (rospy.ROSException, NoAnswer) as error:
        raise ServiceError(f"the service {name} is not available (waited {timeout_s:g} s)") from error
