#!/usr/bin/env python3
"""Measures the page: first paint, event to page, ten pages, idle, and the pipeline with and without it, in one run.

The pipeline is compared with itself: its way from a text to a goal, in turns with a page that is open, and without the
node of the page. Programs that stand for pages are websocket clients in a process of their own.

    benchmarks/console.py [SECONDS of the ten pages, 60]
    benchmarks/console.py SECONDS CHECKOUT

With the checkout of another version, its page is measured in turns with this one, with its own packages in Python and
the messages of this version; the last lines are the ratios of this one to the other.
"""

import itertools
import os
import statistics
import subprocess
import sys
import threading
import time
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Dict, Iterator, List, Sequence, Tuple

from measuring.own_graph import OwnGraph, end
from measuring.processor_time import processor_s
from stage_latency import Measurement

PORT = 18090
URL = f"http://127.0.0.1:{PORT}/"
IDLE_S = 20.0
TURNS, TEXTS = 5, 40
#: Of two versions, each.
TURNS_BESIDE = 3
EVENTS = 200
LOADS = 5
PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "tests", "rostest")


def pages(count: int, shall_tell: bool) -> None:
    """Open pages that read everything; with `shall_tell`, print the time of each event that arrives."""
    import asyncio
    import json

    from tornado.websocket import websocket_connect

    async def read() -> None:
        page = await websocket_connect(URL.replace("http", "ws") + "live")
        print("open", flush=True)
        while True:
            message = await page.read_message()
            if message is None:
                return
            if not shall_tell:
                continue
            now_s = time.monotonic()
            said = json.loads(message)
            if said["view"] == "command":
                for stage in said["value"]["stages"]:
                    print(stage["sentence"], now_s, flush=True)

    async def read_all() -> None:
        await asyncio.gather(*(read() for _ in range(count)))

    asyncio.run(read_all())


@contextmanager
def open_pages(count: int, *, shall_tell: bool = False) -> "Iterator[subprocess.Popen[str]]":
    """Pages in a process of their own; all are open when this returns."""
    process = subprocess.Popen(
        [sys.executable, os.path.abspath(__file__), "pages", str(count), "tell" if shall_tell else ""],
        stdout=subprocess.PIPE,
        text=True,
    )
    try:
        assert process.stdout is not None
        for _ in range(count):
            while process.stdout.readline().strip() != "open":
                if process.poll() is not None:
                    raise SystemExit("the page cannot be opened")
        yield process
    finally:
        process.kill()
        process.wait()


def command_of(checkout: str) -> Tuple[List[str], Dict[str, str]]:
    """Return the program of the page, and its environment; of this version when the checkout is empty."""
    if not checkout:
        found = subprocess.run(
            ["catkin_find", "--first-only", "web_console", "web_console"], capture_output=True, text=True, check=True
        )
        return [found.stdout.strip()], dict(os.environ)
    sources = sorted(str(path.parent / "src") for path in Path(checkout, "src").rglob("package.xml"))
    paths = os.pathsep.join([*sources, os.environ.get("PYTHONPATH", "")])
    (program,) = Path(checkout, "src").rglob("nodes/web_console")
    return [sys.executable, str(program)], dict(os.environ, PYTHONPATH=paths)


@contextmanager
def console(checkout: str = "") -> "Iterator[subprocess.Popen[bytes]]":
    """The node of the page, once it answers; that of another checkout, if one is given."""
    import rospy
    from tornado.httpclient import HTTPClient, HTTPClientError

    if rospy.has_param("/web_console/url"):
        rospy.delete_param("/web_console/url")
    program, environment = command_of(checkout)
    process = subprocess.Popen(
        [*program, f"_port:={PORT}"], env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    try:
        end_s = time.monotonic() + 60.0
        while not rospy.has_param("/web_console/url"):
            if time.monotonic() > end_s:
                raise SystemExit("the page is not there")
            time.sleep(0.1)
        client = HTTPClient()
        try:
            client.fetch(URL)
        except (OSError, HTTPClientError) as error:
            raise SystemExit(f"{URL}: {error}") from error
        finally:
            client.close()
        time.sleep(3.0)
        yield process
    finally:
        end(process)


def memory_mb(pid: int) -> float:
    """Resident memory of a process."""
    lines = Path(f"/proc/{pid}/status").read_text(encoding="ascii").splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith("VmRSS:")) / 1024.0


