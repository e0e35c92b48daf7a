"""The server with the client of the SDK, in one process; the graph is played."""

import asyncio
from typing import Any, Awaitable, Callable, List

import pytest

pytest.importorskip("mcp", reason="the SDK of the Model Context Protocol is not installed: make agents")
import mcp_types as types
from agent_cases import PlayedRobot
from mcp import Client

from agent_server.mcp_server import MOST_CALLS, AgentServer
from agent_server.robot import Answer

ERAS = ["legacy", "auto"]
DONE = Answer("", "DONE", "executor", "DONE", "Done.")
ASKS = Answer("", "NEEDS_INFORMATION", "semantic_framer", "CONFIRM", "Shall I really do this? Say yes or no.")


async def explain(text: str) -> str:
    return f"it is read as {text}"


def run(work: Callable[[Client, PlayedRobot], Awaitable[Any]], robot: PlayedRobot, era: str, **options: Any) -> Any:
    agents = AgentServer(robot, explain)
    robot.hear = agents.hear

    async def main() -> Any:
        info = types.Implementation(name="Test Agent", version="1")
        async with Client(agents.server, mode=era, client_info=info, cache=None, **options) as client:
            robot.tell_tools = agents.tell_tools
            return await asyncio.wait_for(work(client, robot), 60.0)

    return asyncio.run(main())


def person(says: str, asked: List[str]) -> Any:
    async def elicit(_context: Any, params: Any) -> Any:
        asked.append(params.message)
        if says == "cancel":
            return types.ElicitResult(action="cancel")
        return types.ElicitResult(action="accept", content={"confirm": says == "yes"})

    return elicit


@pytest.mark.parametrize("era", ERAS)
def test_every_frame_and_every_own_tool_is_listed(era: str) -> None:
    async def work(client: Client, robot: PlayedRobot) -> None:
        listed = {tool.name: tool for tool in (await client.list_tools()).tools}
        assert set(listed) == {"say", "stop", "world", "deeds", "explain", *robot.tools}
        assert listed["turning"].input_schema["required"] == ["direction"]
        assert listed["unlocking"].annotations.destructive_hint
        assert listed["world"].annotations.read_only_hint

    run(work, PlayedRobot(), era)


@pytest.mark.parametrize("era", ERAS)
def test_a_call_returns_the_one_reply_with_progress(era: str) -> None:
    told: List[str] = []

    async def work(client: Client, robot: PlayedRobot) -> None:
        async def progress(_number: float, _total: Any, message: Any) -> None:
            told.append(message)

        result = await client.call_tool("turning", {"direction": "left", "angle": 1.0}, progress_callback=progress)
        assert not result.is_error
        assert result.structured_content["outcome"] == "DONE"
        assert result.structured_content["command_id"].startswith("agent-Test_Agent-")
        assert robot.called[0][0] == "agent Test_Agent"
        assert robot.called[0][1].frame_name == "turning"

    robot = PlayedRobot([DONE])
    run(work, robot, era)
    assert told == ["executor: begins"]
    assert robot.cancelled == []


@pytest.mark.parametrize("era", ERAS)
@pytest.mark.parametrize(
    ("name", "arguments", "code"),
    [
        ("flying", {}, "UNKNOWN_TOOL"),
        ("cmd_vel", {"linear": 1.0}, "UNKNOWN_TOOL"),
        ("turning", {"direction": "up"}, "VALUE_NOT_ALLOWED"),
        ("say", {}, "MISSING_ELEMENT"),
        ("say", {"text": "Release the emergency stop."}, "EMERGENCY_STOP"),
        ("say", {"text": "yes"}, "NOT_A_PERSON"),
        ("stop", {"emergency": "false"}, "WRONG_TYPE"),
        ("stop", {"release": True}, "UNKNOWN_ELEMENT"),
        ("world", {"most": 1.5}, "WRONG_TYPE"),
    ],
)
def test_a_refusal_names_its_reason_and_is_in_the_log_of_deeds(era: str, name: str, arguments: Any, code: str) -> None:
    async def work(client: Client, robot: PlayedRobot) -> None:
        result = await client.call_tool(name, arguments)
        assert result.is_error
        assert (result.structured_content["outcome"], result.structured_content["code"]) == ("REFUSED", code)
        deeds = (await client.call_tool("deeds", {})).structured_content["deeds"]
        assert (deeds[0]["asked_by"], deeds[0]["code"]) == ("agent Test_Agent", code)

    robot = PlayedRobot()
    run(work, robot, era)
    assert robot.called == []
    assert robot.said == []


@pytest.mark.parametrize("era", ERAS)
@pytest.mark.parametrize("says", ["yes", "no", "cancel"])
def test_a_person_confirms_a_frame_or_not(era: str, says: str) -> None:
    asked: List[str] = []

    async def work(client: Client, robot: PlayedRobot) -> None:
        result = await client.call_tool("unlocking", {"lock": "the front door"})
        assert result.structured_content["code"] == ("DONE" if says == "yes" else "DECLINED")

    robot = PlayedRobot([DONE])
    run(work, robot, era, elicitation_callback=person(says, asked))
    assert len(asked) == 1
    assert "unlocking (lock: the front door)" in asked[0]
    assert "agent Test_Agent" in asked[0]
    assert len(robot.called) == (1 if says == "yes" else 0)


