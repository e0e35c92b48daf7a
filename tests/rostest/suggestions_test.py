#!/usr/bin/python3
"""Each sentence that the page suggests, said when the page shows it, is done: as many as ~count, of them ~least."""

import asyncio
import json
import unittest
from typing import Any, Dict, List, Tuple

import rospy
from tornado.websocket import WebSocketClientConnection, websocket_connect

from roboframenet_rostest import wait_for_pipeline
from roboframenet_testing import wait_until

_REPLY_S = 180.0
_SETTLE_S = 60.0
#: How a question ends that is asked before something that needs a confirmation.
_CONFIRM = "Say yes or no."


class Page:
    """What a page in a browser is told, and what it asks for."""

    def __init__(self, socket: WebSocketClientConnection) -> None:
        self._socket = socket
        self._views: Dict[str, Any] = {}
        self._commands: Dict[str, Any] = {}

    async def _hear(self) -> None:
        message = await self._socket.read_message()
        assert message is not None, "the page has lost its connection"
        heard = json.loads(message)
        if heard["view"] == "command":
            self._commands[heard["value"]["id"]] = heard["value"]
        else:
            self._views[heard["view"]] = heard["value"]

    async def suggestion(self, before: str) -> str:
        """Return the first suggestion, as soon as there is another one than before and nothing runs."""
        while self._suggestions[:1] in ([], [before]) or self._views.get("status", {}).get("active"):
            await asyncio.wait_for(self._hear(), _SETTLE_S)
        return str(self._suggestions[0])

    @property
    def _suggestions(self) -> List[str]:
        return list(self._views.get("suggestions", {}).get("sentences", ()))

    async def say(self, text: str) -> Tuple[str, str]:
        """Say a sentence; return the outcome and the sentence of its reply."""
        before = set(self._commands)
        await self._socket.write_message(json.dumps({"verb": "say", "text": text}))
        while True:
            await self._hear()
            new = [one for ident, one in self._commands.items() if ident not in before and one["text"] == text]
            if new and new[-1]["reply"]:
                return str(new[-1]["reply"]["outcome"]), str(new[-1]["reply"]["sentence"])


async def say_all(address: str, count: int) -> List[Tuple[str, str, str]]:
    """Say suggestions one after the other; return each with the outcome and the sentence of its reply."""
    page = Page(await websocket_connect(address))
    told: List[Tuple[str, str, str]] = []
    text = ""
    for _ in range(count):
        text = await page.suggestion(text)
        try:
            outcome, sentence = await asyncio.wait_for(page.say(text), _REPLY_S)
            if sentence.endswith(_CONFIRM):
                outcome, sentence = await asyncio.wait_for(page.say("Yes."), _REPLY_S)
        except asyncio.TimeoutError:
            outcome, sentence = "LATE", ""
            await page.say("Stop.")
        told.append((text, outcome, sentence))
        print(f"{len(told)} {text} {outcome} {sentence}", flush=True)
        if outcome == "NEEDS_INFORMATION":
            await page.say("No.")
    return told


class SuggestionsTest(unittest.TestCase):
    """All in one conversation."""

    def test_suggestions_are_done(self) -> None:
        wait_until(lambda: rospy.has_param("web_console/url"), message="the page is not there")
        wait_for_pipeline(tuple(rospy.get_param("~frames")))
        address = rospy.get_param("web_console/url").replace("http:", "ws:") + "live"
        told = asyncio.run(say_all(address, rospy.get_param("~count")))
        self.assertEqual(len({text for text, _, _ in told}), len(told), "a sentence was suggested twice")
        done = [text for text, outcome, _ in told if outcome == "DONE"]
        other = [one for one in told if one[1] != "DONE"]
        self.assertGreaterEqual(len(done), rospy.get_param("~least"), other)


if __name__ == "__main__":
    import rostest

    rospy.init_node("suggestions_test", disable_signals=True)
    rostest.rosrun("roboframenet_tests", "suggestions", SuggestionsTest)
