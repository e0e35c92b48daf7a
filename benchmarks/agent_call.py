#!/usr/bin/env python3
"""Compares the call of a tool by an agent with the action goal that it becomes, in one run.

The server ends each goal at once, so what is measured is the way to it and back: the client of the SDK, its pipe, the
server for agents, and the stages from the frame registrar on. A sentence takes the way through the parser, too.
"""

import asyncio
import importlib.util
import os
import sys
import threading
import time
from typing import Any, Callable, Dict, List

from measuring.arrivals import quantiles
from measuring.own_graph import OwnGraph

START_TIMEOUT_S = 120.0
ANSWER_TIMEOUT_S = 20.0
COUNT, WARM_UP = 100, 5
FRAME, SERVER = "pinging", "answering_at_once"
#: An agent that calls more often is refused; seconds between two calls.
PAUSE_S = 0.12
#: What a call may take at most beyond the goal, 99 times of 100; milliseconds.
ALLOWED_MS = 300.0


def serve() -> None:
    """The server: it does nothing, and says so."""
    import rospy

    from rfnserver import RFNServer

    rospy.init_node("server")
    server = RFNServer(SERVER, lambda frame: None)
    server.start()
    server.register_with_frame(FRAME)
    rospy.spin()


class Goals:
    """Sends goals of the two actions."""

    def __init__(self) -> None:
        """Connect to both; returns when they are up."""
        import actionlib
        import rospy
        from roboframenet_msgs.msg import ExecuteCommandAction, FilledSemanticFrameAction

        from roboframenet_ros.ros_waiting import wait_for_action_server

        rospy.init_node("measuring")
        self._server = actionlib.ActionClient(SERVER, FilledSemanticFrameAction)
        self._command = actionlib.ActionClient("command", ExecuteCommandAction)
        for client in (self._server, self._command):
            if not wait_for_action_server(client, START_TIMEOUT_S):
                raise SystemExit("an action server is not there in time")

    def goal_ms(self) -> float:
        """Return the time of the action goal itself."""
        from roboframenet_msgs.msg import FilledSemanticFrame, FilledSemanticFrameGoal

        frame = FilledSemanticFrame(name=FRAME, action_server_topics=[SERVER])
        return self._time_ms(self._server, FilledSemanticFrameGoal(frame=frame))

    def sentence_ms(self) -> float:
        """Return the time of a sentence that asks for the same."""
        from roboframenet_msgs.msg import ExecuteCommandGoal

        return self._time_ms(self._command, ExecuteCommandGoal(text="Ping."))

    def _time_ms(self, client: Any, goal: Any) -> float:
        import actionlib

        done = threading.Event()
        start_s = time.monotonic()
        handle = client.send_goal(
            goal, lambda one: done.set() if one.get_comm_state() == actionlib.CommState.DONE else None
        )
        if not done.wait(ANSWER_TIMEOUT_S) or handle.get_terminal_state() != actionlib.TerminalState.SUCCEEDED:
            raise SystemExit("a goal was not carried out")
        return 1000.0 * (time.monotonic() - start_s)


async def turns(count: int, goals: Goals) -> Dict[str, List[float]]:
    """Return the times of each way, milliseconds; the ways take turns."""
    from mcp import Client
    from mcp.client.stdio import StdioServerParameters

    async def call_ms(client: Any) -> float:
        start_s = time.monotonic()
        result = await client.call_tool(FRAME, {})
        took_ms = 1000.0 * (time.monotonic() - start_s)
        if result.is_error:
            raise SystemExit(f"a call was not carried out: {result.structured_content}")
        return took_ms

    async def in_thread(work: Callable[[], float]) -> float:
        return await asyncio.get_running_loop().run_in_executor(None, work)

    program = StdioServerParameters(command="rosrun", args=["agent_server", "agent_server"], env=dict(os.environ))
    found: Dict[str, List[float]] = {"action goal": [], "call of an agent": [], "sentence": []}
    async with Client(program, cache=None) as client:
        end_s = time.monotonic() + START_TIMEOUT_S
        while FRAME not in {tool.name for tool in (await client.list_tools()).tools}:
            if time.monotonic() > end_s:
                raise SystemExit("the tool is not there in time")
            await asyncio.sleep(0.2)
        for number in range(WARM_UP + count):
            times = (await in_thread(goals.goal_ms), await call_ms(client), await in_thread(goals.sentence_ms))
            await asyncio.sleep(PAUSE_S)
            if number >= WARM_UP:
                for name, took_ms in zip(found, times):
                    found[name].append(took_ms)
    return found


def measure(count: int) -> int:
    """Print the table."""
    import rospy

    try:
        found = asyncio.run(turns(count, Goals()))
        print(f"{'way':24}{'p50 ms':>10}{'p99 ms':>10}{'ratio':>8}   of {count}")
        goal_p50, goal_p99 = quantiles(found["action goal"])
        for name, times in found.items():
            p50, p99 = quantiles(times)
            print(f"{name:24}{p50:10.2f}{p99:10.2f}{p50 / goal_p50:8.1f}")
        beyond_ms = quantiles(found["call of an agent"])[1] - goal_p99
        is_late = beyond_ms > ALLOWED_MS
        kept = "exceeded" if is_late else "kept"
        print(f"{'beyond the goal':24}{'':10}{beyond_ms:10.2f}   allowed {ALLOWED_MS:.0f}: {kept}")
        return int(is_late)
    finally:
        # A thread of actionlib would keep the process alive.
        rospy.signal_shutdown("done")


def main(count: int) -> int:
    """Start the pipeline, the server and the measurement."""
    if importlib.util.find_spec("mcp") is None:
        print("not run: the SDK of the Model Context Protocol is not installed (make agents)")
        return 0
    own = [sys.executable, os.path.abspath(__file__)]
    with OwnGraph() as graph:
        graph.start_master()
        graph.start(["roslaunch", "-p", str(graph.port), "roboframenet_bringup", "pipeline.launch", "compact:=true"])
        graph.start([*own, "serve"])
        return graph.run([*own, "measure", str(count)])


if __name__ == "__main__":
    if sys.argv[1:2] == ["measure"]:
        sys.exit(measure(int(sys.argv[2])))
    elif sys.argv[1:2] == ["serve"]:
        serve()
    else:
        sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else COUNT))