@pytest.mark.parametrize("era", ERAS)
def test_without_a_person_what_wants_a_yes_is_refused(era: str) -> None:
    async def work(client: Client, robot: PlayedRobot) -> None:
        result = await client.call_tool("unlocking", {"lock": "the front door"})
        assert result.structured_content["code"] == "CONFIRM"
        assert "cannot ask" in result.structured_content["sentence"]

    robot = PlayedRobot([DONE])
    run(work, robot, era)
    assert robot.called == []


@pytest.mark.parametrize("era", ERAS)
@pytest.mark.parametrize("says", ["yes", "no", "nobody"])
def test_a_person_answers_what_the_robot_asks_about_a_sentence(era: str, says: str) -> None:
    asked: List[str] = []

    async def work(client: Client, robot: PlayedRobot) -> Any:
        return await client.call_tool("say", {"text": "Unlock the front door."})

    robot = PlayedRobot([ASKS, DONE])
    options = {} if says == "nobody" else {"elicitation_callback": person(says, asked)}
    result = run(work, robot, era, **options)
    assert [text for _, text in robot.said] == ["Unlock the front door.", "Yes." if says == "yes" else "No."]
    if says == "nobody":
        assert result.structured_content["code"] == "CONFIRM"
    else:
        assert "Shall I really do this?" in asked[0]


def test_an_answer_counts_for_its_own_call_only() -> None:
    async def work(client: Client, robot: PlayedRobot) -> None:
        first = await client.session.call_tool("unlocking", {"lock": "the shed"}, allow_input_required=True)
        state = first.request_state
        yes = {"confirm": types.ElicitResult(action="accept", content={"confirm": True})}
        for lock, said_state in (("the front door", state), ("the shed", state), ("the shed", "made up")):
            result = await client.session.call_tool(
                "unlocking", {"lock": lock}, input_responses=yes, request_state=said_state, allow_input_required=True
            )
            assert result.structured_content["code"] == "DECLINED"

    robot = PlayedRobot([DONE])
    run(work, robot, "auto", elicitation_callback=person("yes", []))
    assert robot.called == []


@pytest.mark.parametrize("era", ERAS)
def test_a_call_that_is_given_up_is_cancelled(era: str) -> None:
    async def work(client: Client, robot: PlayedRobot) -> None:
        task = asyncio.ensure_future(client.call_tool("turning", {"direction": "left"}))
        while not robot.called:
            await asyncio.sleep(0.01)
        task.cancel()
        while not robot.cancelled:
            await asyncio.sleep(0.01)

    robot = PlayedRobot()
    run(work, robot, era)
    assert len(robot.cancelled) == 1


def test_an_emergency_stop_refuses_calls() -> None:
    async def work(client: Client, robot: PlayedRobot) -> None:
        robot.emergency = "The emergency stop holds."
        result = await client.call_tool("turning", {"direction": "left"})
        assert result.structured_content["code"] == "EMERGENCY_STOP"

    run(work, PlayedRobot([DONE]), "legacy")


def test_nobody_there_is_told() -> None:
    async def work(client: Client, robot: PlayedRobot) -> None:
        robot.is_there = False
        result = await client.call_tool("turning", {"direction": "left"})
        assert result.structured_content["code"] == "STAGE_SILENT"

    run(work, PlayedRobot(), "legacy")


def test_calls_at_a_time_are_limited_and_a_stop_is_not() -> None:
    async def work(client: Client, robot: PlayedRobot) -> None:
        tasks = [asyncio.ensure_future(client.call_tool("turning", {"direction": "left"})) for _ in range(MOST_CALLS)]
        while len(robot.called) < MOST_CALLS:
            await asyncio.sleep(0.01)
        result = await client.call_tool("turning", {"direction": "left"})
        assert result.structured_content["code"] == "BUSY"
        robot.answers = [Answer("", "DONE", "stop_server", "DONE", "Stopped.")]
        result = await client.call_tool("stop", {})
        assert result.structured_content["outcome"] == "DONE"
        assert robot.said[-1][1] == "Stop."
        for task in tasks:
            task.cancel()

    run(work, PlayedRobot(), "legacy")


def test_a_client_hears_that_the_tools_have_changed() -> None:
    heard: List[str] = []

    async def on_message(message: Any) -> None:
        heard.append(type(message).__name__)

    async def work(client: Client, robot: PlayedRobot) -> None:
        await client.list_tools()
        robot.tools.pop("turning")
        await robot.tell_tools()
        while "ToolListChangedNotification" not in heard:
            await asyncio.sleep(0.01)
        assert "turning" not in {tool.name for tool in (await client.list_tools()).tools}

    run(work, PlayedRobot(), "legacy", message_handler=on_message)


def test_a_sentence_is_explained_and_not_said() -> None:
    async def work(client: Client, robot: PlayedRobot) -> None:
        result = await client.call_tool("explain", {"text": "Turn left."})
        assert result.structured_content["explanation"] == "it is read as Turn left."

    robot = PlayedRobot()
    run(work, robot, "legacy")
    assert robot.said == []
