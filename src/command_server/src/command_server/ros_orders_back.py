"""Whether an utterance takes back the standing order to which the last reply was given."""

import rospy
from roboframenet_msgs.msg import Reply

from command_server.orders_back import takes_order_back


def takes_back(text: str, last: Reply, *, is_free: bool) -> bool:
    """See :func:`command_server.orders_back.takes_order_back`.

    Args:
        text: as it was said
        last: the last reply
        is_free: whether no command is open
    """
    age_s = (rospy.Time.now() - last.stamp).to_sec()
    return takes_order_back(text, is_free=is_free, stage=last.stage, outcome=last.outcome, age_s=age_s)
