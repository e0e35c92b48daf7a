"""Log calls that never wait for the master."""

import logging
import time

import rospy

from roboframenet_ros.log_thread import LogThread, put_threads_before

_LAST_WORDS_TIMEOUT_S = 0.5


def log_from_threads() -> None:
    """Have threads write the log of this node, so that no log call waits; call it after ``rospy.init_node``.

    rospy asks the master about ``/rosout_disable_topics_generation`` at each log call, without a deadline: with a
    master that hangs, a node stands still at the next one.
    """
    logger = logging.getLogger("rosout")
    is_new = not any(isinstance(handler, LogThread) for handler in logger.handlers)
    put_threads_before(logger)
    if is_new:
        rospy.on_shutdown(_wait_for_last_words)


def _wait_for_last_words() -> None:
    end_s = time.monotonic() + _LAST_WORDS_TIMEOUT_S
    for handler in logging.getLogger("rosout").handlers:
        if isinstance(handler, LogThread):
            handler.wait_until_written(timeout_s=max(0.0, end_s - time.monotonic()))
