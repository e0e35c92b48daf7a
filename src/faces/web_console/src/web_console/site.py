"""The web server: one page, its pictures and its websocket. Everything runs in the thread of the event loop."""

import asyncio
import hashlib
import hmac
import json
import math
import re
import time
from concurrent.futures import Future
from dataclasses import dataclass, field
from typing import Callable, Dict, Optional, Protocol, Sequence, Set, Tuple, Union

from tornado.httpserver import HTTPServer
from tornado.web import Application, RequestHandler
from tornado.websocket import WebSocketClosedError, WebSocketHandler

from roboframenet_ros.sqlite_file import StoreError
from web_console.access import host_pattern, is_local, is_token
from web_console.outbox import Outbox
from web_console.page_files import PageFile, read_page
from web_console.past import FILES, LIST
from web_console.rate_limit import Rate, RateLimit
from web_console.requests import LONGEST_MESSAGE, BadRequest, Request, Sound, Stop, read_request, read_sound
from web_console.sensing import NoPicture

#: Beside the policy of `page_files`: in no frame of another page, and nothing told to another.
HEADERS = {
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cache-Control": "no-cache",
}
_COOKIE = "web_console"
_PING_S = 20.0
#: Sentences, answers and cancels of one page, and of all.
PAGE_RATE = Rate(per_s=2.0, burst=8.0)
ALL_RATE = Rate(per_s=5.0, burst=20.0)
#: Stops come more often, but a flood of them must not keep the node from anything else.
STOP_RATE = Rate(per_s=10.0, burst=20.0)
#: Parts of sound of all pages: one page sends ten a second.
SOUND_RATE = Rate(per_s=15.0, burst=30.0)
#: A page that sends this many bad or too many messages is closed.
_TOKEN_RATE = Rate(per_s=0.5, burst=5.0)
_MOST_FAULTS = 50
#: Searches of all pages in what was said.
PAST_RATE = Rate(per_s=5.0, burst=20.0)
#: Pictures and numbers of all pages.
SENSOR_RATE = Rate(per_s=40.0, burst=80.0)
_TOO_FAST = "That was too fast. Please wait a second."
_LONGEST_SEARCH = 200
_MOST_NUMBERS = 4
MOST_PAGES = 32


@dataclass(frozen=True)
class SiteSettings:
    """What the site offers, and to whom.

    Attributes:
        address: where it listens
        token: what a browser must know; empty for none
        names: names by which other machines call this one
        longest_text: how many characters a sentence may have
    """

    address: str
    token: str = ""
    names: Tuple[str, ...] = ()
    longest_text: int = 1000


class Sensors(Protocol):
    """Cameras and numbers, by their places in the list that was offered; `picture` and `numbers` raise `NoPicture`."""

    def offered(self) -> str:
        """Return the names of cameras and numbers as JSON."""

    def numbers(self, places: Sequence[int]) -> str:
        """Return the newest values of numbers as JSON."""

    def picture(self, place: int) -> "Future[Tuple[str, bytes]]":
        """Return the media type and the data of the newest picture of a camera."""


@dataclass(frozen=True)
class Callbacks:
    """Called in the thread of the event loop; none may block.

    Attributes:
        on_request: a page asks for something
        on_pages: the number of pages has changed
        snapshot: returns all keys and messages for a new page
        sensors: cameras and numbers
        past: finds past conversations: the name of the list or file, words, and a time before which they were said
    """

    on_request: Callable[[Request], None]
    on_pages: Callable[[int], None]
    snapshot: Callable[[], Sequence[Tuple[str, str]]]
    past: "Callable[[str, str, float], Future[str]]"
    sensors: "Sensors"


@dataclass
class _Shared:
    """What the handlers share."""

    settings: SiteSettings
    callbacks: Callbacks
    files: Dict[str, PageFile]
    policy: str
    cookie: str
    pages: "Set[PageSocket]" = field(default_factory=set)
    pictures: Dict[str, bytes] = field(default_factory=dict)
    limits: Dict[str, RateLimit] = field(default_factory=dict)

    def may(self, what: str) -> bool:
        return self.limits[what].take(time.monotonic())


