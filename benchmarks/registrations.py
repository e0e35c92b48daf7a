#!/usr/bin/env python3
"""Compares the time from sentence to goal with 10 and with 1,000 registrations: two pipelines, addressed in turn."""

import os
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from contextlib import ExitStack
from typing import Dict, List

from measuring.own_graph import end, free_port

COUNTS = (10, 1000)
SENTENCES = 40
LIMIT = 1.2
ANSWER = "answer:"
START_TIMEOUT_S = 300.0


def measure(count: int) -> None:
    """Register a server for so many frames; then answer each line of the standard input with the milliseconds from
    a sentence to its goal."""
    import rospy
    from roboframenet_msgs.msg import Command
    from std_msgs.msg import String

    from rfnserver import RFNServer

    rospy.init_node("measuring")
    goals = threading.Semaphore(0)
    server = RFNServer("measured", lambda frame: goals.release())
    server.start()
    text = rospy.Publisher("text", String, queue_size=10)
    for topic in ("register_with_frame", "add_lexical_unit"):
        rospy.wait_for_service(topic, timeout=START_TIMEOUT_S)
    for frame_name in ["pinging"] + [f"frame_{number}" for number in range(count - 1)]:
        if not server.register_with_frame(frame_name):
            raise SystemExit(server.last_error)
    end_s = time.monotonic() + START_TIMEOUT_S
    parser = rospy.Publisher("command_text", Command, queue_size=1)  # only to see whether the parser listens yet
    while (text.get_num_connections() < 2 or parser.get_num_connections() < 1) and time.monotonic() < end_s:
        time.sleep(0.05)
    print(ANSWER, "ready", flush=True)
    for _ in sys.stdin:
        start_s = time.monotonic()
        text.publish(String(data="Ping."))
        if not goals.acquire(timeout=60.0):
            raise SystemExit("no goal came")
        print(ANSWER, 1000.0 * (time.monotonic() - start_s), flush=True)


def write_frames(folder: str) -> None:
    """Write frames that are registered and never used."""
    os.makedirs(os.path.join(folder, "frames"))
    for number in range(max(COUNTS)):
        with open(os.path.join(folder, "frames", f"frame_{number}.yaml"), "w", encoding="utf-8") as file:
            file.write(f"name: frame_{number}\ndescription: One of many.\nframe_elements:\n  - {{name: theme}}\n")


def answer_of(process: "subprocess.Popen[str]") -> str:
    """Read the next answer, with a deadline; skip the log lines of rospy."""
    timer = threading.Timer(START_TIMEOUT_S, process.kill)
    timer.start()
    try:
        for line in process.stdout:
            if line.startswith(ANSWER):
                return line[len(ANSWER) :].strip()
    finally:
        timer.cancel()
    raise SystemExit("a measuring process ended")


def main() -> int:
    """Run the comparison."""
    shipped = subprocess.run(
        ["rospack", "find", "roboframenet_domains"], stdout=subprocess.PIPE, text=True, check=True
    ).stdout.strip()
    times: Dict[int, List[float]] = {count: [] for count in COUNTS}
    with ExitStack() as stack, tempfile.TemporaryDirectory() as folder:
        write_frames(folder)
        workers: Dict[int, subprocess.Popen[str]] = {}
        for count in COUNTS:
            port = free_port()
            environment = dict(os.environ, ROS_MASTER_URI=f"http://127.0.0.1:{port}")
            pipeline = subprocess.Popen(
                ["roslaunch", "-p", str(port), "roboframenet_bringup", "pipeline.launch"]
                + [f"domains:={shipped}/domains, {folder}"],
                env=environment,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
            )
            stack.callback(end, pipeline)
            workers[count] = subprocess.Popen(
                [sys.executable, os.path.abspath(__file__), "measure", str(count)],
                env=environment,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                text=True,
            )
            stack.callback(end, workers[count])
        for count, worker in workers.items():
            assert answer_of(worker) == "ready"
            print(f"a pipeline with {count} registrations is ready", flush=True)
        for number in range(SENTENCES):
            for count in COUNTS if number % 2 else reversed(COUNTS):
                workers[count].stdin.write("\n")
                workers[count].stdin.flush()
                times[count].append(float(answer_of(workers[count])))
    few, many = (statistics.median(times[count]) for count in COUNTS)
    is_held = many <= LIMIT * few
    print(
        f"sentence to goal, median of {SENTENCES}: {COUNTS[1]} | {COUNTS[0]} registrations: {many:.1f} | {few:.1f} ms, "
        f"ratio {many / few:.3f}  (at most {LIMIT}: {'held' if is_held else 'MISSED'})"
    )
    return 0 if is_held else 1


if __name__ == "__main__":
    if sys.argv[1:2] == ["measure"]:
        measure(int(sys.argv[2]))
    else:
        raise SystemExit(main())
