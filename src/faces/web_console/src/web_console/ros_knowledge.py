"""Hears what the robot can do, and whether its nodes live. A thread reads the files and asks the nodes."""

import threading
import time
import xmlrpc.client
from typing import Callable, FrozenSet, Iterable, Optional, Set, Tuple

import rospy
from roboframenet_msgs.msg import FrameCatalogue, FrameServers, Lexicon

from roboframenet_ros.ros_master import NO_ANSWER, TimedMaster
from roboframenet_ros.timed_transport import TimedTransport
from web_console.abilities import File, Knowledge
from web_console.health import RUNS, STAGES, health_of, nodes_to_ask
from web_console.ros_values import living_servers, servers_of
from web_console.views import AbilitiesView, HealthView

_TURN_S = 0.5
#: The thread has nothing to do while nobody looks; the first page wakes it.
_SLEEP_S = 600.0
#: Files are read once they have been quiet for this long: at the start they come one by one.
_QUIET_S = 0.7
_LONGEST_QUIET_S = 3.0
#: How often nodes are asked: seldom while all run.
_ASK_S = 4.0
_ASK_AGAIN_S = 15.0
_ANSWER_S = 1.0


class KnowledgeTap:
    """What the robot can do, and who of its nodes answers.

    Subscribes: ``frame_catalogue``, ``frame_servers``, ``lexicon``. A thread does the slow part; what it
    finds is told in the thread of the event loop.
    """

    def __init__(
        self,
        *,
        call_soon: Callable[..., None],
        on_abilities: Callable[[AbilitiesView], None],
        on_health: Callable[[HealthView], None],
        on_turn: Callable[[bool], None],
    ) -> None:
        """Prepare; `start` subscribes.

        Args:
            call_soon: calls a function in the thread of the event loop, from any thread
            on_abilities: called with what the robot can do
            on_health: called with the state of the nodes
            on_turn: called from the thread with whether somebody looks, twice a second while somebody does, and when
                nobody does any more; may wait for the master
        """
        self._call_soon = call_soon
        self._on_abilities = on_abilities
        self._on_health = on_health
        self._on_turn = on_turn
        self._lock = threading.Lock()
        self._catalogue: Optional[FrameCatalogue] = None
        self._servers = FrameServers()
        self._lexicon: Optional[Lexicon] = None
        self._names: Tuple[str, ...] = ()
        self._changed_s: Optional[float] = None
        self._first_change_s = 0.0
        self._is_watched = False
        self._wake = threading.Event()
        self._is_closing = threading.Event()
        self._master = TimedMaster(timeout_s=2.0)
        # A daemon: a master that hangs must not keep the process alive.
        self._thread = threading.Thread(target=self._work, name="knowledge", daemon=True)

    def start(self) -> None:
        """Subscribe, and start the thread."""
        self._subscribers = [
            rospy.Subscriber("frame_catalogue", FrameCatalogue, self._on_catalogue, queue_size=1),
            rospy.Subscriber("frame_servers", FrameServers, self._on_servers, queue_size=1),
            rospy.Subscriber("lexicon", Lexicon, self._on_lexicon, queue_size=1),
        ]
        self._thread.start()

    def close(self, *, timeout_s: float) -> None:
        """End the thread."""
        self._is_closing.set()
        self._wake.set()
        self._thread.join(timeout_s)

    def watch(self, is_watched: bool) -> None:
        """Somebody looks, or nobody does; returns at once."""
        self._is_watched = is_watched
        self._wake.set()

    def know_names(self, names: Tuple[str, ...]) -> None:
        """Take the names of places; returns at once."""
        with self._lock:
            self._names = names
            self._note_change()

    def _on_catalogue(self, message: FrameCatalogue) -> None:
        with self._lock:
            self._catalogue = message
            self._note_change()

    def _on_servers(self, message: FrameServers) -> None:
        with self._lock:
            self._servers = message
            self._note_change()

    def _on_lexicon(self, message: Lexicon) -> None:
        with self._lock:
            self._lexicon = message
            self._note_change()

    def _note_change(self) -> None:
        now_s = time.monotonic()
        if self._changed_s is None:
            self._first_change_s = now_s
        self._changed_s = now_s

    def _work(self) -> None:
        knowledge = Knowledge()
        ask_at_s = 0.0
        while not self._is_closing.is_set():
            self._wake.wait(_TURN_S if self._is_watched else _SLEEP_S)
            self._wake.clear()
            try:
                self._on_turn(self._is_watched)
                # A page that nobody looks at needs no news; the next one gets them at once.
                if self._is_watched and self._is_due():
                    self._tell_abilities(knowledge)
                if self._is_watched and time.monotonic() >= ask_at_s:
                    ask_at_s = time.monotonic() + (_ASK_AGAIN_S if self._tell_health() else _ASK_S)
            except Exception as error:  # boundary: one failure must not end the thread
                if not rospy.is_shutdown():
                    rospy.logwarn("the page may be out of date: %s: %s", type(error).__name__, error)

    def _is_due(self) -> bool:
        with self._lock:
            now_s = time.monotonic()
            return self._changed_s is not None and (
                now_s - self._changed_s >= _QUIET_S or now_s - self._first_change_s >= _LONGEST_QUIET_S
            )

    def _tell_abilities(self, knowledge: Knowledge) -> None:
        with self._lock:
            catalogue, servers, lexicon, names = self._catalogue, self._servers, self._lexicon, self._names
            self._changed_s = None
        view = knowledge.view(_files(catalogue), _files(lexicon), living_servers(servers), names)
        self._call_soon(self._on_abilities, view)

    def _tell_health(self) -> bool:
        """Ask the nodes; returns whether all run."""
        try:
            state = self._master.system_state()
        except NO_ANSWER:
            self._call_soon(self._on_health, HealthView(is_master_up=False))
            return False
        stages = nodes_to_ask(state.publishers, {stage: rospy.resolve_name(topic) for stage, topic, _ in STAGES})
        answering = self._answering({node for nodes in stages.values() for node in nodes})
        with self._lock:
            servers = self._servers
        health = health_of(stages, answering, servers_of(servers))
        self._call_soon(self._on_health, health)
        return all(node.state == RUNS for node in health.nodes)

    def _answering(self, nodes: Iterable[str]) -> FrozenSet[str]:
        found: Set[str] = set()
        for node in nodes:
            try:
                uri = self._master.uri_of(node)
                xmlrpc.client.ServerProxy(uri, transport=TimedTransport(_ANSWER_S)).getPid(rospy.get_name())
            except NO_ANSWER:
                continue
            found.add(node)
        return frozenset(found)


def _files(message: "Optional[FrameCatalogue | Lexicon]") -> Tuple[File, ...]:
    return () if message is None else tuple((file.path, file.text) for file in message.files)
