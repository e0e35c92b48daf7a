"""The server of the Model Context Protocol, on the official SDK, which needs Python 3.10."""

import asyncio
import json
import secrets
import time
from dataclasses import dataclass, field
from typing import Any, Awaitable, Callable, Dict, List, Mapping, Optional, Union

import mcp_types as types
from mcp.server.lowlevel import NotificationOptions, Server
from mcp.server.subscriptions import InMemorySubscriptionBus, ListenHandler, ToolsListChanged
from mcp_types.version import MODERN_PROTOCOL_VERSIONS

from agent_server.agent_names import CommandIds, clean_name
from agent_server.deeds import Deed
from agent_server.filled_call import filled_call
from agent_server.frame_tool import FrameTool
from agent_server.own_tools import INSTRUCTIONS, OWN
from agent_server.refused import CallRefused
from agent_server.robot import DONE, NEEDS_INFORMATION, REFUSED, Answer, Progress, Robot
from agent_server.schema_check import checked
from agent_server.words import YES_OR_NO, check_said
from agent_server.world_view import one_line, world_view
from web_console.rate_limit import Rate, RateLimit

NAME = "roboframenet"
#: A command that nobody tells of for so long gets no reply any more, seconds: the command server is dead.
SILENCE_S = 30.0
#: How long a person may think about a question, seconds.
THINKING_S = 55.0
#: Calls of one agent at a time, and how often it may call.
MOST_CALLS = 8
_RATE = Rate(per_s=10.0, burst=60.0)
#: Agents and open questions that are remembered.
_MOST_AGENTS, _MOST_QUESTIONS = 64, 64
_LONGEST_TOLD = 1000
_CONFIRM = "confirm"
_YES: Mapping[str, Any] = {
    "type": "object",
    "properties": {
        _CONFIRM: {"type": "boolean", "title": "Yes, do it", "description": "Whether the robot shall do it."}
    },
    "required": [_CONFIRM],
}

Explain = Callable[[str], Awaitable[str]]
Event = Union[Progress, Answer]


@dataclass
class _Agent:
    """A client.

    Attributes:
        name: a clean name
        ids: of its commands
        rate: how often it may call
        running: its calls that have not ended
        session: of its last request; it is told of changes by it
    """

    name: str
    ids: CommandIds
    rate: RateLimit
    running: int = 0
    session: Any = None

    @property
    def who(self) -> str:
        """Who asks, as the log of deeds has it."""
        return f"agent {self.name}"


@dataclass(frozen=True)
class _Asked:
    """A question that the client puts to a person between two requests.

    Attributes:
        call: name and arguments of the call, as JSON: the answer counts for this call only
        expires_s: monotonic seconds
        about: id of the command whose reply asks it; empty for a frame
    """

    call: str
    expires_s: float
    about: str


class _InputRequired(Exception):
    """The client must ask a person, and call again."""

    def __init__(self, result: Any) -> None:
        super().__init__("input required")
        self.result = result


@dataclass
class _Request:
    """A call that is carried out."""

    context: Any
    agent: _Agent
    name: str
    arguments: Any
    state: Optional[str] = None
    responses: Mapping[str, Any] = field(default_factory=dict)

    @property
    def key(self) -> str:
        """The call as a text that two calls share only if they are the same."""
        return json.dumps([self.agent.name, self.name, self.arguments], sort_keys=True, default=str)


