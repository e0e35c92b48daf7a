"""Each line of the table of dangers in the README, against the real server: sockets, headers, websockets."""

import asyncio
import base64
import contextlib
import gzip
import hashlib
import json
import re
import socket
from concurrent.futures import Future
from dataclasses import replace

import pytest
from tornado.httpclient import AsyncHTTPClient, HTTPClientError, HTTPRequest
from tornado.websocket import websocket_connect

from roboframenet_ros.sqlite_file import StoreError
from web_console.page_files import FOLDER
from web_console.requests import LONGEST_MESSAGE, LONGEST_SOUND, Cancel, Say, Sound, Stop
from web_console.sensing import NoPicture
from web_console.site import MOST_PAGES, PAGE_RATE, PAST_RATE, Callbacks, Site, SiteSettings

TOKEN = "0123456789abcdef"
LIMIT_S = 20.0


class Console:
    """A site on a free port, and what its pages asked for."""

    def __init__(self, settings):
        self.asked = []
        self.counts = []
        self.site = Site(
            settings,
            Callbacks(
                on_request=self.asked.append,
                on_pages=self.counts.append,
                snapshot=lambda: [("status", '{"view":"status","value":1}')],
                past=self.past,
                sensors=self,
            ),
        )
        self.port = self.site.listen([0])

    def offered(self):
        return '{"cameras":{"0":"front camera"},"numbers":{}}'

    def numbers(self, places):
        self.asked.append(places)
        return "[1.5]"

    def picture(self, place):
        if place:
            raise NoPicture("there is no such camera or number")
        found = Future()
        found.set_result(("image/jpeg", b"picture"))
        return found

    def past(self, name, words, before_s):
        self.asked.append((name, words, before_s))
        found = Future()
        if words == "broken":
            found.set_exception(StoreError("the disk is full"))
        else:
            found.set_result(f"{name} {words}")
        return found

    async def fetch(self, path="/", **headers):
        request = HTTPRequest(f"http://127.0.0.1:{self.port}{path}", headers=headers, follow_redirects=False)
        return await AsyncHTTPClient().fetch(request, raise_error=False)

    async def page(self, **headers):
        return await websocket_connect(HTTPRequest(f"ws://127.0.0.1:{self.port}/live", headers=headers))

    async def refusal(self, **headers):
        with pytest.raises(HTTPClientError) as refused:
            await self.page(**headers)
        return refused.value.code


def with_console(test, settings=None):
    """Run a test with a console; nothing in it takes longer than the limit."""

    async def run():
        console = Console(settings or SiteSettings(address="127.0.0.1", longest_text=50))
        try:
            await asyncio.wait_for(test(console), LIMIT_S)
        finally:
            console.site.close()

    asyncio.run(run())


async def until(condition):
    while not condition():
        await asyncio.sleep(0.01)


async def notice(page):
    """Return the text of the next notice."""
    while True:
        message = json.loads(await page.read_message())
        if message["view"] == "notice":
            return message["value"]["text"]


# other machines


def test_other_machines_cannot_connect():
    async def test(console):
        (listening,) = console.site._server._sockets.values()
        assert listening.getsockname()[0] == "127.0.0.1"
        with contextlib.closing(socket.socket()) as other, pytest.raises(OSError):
            other.settimeout(2.0)
            other.connect(("127.0.0.2", console.port))

    with_console(test)


def test_with_a_token_nothing_is_said_without_it():
    async def test(console):
        for path in ("/", "/main.js", "/map-1.png", "/past.json", "/?token=wrong"):
            answer = await console.fetch(path)
            assert answer.code == 401 and b"canvas" not in answer.body
        assert await console.refusal() == 401
        assert await console.refusal(Cookie="web_console=" + "0" * 64) == 401

    with_console(test, SiteSettings(address="127.0.0.1", token=TOKEN))


