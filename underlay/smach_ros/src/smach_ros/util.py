"""Preemption of a machine when the program ends."""
import rospy
import smach


def set_preempt_handler(sc: smach.State) -> None:
    """Ask a state or container to stop when the node shuts down, for example by Ctrl-C."""
    rospy.core.add_client_shutdown_hook(sc.request_preempt)