class Site:
    """Offers the page and keeps its copies up to date."""

    def __init__(self, settings: SiteSettings, callbacks: Callbacks) -> None:
        """Read the files of the page.

        Args:
            settings: what is offered
            callbacks: what happens when a page asks
        """
        files, policy = read_page()
        cookie = hmac.new(settings.token.encode(), b"web_console", hashlib.sha256).hexdigest()
        self._shared = _Shared(settings, callbacks, files, policy, cookie)
        now_s = time.monotonic()
        for name, rate in (
            ("request", ALL_RATE),
            ("stop", STOP_RATE),
            ("sound", SOUND_RATE),
            ("token", _TOKEN_RATE),
            ("past", PAST_RATE),
            ("sensors", SENSOR_RATE),
        ):
            self._shared.limits[name] = RateLimit(rate, now_s)
        self._server: Optional[HTTPServer] = None

    def application(self) -> Application:
        """Make the application: it answers only requests for its own names."""
        application = Application(
            default_handler_class=_OtherHost,
            log_function=lambda handler: None,
            websocket_max_message_size=LONGEST_MESSAGE,
            websocket_ping_interval=_PING_S,
        )
        shared = {"shared": self._shared}
        application.add_handlers(
            host_pattern(self._shared.settings.address, self._shared.settings.names),
            [
                (r"/live", PageSocket, shared),
                (r"/(sensors\.json|numbers\.json|camera)", _Sensor, shared),
                (r"/(map-\d+\.png)", _Picture, shared),
                (rf"/({'|'.join(map(re.escape, (LIST, *FILES)))})", _PastFile, shared),
                (r"/([a-z_]*(?:\.[a-z]+)?)", _File, shared),
            ],
        )
        return application

    def listen(self, ports: Sequence[int]) -> int:
        """Begin to answer; returns the port.

        Args:
            ports: the first that is free is taken; 0 is any

        Raises:
            OSError: none is free, or the address is none of this machine
        """
        server = HTTPServer(self.application(), max_body_size=LONGEST_MESSAGE, max_header_size=LONGEST_MESSAGE)
        for port in ports:
            try:
                server.listen(port, address=self._shared.settings.address)
            except OSError:
                if port == ports[-1]:
                    raise
                continue
            self._server = server
            return next(iter(server._sockets.values())).getsockname()[1]  # type: ignore[no-any-return]
        raise OSError("no port")

    def close(self) -> None:
        """End all pages."""
        if self._server is not None:
            self._server.stop()
        for page in tuple(self._shared.pages):
            page.close(1001, "The console ends.")

    def send(self, changes: Sequence[Tuple[str, str]]) -> None:
        """Send messages, each with its key, to all pages."""
        for page in tuple(self._shared.pages):
            page.put(changes)

    def show_picture(self, name: str, data: bytes) -> None:
        """Offer a picture, and no other of its kind."""
        self._shared.pictures = {name: data}

    @property
    def page_count(self) -> int:
        """How many pages are open."""
        return len(self._shared.pages)


class _OtherHost(RequestHandler):
    """A request for a name that is not ours, or a path that does not exist: nothing is said about what is here."""

    def prepare(self) -> None:
        self.set_status(403)
        self.finish("Call this page by the name of its machine, such as 127.0.0.1.\n")


class _Guarded(RequestHandler):
    """Sends the headers of the page, and asks for the token where there is one."""

    def initialize(self, shared: _Shared) -> None:
        self.shared = shared

    def set_default_headers(self) -> None:
        for name, value in HEADERS.items():
            self.set_header(name, value)
        self.clear_header("Server")

    def refuse(self, status: int, reason: str) -> None:
        """Answer with a reason in place of what was asked for."""
        self.set_status(status)
        self.finish(f"{reason}\n")

    def prepare(self) -> None:
        self.set_header("Content-Security-Policy", self.shared.policy)
        if _knows_token(self, self.shared):
            return
        said = self.get_query_argument("token", "")
        if not self.shared.may("token"):
            self.refuse(429, "Too many attempts; wait a moment.")
        elif self.request.path == "/" and said and is_token(said, self.shared.settings.token):
            self.set_cookie(_COOKIE, self.shared.cookie, httponly=True, samesite="Strict")
            self.redirect("/")
        else:
            self.refuse(401, "Open this page as /?token=..., with the secret of the file that ~token_file names.")


def _knows_token(handler: RequestHandler, shared: _Shared) -> bool:
    return not shared.settings.token or is_token(handler.get_cookie(_COOKIE) or "", shared.cookie)


class _File(_Guarded):
    """The files of the page."""

    def get(self, name: str) -> None:
        file = self.shared.files.get(name)
        if file is None:
            self.refuse(404, "There is no such page.")
            return
        self.set_header("Content-Type", file.kind)
        self.set_header("Vary", "Accept-Encoding")
        accepted = self.request.headers.get("Accept-Encoding", "")
        if "gzip" in [one.partition(";")[0].strip() for one in accepted.split(",")]:
            self.set_header("Content-Encoding", "gzip")
            self.finish(file.packed)
        else:
            self.finish(file.data)


class _Picture(_Guarded):
    """The picture of the map."""

    def get(self, name: str) -> None:
        data = self.shared.pictures.get(name)
        if data is None:
            self.refuse(404, "There is no such picture.")
            return
        self.set_header("Content-Type", "image/png")
        self.finish(data)


