#!/usr/bin/env python3
"""Measures what 100 standing orders cost while nothing happens, beside a bare rospy node in the same seconds.

Half of the orders wait for a time of the clock, half for a condition that a `ConditionServer` watches. Processor time
is that of the kernel's account of each process.
"""

import os
import sys
import tempfile
import time
from typing import Any, Callable, List

from measuring.own_graph import BARE, OwnGraph
from measuring.processor_time import pid_of, processor_s

START_TIMEOUT_S = 60.0
SETTLE_S = 10.0
IDLE_S = 60.0
ORDERS = 100
#: What the orders may take at most, per cent of a core.
ALLOWED_PERCENT = 2.0


def watcher() -> None:
    """The server of the conditions: none of them holds."""
    import rospy

    from rfnserver import ConditionServer, Observed

    rospy.init_node("watcher")
    server = ConditionServer("watching", lambda frame: Observed(False, rospy.Time.now()))
    server.start()
    rospy.spin()


def plan_of(number: int) -> Any:
    """The plan of an order: for a time in some hours, or for a condition."""
    import rospy
    from roboframenet_msgs import msg

    def clause(kind: int, label: str, server: str) -> msg.PlanNode:
        goal = msg.FilledFrameElement(name="goal", argument=str(number))
        frame = msg.FilledSemanticFrame(name=server, action_server_topics=[server], frame_elements=[goal])
        return msg.PlanNode(kind=kind, label=label, candidates=[msg.PlanCandidate(frames=[frame], coverage=1.0)])

    deed = clause(msg.PlanNode.DO, f"ping {number}", "pinging")
    if number % 2:
        condition = clause(msg.PlanNode.CONDITION, f"bell {number} rings", "watching")
        root = msg.PlanNode(kind=msg.PlanNode.WHENEVER, label=deed.label, children=[1, 2])
        return msg.Plan(nodes=[root, condition, deed])
    hours = 1 + number
    when = msg.TimeExpression(kind="time", words="then", value=f"PT{hours}H", offset=rospy.Duration(3600.0 * hours))
    return msg.Plan(nodes=[msg.PlanNode(kind=msg.PlanNode.AT, label=deed.label, children=[1], when=when), deed])


def wait_for(is_true: Callable[[], bool], what: str) -> None:
    """Wait until something is true.

    Raises:
        SystemExit: it is not true in time
    """
    end_s = time.monotonic() + START_TIMEOUT_S
    while not is_true():
        if time.monotonic() > end_s:
            raise SystemExit(f"it did not come true in {START_TIMEOUT_S:g} s: {what}")
        time.sleep(0.1)


def measure() -> int:
    """Give the orders, wait, and print the table."""
    import rospy
    from roboframenet_msgs.msg import Command, CommandPlan, StandingOrders

    rospy.init_node("measuring")
    kept: List[StandingOrders] = []
    given = rospy.Publisher("command_standing_order", CommandPlan, queue_size=ORDERS)
    subscriber = rospy.Subscriber("standing_orders", StandingOrders, kept.append)
    try:
        wait_for(lambda: bool(given.get_num_connections() and kept), "standing_orders is not there")
        for number in range(ORDERS):
            command = Command(id=f"order_{number}", text=f"ping {number}", stamp=rospy.Time.now())
            given.publish(CommandPlan(command=command, plan=plan_of(number)))
        wait_for(lambda: len(kept[-1].orders) == ORDERS, "not all orders are kept")
        wait_for(lambda: all(order.state == "waits" for order in kept[-1].orders), "an order does not wait")
        subscriber.unregister()
        time.sleep(SETTLE_S)
        pids = {"100 standing orders": pid_of("/standing_orders"), "bare rospy node": pid_of(f"/{BARE}")}
        before = {name: processor_s(pid) for name, pid in pids.items()}
        time.sleep(IDLE_S)
        percent = {name: 100.0 * (processor_s(pid) - before[name]) / IDLE_S for name, pid in pids.items()}
        for name, value in percent.items():
            print(f"{name:24}{value:10.2f} % of a core, in {IDLE_S:g} s")
        is_dear = percent["100 standing orders"] > ALLOWED_PERCENT
        print(f"{'allowed':24}{ALLOWED_PERCENT:10.2f} %   {'exceeded' if is_dear else 'kept'}")
        return int(is_dear)
    finally:
        # A thread of actionlib would keep the process alive.
        rospy.signal_shutdown("done")


def main() -> int:
    """Start a graph of its own, and measure in it."""
    worker = [sys.executable, os.path.abspath(__file__)]
    with OwnGraph() as graph, tempfile.TemporaryDirectory() as folder:
        graph.start_master()
        graph.start_bare_node()
        graph.start([*worker, "watcher"])
        graph.start(["rosrun", "standing_orders", "standing_orders", f"_file:={folder}/orders.sqlite"])
        return graph.run([*worker, "measure"])


if __name__ == "__main__":
    programs = {"watcher": watcher, "measure": measure}
    raise SystemExit(programs[sys.argv[1]]() if sys.argv[1:] and sys.argv[1] in programs else main())
