"""The node of the page: the event loop of the web server in the main thread, and the subscribers of rospy."""

import functools
import os
from typing import Any, Callable, Dict, FrozenSet, List, Tuple

import rospy
from roboframenet_msgs.msg import StopReport
from tornado.ioloop import IOLoop, PeriodicCallback

from command_server.ros_settings import StopTargets
from roboframenet_ros.command_ids import came_by_action
from roboframenet_ros.home_folder import file_in_ros_home
from roboframenet_ros.ros_node import StartError, read_parameters, run_node
from robot_stop.emergency import Emergency
from robot_stop.ros_emergency import EmergencyWatch
from robot_stop.settings import BrakeSettings
from web_console.access import AccessError, check_access, read_token
from web_console.board import Board
from web_console.conversations import Conversation
from web_console.history import MOST_COMMANDS, History
from web_console.past import Past
from web_console.requests import Cancel, Judge, Listen, Request, Say, Sound
from web_console.ros_ground import GroundTap
from web_console.ros_knowledge import KnowledgeTap
from web_console.ros_listener import Listener
from web_console.ros_sensors import SensorTap
from web_console.ros_speaker import Speaker
from web_console.ros_voice import VoiceTap
from web_console.settings import Settings
from web_console.site import Callbacks, Site, SiteSettings
from web_console.suggestions import Present, read_templates, suggest
from web_console.views import AbilitiesView, EmergencyView, HealthView, PastView, StopView, SuggestionsView

#: Changes are gathered for this long, so that a page is not drawn anew for each of several messages about one thing.
_GATHER_S = 0.015
_LOOK_MS = 100
#: So many sentences are not suggested again; then all are.
_MOST_SAID = 1000
#: Two others can stop the robot before this node has to.
_REFRESH_PERIOD_S = 5.0
#: When the port is taken, the next ones are tried.
_PORTS = 10