class AgentServer:
    """Serves tools to agents. Everything runs in the thread of one event loop.

    Attributes:
        server: of the SDK; a transport runs it
    """

    def __init__(self, robot: Robot, explain: Explain) -> None:
        """
        Args:
            robot: what is known of it, and asked of it
            explain: tells how a sentence would be understood
        """
        self._robot = robot
        self._explain = explain
        self._agents: Dict[str, _Agent] = {}
        self._waiting: Dict[str, asyncio.Queue[Event]] = {}
        self._asked: Dict[str, _Asked] = {}
        self._bus = InMemorySubscriptionBus()
        self.server = Server(
            NAME,
            title="RoboFrameNet",
            instructions=INSTRUCTIONS,
            on_list_tools=self._on_list,
            on_call_tool=self._on_call,
            on_subscriptions_listen=ListenHandler(self._bus, max_subscriptions=_MOST_AGENTS),
            get_tool_input_schema=self._schema_of,
        )

    @property
    def options(self) -> Any:
        """What the server says of itself when a client connects."""
        return self.server.create_initialization_options(NotificationOptions(tools_changed=True))

    def hear(self, event: Event) -> None:
        """Take what the robot tells of a command."""
        queue = self._waiting.get(event.command_id)
        if queue is not None:
            queue.put_nowait(event)

    async def tell_tools(self) -> None:
        """Tell every client that the tools have changed."""
        await self._bus.publish(ToolsListChanged())
        for key, agent in list(self._agents.items()):
            if agent.session is None or agent.session.protocol_version in MODERN_PROTOCOL_VERSIONS:
                continue
            try:
                await agent.session.send_tool_list_changed()
            except Exception:  # boundary: the client of a session that has ended hears nothing more
                self._agents.pop(key, None)

    async def _on_list(self, context: Any, _params: Any) -> Any:
        self._agent_of(context)
        own = [_own_tool(name) for name in OWN]
        return types.ListToolsResult(tools=[*own, *(_frame_tool(tool) for tool in self._robot.tools.values())])

    def _schema_of(self, name: str) -> Optional[Mapping[str, Any]]:
        tool = self._robot.tools.get(name)
        if tool is not None:
            return tool.schema
        return OWN[name].schema if name in OWN else None

    async def _on_call(self, context: Any, params: Any) -> Any:
        agent = self._agent_of(context)
        arguments = {} if params.arguments is None else params.arguments
        request = _Request(
            context, agent, params.name, arguments, params.request_state, dict(params.input_responses or {})
        )
        try:
            self._take_turn(agent, params.name)
            agent.running += 1
            try:
                return await self._carry_out(request)
            finally:
                agent.running -= 1
        except _InputRequired as required:
            return required.result
        except CallRefused as refused:
            return self._refuse(request, refused)

    def _take_turn(self, agent: _Agent, name: str) -> None:
        """A stop is never too much."""
        if name == "stop":
            return
        if agent.running >= MOST_CALLS:
            raise CallRefused("BUSY", f"You have {MOST_CALLS} calls that have not ended.")
        if not agent.rate.take(time.monotonic()):
            raise CallRefused("BUSY", "You call too often.")

    async def _carry_out(self, request: _Request) -> Any:
        name = request.name
        if name not in OWN:
            tool = self._robot.tools.get(name)
            if tool is None:
                raise CallRefused("UNKNOWN_TOOL", f"No server of this robot carries out {name[:60]!r} now.")
            return await self._call_frame(request, tool)
        values = checked(OWN[name].schema, request.arguments)
        self._robot.note(request.agent.who, f"{name} {json.dumps(values, sort_keys=True)}")
        if name == "say":
            return await self._say(request, values["text"])
        if name == "stop":
            text = "Emergency stop." if values.get("emergency") else "Stop."
            return _result(await self._command(request, lambda command_id: self._robot.say(command_id, text)))
        if name == "world":
            most = int(values.get("most", 50))
            view = world_view(self._robot.world, sort=values.get("sort", ""), words=values.get("words", ""), most=most)
            return _data(view)
        if name == "deeds":
            return _data({"deeds": self._robot.deeds.last(int(values.get("most", 20)))})
        return _data({"explanation": await self._explain(values["text"])})

    async def _call_frame(self, request: _Request, tool: FrameTool) -> Any:
        call = filled_call(tool, request.arguments, self._robot.world)
        who = request.agent.who
        if self._robot.emergency:
            raise CallRefused("EMERGENCY_STOP", self._robot.emergency)
        if call.doubts:
            question = f"{' '.join(call.doubts)} Shall the robot really do this: {call.words}?"
            if not await self._yes(request, question):
                raise CallRefused("DECLINED", "The person said no, or nothing.")
        self._robot.note(who, call.words)
        return _result(
            await self._command(request, lambda command_id: self._robot.call(command_id, call, asked_by=who))
        )

    async def _say(self, request: _Request, text: str) -> Any:
        if request.state is not None:
            asked = self._asked.get(request.state)
            is_yes = await self._yes(request, "")
            return await self._answer(request, "" if asked is None else asked.about, is_yes=is_yes)
        check_said(text, self._robot.question, own_prefix=request.agent.ids.prefix, now_s=time.monotonic())
        answer = await self._command(request, lambda command_id: self._robot.say(command_id, text))
        if answer.outcome != NEEDS_INFORMATION or answer.code not in YES_OR_NO:
            return _result(answer)
        try:
            is_yes = await self._yes(request, answer.sentence, about=answer.command_id)
        except CallRefused:
            # Without a person the answer is no: the question must not stay open for somebody else's words.
            await self._answer(request, answer.command_id, is_yes=False)
            raise
        return await self._answer(request, answer.command_id, is_yes=is_yes)

    async def _answer(self, request: _Request, about: str, *, is_yes: bool) -> Any:
        """Say what a person has answered, if the robot still waits for it."""
        question = self._robot.question
        if question is None or question.command_id != about:
            raise CallRefused("DECLINED", "The robot no longer asks that: something else was said meanwhile.")
        word = "Yes." if is_yes else "No."
        return _result(await self._command(request, lambda command_id: self._robot.say(command_id, word)))

    async def _yes(self, request: _Request, question: str, *, about: str = "") -> bool:
        """Return whether a person says yes.

        Args:
            request: the call
            question: for the person
            about: id of the command whose reply asks it; empty for a frame
        Raises:
            CallRefused: the client cannot ask a person
            _InputRequired: the client asks, and calls again
        """
        if request.state is not None:
            asked = self._asked.pop(request.state, None)
            if asked is None or asked.call != request.key or time.monotonic() > asked.expires_s:
                raise CallRefused("DECLINED", "That answer belongs to no open question.")
            return _is_yes(request.responses.get(_CONFIRM))
        session = request.context.session
        capabilities = session.client_capabilities
        if capabilities is None or capabilities.elicitation is None:
            raise CallRefused("CONFIRM", f"A person must say yes, and your client cannot ask one. {question}")
        asking = f"{question} (asked by {request.agent.who})"
        if session.protocol_version in MODERN_PROTOCOL_VERSIONS:
            raise _InputRequired(self._ask_between(request, asking, about))
        try:
            answer = await asyncio.wait_for(
                session.elicit_form(asking, dict(_YES), request.context.request_id), THINKING_S
            )
        except asyncio.TimeoutError:
            return False
        except Exception as error:  # boundary: a client that fails to ask has no yes
            raise CallRefused("CONFIRM", f"Your client could not ask a person: {type(error).__name__}.") from error
        return _is_yes(answer)

    def _ask_between(self, request: _Request, question: str, about: str) -> Any:
        now_s = time.monotonic()
        self._asked = {state: asked for state, asked in self._asked.items() if asked.expires_s > now_s}
        if len(self._asked) >= _MOST_QUESTIONS:
            raise CallRefused("BUSY", "Too many questions are open.")
        state = secrets.token_urlsafe(24)
        self._asked[state] = _Asked(request.key, now_s + THINKING_S, about)
        asked = types.ElicitRequest(params=types.ElicitRequestFormParams(message=question, requested_schema=dict(_YES)))
        return types.InputRequiredResult(input_requests={_CONFIRM: asked}, request_state=state)

    async def _command(self, request: _Request, send: Callable[[str], bool]) -> Answer:
        """Give a command, tell how it goes, and return its one reply; a call that is given up is cancelled."""
        command_id = request.agent.ids.next_id()
        queue: asyncio.Queue[Event] = asyncio.Queue()
        self._waiting[command_id] = queue
        is_open = False
        try:
            if not send(command_id):
                raise CallRefused("STAGE_SILENT", "The command server does not run, so nothing was done.")
            is_open = True
            count = 0
            before = ""
            while True:
                try:
                    event = await asyncio.wait_for(queue.get(), SILENCE_S)
                except asyncio.TimeoutError:
                    sentence = f"There is no news of it for {SILENCE_S:.0f} s. It is cancelled."
                    return Answer(command_id, "FAILED", "agent_server", "STAGE_SILENT", sentence)
                if isinstance(event, Answer):
                    is_open = False
                    return event
                told = f"{event.stage}: {event.sentence}"
                if told != before:
                    count += 1
                    before = told
                    await request.context.session.report_progress(float(count), None, _told(told))
        finally:
            del self._waiting[command_id]
            if is_open:
                self._robot.cancel(command_id)

    def _refuse(self, request: _Request, refused: CallRefused) -> Any:
        who = request.agent.who
        what = f"{request.name[:60]} {json.dumps(request.arguments, default=str)[:200]}"
        self._robot.note(who, f"refused: {refused.code}: {what}")
        self._robot.deeds.add(Deed(who, what, REFUSED, refused.code, str(refused), time.time()))
        return _result(Answer("", REFUSED, "agent_server", refused.code, str(refused)))

    def _agent_of(self, context: Any) -> _Agent:
        """Return the client of a request. One that has no session is known by its name."""
        session = context.session
        parameters = session.client_params
        name = clean_name(parameters.client_info.name) if parameters is not None else "unnamed"
        headers = getattr(context.request, "headers", None) or {}
        key = headers.get("mcp-session-id") or name
        agent = self._agents.get(key)
        if agent is None or agent.name != name:
            while len(self._agents) >= _MOST_AGENTS:
                del self._agents[next(iter(self._agents))]
            agent = _Agent(name, CommandIds(name), RateLimit(_RATE, time.monotonic()))
            self._agents[key] = agent
        agent.session = session
        return agent


