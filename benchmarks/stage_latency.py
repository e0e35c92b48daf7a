#!/usr/bin/env python3
"""Compares the way from a text to a goal, stage by stage, with bare hops of rospy and a bare goal of actionlib.

One process sends the texts, takes the goals, and notes when the message of each stage arrives; between ten texts and
the next ten it sends bare ones through a relay, which answers them and sends bare goals. All of it happens in one run,
in turn, so that a machine that is busy is busy for both. A text follows the last one after a pause, as when people
speak; and then at once, as when a program does, when the processor still has in its caches what each process needs. To
listen to the stages costs time, too: first the whole way is measured without that. The text is always the same, so the
parser has its parse already: what is measured is everything else. Further arguments go to the launch file
("150 compact:=true").
"""

import os
import sys
import time
from math import ceil
from typing import Dict, List, Sequence

from measuring.arrivals import Arrivals, quantiles, wait_for_connections
from measuring.own_graph import OwnGraph

START_TIMEOUT_S = 300.0
ANSWER_TIMEOUT_S = 60.0
# What each stage publishes, in the order of the pipeline. The goal comes last.
STAGES = (
    ("command_server", "command_text", "Command"),
    ("stanford_parser_ros", "command_parse", "CommandParse"),
    ("semantic_framer", "command_lexical_units", "CommandLexicalUnits"),
    ("frame_registrar", "command_semantic_frames", "CommandSemanticFrames"),
    ("arbitrator", "command_plan", "CommandPlan"),
)
EXECUTOR, REPLY = "executor", "reply"
HOP, GOAL = "bare hop", "bare goal"
# Before each text, seconds; and what its times are called.
PAUSES = ((0.05, ""), (0.0, ", at once"))
# Texts come in blocks: between those that a program says at once is nothing else.
COUNT, BLOCK, WARM_UP_BLOCKS = 200, 10, 2
# For how long a thread of the measuring process may compute. Python's own 5 ms are as long as a command takes: a thread
# that reads a status would hold up the one that notes an arrival.
SWITCH_INTERVAL_S = 0.0005
#: For how long the bare server tells that a goal is over.
STATUS_LIST_TIMEOUT_S = 0.2
TEXT = "Ping."


def relay() -> None:
    """Answer each bare text, and send a bare goal for each order."""
    import actionlib
    import rospy
    from actionlib.msg import TestAction, TestGoal
    from std_msgs.msg import String

    from roboframenet_ros.ros_waiting import wait_for_action_server

    rospy.init_node("bare_relay")
    client = actionlib.SimpleActionClient("bare_server", TestAction)
    assert wait_for_action_server(client, START_TIMEOUT_S), "the stock server does not answer"
    back = rospy.Publisher("bare_back", String, queue_size=10)
    rospy.Subscriber("bare_text", String, back.publish)
    rospy.Subscriber("bare_order", String, lambda message: client.send_goal(TestGoal()))
    rospy.spin()


