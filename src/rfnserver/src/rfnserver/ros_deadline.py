"""Service calls that end: rospy's own wait for ever when the other side hangs."""
import queue
import threading
from typing import Any, Tuple

import rospy


class ServiceError(RuntimeError):
    """A service was not there, did not answer in time, or failed; the message says which."""


def call_service(name: str, service_type: Any, *, timeout_s: float, **request: Any) -> Any:
    """Call a service with a deadline.

    Args:
        name: of the service
        service_type: its class
        timeout_s: how long to wait for the service to be there, and then again for the answer
        request: its fields
    Returns:
        the response
    Raises:
        ServiceError: no service, no answer, or an error of the service
    """
    try:
        rospy.wait_for_service(name, timeout=timeout_s)
    except rospy.ROSException as error:
        raise ServiceError(f"the service {name} is not there (waited {timeout_s:g} s)") from error
    answers: "queue.Queue[Tuple[bool, Any]]" = queue.Queue()

    def call() -> None:
        try:
            answers.put((True, rospy.ServiceProxy(name, service_type)(**request)))
        except rospy.ServiceException as error:
            answers.put((False, error))

    # A daemon: a call that never comes back must not keep the process alive.
    threading.Thread(target=call, name=f"call of {name}", daemon=True).start()
    try:
        is_answer, answer = answers.get(timeout=timeout_s)
    except queue.Empty:
        raise ServiceError(f"the service {name} did not answer within {timeout_s:g} s") from None
    if not is_answer:
        raise ServiceError(f"the service {name} failed: {answer}")
    return answer
