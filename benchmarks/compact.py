#!/usr/bin/env python3
"""Measures a simulated Turtlebot in the compact form: memory, the time until it obeys, and what it costs while idle.

Memory is the proportional set size (PSS): what processes share counts once. Processor time is that of the kernel's
account of each process: until the first command was done, and then while idle, beside a bare rospy node.
`compact.py --apart` measures the form of many processes.
"""

import argparse
import os
import sys
import tempfile
import threading
import time
from typing import Dict

import psutil
from measuring.own_graph import BARE, OwnGraph
from measuring.processor_time import processor_s

START_TIMEOUT_S = 120.0
ANSWER_S = 0.5
SETTLE_S = 10.0
IDLE_S = 60.0
PARSER = "stanford_parser_ros"
#: Simulation and rosout stand for hardware and for ROS: they are listed, and do not count as idle.
NOT_OURS = ("turtlebot_sim", "rosout", "rosmaster", "roslaunch", BARE)
ALLOWED_MB, ALLOWED_PARSER_MB = 600.0, 250.0
ALLOWED_READY_S, ALLOWED_PERCENT = 8.0, 1.0


def ready_s(began_s: float) -> float:
    """Say "Ping." until it is done; returns how long that took.

    Raises:
        SystemExit: it is not done in time
    """
    import rospy
    from roboframenet_msgs.msg import Reply
    from std_msgs.msg import String

    is_done = threading.Event()
    text = rospy.Publisher("text", String, queue_size=10)
    subscriber = rospy.Subscriber("reply", Reply, lambda reply: reply.outcome == Reply.DONE and is_done.set())
    while time.monotonic() < began_s + START_TIMEOUT_S:
        text.publish("Ping.")
        if is_done.wait(ANSWER_S):
            took_s = time.monotonic() - began_s
            subscriber.unregister()
            return took_s
    raise SystemExit(f"'Ping.' was not done within {START_TIMEOUT_S:g} s")


def processes() -> Dict[str, psutil.Process]:
    """What runs beside this program, by name of the node or program."""
    found = {}
    for process in psutil.Process(os.getppid()).children(recursive=True):
        words = process.cmdline()
        names = [word.partition(":=")[2] for word in words if word.startswith("__name:=")]
        programs = [os.path.basename(word) for word in words if os.path.basename(word) in (*NOT_OURS, "compact.py")]
        name = (names or programs or [""])[0]
        if name and process.pid != os.getpid():
            found[name] = process
    return found


def measure(began_s: float) -> int:
    """Print the table; returns whether a figure is exceeded."""
    import rospy

    rospy.init_node("measuring")
    try:
        took_s = ready_s(began_s)
        start_s = {name: processor_s(process.pid) for name, process in processes().items()}
        time.sleep(SETTLE_S)
        running = processes()
        before = {name: processor_s(process.pid) for name, process in running.items()}
        time.sleep(IDLE_S)
        percent = {name: 100.0 * (processor_s(one.pid) - before[name]) / IDLE_S for name, one in running.items()}
        memory_mb = {name: process.memory_full_info().pss / 1e6 for name, process in running.items()}
    finally:
        rospy.signal_shutdown("done")
    print(f"{'':24}{'PSS MB':>10}{'idle %':>10}{'start s':>10}   load {os.getloadavg()[0]:.1f}")
    for name in sorted(running, key=lambda one: -memory_mb[one]):
        print(f"{name:24}{memory_mb[name]:10.1f}{percent[name]:10.2f}{start_s.get(name, 0.0):10.2f}")
    print(f"{'processor time of the start':28}{sum(start_s.values()):10.2f} s")
    ours = [name for name in running if name not in NOT_OURS]
    robot = [*ours, "turtlebot_sim"]
    figures = (
        ("all nodes of the robot", sum(memory_mb[name] for name in robot), ALLOWED_MB, "MB"),
        ("the parser", memory_mb[PARSER], ALLOWED_PARSER_MB, "MB"),
        ("start to the first command", took_s, ALLOWED_READY_S, "s"),
        ("idle, without simulation", sum(percent[name] for name in ours), ALLOWED_PERCENT, "% of a core"),
    )
    for what, value, allowed, unit in figures:
        print(f"{what:28}{value:10.2f} {unit}, allowed {allowed:g}: {'kept' if value <= allowed else 'exceeded'}")
    return int(any(value > allowed for _, value, allowed, _ in figures))


def main(compact: bool) -> int:
    """Start a robot, and measure it."""
    worker = [sys.executable, os.path.abspath(__file__)]
    with tempfile.TemporaryDirectory() as folder, OwnGraph() as graph:
        graph.start_master()
        graph.start_bare_node()
        files = [f"{name}_file:={folder}/{name}.sqlite" for name in ("world_memory", "standing_orders")]
        began_s = time.monotonic()
        graph.start(["roslaunch", "roboframenet_bringup", "robot.launch", f"compact:={str(compact).lower()}", *files])
        return graph.run([*worker, "measure", str(began_s)])


if __name__ == "__main__":
    if sys.argv[1:2] == ["measure"]:
        raise SystemExit(measure(float(sys.argv[2])))
    else:
        parser = argparse.ArgumentParser(description=__doc__)
        parser.add_argument("--apart", action="store_true", help="a process for each stage")
        raise SystemExit(main(not parser.parse_args().apart))
