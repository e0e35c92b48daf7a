#!/usr/bin/env python3
"""Compares "until ..." with a bare subscriber: from the moment when the condition holds to the cancel of the goal.

The source stamps its message; a bare subscriber in another process answers the same message. The condition goes through
a `ConditionServer` and the executor, which cancels the goal of the running clause. Both are measured in each turn.
"""

import os
import sys
import time
from typing import Dict, List

from measuring.arrivals import Arrivals, quantiles, wait_for_connections
from measuring.own_graph import OwnGraph

START_TIMEOUT_S = 60.0
ANSWER_TIMEOUT_S = 20.0
SETTLE_S = 0.1
COUNT, WARM_UP = 100, 5
#: What "until" may take at most, 99 times of 100; milliseconds.
ALLOWED_MS = 300.0


def relay() -> None:
    """The bare subscriber: answer each message of the source."""
    import rospy
    from std_msgs.msg import Header

    rospy.init_node("bare_subscriber")
    back = rospy.Publisher("bare_back", Header, queue_size=10)
    rospy.Subscriber("source", Header, back.publish)
    rospy.spin()


def watcher() -> None:
    """The server of the condition: it holds when the source has said so since the goal began."""
    import rospy
    from std_msgs.msg import Header

    from rfnserver import ConditionServer, Observed

    rospy.init_node("watcher")
    last: List[Header] = []
    server = ConditionServer(
        "watching",
        lambda frame: (
            Observed(True, last[-1].stamp)
            if last and last[-1].frame_id == frame["goal"].text
            else Observed(False, rospy.Time.now())
        ),
    )

    def hear(message: Header) -> None:
        last[:] = [message]
        server.changed()

    rospy.Subscriber("source", Header, hear, tcp_nodelay=True)
    server.start()
    rospy.spin()


class Measurement:
    """The source, and the server whose goal is cancelled."""

    def __init__(self) -> None:
        """Connect to everything; returns when all of it is up."""
        import actionlib
        import rospy
        from roboframenet_msgs.msg import CommandPlan, FilledSemanticFrameAction, StageEvent
        from std_msgs.msg import Header

        rospy.init_node("measuring")
        self._arrivals = Arrivals(ANSWER_TIMEOUT_S)
        self._source = rospy.Publisher("source", Header, queue_size=10, tcp_nodelay=True)
        self._plans = rospy.Publisher("command_plan", CommandPlan, queue_size=10)
        self._server = actionlib.ActionServer(
            "driving", FilledSemanticFrameAction, self._begin, self._cancel, auto_start=False
        )
        self._server.start()
        self._subscribers = [
            rospy.Subscriber("bare_back", Header, lambda message: self._arrivals.note("bare subscriber")),
            rospy.Subscriber("stage_events", StageEvent, lambda event: event.is_final and self._arrivals.note("reply")),
        ]
        wait_for_connections(self._missing, START_TIMEOUT_S)

    def _missing(self) -> List[str]:
        missing = [one.name for one in (self._plans, *self._subscribers) if not one.get_num_connections()]
        # The watcher and the bare subscriber hear the source.
        return missing if self._source.get_num_connections() >= 2 else [*missing, self._source.name]

    def _begin(self, handle: object) -> None:
        handle.set_accepted()  # type: ignore[attr-defined]
        self._arrivals.note("begun")

    def _cancel(self, handle: object) -> None:
        self._arrivals.note("until")
        handle.set_canceled()  # type: ignore[attr-defined]

    def turn(self, number: int) -> Dict[str, float]:
        """Milliseconds from the message of the source to the cancel, and to the answer of the bare subscriber."""
        import rospy
        from roboframenet_msgs import msg
        from std_msgs.msg import Header

        def candidate(frame: str, server: str) -> msg.PlanCandidate:
            goal = msg.FilledFrameElement(name="goal", argument=str(number))
            filled = msg.FilledSemanticFrame(name=frame, action_server_topics=[server], frame_elements=[goal])
            return msg.PlanCandidate(frames=[filled], coverage=1.0)

        nodes = [
            msg.PlanNode(kind=msg.PlanNode.UNTIL, label="drive until it is so", children=[1, 2]),
            msg.PlanNode(kind=msg.PlanNode.CONDITION, label="it is so", candidates=[candidate("being", "watching")]),
            msg.PlanNode(kind=msg.PlanNode.DO, label="drive", candidates=[candidate("driving", "driving")]),
        ]
        self._arrivals.clear()
        command = msg.Command(id=f"until_{number}", text="drive until it is so", stamp=rospy.Time.now())
        self._plans.publish(msg.CommandPlan(command=command, plan=msg.Plan(nodes=nodes)))
        self._arrivals.after(0.0, ["begun"])
        time.sleep(SETTLE_S)
        start_s = time.monotonic()
        self._source.publish(Header(stamp=rospy.Time.now(), frame_id=str(number)))
        return self._arrivals.after(start_s, ["until", "bare subscriber", "reply"])


def measure(count: int) -> int:
    """Print the table."""
    import rospy

    try:
        measurement = Measurement()
        turns = [measurement.turn(number) for number in range(WARM_UP + count)][WARM_UP:]
        print(f"{'condition true to':24}{'p50 ms':>10}{'p99 ms':>10}   of {count}")
        for what, name in (("bare subscriber", "bare subscriber"), ("until", "cancel of the goal")):
            p50, p99 = quantiles([turn[what] for turn in turns])
            print(f"{name:24}{p50:10.2f}{p99:10.2f}")
        is_late = p99 > ALLOWED_MS
        print(f"{'allowed':24}{'':10}{ALLOWED_MS:10.2f}   {'exceeded' if is_late else 'kept'}")
        return int(is_late)
    finally:
        # A thread of actionlib would keep the process alive.
        rospy.signal_shutdown("done")


def main(count: int) -> int:
    """Start the executor, the source's other listeners and the measurement."""
    own = [sys.executable, os.path.abspath(__file__)]
    with OwnGraph() as graph:
        graph.start_master()
        for command in (["rosrun", "executor", "executor"], [*own, "relay"], [*own, "watcher"]):
            graph.start(command)
        return graph.run([*own, "measure", str(count)])


if __name__ == "__main__":
    roles = {"relay": relay, "watcher": watcher}
    if sys.argv[1:2] == ["measure"]:
        sys.exit(measure(int(sys.argv[2])))
    elif sys.argv[1:2] and sys.argv[1] in roles:
        roles[sys.argv[1]]()
    else:
        sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else COUNT))