def test_token_opens_the_page_and_stays_out_of_scripts():
    async def test(console):
        answer = await console.fetch(f"/?token={TOKEN}")
        assert (answer.code, answer.headers["Location"]) == (302, "/")
        cookie = answer.headers["Set-Cookie"]
        assert "HttpOnly" in cookie and "SameSite=Strict" in cookie and TOKEN not in cookie
        known = cookie.partition(";")[0]
        assert (await console.fetch("/", Cookie=known)).code == 200
        page = await console.page(Cookie=known)
        assert json.loads(await page.read_message())["view"] == "status"

    with_console(test, SiteSettings(address="127.0.0.1", token=TOKEN))


def test_tokens_cannot_be_tried_at_will():
    async def test(console):
        codes = [(await console.fetch(f"/?token={number}")).code for number in range(12)]
        assert set(codes) == {401, 429} and codes[-1] == 429

    with_console(test, SiteSettings(address="127.0.0.1", token=TOKEN))


# another page in the same browser


@pytest.mark.parametrize("origin", ["http://evil.example", "null", "http://127.0.0.1:1", "https://localhost"])
def test_foreign_origins_are_refused(origin):
    async def test(console):
        assert await console.refusal(Origin=origin) == 403
        assert console.asked == [] and console.counts == []

    with_console(test)


def test_own_origin_is_accepted():
    async def test(console):
        page = await console.page(Origin=f"http://127.0.0.1:{console.port}")
        assert json.loads(await page.read_message())["view"] == "status"

    with_console(test)


@pytest.mark.parametrize("host", ["evil.example", "evil.example:8080", "localhost.evil.example", "192.168.1.5"])
def test_foreign_hosts_are_refused(host):
    async def test(console):
        for path in ("/", "/main.js", "/live"):
            answer = await console.fetch(path, Host=host)
            assert answer.code == 403 and b"canvas" not in answer.body
        # A name that was made to point here: Origin and Host agree.
        assert await console.refusal(Host=host, Origin=f"http://{host}") == 403

    with_console(test)


def test_page_is_in_no_frame_of_another():
    async def test(console):
        answer = await console.fetch()
        assert answer.headers["X-Frame-Options"] == "DENY"
        assert "frame-ancestors 'none'" in answer.headers["Content-Security-Policy"]

    with_console(test)


# injected markup


def test_every_file_has_the_policy():
    async def test(console):
        for name in ["", *(path.name for path in FOLDER.iterdir())]:
            answer = await console.fetch(f"/{name}")
            assert answer.code == 200
            assert answer.headers["Content-Security-Policy"].startswith("default-src 'self';")
            assert "unsafe" not in answer.headers["Content-Security-Policy"]
            assert answer.headers["X-Content-Type-Options"] == "nosniff"

    with_console(test)


def test_page_comes_with_its_style_and_asks_for_its_modules_at_once():
    async def test(console):
        text = (await console.fetch()).body.decode()
        style = (FOLDER / "style.css").read_text(encoding="utf-8")
        within = text[text.index("<style>") + len("<style>") : text.index("</style>")]
        assert within.endswith(style) and '<link rel="stylesheet"' not in text
        # The worklet is asked for when somebody turns the microphone on.
        modules = {path.name for path in FOLDER.glob("*.js")} - {"main.js", "microphone_worklet.js"}
        assert set(re.findall(r'rel="modulepreload" href="(.*?)"', text)) == modules
        digest = base64.b64encode(hashlib.sha256(within.encode()).digest()).decode()
        policy = (await console.fetch()).headers["Content-Security-Policy"]
        assert f"; style-src 'sha256-{digest}';" in policy

    with_console(test)


def test_files_are_compressed_for_those_that_can_read_it():
    async def test(console):
        name, plain = "/main.js", (FOLDER / "main.js").read_bytes()
        url = f"http://127.0.0.1:{console.port}{name}"
        packed = HTTPRequest(url, headers={"Accept-Encoding": "br, gzip;q=0.8"}, decompress_response=False)
        answer = await AsyncHTTPClient().fetch(packed)
        assert answer.headers["Content-Encoding"] == "gzip" and gzip.decompress(answer.body) == plain
        answer = await AsyncHTTPClient().fetch(HTTPRequest(url, decompress_response=False))
        assert "Content-Encoding" not in answer.headers and answer.body == plain

    with_console(test)


