"""The node: the event loop of the SDK in the main thread, and the subscribers of rospy."""

import asyncio
import contextlib
import json
import os
import signal
import sys
import time
from typing import Any, Coroutine, Optional, Sequence, Set

import rosgraph
import rospy

from agent_server.settings import Settings
from roboframenet_ros.parameters import ParameterError
from roboframenet_ros.ros_log import log_from_threads
from roboframenet_ros.ros_missed_publishers import connect_missed_publishers
from roboframenet_ros.ros_node import read_parameters
from roboframenet_ros.ros_prompt_connection import publish_promptly
from web_console.access import SHORTEST_TOKEN

#: The oldest Python that the SDK runs on.
OLDEST_PYTHON = (3, 10)
#: How long the master, and then the command server, may take to be there, seconds.
_WAIT_S = 10.0
_POLL_S = 0.1
#: For `rfn explain`, which reads the models first, seconds.
_EXPLAIN_S = 90.0
_MOST_EXPLAINED = 20_000
#: For the last cancels to leave the process, seconds.
_FLUSH_S = 0.3
USAGE = "usage: rosrun agent_server agent_server [--http] [_port:=8765 _token_file:=FILE]"


class Cannot(RuntimeError):
    """The node cannot start; the text says why."""


def main(words: Optional[Sequence[str]] = None) -> None:
    """Run the node until its client or ROS is gone.

    Args:
        words: of the command line
    Raises:
        SystemExit: it cannot start; the text says why
    """
    said = rospy.myargv(list(sys.argv if words is None else words))[1:]
    if [word for word in said if word != "--http"]:
        raise SystemExit(USAGE)
    if sys.version_info < OLDEST_PYTHON:
        raise SystemExit("agent_server: the SDK of the Model Context Protocol needs Python 3.10 or later")
    try:
        from agent_server.transports import divert_stdout
    except ImportError as error:
        raise SystemExit(f"agent_server: {error}; run 'make agents'") from error
    is_http = "--http" in said
    wire = None if is_http else divert_stdout()
    try:
        _init_node(is_http=is_http)
        settings = read_parameters(Settings)
        os.nice(settings.niceness)
        asyncio.run(_serve(settings, wire))
    except (Cannot, ParameterError) as error:
        raise SystemExit(f"agent_server: {error}") from error
    time.sleep(_FLUSH_S)
    rospy.signal_shutdown("the client is gone")
    sys.stderr.flush()
    # A thread may still wait for a line of a client that is gone.
    os._exit(0)


def _init_node(*, is_http: bool) -> None:
    end_s = time.monotonic() + _WAIT_S
    # Without a master, init_node would try for ever.
    while not rosgraph.is_master_online():
        if time.monotonic() >= end_s:
            raise Cannot(f"no ROS master at {rosgraph.get_master_uri()}: is the robot up, and ROS_MASTER_URI right?")
        time.sleep(_POLL_S)
    publish_promptly()
    # Each agent on standard input and output has a node of its own.
    rospy.init_node("agent_server", anonymous=not is_http, disable_signals=True)
    log_from_threads()
    connect_missed_publishers()


async def _serve(settings: Settings, wire: Optional[int]) -> None:
    from agent_server.mcp_server import AgentServer
    from agent_server.ros_robot import GraphRobot
    from agent_server.transports import PATH, HttpServer, serve_stdio

    loop = asyncio.get_running_loop()
    tasks: Set[asyncio.Task[Any]] = set()

    def begin(work: Coroutine[Any, Any, Any]) -> None:
        task = loop.create_task(work)
        tasks.add(task)
        task.add_done_callback(tasks.discard)

    def hear(event: Any) -> None:
        agents.hear(event)

    def call_soon(*work: Any) -> None:
        # What is heard when the client is gone is for nobody.
        with contextlib.suppress(RuntimeError):
            loop.call_soon_threadsafe(*work)

    robot = GraphRobot(
        call_soon,
        hear=hear,
        on_tools=lambda: begin(agents.tell_tools()),
    )
    agents = AgentServer(robot, _explain)
    await _wait_until_connected(robot)
    if wire is not None:
        work = asyncio.ensure_future(serve_stdio(agents, wire))
        end = work.cancel
    else:
        server = HttpServer(agents, _read_token(settings.token_file), settings.port)
        work, end = asyncio.ensure_future(server.serve()), server.stop
        begin(_tell_url(server, PATH))
    for number in (signal.SIGINT, signal.SIGTERM):
        loop.add_signal_handler(number, end)

    rospy.on_shutdown(lambda: call_soon(end))
    try:
        await work
    except asyncio.CancelledError:
        rospy.loginfo("ended")
    except Exception as error:  # boundary: a client that is killed leaves a broken pipe, and what it began is cancelled
        if wire is None:
            raise
        rospy.loginfo("the client is gone: %s", type(error).__name__)


async def _wait_until_connected(robot: Any) -> None:
    """Wait until the command server hears this node, and the tools are known; without them, serve what there is."""
    end_s = time.monotonic() + _WAIT_S
    while time.monotonic() < end_s and not (robot.is_connected and robot.tools):
        await asyncio.sleep(_POLL_S)


async def _tell_url(server: Any, path: str) -> None:
    while not server.port:
        await asyncio.sleep(_POLL_S)
    url = f"http://127.0.0.1:{server.port}{path}"
    rospy.set_param("~url", url)
    rospy.loginfo("agents of this machine that know the token find the robot at %s", url)


def _read_token(path: str) -> str:
    if not path:
        raise Cannot("streamable HTTP needs ~token_file, a file with a secret (openssl rand -hex 16 > FILE)")
    try:
        with open(path, encoding="utf-8") as file:
            token = file.read(8192).strip()
    except (OSError, ValueError) as error:
        raise Cannot(f"~token_file {path!r} cannot be read: {error}") from error
    if len(token) < SHORTEST_TOKEN:
        raise Cannot(f"~token_file holds {len(token)} characters; expected at least {SHORTEST_TOKEN}")
    return token


async def _explain(text: str) -> str:
    """Return what ``rfn explain --live`` says of a sentence."""
    process = await asyncio.create_subprocess_exec(
        sys.executable,
        "-c",
        "import sys; from roboframenet_tools.cli import main; sys.exit(main(sys.argv[1:]))",
        "explain",
        "--live",
        "--",
        text,
        stdin=asyncio.subprocess.DEVNULL,
        stdout=asyncio.subprocess.PIPE,
        stderr=asyncio.subprocess.PIPE,
    )
    try:
        out, err = await asyncio.wait_for(process.communicate(), _EXPLAIN_S)
    except asyncio.TimeoutError:
        return json.dumps("It took too long.")
    finally:
        if process.returncode is None:
            process.kill()
    return (out or err).decode("utf-8", "replace")[:_MOST_EXPLAINED]