class _Sensor(_Guarded):
    """What can be looked at, the newest numbers, and the newest picture of a camera."""

    async def get(self, name: str) -> None:
        if not self.shared.may("sensors"):
            self.refuse(429, _TOO_FAST)
            return
        sensors = self.shared.callbacks.sensors
        kind = "application/json"
        try:
            if name == "sensors.json":
                data: Union[str, bytes] = sensors.offered()
            else:
                said = self.get_query_argument("of", "") or ""
                places = [int(one) for one in said.split(",")[:_MOST_NUMBERS] if one.isdecimal() and len(one) < 5]
                if name == "numbers.json":
                    data = sensors.numbers(places)
                else:
                    picture = await asyncio.wrap_future(sensors.picture(places[0] if places else -1))
                    kind, data = picture
        except NoPicture as error:
            self.refuse(404, f"Nothing to see: {error}.")
            return
        self.set_header("Content-Type", kind)
        self.finish(data)


class _PastFile(_Guarded):
    """What was said before: the list, and files to keep."""

    async def get(self, name: str) -> None:
        words = (self.get_query_argument("words", "") or "")[:_LONGEST_SEARCH]
        if not self.shared.may("past"):
            self.refuse(429, _TOO_FAST)
            return
        try:
            before_s = float(self.get_query_argument("before", "0") or 0.0)
            text = await asyncio.wrap_future(
                self.shared.callbacks.past(name, words, before_s if math.isfinite(before_s) else 0.0)
            )
        except (ValueError, StoreError) as error:
            self.refuse(500 if isinstance(error, StoreError) else 400, str(error))
            return
        self.set_header("Content-Type", "application/json" if name == LIST else "text/plain; charset=utf-8")
        if name != LIST:
            self.set_header("Content-Disposition", f'attachment; filename="{name}"')
        self.finish(text)


class PageSocket(WebSocketHandler):
    """One open page. `check_origin` is Tornado's: only pages that came from here may connect."""

    def initialize(self, shared: _Shared) -> None:
        """Called by Tornado."""
        self._shared = shared
        self._outbox = Outbox()
        self._wake = asyncio.Event()
        self._limit = RateLimit(PAGE_RATE, time.monotonic())
        self._faults = 0
        self._number = 0
        self._writer: Optional[asyncio.Task[None]] = None

    def prepare(self) -> None:
        """Refuse a page without the token."""
        if not _knows_token(self, self._shared):
            self.set_status(401)
            self.finish()
        elif len(self._shared.pages) >= MOST_PAGES:
            self.set_status(503)
            self.finish()

    def open(self, *_args: str, **_kwargs: str) -> None:
        """A page has come: it gets everything."""
        self.set_nodelay(True)
        self._shared.pages.add(self)
        self.put(self._shared.callbacks.snapshot())
        self._writer = asyncio.ensure_future(self._write())
        self._shared.callbacks.on_pages(len(self._shared.pages))

    def on_close(self) -> None:
        """A page has gone."""
        self._shared.pages.discard(self)
        if self._writer is not None:
            self._writer.cancel()
        self._shared.callbacks.on_pages(len(self._shared.pages))

    def put(self, messages: Sequence[Tuple[str, str]]) -> None:
        """Let messages wait for their turn."""
        for key, message in messages:
            self._outbox.put(key, message)
        self._wake.set()

    async def _write(self) -> None:
        try:
            while True:
                await self._wake.wait()
                self._wake.clear()
                message = self._outbox.take()
                while message is not None:
                    await self.write_message(message)
                    message = self._outbox.take()
        except WebSocketClosedError:
            return

    def on_message(self, message: Union[str, bytes]) -> None:
        """The page asks for something."""
        try:
            request = self._read(message)
        except BadRequest as error:
            self._refuse(str(error))
            return
        if isinstance(request, Sound):
            # What is too much is lost.
            if self._shared.may("sound"):
                self._shared.callbacks.on_request(request)
            return
        if isinstance(request, Stop):
            is_allowed = self._shared.may("stop")
        else:
            is_allowed = self._limit.take(time.monotonic()) and self._shared.may("request")
        if is_allowed:
            self._shared.callbacks.on_request(request)
        else:
            self._refuse(_TOO_FAST)

    def _read(self, message: Union[str, bytes]) -> Request:
        """Read a message.

        Raises:
            BadRequest: it is no request, or a sound from where other machines can be
        """
        if isinstance(message, str):
            return read_request(message, longest_text=self._shared.settings.longest_text)
        if not is_local(self._shared.settings.address):
            raise BadRequest("Only a page that no other machine can open may send sound.")
        return read_sound(message)

    def _refuse(self, reason: str) -> None:
        self._faults += 1
        if self._faults > _MOST_FAULTS:
            self.close(1008, "Too many requests.")
            return
        self._number += 1
        self.put([("notice", json.dumps({"view": "notice", "value": {"number": self._number, "text": reason}}))])
