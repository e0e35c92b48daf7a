#!/usr/bin/python3
"""A server that ignores cancels and drives on, as some drivers do."""

import rospy
from geometry_msgs.msg import Twist

from rfnserver import RFNServer


def main() -> None:
    """Run the node."""
    rospy.init_node("patrol")
    velocity = rospy.Publisher("cmd_vel", Twist, queue_size=1)
    twist = Twist()
    twist.linear.x = 0.1

    def patrol(frame):
        duration_s = float({element.name: element.argument for element in frame.frame_elements}["duration"])
        rate = rospy.Rate(15.0)
        end = rospy.Time.now() + rospy.Duration(duration_s)
        while rospy.Time.now() < end and not rospy.is_shutdown():
            velocity.publish(twist)
            rate.sleep()
        velocity.publish(Twist())

    server = RFNServer("patrolling", patrol)
    server.register_with_frame("patrolling")
    server.start()
    rospy.spin()


main()
