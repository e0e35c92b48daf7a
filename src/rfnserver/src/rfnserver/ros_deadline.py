"""Service calls that end: rospy's own wait for ever when the other side hangs."""

import queue
import threading
from typing import Any, Optional, Tuple

import rospy


class ServiceError(RuntimeError):
    """A service was not there, did not answer in time, or failed; the message says which."""


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
        timeout_s: how long to wait for the service to be there
        answer_timeout_s: how long to wait then for the answer; the same again where it is left out
        message: the request
        request: or its fields
    Returns:
        the response
    Raises:
        ServiceError: no service, no answer, or an error of the service
    """
    answer_timeout_s = timeout_s if answer_timeout_s is None else answer_timeout_s
    try:
        rospy.wait_for_service(name, timeout=timeout_s)
    except rospy.ROSException as error:
        raise ServiceError(f"the service {name} is not there (waited {timeout_s:g} s)") from error
    answers: queue.Queue[Tuple[bool, Any]] = queue.Queue()

    def call() -> None:
        try:
            proxy = rospy.ServiceProxy(name, service_type)
            answers.put((True, proxy(**request) if message is None else proxy(message)))
        except rospy.ServiceException as error:
            answers.put((False, error))

    # A daemon: a call that never comes back must not keep the process alive.
    threading.Thread(target=call, name=f"call of {name}", daemon=True).start()
    try:
        is_answer, answer = answers.get(timeout=answer_timeout_s)
    except queue.Empty:
        raise ServiceError(f"the service {name} did not answer within {answer_timeout_s:g} s") from None
    if not is_answer:
        raise ServiceError(f"the service {name} failed: {answer}")
    return answer
