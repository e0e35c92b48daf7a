"""``rfn say``: sends a sentence to the action ``command`` and shows the stages as they report."""

import argparse
import queue
import sys
import time
from typing import Optional, Tuple, Union

import actionlib
import rosgraph
import rospy
from roboframenet_msgs.msg import ExecuteCommandAction, ExecuteCommandFeedback, ExecuteCommandGoal, Reply

from roboframenet_ros.ros_waiting import wait_for_action_server
from roboframenet_tools.saying import (
    EXIT_STATUS,
    NO_REPLY,
    Answer,
    Outcome,
    Stage,
    format_answer,
    format_stage,
    is_news,
)

#: Period in which a missing master is looked for, seconds.
_POLL_S = 0.2
EXAMPLES = """examples:
  rfn say "Turn left 120 degrees."
  rfn say --json --timeout 20 "Go to the office."

exit status: 0 done, 1 failed, 2 wrong usage, 3 refused, 4 needs information, 5 superseded, 6 no reply
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn say``."""
    parser.epilog = EXAMPLES
    parser.add_argument("text", nargs="+", help="the sentence; several words are joined by blanks")
    parser.add_argument("--json", action="store_true", help="one JSON object in each line: events, then the reply")
    parser.add_argument(
        "--timeout",
        type=float,
        default=120.0,
        metavar="SECONDS",
        help="how long to wait for the reply (default 120); then the command is cancelled",
    )
    parser.add_argument(
        "--wait",
        type=float,
        default=10.0,
        metavar="SECONDS",
        help="how long to wait for the master, and again for the command server (default 10)",
    )


def run(arguments: argparse.Namespace) -> int:
    """Say the sentence; return the exit status."""
    end = time.monotonic() + arguments.wait
    # Without a master, init_node would try for ever.
    while not rosgraph.is_master_online():
        if time.monotonic() >= end:
            return _complain(
                f"no ROS master at {rosgraph.get_master_uri()} within {arguments.wait:g} s: is the pipeline up "
                "('make run'), and ROS_MASTER_URI right?"
            )
        time.sleep(_POLL_S)
    try:
        rospy.init_node("rfn_say", anonymous=True, disable_signals=True)
    except rospy.ROSException as error:
        return _complain(f"no ROS master: {error}")
    client = actionlib.ActionClient("command", ExecuteCommandAction)
    # The start of the node may have taken most of the time on a busy machine.
    if not wait_for_action_server(client, max(_POLL_S, arguments.wait)):
        return _complain(f"no command server within {arguments.wait:g} s: is the pipeline up ('make run')?")
    arrived: queue.Queue[Union[Stage, Tuple[int, Reply]]] = queue.Queue()

    def on_transition(handle: actionlib.ClientGoalHandle) -> None:
        if handle.get_comm_state() == actionlib.CommState.DONE:
            result = handle.get_result()
            arrived.put((handle.get_terminal_state(), result.reply if result else Reply()))

    def on_feedback(_handle: actionlib.ClientGoalHandle, feedback: ExecuteCommandFeedback) -> None:
        arrived.put(Stage(stage=feedback.event.stage, sentence=feedback.event.sentence))

    # actionlib keeps a weak reference to the handle only.
    handle = client.send_goal(ExecuteCommandGoal(text=" ".join(arguments.text)), on_transition, on_feedback)
    end = time.monotonic() + arguments.timeout
    before: Optional[Stage] = None
    try:
        while True:
            item = arrived.get(timeout=max(0.01, end - time.monotonic()))
            if isinstance(item, Stage):
                if arguments.json or is_news(item, before):
                    print(format_stage(item, as_json=arguments.json), flush=True)
                before = item
                continue
            return _report(item, as_json=arguments.json)
    except queue.Empty:
        handle.cancel()
        return _complain(f"no reply within {arguments.timeout:g} s; the command was cancelled")
    except KeyboardInterrupt:
        handle.cancel()
        return _complain("cancelled")


def _report(item: Tuple[int, Reply], *, as_json: bool) -> int:
    status, reply = item
    if not reply.command.id:
        return _complain(
            f"the command server ended the goal as {actionlib.TerminalState.to_string(status)} without a reply"
        )
    answer = Answer(
        id=reply.command.id,
        text=reply.command.text,
        outcome=Outcome(reply.outcome),
        stage=reply.stage,
        code=reply.code,
        sentence=reply.sentence,
    )
    print(format_answer(answer, as_json=as_json), flush=True)
    return EXIT_STATUS[answer.outcome]


def _complain(sentence: str) -> int:
    print(f"rfn say: {sentence}", file=sys.stderr)
    return NO_REPLY