class WebConsole:
    """Joins the subscribers, the views and the site. Its methods run in the thread of the event loop.

    Publishes: what a `Speaker` and a `VoiceTap` do. Subscribes: ``emergency_stop``, and what `Listener`, `GroundTap`,
    `KnowledgeTap` and `VoiceTap` do.
    """

    def __init__(self, settings: Settings, site_settings: SiteSettings, brake_settings: BrakeSettings) -> None:
        self._loop = IOLoop.current()
        self._is_flush_due = False
        self._board = Board(most_commands=MOST_COMMANDS)
        self._history = History(is_own=came_by_action)
        self._templates = read_templates()
        self._frames: FrozenSet[str] = frozenset()
        self._present: Tuple[Present, ...] = ()
        self._said: Dict[str, None] = {}
        robot = rospy.get_namespace().strip("/").replace("/", ".")
        own_file = f"conversations.{robot}.sqlite" if robot else "conversations.sqlite"
        self._past = Past(
            os.path.expanduser(settings.conversations_file or file_in_ros_home(own_file)),
            on_problem=lambda problem: rospy.logerr("past conversations: %s", problem),
        )
        self._past_changes = 0
        self._sensors = SensorTap()
        self._site = Site(
            site_settings,
            Callbacks(
                on_request=self._on_request,
                on_pages=self._on_pages,
                snapshot=self._snapshot,
                past=self._past.text,
                sensors=self._sensors,
            ),
        )
        call_soon: Callable[..., None] = self._loop.add_callback
        self._speaker = Speaker(
            brake_settings, call_soon=call_soon, call_later=self._loop.call_later, on_stop=self._on_stop
        )
        self._listener = Listener(
            self._board,
            self._history,
            call_soon=call_soon,
            call_later=self._loop.call_later,
            on_change=self._flush_soon,
            on_reply=self._on_reply,
            on_stop_report=self._on_stop_report,
        )
        self._emergency = EmergencyWatch(lambda state: call_soon(self._on_emergency, state))
        self._on_emergency(self._emergency.state)
        self._ground = GroundTap(
            self._board,
            path_topics=settings.path_topics,
            call_soon=call_soon,
            on_change=self._flush_soon,
            on_picture=self._site.show_picture,
            on_names=self._on_names,
            on_world=self._on_world,
        )
        self._knowledge = KnowledgeTap(
            call_soon=call_soon,
            on_abilities=self._on_abilities,
            on_health=lambda view: self._show("health", view),
            on_turn=self._watch,
        )
        self._voice = VoiceTap(call_soon=call_soon, on_voice=lambda view: self._show("voice", view))
        self._look = PeriodicCallback(self._ground.look, _LOOK_MS)
        for kind, view in (("abilities", AbilitiesView()), ("health", HealthView()), ("stop", StopView())):
            self._board.show(kind, view)

    def run(self, ports: List[int], address: str) -> None:
        """Offer the page until ROS shuts down.

        Raises:
            StartError: no port is free
        """
        try:
            port = self._site.listen(ports)
        except OSError as error:
            raise StartError(
                f"the page cannot be offered on {address}, ports {ports[0]} to {ports[-1]}: {error}"
            ) from error
        shown = f"[{address}]" if ":" in address else address
        url = f"http://{shown}:{port}/"
        # Before any page: one that is opened when the master has died must still stop the robot.
        self._speaker.start()
        self._listener.start()
        self._ground.start()
        self._knowledge.start()
        self._voice.start()
        rospy.set_param("~url", url)
        rospy.loginfo("the page is at %s", url)
        rospy.on_shutdown(lambda: self._loop.asyncio_loop.call_soon_threadsafe(self._loop.stop))
        self._loop.start()
        self._site.close()
        self._knowledge.close(timeout_s=1.0)
        self._speaker.close()
        self._past.close()
        self._sensors.close()

    def _watch(self, is_watched: bool) -> None:
        """Hear what pages show, in the thread that may wait for the master."""
        self._ground.watch(is_watched)
        self._sensors.turn(is_watched)

    def _show(self, kind: str, view: Any) -> None:
        if self._board.show(kind, view):
            self._flush_soon()

    def _flush_soon(self) -> None:
        if not self._is_flush_due:
            self._is_flush_due = True
            self._loop.call_later(_GATHER_S, self._flush)

    def _flush(self) -> None:
        self._is_flush_due = False
        if self._site.page_count:
            self._site.send(self._board.take_changes())
        else:
            self._board.forget_changes()

    def _snapshot(self) -> Tuple[Tuple[str, str], ...]:
        """Return all views for a new page; what nobody needed before is made now."""
        self._ground.look()
        self._suggest()
        return self._board.snapshot()

    def _on_pages(self, count: int) -> None:
        self._knowledge.watch(count > 0)
        if count and not self._look.is_running():
            self._look.start()
        elif not count:
            self._look.stop()

    def _on_request(self, request: Request) -> None:
        if isinstance(request, Say):
            command_id = self._speaker.say(request.text)
            if not command_id:
                self._show("unheard", request.text)
                return
            self._show("unheard", "")
            self._history.heard(command_id, request.text, rospy.get_time())
            self._listener.show((*self._history.close_questions(), command_id))
        elif isinstance(request, Listen):
            self._voice.listen()
        elif isinstance(request, Sound):
            self._voice.hear(request.pcm)
        elif isinstance(request, Cancel):
            self._speaker.cancel(request.command_id)
        elif isinstance(request, Judge):
            self._past.judge(request.command_id, request.verdict, request.meant)
            self._show_past()
        else:
            self._speaker.stop(stays=request.stays)

    def _on_emergency(self, state: Emergency) -> None:
        self._show("emergency", EmergencyView(state.is_engaged, state.sentence))

    def _on_reply(self, conversation: Conversation) -> None:
        self._past.keep(conversation)
        self._show_past()
        self._suggest()

    def _show_past(self) -> None:
        self._past_changes += 1
        self._show("past", PastView(self._past_changes))

    def _on_stop(self, stop: StopView) -> None:
        self._show("stop", stop)

    def _on_stop_report(self, report: StopReport) -> None:
        self._speaker.hear_report(report)

    def _on_abilities(self, view: AbilitiesView) -> None:
        self._frames = frozenset(ability.frame for ability in view.abilities)
        self._show("abilities", view)
        self._suggest()

    def _on_world(self, present: Tuple[Present, ...]) -> None:
        if present != self._present:
            self._present = present
            self._suggest()

    def _suggest(self) -> None:
        self._said = dict.fromkeys([*self._said, *(view.text for view in self._history.views())])
        if len(self._said) > _MOST_SAID:
            self._said = {}
        if not self._site.page_count:
            return
        self._show("suggestions", SuggestionsView(suggest(self._templates, self._frames, self._present, self._said)))

    def _on_names(self, names: Tuple[str, ...]) -> None:
        self._history.names = {"where": names, "which": names}
        self._knowledge.know_names(names)


def _start() -> WebConsole:
    settings = read_parameters(Settings)
    os.nice(settings.niceness)
    try:
        token = read_token(settings.token_file)
        check_access(settings.address, token)
    except AccessError as error:
        raise StartError(str(error)) from error
    targets = read_parameters(StopTargets, prefix="stop_server/")
    console = WebConsole(
        settings,
        SiteSettings(
            address=settings.address, token=token, names=settings.host_names, longest_text=settings.max_text_length
        ),
        BrakeSettings(
            velocity_topics=targets.velocity_topics,
            also_cancel=targets.also_cancel,
            refresh_period_s=_REFRESH_PERIOD_S,
        ),
    )
    ports = [settings.port + more for more in range(_PORTS)] if 0 < settings.port <= 65536 - _PORTS else [settings.port]
    console.run(ports, settings.address)
    return console


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("web_console", functools.partial(_start))
