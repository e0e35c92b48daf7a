#!/usr/bin/env python3
"""Compares RFNServers with stock actionlib servers in one run: the cost of idling, and the rate of goals.

Everything idles at the same time for the same seconds, so that a machine that is busy is busy for all. Processor time
is that of the kernel's account of each process; memory is the proportional set size (shared pages are shared out).
"""

import os
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from contextlib import ExitStack
from pathlib import Path
from typing import Any, Dict, List, Sequence

from measuring.own_graph import free_port

IN_ONE_PROCESS = 200
PROCESSES = 50
HOSTED = 50
ON_DEMAND = 1000
#: The work of starting finishes: ten seconds after it registered, a server looks once whether a file describes its
#: frame meanwhile. None does here.
SETTLE_S = 15.0
IDLE_S = 25.0
GOALS = 400
START_TIMEOUT_S = 600.0
TICKS_PER_S = os.sysconf("SC_CLK_TCK")


# ---- in the measured processes


def serve(kind: str, first: int, count: int) -> None:
    """Run some idle servers of a kind: bare, stock, rfn."""
    import actionlib
    import rospy
    from actionlib_tutorials.msg import FibonacciAction

    from rfnserver import RFNServer

    rospy.init_node(f"{kind}_{first}_{count}")
    servers: List[Any] = []
    for number in range(first, first + count):
        name = f"{kind}_server_{number}_of_{count}"
        if kind == "stock":
            server = actionlib.SimpleActionServer(name, FibonacciAction, execute_cb=lambda goal: None, auto_start=False)
            server.start()
            servers.append(server)
        elif kind == "rfn":
            frame_server = RFNServer(name, lambda frame: None)
            frame_server.start()
            frame_server.register_with_frame("pinging")
            servers.append(frame_server)
    print("ready", flush=True)
    rospy.spin()


def take_goals(kind: str) -> None:
    """Run one server that ends each goal at once."""
    import actionlib
    import rospy
    from actionlib_tutorials.msg import FibonacciAction

    from rfnserver import RFNServer

    rospy.init_node(f"{kind}_goals")
    make = actionlib.SimpleActionServer if kind == "stock" else RFNServer
    server = make(f"{kind}_goals", FibonacciAction, execute_cb=lambda goal: server.set_succeeded(), auto_start=False)
    server.start()
    print("ready", flush=True)
    rospy.spin()


# ---- in the measuring process


class Process:
    """A process that says "ready" and is then measured."""

    def __init__(self, command: Sequence[str]) -> None:
        self._process = subprocess.Popen(
            list(command), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, start_new_session=True
        )
        self.pid = self._process.pid

    def wait_until_ready(self) -> None:
        timer = threading.Timer(START_TIMEOUT_S, self._process.kill)
        timer.start()
        for line in self._process.stdout:
            if line.strip() == "ready":
                timer.cancel()
                return
        raise SystemExit(f"{self._process.args}: it ended before it was ready")

    def cpu_s(self) -> float:
        """Processor time so far, of all its threads."""
        fields = Path(f"/proc/{self.pid}/stat").read_text(encoding="ascii").rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / TICKS_PER_S

    def memory_mib(self) -> float:
        """Proportional set size."""
        text = Path(f"/proc/{self.pid}/smaps_rollup").read_text(encoding="ascii")
        return next(int(line.split()[1]) for line in text.splitlines() if line.startswith("Pss:")) / 1024.0

    def end(self) -> None:
        self._process.terminate()
        try:
            self._process.wait(10.0)
        except subprocess.TimeoutExpired:
            self._process.kill()


def worker(*arguments: object) -> List[str]:
    return [sys.executable, os.path.abspath(__file__)] + [str(argument) for argument in arguments]


def started(stack: ExitStack, commands: Sequence[Sequence[str]]) -> List[Process]:
    """Start processes and wait until all are ready."""
    processes = []
    for command in commands:
        processes.append(Process(command))
        stack.callback(processes[-1].end)
    for process in processes:
        process.wait_until_ready()
    return processes


