"""A page can do six things, and nothing else."""

import json

import pytest

from web_console.outbox import MOST_WAITING, Outbox
from web_console.rate_limit import Rate, RateLimit
from web_console.requests import BadRequest, Cancel, Judge, Listen, Say, Stop, read_request


def read(**said):
    return read_request(json.dumps(said), longest_text=20)


def test_six_verbs():
    assert read(verb="say", text="Ping.") == Say("Ping.")
    assert read(verb="cancel", id="console-1") == Cancel("console-1")
    assert read(verb="stop") == Stop()
    assert read(verb="listen") == Listen()
    assert read(verb="emergency_stop") == Stop(stays=True)
    assert read(verb="judge", id="console-1", verdict="wrong", meant=" Go\nhome. ") == Judge(
        "console-1", "wrong", "Go home."
    )
    assert read(verb="judge", id="console-1", verdict="", meant="") == Judge("console-1", "")


@pytest.mark.parametrize(
    "message",
    [
        "",
        "stop",
        "[]",
        "3",
        '"stop"',
        "[" * 100_000,
        b'{"verb": "stop"}',
        '{"verb": "publish", "topic": "cmd_vel"}',
        '{"verb": "say", "text": "Ping.", "topic": "cmd_vel"}',
        '{"verb": "say"}',
        '{"verb": "say", "text": 3}',
        '{"verb": "say", "text": ["Ping."]}',
        '{"verb": "cancel", "id": ""}',
        '{"verb": "cancel", "id": null}',
        '{"verb": "judge", "id": "console-1", "verdict": "good", "meant": ""}',
        '{"verb": "judge", "id": "console-1", "verdict": ["right"], "meant": ""}',
        '{"verb": "judge", "id": "console-1", "verdict": "right"}',
        '{"verb": "judge", "id": "", "verdict": "right", "meant": ""}',
        '{"verb": "judge", "id": "console-1", "verdict": "wrong", "meant": "longer than 20 characters"}',
        '{"verb": ["stop"]}',
        '{"verb": "emergency_stop", "release": true}',
        '{"verb": "release"}',
        '{"verb": "listen", "text": "Ping."}',
        '{"op": "call_service", "service": "/rosapi/get_param"}',
    ],
)
def test_nothing_else(message):
    with pytest.raises(BadRequest):
        read_request(message, longest_text=20)


def test_sentences_have_a_limit():
    assert read(verb="say", text="x" * 20) == Say("x" * 20)
    with pytest.raises(BadRequest, match="at most 20 characters; this one has 21"):
        read(verb="say", text="x" * 21)


def test_sentences_are_one_line_of_print():
    assert read(verb="say", text=" turn\n\x1b[31m\tleft ") == Say("turn [31m left")
    with pytest.raises(BadRequest, match="no words"):
        read(verb="say", text=" \x00\n ")


def test_rate_is_limited_and_recovers():
    limit = RateLimit(Rate(per_s=2.0, burst=3.0), now_s=10.0)
    assert [limit.take(10.0) for _ in range(5)] == [True, True, True, False, False]
    assert not limit.take(10.4)
    assert limit.take(10.5)
    assert [limit.take(1000.0) for _ in range(4)] == [True, True, True, False]


def test_outbox_keeps_the_newest_of_each_view():
    outbox = Outbox()
    for number in range(1000):
        outbox.put("pose", f"pose {number}")
        outbox.put("status", f"status {number}")
    assert len(outbox) == 2
    assert [outbox.take(), outbox.take(), outbox.take()] == ["pose 999", "status 999", None]


def test_outbox_of_a_page_that_hangs_is_bounded():
    outbox = Outbox()
    outbox.put("abilities", "what it can do")
    for number in range(5000):
        outbox.put(f"command {number}", f"command {number}")
    assert len(outbox) == MOST_WAITING
    assert outbox.take() == "what it can do"
    waiting = [outbox.take() for _ in range(MOST_WAITING - 1)]
    assert waiting[-1] == "command 4999"