def test_page_makes_no_markup_of_text():
    for path in FOLDER.glob("*.js"):
        text = path.read_text(encoding="utf-8")
        for call in (
            "innerHTML",
            "outerHTML",
            "insertAdjacentHTML",
            "document.write",
            "eval(",
            "Function(",
            "DOMParser",
        ):
            assert call not in text, path
    index = (FOLDER / "index.html").read_text(encoding="utf-8")
    assert not re.search(r"<script(?![^>]*\bsrc=)|<style|\bon\w+=|style=", index)


def test_page_needs_nothing_from_elsewhere():
    for path in FOLDER.iterdir():
        text = path.read_text(encoding="utf-8").replace("http://www.w3.org/2000/svg", "")
        assert not re.search(r"https?://|//[a-z]+\.|@import|url\(", text), path


# a page that can do anything


def test_three_verbs_arrive():
    async def test(console):
        page = await console.page()
        for request in ({"verb": "say", "text": "Ping."}, {"verb": "cancel", "id": "console-1"}, {"verb": "stop"}):
            page.write_message(json.dumps(request))
        await until(lambda: len(console.asked) == 3)
        assert console.asked == [Say("Ping."), Cancel("console-1"), Stop()]

    with_console(test)


def test_sound_arrives_in_parts_that_are_not_too_many():
    async def test(console):
        page = await console.page()
        await page.write_message(bytes(3200), binary=True)
        await until(lambda: console.asked)
        assert console.asked == [Sound(bytes(3200))]
        for bad in (b"", bytes(3), bytes(LONGEST_SOUND + 2)):
            await page.write_message(bad, binary=True)
            assert await notice(page) == "This is no sound."
        for _ in range(100):
            await page.write_message(bytes(2), binary=True)
        await page.write_message('{"verb": "stop"}')
        await until(lambda: Stop() in console.asked)
        assert 10 < len(console.asked) < 60

    with_console(test)


def test_no_sound_where_other_machines_can_be():
    async def test(console):
        console.site._shared.settings = replace(console.site._shared.settings, address="0.0.0.0")
        page = await console.page()
        await page.write_message(bytes(3200), binary=True)
        assert "no other machine" in await notice(page)
        assert console.asked == []

    with_console(test)


def test_other_requests_are_refused():
    async def test(console):
        page = await console.page()
        page.write_message('{"verb": "publish", "topic": "cmd_vel"}')
        assert await notice(page) == "This is not a request."
        page.write_message(json.dumps({"verb": "say", "text": "x" * 51}))
        assert "at most 50 characters" in await notice(page)
        page.write_message(b"\x00\xff\x00", binary=True)
        assert await notice(page) == "This is no sound."
        assert console.asked == []

    with_console(test)


def test_oversize_messages_end_the_page():
    async def test(console):
        page = await console.page()
        page.write_message("x" * (LONGEST_MESSAGE + 1))
        while await page.read_message() is not None:
            pass
        assert page.close_code == 1009 and console.asked == []

    with_console(test)


def test_flood_of_sentences_is_limited_and_stop_still_works():
    async def test(console):
        page = await console.page()
        for _ in range(30):
            page.write_message('{"verb": "say", "text": "Ping."}')
        page.write_message('{"verb": "stop"}')
        assert await notice(page) == "That was too fast. Please wait a second."
        await until(lambda: Stop() in console.asked)
        assert console.asked.count(Say("Ping.")) <= PAGE_RATE.burst + 5

    with_console(test)


def test_many_pages_do_not_raise_the_limit():
    async def test(console):
        pages = [await console.page() for _ in range(8)]
        for page in pages:
            for _ in range(8):
                page.write_message('{"verb": "say", "text": "Ping."}')
        pages[0].write_message('{"verb": "stop"}')
        await until(lambda: Stop() in console.asked)
        assert console.asked.count(Say("Ping.")) < 40

    with_console(test)


def test_page_that_floods_is_closed():
    async def test(console):
        page = await console.page()
        for _ in range(200):
            page.write_message("nonsense")
        while await page.read_message() is not None:
            pass
        assert page.close_code == 1008

    with_console(test)