def report(what: str, ours: float, theirs: float, unit: str, limit: str, is_held: bool) -> bool:
    print(
        f"{what:66} {ours:9.3f} | {theirs:9.3f} {unit:6} ratio {ours / theirs:7.3f}  "
        f"({limit}: {'held' if is_held else 'MISSED'})"
    )
    return is_held


def goals_per_s(name: str) -> float:
    """Goals per second, the next one sent when the one before has ended."""
    import actionlib
    from actionlib_tutorials.msg import FibonacciAction, FibonacciGoal

    from roboframenet_ros.ros_waiting import wait_for_action_server

    client = actionlib.ActionClient(name, FibonacciAction)
    assert wait_for_action_server(client, 30.0), f"{name} does not answer"
    done = threading.Semaphore(0)

    def on_transition(handle: Any) -> None:
        if handle.get_comm_state() == actionlib.CommState.DONE:
            done.release()

    handles = []
    start_s = time.monotonic()
    for _ in range(GOALS):
        handles.append(client.send_goal(FibonacciGoal(order=1), on_transition))
        assert done.acquire(timeout=30.0), "a goal does not end"
        handles.clear()
    return GOALS / (time.monotonic() - start_s)


def on_demand_files(folder: str) -> str:
    """Write a manifest file with many frames; return its path."""
    path = os.path.join(folder, "manifests.yaml")
    with open(path, "w", encoding="utf-8") as file:
        file.write("on_demand:\n")
        file.writelines(
            f"  - {{frame: frame_{number}, server: server_{number}, "
            f"run: {{package: rfnserver, executable: ping, name: ping_{number}}}}}\n"
            for number in range(ON_DEMAND)
        )
    return path


def idle(stack: ExitStack, folder: str) -> bool:
    """Measure the cost of idling."""
    import rospy
    from roboframenet_msgs.msg import FrameServers

    rospy.set_param("/on_demand/files", [on_demand_files(folder)])
    registered: Dict[str, int] = {}
    subscriber = rospy.Subscriber(
        "frame_servers",
        FrameServers,
        lambda message: registered.update(
            on_demand=sum(callback.callback_topic.strip("/") == "on_demand" for callback in message.callbacks)
        ),
    )
    on_demand = Process(["rosrun", "server_hosting", "on_demand"])
    stack.callback(on_demand.end)
    end_s = time.monotonic() + START_TIMEOUT_S
    while registered.get("on_demand", 0) < ON_DEMAND and time.monotonic() < end_s:
        time.sleep(0.2)
    subscriber.unregister()
    print(f"{registered.get('on_demand', 0)} frames on demand are registered", flush=True)
    many = started(stack, [worker("serve", kind, 0, IN_ONE_PROCESS) for kind in ("stock", "rfn")])
    print(f"{IN_ONE_PROCESS} servers of each kind in a process", flush=True)
    hosted = started(stack, [worker("serve", "rfn", 0, HOSTED)])
    single: Dict[str, List[Process]] = {}
    for kind in ("bare", "stock", "rfn"):
        single[kind] = started(stack, [worker("serve", kind, number, 1) for number in range(PROCESSES)])
        print(f"{PROCESSES} processes: {kind}", flush=True)
    groups: Dict[str, List[Process]] = {
        "stock in one": many[:1],
        "rfn in one": many[1:],
        "hosted": hosted,
        "on demand": [on_demand],
        **{f"{kind} alone": processes for kind, processes in single.items()},
    }
    time.sleep(SETTLE_S)
    before = {name: sum(process.cpu_s() for process in group) for name, group in groups.items()}
    time.sleep(IDLE_S)
    cpu = {
        name: 100.0 * (sum(process.cpu_s() for process in group) - before[name]) / IDLE_S
        for name, group in groups.items()
    }
    memory = {name: sum(process.memory_mib() for process in group) for name, group in groups.items()}
    for name in groups:
        print(f"  {name:12} {cpu[name]:8.2f} % of a core  {memory[name]:8.1f} MiB")
    held = [
        report(
            f"{IN_ONE_PROCESS} idle in one process: RFNServer | SimpleActionServer",
            cpu["rfn in one"],
            cpu["stock in one"],
            "% core",
            "at most 0.2",
            cpu["rfn in one"] <= 0.2 * cpu["stock in one"],
        ),
        report(
            f"{PROCESSES} idle, a process each: RFNServer | SimpleActionServer",
            cpu["rfn alone"],
            cpu["stock alone"],
            "% core",
            "at most 0.35",
            cpu["rfn alone"] <= 0.35 * cpu["stock alone"],
        ),
        report(
            f"{HOSTED} RFNServers: one process | a process each",
            memory["hosted"],
            memory["rfn alone"],
            "MiB",
            "at most 1/30",
            memory["hosted"] <= memory["rfn alone"] / 30.0,
        ),
        report(
            f"{ON_DEMAND} frames on demand, one process | one RFNServer process, memory",
            memory["on demand"],
            memory["rfn alone"] / PROCESSES,
            "MiB",
            "one process: at most 2",
            memory["on demand"] <= 2.0 * memory["rfn alone"] / PROCESSES,
        ),
    ]
    print(
        f"{'a bare rospy node | SimpleActionServer, a process each':66} {cpu['bare alone']:9.3f} | "
        f"{cpu['stock alone']:9.3f} % core ratio {cpu['bare alone'] / cpu['stock alone']:7.3f}"
    )
    return all(held)