def _is_yes(answer: Any) -> bool:
    content = getattr(answer, "content", None) or {}
    return getattr(answer, "action", "") == "accept" and content.get(_CONFIRM) is True


def _own_tool(name: str) -> Any:
    own = OWN[name]
    return types.Tool(
        name=name,
        description=own.description,
        input_schema=dict(own.schema),
        annotations=types.ToolAnnotations(
            read_only_hint=own.is_read_only, destructive_hint=False, open_world_hint=name == "say"
        ),
    )


def _frame_tool(tool: FrameTool) -> Any:
    return types.Tool(
        name=tool.name,
        description=tool.description,
        input_schema=dict(tool.schema),
        annotations=types.ToolAnnotations(
            title=tool.frame.name.replace("_", " "),
            read_only_hint=tool.frame.is_question,
            destructive_hint=tool.may_want_yes,
            open_world_hint=False,
        ),
        _meta={
            "frame": tool.frame.name,
            "framenet": tool.frame.framenet,
            "servers": [server.name for server in tool.servers],
            "confirmed": tool.may_want_yes,
        },
    )


def _result(answer: Answer) -> Any:
    told: Dict[str, Any] = {
        "outcome": answer.outcome,
        "code": answer.code,
        "stage": answer.stage,
        "sentence": _told(answer.sentence),
        "command_id": answer.command_id,
    }
    content: List[Any] = [types.TextContent(type="text", text=f"{answer.outcome}: {_told(answer.sentence)}")]
    return types.CallToolResult(content=content, structured_content=told, is_error=answer.outcome != DONE)


def _data(value: Mapping[str, Any]) -> Any:
    content: List[Any] = [types.TextContent(type="text", text=json.dumps(value, ensure_ascii=False))]
    return types.CallToolResult(content=content, structured_content=dict(value))


def _told(text: str) -> str:
    """Return a text of the robot as one line of bounded length."""
    return one_line(text, _LONGEST_TOLD)