def share_of_core(pid: int, seconds: float) -> float:
    """Percent of a core that a process takes in some time."""
    before_s, start_s = processor_s(pid), time.monotonic()
    time.sleep(seconds)
    return 100.0 * (processor_s(pid) - before_s) / (time.monotonic() - start_s)


def p(values: Sequence[float], share: float) -> float:
    """The value that this share does not exceed."""
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))]


def say(what: str, value: str) -> None:
    """Print a line of the table."""
    print(f"{what:52}{value}", flush=True)


def event_to_page(count: int) -> List[float]:
    """Milliseconds from the publication of an event to its arrival at a page."""
    import rospy
    from roboframenet_msgs.msg import Command, StageEvent

    events = rospy.Publisher("stage_events", StageEvent, queue_size=10)
    sent: Dict[str, float] = {}
    arrived: Dict[str, float] = {}

    def read(stream: Any) -> None:
        for line in stream:
            sentence, _, when_s = line.rpartition(" ")
            arrived.setdefault(sentence, float(when_s) if when_s.strip() != "open" else 0.0)

    with open_pages(1, shall_tell=True) as process:
        threading.Thread(target=read, args=(process.stdout,), daemon=True).start()
        time.sleep(1.0)
        for number in range(count):
            command = Command(id=f"text-measured-{number // 20}", text="measured", stamp=rospy.Time.now())
            sentence = f"event {number}"
            event = StageEvent(command=command, stage=f"stage {number % 5}", stamp=rospy.Time.now(), sentence=sentence)
            sent[sentence] = time.monotonic()
            events.publish(event)
            time.sleep(0.05)
        time.sleep(1.0)
    missing = set(sent) - set(arrived)
    if missing:
        raise SystemExit(f"{len(missing)} of {count} events did not arrive")
    return [1000.0 * (arrived[sentence] - sent_s) for sentence, sent_s in sent.items()]


def first_paint(loads: int) -> List[float]:
    """Milliseconds from the request to the first content, in a new browser for the first load."""
    sys.path.insert(0, PAGE)
    from console_browser import ConsoleBrowser

    times = []
    browser = ConsoleBrowser(URL)
    try:
        for _ in range(loads):
            browser.driver.get("about:blank")
            browser.driver.get(URL)
            time.sleep(1.0)
            times.append(browser.run("performance.getEntriesByName('first-contentful-paint')[0].startTime"))
    finally:
        browser.close()
    return times


def compare(measurement: Measurement) -> None:
    """Print the way from a text to a goal with an open page, and without the node.

    People say something else each time, and it is parsed; a text that is said again has its parse already.
    """
    times: Dict[Tuple[str, str], List[float]] = {}
    angles = itertools.count(1)

    def take(how: str) -> None:
        for number in range(TEXTS + 5):
            for what, text in (("another text each time", f"Turn left {next(angles)} degrees."), ("the same", "Ping.")):
                ms = measurement.to_goal_ms(text)
                if number >= 5:
                    times.setdefault((what, how), []).append(ms)

    for _ in range(TURNS):
        with console(), open_pages(1):
            take("with a page")
        time.sleep(2.0)
        take("without")
    medians = {key: statistics.median(values) for key, values in times.items()}
    for (what, how), values in times.items():
        spread = f"p50 {medians[what, how]:.2f} ms, p95 {p(values, 0.95):.2f} ms, of {len(values)}"
        say(f"text to goal {how}, {what}", spread)
    for what in dict.fromkeys(what for what, _ in times):
        ratio = medians[what, "with a page"] / medians[what, "without"]
        say(f"ratio of the medians, {what}", f"{ratio:.3f}   (at most 1.05)")