def test_there_are_not_too_many_pages():
    async def test(console):
        pages = [await console.page() for _ in range(MOST_PAGES)]
        assert await console.refusal() == 503
        pages[0].close()
        await until(lambda: console.counts[-1] < MOST_PAGES)
        await console.page()

    with_console(test)


@pytest.mark.parametrize(
    "path", ["/../node.py", "/%2e%2e/node.py", "/etc/passwd", "/node.py", "/map-1.png", "/style.css/x"]
)
def test_there_are_no_other_files(path):
    async def test(console):
        assert (await console.fetch(path)).code in (403, 404)

    with_console(test)


# a page that comes late or drops out


def test_late_page_gets_everything_and_then_changes():
    async def test(console):
        page = await console.page()
        assert await page.read_message() == '{"view":"status","value":1}'
        console.site.send([("pose", "moved")])
        assert await page.read_message() == "moved"

    with_console(test)


def test_page_that_drops_out_is_forgotten():
    async def test(console):
        page = await console.page()
        await until(lambda: console.site.page_count == 1)
        page.close()
        await until(lambda: console.site.page_count == 0)
        console.site.send([("pose", "moved")])
        assert console.counts == [1, 0]

    with_console(test)


def test_taken_port_is_skipped():
    async def test(console):
        other = Site(SiteSettings(address="127.0.0.1"), Callbacks(print, print, list, print, print))
        with pytest.raises(OSError):
            other.listen([console.port])
        assert other.listen([console.port, 0]) not in (0, console.port)
        other.close()

    with_console(test)


# what was said before


def test_past_conversations_are_found_and_kept_as_files():
    async def test(console):
        answer = await console.fetch("/past.json?words=cup&before=12.5")
        assert (answer.body, answer.headers["Content-Type"]) == (b"past.json cup", "application/json")
        answer = await console.fetch("/sentences.yaml?words=cup%20:wrong")
        assert answer.body == b"sentences.yaml cup :wrong"
        assert answer.headers["Content-Disposition"] == 'attachment; filename="sentences.yaml"'
        assert console.asked == [("past.json", "cup", 12.5), ("sentences.yaml", "cup :wrong", 0.0)]

    with_console(test)


def test_searches_are_short_and_their_failures_are_told():
    async def test(console):
        await console.fetch(f"/past.json?words={'x' * 5000}")
        assert len(console.asked[0][1]) == 200
        assert (await console.fetch("/past.json?before=yesterday")).code == 400
        await console.fetch("/past.json?before=nan")
        assert console.asked[-1] == ("past.json", "", 0.0)
        answer = await console.fetch("/past.json?words=broken")
        assert (answer.code, answer.body) == (500, b"the disk is full\n")
        answers = [(await console.fetch("/past.json")).code for _ in range(2 * int(PAST_RATE.burst))]
        assert 429 in answers

    with_console(test)


# what it senses


def test_pictures_and_numbers_are_asked_for_by_their_places():
    async def test(console):
        assert b"front camera" in (await console.fetch("/sensors.json")).body
        answer = await console.fetch("/camera?of=0&at=1")
        assert (answer.body, answer.headers["Content-Type"]) == (b"picture", "image/jpeg")
        assert (await console.fetch("/numbers.json?of=3,1")).body == b"[1.5]"
        assert console.asked == [[3, 1]]
        answer = await console.fetch("/camera?of=1")
        assert (answer.code, answer.body) == (404, b"Nothing to see: there is no such camera or number.\n")

    with_console(test)


def test_no_name_of_a_topic_is_read():
    async def test(console):
        assert (await console.fetch("/camera?of=/front_camera/image_raw")).code == 404
        await console.fetch("/numbers.json?of=/odom,-1,%D9%A3x,99999,2,3,4,5,6,7")
        assert console.asked == [[]]
        await console.fetch("/numbers.json?of=2,3,4,5,6,7")
        assert console.asked[-1] == [2, 3, 4, 5]

    with_console(test)
