#!/usr/bin/python3
"""Kills one node, or the master, while one kind of plan node runs, in a graph of its own; prints what happened as JSON.

    kill_in_plan.py KIND VICTIM [finish|stop]

KIND is that of a plan node, VICTIM one of executor, source, master. The last word is the executor's `on_master_lost`.
Two more victims: "hang", a master that hangs before anything is said; "commander", the master, and then the command
server, which would pass on a stop.
"""

import contextlib
import json
import os
import signal
import socket
import subprocess
import sys
import time
from typing import Any, Dict, List, Optional, Set

import rosgraph
import rospy
from roboframenet_msgs.msg import (
    Command,
    CommandPlan,
    FilledFrameElement,
    FilledSemanticFrame,
    FrameCallback,
    FrameServers,
    Plan,
    PlanCandidate,
    PlanNode,
    Reply,
    StageEvent,
)
from std_msgs.msg import String

from roboframenet_testing import wait_until

#: A leaf that nobody ends is over after this time.
LEAF_S = 4.0
#: The executor has noticed that the master is dead.
NOTICED_S = 2.0
#: A plan goes on for so long after everything that should happen has happened.
AFTER_S = 1.5


def candidate(name: str, server: str, **elements: Any) -> PlanCandidate:
    arguments = [FilledFrameElement(element, str(value)) for element, value in elements.items()]
    frame = FilledSemanticFrame(name=name, action_server_topics=[server], frame_elements=arguments)
    return PlanCandidate(frames=[frame], coverage=1.0)


def node(kind: str, *children: int, **fields: Any) -> PlanNode:
    return PlanNode(kind=getattr(PlanNode, kind), label=kind.lower(), children=children, **fields)


#: Goes on for a while; what comes after it; a condition that does not hold, and one that does.
LAST = PlanNode(kind=PlanNode.DO, label="go on", candidates=[candidate("last", "one", seconds=LEAF_S)])
NEXT = PlanNode(kind=PlanNode.DO, label="what follows", candidates=[candidate("succeed", "two")])
IS_NOT = PlanNode(
    kind=PlanNode.CONDITION,
    label="it is so",
    candidates=[candidate("watch", "watching", then="so", seconds=600, before=0)],
)
IS_SO = PlanNode(
    kind=PlanNode.CONDITION,
    label="it is so",
    candidates=[candidate("watch", "watching", then="so", seconds=600, before=1)],
)
#: Each goes on with the leaf that lasts (a WAIT without one), and then with another one.
PLANS: Dict[str, List[PlanNode]] = {
    "DO": [LAST],
    "SEQUENCE": [node("SEQUENCE", 1, 2), LAST, NEXT],
    "ANY_ORDER": [node("ANY_ORDER", 1, 2), LAST, NEXT],
    "FALLBACK": [node("FALLBACK", 1, 2), LAST, NEXT],
    "PARALLEL": [node("SEQUENCE", 1, 4), node("PARALLEL", 2, 3), LAST, NEXT, NEXT],
    "IF": [node("SEQUENCE", 1, 4), node("IF", 2, 3), IS_SO, LAST, NEXT],
    "UNTIL": [node("SEQUENCE", 1, 4), node("UNTIL", 2, 3), IS_NOT, LAST, NEXT],
    "WHILE": [node("SEQUENCE", 1, 4), node("WHILE", 2, 3), IS_SO, LAST, NEXT],
    "REPEAT": [node("REPEAT", 1, count=3, most=3), LAST],
    "WAIT": [node("SEQUENCE", 1, 3), node("WAIT", 2), IS_NOT, NEXT],
}
#: Kinds that watch while the leaf goes on.
WATCHING = ("UNTIL", "WHILE", "WAIT")


class Graph(contextlib.ExitStack):
    """Programs under a master of their own."""

    def __init__(self) -> None:
        super().__init__()
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            self.port = int(probe.getsockname()[1])
        os.environ["ROS_MASTER_URI"] = f"http://127.0.0.1:{self.port}"
        os.environ["ROS_HOME"] = os.path.join(os.environ.get("ROS_HOME", "/tmp"), f"kill_{self.port}")

    def start(self, *command: str) -> "subprocess.Popen[bytes]":
        """Start a program, which is killed in the end."""
        process = subprocess.Popen(
            command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True
        )
        self.callback(_end, process)
        return process


def _end(process: "subprocess.Popen[bytes]") -> None:
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    process.wait(10.0)


