"""The ways to an agent: standard input and output, and streamable HTTP on this machine with a token."""

import io
import os
from typing import Any, Awaitable, Callable, Mapping

import anyio
import uvicorn
from mcp.server.stdio import stdio_server

from agent_server.mcp_server import AgentServer
from agent_server.settings import ADDRESS
from web_console.access import is_token

PATH = "/mcp"
_BEARER = b"bearer "

Receive = Callable[[], Awaitable[Mapping[str, Any]]]
Send = Callable[[Mapping[str, Any]], Awaitable[None]]


class TokenGate:
    """Lets only requests with the token through to an application."""

    def __init__(self, application: Any, token: str) -> None:
        """
        Args:
            application: of ASGI
            token: the secret
        """
        self._application = application
        self._token = token

    async def __call__(self, scope: Mapping[str, Any], receive: Receive, send: Send) -> None:
        """Serve a request."""
        if scope["type"] == "http" and not is_token(_said_token(scope), self._token):
            headers = [(b"content-type", b"text/plain"), (b"www-authenticate", b"Bearer")]
            await send({"type": "http.response.start", "status": 401, "headers": headers})
            await send({"type": "http.response.body", "body": b"A token is needed.\n"})
            return
        await self._application(scope, receive, send)


def _said_token(scope: Mapping[str, Any]) -> str:
    for name, value in scope["headers"]:
        if name.lower() == b"authorization" and value[: len(_BEARER)].lower() == _BEARER:
            return str(value[len(_BEARER) :].strip().decode("utf-8", "replace"))
    return ""


def divert_stdout() -> int:
    """Keep standard output for the protocol, and return where it goes; whatever prints goes to standard error."""
    wire = os.dup(1)
    os.dup2(2, 1)
    return wire


async def serve_stdio(agents: AgentServer, wire: int) -> None:
    """Serve the one client that has started this process, until it is gone.

    Args:
        agents: the server
        wire: what `divert_stdout` returned
    """
    out = anyio.wrap_file(io.TextIOWrapper(os.fdopen(wire, "wb", closefd=False), encoding="utf-8"))
    async with stdio_server(stdout=out) as (read, write):
        await agents.server.run(read, write, agents.options)


class HttpServer:
    """Serves clients of this machine that know the token."""

    def __init__(self, agents: AgentServer, token: str, port: int) -> None:
        """
        Args:
            agents: the server
            token: the secret
            port: on 127.0.0.1; 0: any
        """
        gate = TokenGate(agents.server.streamable_http_app(streamable_http_path=PATH, host=ADDRESS), token)
        config = uvicorn.Config(gate, host=ADDRESS, port=port, log_level="warning", timeout_graceful_shutdown=1)
        self._server = uvicorn.Server(config)

    @property
    def port(self) -> int:
        """The port, once it serves; 0 before."""
        sockets = [one for server in getattr(self._server, "servers", ()) for one in server.sockets]
        return int(sockets[0].getsockname()[1]) if sockets else 0

    async def serve(self) -> None:
        """Serve until `stop`."""
        await self._server.serve()

    def stop(self) -> None:
        """End; from the thread of the event loop."""
        self._server.should_exit = True