class Measurement:
    """Sends, and notes what arrives when."""

    def __init__(self, frames: Sequence[str] = ("pinging",)) -> None:
        """Connect to everything; returns when all of it is up.

        Args:
            frames: that can be said
        """
        import actionlib
        import roboframenet_msgs.msg
        import rospy
        from actionlib.msg import TestAction
        from std_msgs.msg import String

        from rfnserver import RFNServer

        rospy.init_node("measuring")
        self.pause_s = PAUSES[0][0]
        self._arrivals = Arrivals(ANSWER_TIMEOUT_S)
        # Otherwise each status tells of hundreds of goals that are over, and this process would do little else.
        rospy.set_param("bare_server/status_list_timeout", STATUS_LIST_TIMEOUT_S)
        self._bare_server = actionlib.SimpleActionServer(
            "bare_server", TestAction, lambda goal: self._take_bare_goal(), auto_start=False
        )
        self._bare_server.start()
        self._server = RFNServer("measured", lambda frame: self._arrivals.note(EXECUTOR))
        self._server.start()
        self._publishers = {
            topic: rospy.Publisher(topic, String, queue_size=10) for topic in ("text", "bare_text", "bare_order")
        }
        self._subscribers = [
            rospy.Subscriber("bare_back", String, lambda message: self._arrivals.note(HOP)),
            rospy.Subscriber("reply", roboframenet_msgs.msg.Reply, lambda message: self._arrivals.note(REPLY)),
        ]
        for service in ("register_with_frame", "add_lexical_unit"):
            rospy.wait_for_service(service, timeout=START_TIMEOUT_S)
        for frame in frames:
            if not self._server.register_with_frame(frame):
                raise SystemExit(self._server.last_error)
        # Only to see whether the parser listens.
        self._publishers["command_text"] = rospy.Publisher("command_text", roboframenet_msgs.msg.Command, queue_size=1)
        wait_for_connections(self._missing, START_TIMEOUT_S)

    def _missing(self) -> List[str]:
        missing = [topic.name for topic in self._subscribers if not topic.get_num_connections()]
        # The command server and the stop server hear a text.
        return missing + [
            name
            for name, publisher in self._publishers.items()
            if publisher.get_num_connections() < (2 if name == "text" else 1)
        ]

    def observe(self) -> None:
        """Listen to each stage from now on."""
        import roboframenet_msgs.msg
        import rospy

        self._subscribers += [
            rospy.Subscriber(
                topic, getattr(roboframenet_msgs.msg, kind), lambda _, stage=stage: self._arrivals.note(stage)
            )
            for stage, topic, kind in STAGES
        ]
        wait_for_connections(self._missing, START_TIMEOUT_S)

    def _take_bare_goal(self) -> None:
        self._arrivals.note(GOAL)
        self._bare_server.set_succeeded()

    def _send(self, topic: str, text: str, until: Sequence[str]) -> Dict[str, float]:
        """Publish a text; return the milliseconds after which each thing was seen."""
        from std_msgs.msg import String

        time.sleep(self.pause_s)
        self._arrivals.clear()
        start_s = time.monotonic()
        self._publishers[topic].publish(String(data=text))
        return self._arrivals.after(start_s, until)

    def bare(self) -> Dict[str, float]:
        """Milliseconds of a bare hop, of a bare goal, and of as many of them as the pipeline has."""
        hop = self._send("bare_text", "", [HOP])[HOP] / 2.0
        goal = self._send("bare_order", "", [GOAL])[GOAL] - hop
        return {HOP: hop, GOAL: goal, "floor": len(STAGES) * hop + goal}

    def to_goal_ms(self, text: str = TEXT) -> float:
        """Milliseconds from a text to its goal."""
        return self._send("text", text, [EXECUTOR, REPLY])[EXECUTOR]

    def whole(self) -> Dict[str, float]:
        """Milliseconds from the same text to its goal."""
        return {"text to goal": self.to_goal_ms()}

    def stages(self) -> Dict[str, float]:
        """Milliseconds of each stage, from the message of the last one to its own."""
        stages = [*(stage for stage, _, _ in STAGES), EXECUTOR]
        seen = self._send("text", TEXT, [*stages, REPLY])
        times, last = {}, 0.0
        for stage in stages:
            times[stage], last = seen[stage] - last, seen[stage]
        return {**times, "text to goal, observed": last}


def measure(count: int) -> int:
    """Print the table."""
    import rospy

    sys.setswitchinterval(SWITCH_INTERVAL_S)
    try:
        return print_table(Measurement(), count)
    finally:
        # A thread of actionlib would keep the process alive.
        rospy.signal_shutdown("done")


def print_table(measurement: Measurement, count: int) -> int:
    """Measure and print."""
    all_times: Dict[str, List[float]] = {}
    blocks = ceil(count / BLOCK)
    for measures in ((measurement.bare, measurement.whole), (measurement.bare, measurement.stages)):
        if measurement.stages in measures:
            measurement.observe()
        for measurement.pause_s, suffix in PAUSES:
            for number in range(WARM_UP_BLOCKS + blocks):
                for measure_one in measures:
                    # What the block before has left in the caches is not what a text leaves.
                    measure_one()
                    for what, ms in (item for _ in range(BLOCK) for item in measure_one().items()):
                        if number >= WARM_UP_BLOCKS:
                            all_times.setdefault(what + suffix, []).append(ms)
    print(f"{'':34}{'p50 ms':>10}{'p99 ms':>10}   of {blocks * BLOCK}")
    for _, suffix in PAUSES:
        hop, floor = (quantiles(all_times[what + suffix])[0] for what in (HOP, "floor"))
        for what in (what for what in all_times if what.endswith(PAUSES[1][1]) == bool(suffix)):
            p50, p99 = quantiles(all_times[what])
            beside = f"{p50 / floor:6.1f} floors" if what.startswith("text") else f"{p50 / hop:6.1f} bare hops"
            print(f"{what:34}{p50:10.2f}{p99:10.2f}   {beside}")
    return 0


def main(count: int, launch_arguments: Sequence[str]) -> int:
    """Start the pipeline, the relay and the measurement."""
    launch = ["roboframenet_bringup", "pipeline.launch", *launch_arguments]
    with OwnGraph() as graph:
        graph.start(["roslaunch", "-p", str(graph.port), *launch])
        graph.start([sys.executable, os.path.abspath(__file__), "relay"])
        return graph.run([sys.executable, os.path.abspath(__file__), "measure", str(count)])


if __name__ == "__main__":
    if sys.argv[1:2] == ["relay"]:
        relay()
    elif sys.argv[1:2] == ["measure"]:
        sys.exit(measure(int(sys.argv[2])))
    else:
        sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else COUNT, sys.argv[2:]))