def run(kind: str, victim: str, on_master_lost: str) -> Dict[str, Any]:
    """Run one case; returns the replies, the log of the servers, and what began after the kill."""
    with Graph() as graph:
        master = graph.start("rosmaster", "--core", "-p", str(graph.port))
        wait_until(lambda: _is_up(graph.port), message="no master")
        misbehaving = os.path.join(os.path.dirname(os.path.realpath(__file__)), "misbehaving_server.py")
        graph.start(sys.executable, misbehaving, "__name:=servers", "_servers:=[one, two]")
        source = graph.start(sys.executable, misbehaving, "__name:=source", "_servers:=[watching]")
        executor = graph.start("rosrun", "executor", "executor", f"_on_master_lost:={on_master_lost}")
        commander = graph.start("rosrun", "command_server", "command_server", "_executor_timeout_s:=2.0")
        if victim == "hang":
            return _watch([], kind, hanging=master)
        victims = {"executor": [executor], "source": [source], "master": [master], "commander": [master, commander]}
        return _watch(victims[victim], kind)


def _published_by(node: str) -> Set[str]:
    """Return the topics that a node publishes."""
    publishers = rosgraph.Master(rospy.get_name()).getSystemState()[0]
    return {topic for topic, nodes in publishers if node in nodes}


def _is_up(port: int) -> bool:
    with socket.socket() as probe:
        return probe.connect_ex(("127.0.0.1", port)) == 0


def _watch(
    victims: "List[subprocess.Popen[bytes]]", kind: str, *, hanging: "Optional[subprocess.Popen[bytes]]" = None
) -> Dict[str, Any]:
    rospy.init_node("kill_in_plan", disable_signals=True)
    replies: List[Reply] = []
    log: List[str] = []
    begun = False

    def on_event(event: StageEvent) -> None:
        nonlocal begun
        begun |= event.stage == "executor" and not event.is_final

    text = rospy.Publisher("text", String, queue_size=10)
    plans = rospy.Publisher("command_plan", CommandPlan, queue_size=10)
    servers = rospy.Publisher("frame_servers", FrameServers, queue_size=1, latch=True)
    events = rospy.Publisher("stage_events", StageEvent, queue_size=10)
    names = [("last", "one"), ("succeed", "two"), ("watch", "watching")]
    callbacks = [FrameCallback(frame_name=frame, callback_topic=server, is_alive=True) for frame, server in names]
    servers.publish(FrameServers(registrar_id="test", callbacks=callbacks))

    if len(victims) > 1:
        # Only a cancel may end it.
        LAST.candidates[0].frames[0].frame_elements[0].argument = "600"

    def on_command(command: Command) -> None:
        for stage in ("stanford_parser_ros", "semantic_framer", "frame_registrar", "arbitrator"):
            events.publish(StageEvent(command=command, stage=stage, stamp=rospy.Time.now(), sentence="at it"))
        plans.publish(CommandPlan(command=command, plan=Plan(nodes=PLANS[kind])))

    subscribers = [
        rospy.Subscriber("command_text", Command, on_command),
        rospy.Subscriber("server_log", String, lambda message: log.append(message.data)),
        rospy.Subscriber("reply", Reply, replies.append),
        rospy.Subscriber("stage_events", StageEvent, on_event),
    ]
    wait_until(
        lambda: (
            all(one.get_num_connections() for one in (text, plans, events, servers))
            and subscribers[0].get_num_connections() == 1
            and subscribers[1].get_num_connections() == 2
            and subscribers[2].get_num_connections() >= 1
            and subscribers[3].get_num_connections() >= 2
        ),
        message="the graph does not come up",
    )
    if hanging is not None:
        # No goal was sent yet.
        # It prepares one after the other, and this one last.
        wait_until(lambda: "/watching/goal" in _published_by("/executor"), message="it does not connect")
        os.killpg(hanging.pid, signal.SIGSTOP)
    text.publish("do it all")
    first = "watching begins watch" if kind == "WAIT" else "one begins last"
    wait_until(lambda: first in log and begun, message=lambda: f"nothing begins: {log}")
    if kind in WATCHING:
        wait_until(lambda: "watching begins watch" in log)
    # The first observation has arrived, and PARALLEL has done what is over at once.
    time.sleep(0.7)
    before = list(log)
    killed_s = time.monotonic()
    for number, victim in enumerate(victims):
        time.sleep(NOTICED_S if number else 0.0)
        os.killpg(victim.pid, signal.SIGKILL)
    # A commander that is dead replies no more.
    is_told = (lambda: "one preempted last" in log) if len(victims) > 1 else (lambda: bool(replies))
    wait_until(is_told, 30.0, message=lambda: f"no reply: {log}")
    seconds = time.monotonic() - killed_s
    time.sleep(AFTER_S)
    after = log[len(before) :]
    return {
        "replies": [{"outcome": one.outcome, "code": one.code, "sentence": one.sentence} for one in replies],
        "seconds": round(seconds, 2),
        "begun": [line for line in after if line.split()[1] == "begins"],
        "ended": [line for line in after if line.split()[1] != "begins"],
    }


if __name__ == "__main__":
    arguments = [argument for argument in sys.argv[1:] if ":=" not in argument]
    print(json.dumps(run(arguments[0], arguments[1], (arguments + ["finish"])[2])), flush=True)
    # rospy waits for a master that is gone.
    os._exit(0)
