"""Log calls that never wait for the master."""
import logging

import rospy

from roboframenet_ros.log_thread import LogThread, put_thread_before

_LAST_WORDS_TIMEOUT_S = 0.5


def log_from_a_thread() -> None:
    """Have a thread write the log of this node, so that no log call waits; call it after ``rospy.init_node``.

    rospy asks the master about ``/rosout_disable_topics_generation`` at each log call, without a deadline: with a master
    that hangs, a node stands still at the next one.
    """
    logger = logging.getLogger("rosout")
    is_new = not any(isinstance(handler, LogThread) for handler in logger.handlers)
    thread = put_thread_before(logger)
    if is_new:
        rospy.on_shutdown(lambda: thread.wait_until_written(timeout_s=_LAST_WORDS_TIMEOUT_S) or None)
