#!/usr/bin/env python3
"""Measures the simulation of the home: what it costs while nothing happens, and how fast it runs on one core.

Idle is measured in real time, beside a bare rospy node in the same seconds. Then the home runs on one core, as fast as
it can and at most so many times as fast as real time, while its robot drives from room to room.
"""

import os
import sys
import time

import psutil
from measuring.own_graph import BARE, OwnGraph
from measuring.processor_time import pid_of, processor_s

START_TIMEOUT_S = 60.0
SETTLE_S = 5.0
IDLE_S = 60.0
DRIVE_S = 30.0
#: Times real time that are asked for.
RATE_FACTOR = 50.0
ALLOWED_PERCENT, WANTED_FACTOR = 5.0, 10.0
ROOMS = ("kitchen", "office", "bedroom", "garage")
HOME = "home_sim"


def idle() -> int:
    """Print what the home and a bare node take; returns whether it is too much."""
    import rospy
    from std_msgs.msg import String

    from roboframenet_ros.ros_waiting import wait_for_message

    rospy.init_node("measuring", disable_signals=True)
    wait_for_message("home/truth", String, START_TIMEOUT_S)
    pids = {name: pid_of(f"/{name}") for name in (HOME, BARE)}
    rospy.signal_shutdown("nobody hears the home")
    time.sleep(SETTLE_S)
    before = {name: processor_s(pid) for name, pid in pids.items()}
    time.sleep(IDLE_S)
    percent = {name: 100.0 * (processor_s(pid) - before[name]) / IDLE_S for name, pid in pids.items()}
    print(f"idle                 {percent[HOME]:6.2f} % of a core, at most {ALLOWED_PERCENT:g}", flush=True)
    print(f"bare rospy node      {percent[BARE]:6.2f} %   load {os.getloadavg()[0]:.1f}", flush=True)
    return int(percent[HOME] > ALLOWED_PERCENT)


def drive() -> int:
    """Print how fast the home runs while the robot drives; returns whether it is too slow."""
    import actionlib
    import rospy
    from roboframenet_msgs.msg import (
        FilledFrameElement,
        FilledSemanticFrame,
        FilledSemanticFrameAction,
        FilledSemanticFrameGoal,
    )

    from roboframenet_ros.ros_waiting import wait_for_action_server

    rospy.init_node("measuring", disable_signals=True)
    client = actionlib.SimpleActionClient("home/act", FilledSemanticFrameAction)
    if not wait_for_action_server(client, START_TIMEOUT_S):
        raise SystemExit("home/act does not answer")
    pid = pid_of(f"/{HOME}")
    psutil.Process(pid).cpu_affinity([0])
    begin_s, begin, before_s = time.monotonic(), rospy.Time.now(), processor_s(pid)
    arrived = 0
    while time.monotonic() < begin_s + DRIVE_S:
        goal = FilledFrameElement(name="goal", argument=ROOMS[arrived % len(ROOMS)])
        client.send_goal(FilledSemanticFrameGoal(frame=FilledSemanticFrame(name="go", frame_elements=[goal])))
        with client.done_condition:
            is_there = client.done_condition.wait_for(
                lambda: client.simple_state == actionlib.SimpleGoalState.DONE, DRIVE_S
            )
        if not is_there:
            raise SystemExit(f"the robot does not arrive in the {goal.argument}")
        arrived += 1
    real_s, home_s = time.monotonic() - begin_s, (rospy.Time.now() - begin).to_sec()
    used_s = processor_s(pid) - before_s
    print(
        f"drives on one core   {home_s / real_s:6.1f} times as fast as real time, at least {WANTED_FACTOR:g}; "
        f"{arrived} rooms in {home_s:.0f} s of the home, {real_s:.0f} s, {used_s:.0f} s of processor time; "
        f"load {os.getloadavg()[0]:.1f}"
    )
    rospy.signal_shutdown("done")
    return int(home_s / real_s < WANTED_FACTOR)


def main() -> int:
    """Start a home in real time, and a fast one, and measure each."""
    worker = [sys.executable, os.path.abspath(__file__)]
    with OwnGraph() as graph:
        graph.start_master()
        graph.start_bare_node()
        graph.start(["rosrun", "roboframenet_sim", HOME, "_rate_hz:=20"])
        status = graph.run([*worker, "idle"])
    with OwnGraph() as graph:
        graph.start_master()
        graph.run(["rosparam", "set", "/use_sim_time", "true"])
        graph.start(["rosrun", "roboframenet_sim", HOME, "_rate_hz:=10", f"_rate_factor:={RATE_FACTOR}"])
        return graph.run([*worker, "drive"]) or status


if __name__ == "__main__":
    programs = {"idle": idle, "drive": drive}
    raise SystemExit(programs[sys.argv[1]]() if sys.argv[1:] and sys.argv[1] in programs else main())