def back_to_back(stack: ExitStack) -> bool:
    """Measure goals per second, the two servers in turn."""
    started(stack, [worker("goals", kind) for kind in ("stock", "rfn")])
    rates: Dict[str, List[float]] = {"stock": [], "rfn": []}
    for _ in range(3):
        for kind, measured in rates.items():
            measured.append(goals_per_s(f"{kind}_goals"))
    ours, theirs = (statistics.median(rates[kind]) for kind in ("rfn", "stock"))
    return report(
        "goals back to back: RFNServer | SimpleActionServer", ours, theirs, "/s", "at least 5", ours >= 5.0 * theirs
    )


def main() -> int:
    """Run the comparison."""
    port = free_port()
    os.environ["ROS_MASTER_URI"] = f"http://127.0.0.1:{port}"
    with ExitStack() as stack, tempfile.TemporaryDirectory() as folder:
        core = subprocess.Popen(["roscore", "-p", str(port)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        stack.callback(core.wait, 30.0)
        stack.callback(core.terminate)
        import rospy

        wait_for_master()
        rospy.init_node("rfnserver_idle", disable_signals=True)
        registrar = subprocess.Popen(
            ["rosrun", "frame_registrar", "frame_registrar"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        stack.callback(registrar.wait, 30.0)
        stack.callback(registrar.terminate)
        rospy.wait_for_service("register_with_frame", timeout=60.0)
        held = [idle(stack, folder)]
        held.append(back_to_back(stack))
        rospy.signal_shutdown("done")
    return 0 if all(held) else 1


def wait_for_master() -> None:
    """Wait until the master answers."""
    import rosgraph

    end_s = time.monotonic() + 60.0
    while not rosgraph.is_master_online():
        if time.monotonic() > end_s:
            raise SystemExit("the master does not come up")
        time.sleep(0.2)


if __name__ == "__main__":
    if sys.argv[1:2] == ["serve"]:
        serve(sys.argv[2], int(sys.argv[3]), int(sys.argv[4]))
    elif sys.argv[1:2] == ["goals"]:
        take_goals(sys.argv[2])
    else:
        raise SystemExit(main())
