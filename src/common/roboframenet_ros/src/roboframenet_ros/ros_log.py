"""Log calls that never wait for the master."""

import logging
import threading
import time

import rospy

from roboframenet_ros.log_thread import LogThread, put_threads_before

_LAST_WORDS_TIMEOUT_S = 0.5
# Whether log messages name no topics. rospy asks for it at each log call, and keeps only a value that is set.
_TOPICS_PARAMETER = "/rosout_disable_topics_generation"


def log_from_threads() -> None:
    """Have threads write the log of this node, so that no log call waits; call it after ``rospy.init_node``.

    rospy asks the master about ``/rosout_disable_topics_generation`` at each log call, without a deadline: with a
    master that hangs, a node stands still at the next one. While nobody has set the parameter, each call asks again,
    and the other calls of the node to the master wait behind it; so its default is set.
    """
    logger = logging.getLogger("rosout")
    is_new = not any(isinstance(handler, LogThread) for handler in logger.handlers)
    put_threads_before(logger)
    if is_new:
        rospy.on_shutdown(_wait_for_last_words)
        # A daemon: a master that hangs must not keep the process alive.
        threading.Thread(target=_set_default, name="log_parameter", daemon=True).start()


def _set_default() -> None:
    try:
        if not rospy.has_param(_TOPICS_PARAMETER):
            rospy.set_param(_TOPICS_PARAMETER, False)
    except Exception as error:  # boundary: the master may be away in any way that XML-RPC knows
        rospy.logdebug("%s is not set: %s", _TOPICS_PARAMETER, error)


def _wait_for_last_words() -> None:
    end_s = time.monotonic() + _LAST_WORDS_TIMEOUT_S
    for handler in logging.getLogger("rosout").handlers:
        if isinstance(handler, LogThread):
            handler.wait_until_written(timeout_s=max(0.0, end_s - time.monotonic()))
