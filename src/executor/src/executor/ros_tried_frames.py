"""Tells what became of each frame that was given to a server."""

import rospy
from roboframenet_msgs.msg import Command, TriedFrame

from executor.goal_tracking import Goal, Outcome
from typed_arguments import FilledFrame
from typed_arguments.ros_messages import frame_to_message, to_message

_OUTCOME_OF = {Outcome.SUCCEEDED: TriedFrame.SUCCEEDED, Outcome.FAILED: TriedFrame.FAILED}


def tried_frame(command: Command, frame: FilledFrame, clause: int, goal: Goal, took_s: float) -> TriedFrame:
    """Return the message about a goal that has ended.

    Args:
        command: of which it was a part
        frame: that was to be carried out
        clause: number of the clause in the plan
        goal: how it ended
        took_s: from the beginning to now, seconds
    """
    took = rospy.Duration.from_sec(took_s)
    outcome = TriedFrame.ENDED_BY_OTHERS
    if goal.outcome is not None and not goal.is_withheld:
        outcome = _OUTCOME_OF.get(goal.outcome, TriedFrame.ENDED_BY_OTHERS)
    # A clock that was set back, or has just begun, knows no time before 0.
    began_s = max(0.0, rospy.Time.now().to_sec() - took_s)
    return TriedFrame(
        command=command,
        clause=clause,
        frame=frame_to_message(frame),
        arguments=[to_message(argument) for argument in frame.arguments],
        began=rospy.Time.from_sec(began_s),
        took=took,
        outcome=outcome,
        reason=goal.reason,
    )