def measure(seconds: float, other: str) -> None:
    """Print the table."""
    import rospy

    try:
        measurement = Measurement(("pinging", "turning"))
        say("load of the machine at the start", " ".join(f"{value:.1f}" for value in os.getloadavg()))
        if other:
            measure_beside(measurement, seconds, other)
        else:
            with console() as node:
                figures = figures_of(node, measurement, seconds)
            tell(figures)
            compare(measurement)
        say("load of the machine at the end", " ".join(f"{value:.1f}" for value in os.getloadavg()))
    finally:
        # A thread of actionlib would keep the process alive.
        rospy.signal_shutdown("done")


def figures_of(node: "subprocess.Popen[bytes]", measurement: Measurement, seconds: float) -> Dict[str, List[float]]:
    """Return the figures of a page: percent of a core, milliseconds, megabytes."""
    figures = {"idle without a page, % of a core": [share_of_core(node.pid, IDLE_S)]}
    with open_pages(1):
        # The first page makes the node read all files.
        time.sleep(15.0)
        figures["idle with a page, % of a core"] = [share_of_core(node.pid, IDLE_S)]
    figures["event to page, ms"] = event_to_page(EVENTS)
    try:
        figures["first paint, ms"] = first_paint(LOADS)
    except ImportError as error:
        say("first paint", f"not measured: {error}")
    with open_pages(10):
        # The first fifty commands fill the history.
        for _ in range(60):
            measurement.to_goal_ms()
        before_mb, before_s, start_s = memory_mb(node.pid), processor_s(node.pid), time.monotonic()
        said = 0
        while time.monotonic() < start_s + seconds:
            measurement.to_goal_ms()
            said += 1
            time.sleep(0.5)
        figures["ten pages, ms of a core for a command"] = [1000.0 * (processor_s(node.pid) - before_s) / said]
        figures["ten pages, MB"] = [before_mb]
        figures["ten pages, MB more at the end"] = [memory_mb(node.pid) - before_mb]
    return figures


def tell(figures: Dict[str, List[float]], whose: str = "") -> None:
    """Print the figures of a page."""
    for what, values in figures.items():
        spread = f", p95 {p(values, 0.95):.1f}, worst {max(values):.1f}, of {len(values)}" if len(values) > 1 else ""
        say(f"{what}{whose}", f"{statistics.median(values):.2f}{spread}")


def measure_beside(measurement: Measurement, seconds: float, other: str) -> None:
    """Print the figures of two versions that take turns, and their ratios."""
    figures: Dict[str, Dict[str, List[float]]] = {"": {}, other: {}}
    for turn in range(TURNS_BESIDE):
        for checkout in ("", other) if turn % 2 == 0 else (other, ""):
            with console(checkout) as node:
                for what, values in figures_of(node, measurement, seconds).items():
                    figures[checkout].setdefault(what, []).extend(values)
    tell(figures[""], ", this")
    tell(figures[other], ", the other")
    for what, values in figures[""].items():
        before = statistics.median(figures[other][what])
        if before > 0 and not what.endswith("at the end"):
            say(f"ratio, {what}", f"{statistics.median(values) / before:.2f}")


def main(seconds: float, other: str) -> int:
    """Start the pipeline, a simulated robot and the measurement."""
    with OwnGraph() as graph:
        graph.start(["roslaunch", "-p", str(graph.port), "roboframenet_bringup", "pipeline.launch"])
        # Its odometry goes to the page.
        graph.start(["rosrun", "roboframenet_sim", "turtlebot_sim"])
        relay = os.path.join(os.path.dirname(os.path.abspath(__file__)), "stage_latency.py")
        graph.start([sys.executable, relay, "relay"])
        return graph.run([sys.executable, os.path.abspath(__file__), "measure", str(seconds), other])


if __name__ == "__main__":
    if sys.argv[1:2] == ["pages"]:
        pages(int(sys.argv[2]), sys.argv[3] == "tell")
    elif sys.argv[1:2] == ["measure"]:
        measure(float(sys.argv[2]), sys.argv[3])
    else:
        checkout = os.path.abspath(sys.argv[2]) if len(sys.argv) > 2 else ""
        sys.exit(main(float(sys.argv[1]) if len(sys.argv) > 1 else 60.0, checkout))
