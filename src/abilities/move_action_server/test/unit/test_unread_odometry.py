"""Odometry that is read late has the fields that other subscribers in the process ask for."""

import io

from nav_msgs.msg import Odometry

from move_action_server.ros_odometry import UnreadOdometry, sample_of


def sent() -> bytes:
    message = Odometry(child_frame_id="base_link")
    message.header.frame_id = "odom"
    message.pose.pose.position.x, message.pose.pose.orientation.w = 2.5, 1.0
    message.twist.twist.linear.x = 0.3
    buffer = io.BytesIO()
    message.serialize(buffer)
    return buffer.getvalue()


def test_unread_message_is_read_when_a_field_is_asked_for() -> None:
    unread, plain = UnreadOdometry().deserialize(sent()), Odometry().deserialize(sent())
    assert unread.twist.twist.linear.x == 0.3
    assert (unread.header.frame_id, unread.child_frame_id, unread.pose) == ("odom", "base_link", plain.pose)
    assert sample_of(unread) == sample_of(plain)


def test_unread_message_that_was_never_sent_is_empty() -> None:
    assert UnreadOdometry().pose == Odometry().pose
