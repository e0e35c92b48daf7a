"""The node: the event loop of the SDK in the main thread, and the subscribers of rospy."""

import asyncio
import contextlib
import json
import os
import sys
import time
import uuid
from typing import Any, Coroutine, Optional, Sequence, Set

import rosgraph
import rospy

from agent_server.settings import ADDRESS, Settings
from roboframenet_ros.health import Health, Level
from roboframenet_ros.ros_node import StartError, read_parameters, run_node
from web_console.access import AccessError, check_access, read_token

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


class AgentsNode:
    """Joins the graph and the server of the SDK. It runs in the main thread.

    Subscribes and publishes: what a `GraphRobot` does.
    """

    def __init__(self, settings: Settings, wire: Optional[int]) -> None:
        """
        Args:
            settings: of the node
            wire: where the protocol of standard output goes; None for HTTP
        Raises:
            StartError: HTTP has no token
        """
        self._settings = settings
        self._wire = wire
        self._token = _read_token(settings.token_file) if wire is None else ""
        self._tasks: Set[asyncio.Task[Any]] = set()
        self._tools = 0

    def health(self) -> Health:
        """How the node is."""
        values = {"tools": self._tools, "way": "http" if self._wire is None else "standard input and output"}
        if not self._tools:
            return Health(Level.WARN, "No frame can be called: no living server, or no registrar.", values)
        return Health(values=values)

    def run(self) -> None:
        """Serve until the client or ROS is gone."""
        asyncio.run(self._serve())
        time.sleep(_FLUSH_S)
        rospy.signal_shutdown("the client is gone")

    async def _serve(self) -> None:
        from agent_server.mcp_server import AgentServer
        from agent_server.ros_robot import GraphRobot
        from agent_server.transports import PATH, HttpServer, serve_stdio

        loop = asyncio.get_running_loop()

        def hear(event: Any) -> None:
            agents.hear(event)

        def call_soon(*work: Any) -> None:
            # What is heard when the client is gone is for nobody.
            with contextlib.suppress(RuntimeError):
                loop.call_soon_threadsafe(*work)

        def tell_tools() -> None:
            self._tools = len(robot.tools)
            self._begin(agents.tell_tools())

        robot = GraphRobot(call_soon, hear=hear, on_tools=tell_tools)
        agents = AgentServer(robot, _explain)
        await _wait_until_connected(robot)
        if self._wire is not None:
            work = asyncio.ensure_future(serve_stdio(agents, self._wire))
            end = work.cancel
        else:
            server = HttpServer(agents, self._token, self._settings.port)
            work, end = asyncio.ensure_future(server.serve()), server.stop
            self._begin(_tell_url(server, PATH))
        rospy.on_shutdown(lambda: call_soon(end))
        try:
            await work
        except asyncio.CancelledError:
            rospy.loginfo("ended")
        except Exception as error:  # boundary: a killed client leaves a broken pipe, and what it began is cancelled
            if self._wire is None:
                raise
            rospy.loginfo("the client is gone: %s", type(error).__name__)

    def _begin(self, work: Coroutine[Any, Any, Any]) -> None:
        """Let something run beside the server; the loop keeps no task that nobody refers to."""
        task = asyncio.get_running_loop().create_task(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)


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
    _wait_for_master()
    # Each agent on standard input and output has a node of its own.
    name = "agent_server" if is_http else f"agent_server_{os.getpid()}_{uuid.uuid4().hex[:4]}"
    run_node(name, lambda: _start(wire), work=AgentsNode.run)
    sys.stderr.flush()
    # A thread may still wait for a line of a client that is gone.
    os._exit(0)


def _start(wire: Optional[int]) -> AgentsNode:
    settings = read_parameters(Settings)
    os.nice(settings.niceness)
    return AgentsNode(settings, wire)


def _wait_for_master() -> None:
    """Return when a master answers; without one, the start of a node would never end."""
    end_s = time.monotonic() + _WAIT_S
    while not rosgraph.is_master_online():
        if time.monotonic() >= end_s:
            uri = rosgraph.get_master_uri()
            raise SystemExit(f"agent_server: no ROS master at {uri}: is the robot up, and ROS_MASTER_URI right?")
        time.sleep(_POLL_S)


async def _wait_until_connected(robot: Any) -> None:
    """Wait until the command server hears this node, and the tools are known; without them, serve what there is."""
    end_s = time.monotonic() + _WAIT_S
    while time.monotonic() < end_s and not (robot.is_connected and robot.tools):
        await asyncio.sleep(_POLL_S)


async def _tell_url(server: Any, path: str) -> None:
    while not server.port:
        await asyncio.sleep(_POLL_S)
    url = f"http://{ADDRESS}:{server.port}{path}"
    rospy.set_param("~url", url)
    rospy.loginfo("agents of this machine that know the token find the robot at %s", url)


def _read_token(path: str) -> str:
    if not path:
        raise StartError("streamable HTTP needs ~token_file, a file with a secret (openssl rand -hex 16 > FILE)")
    try:
        token = read_token(path)
        check_access(ADDRESS, token)
    except AccessError as error:
        raise StartError(str(error)) from error
    if not token:
        raise StartError(f"~token_file {path!r} is empty")
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
