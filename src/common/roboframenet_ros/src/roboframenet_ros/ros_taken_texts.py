"""Who takes texts tells which; who hears them too replies to those that nobody took."""

import threading
import time
from typing import Any, Callable, List, Tuple

import rospy
from roboframenet_msgs.msg import Reply
from std_msgs.msg import Duration, String

from roboframenet_ros.command_ids import came_by_action, is_spoken
from roboframenet_ros.ros_server_links import newest_link
from roboframenet_ros.untaken_texts import LISTENING_S, TOLD_S, Said, Taken, UntakenTexts

#: So long after the start of who takes texts, whoever listens is connected, or hangs; seconds.
SETTLED_S = 3.0


class TakenOut(rospy.SubscribeListener):
    """Tells which texts a node takes, and for how long it has heard texts. One thread owns it.

    Publishes: ``text_taken`` (id, age in seconds and text, with blanks between), and another topic: the time since the
    start, to each node that connects.
    """

    def __init__(self, started: str) -> None:
        """
        Args:
            started: the topic that tells the start
        """
        self._taken = rospy.Publisher("text_taken", String, queue_size=1000)
        self._start_topic = started
        self._start_s = time.monotonic()
        self._again: List[Tuple[str, float, str]] = []

    def tell_start(self) -> None:
        """From now on texts are heard."""
        self._start_s = time.monotonic()
        self._started = rospy.Publisher(self._start_topic, Duration, subscriber_listener=self, queue_size=1)

    def peer_subscribe(
        self, topic_name: str, topic_publish: Callable[[Any], None], peer_publish: Callable[[Any], None]
    ) -> None:
        """Tell a node that connects, for how long texts have been heard; called by rospy."""
        peer_publish(Duration(rospy.Duration.from_sec(time.monotonic() - self._start_s)))

    def tell(self, command_id: str, text: str, *, heard_s: float) -> None:
        """A text was taken, and will be answered; right after the start it is told again when all are connected.

        Args:
            command_id: of the command that it has become
            text: as it was said
            heard_s: when it was heard, monotonic seconds
        """
        now_s = time.monotonic()
        self._taken.publish(String(data=Taken(command_id, now_s - heard_s, text).line()))
        if now_s < self._start_s + SETTLED_S:
            self._again.append((command_id, heard_s, text))

    def turn(self) -> None:
        """Tell again what was told before all were connected."""
        if self._again and time.monotonic() >= self._start_s + SETTLED_S:
            again, self._again = self._again, []
            for command_id, heard_s, text in again:
                self.tell(command_id, text, heard_s=heard_s)


class UntakenWatch:
    """Follows which texts a node takes; some time after its start, tells those that were said before.

    It knows by the time since the start whether that node, or only this one, was started anew: who was not connected
    yet has missed what was told. Subscribes: the topics of a `TakenOut`.
    """

    def __init__(self, on_untaken: Callable[[Said], None], *, on_start: Callable[[], None] = lambda: None) -> None:
        """
        Args:
            on_untaken: called with each text that nobody took, in a thread of this object
            on_start: called when the node is there
        """
        self._on_untaken, self._on_start = on_untaken, on_start
        self._lock = threading.Lock()
        self._texts = UntakenTexts()
        self._telling = threading.Timer(TOLD_S, lambda: None)

    def start(self, *, taken: str, started: str) -> None:
        """Listen.

        Args:
            taken: the topic of what is taken
            started: the topic that tells the start
        """
        self._starts = rospy.Subscriber(started, Duration, self._hear_start, queue_size=1)
        self._signs = rospy.Subscriber(taken, String, self._hear_taken, queue_size=1000)

    def close(self) -> None:
        """Tell nothing more."""
        self._telling.cancel()

    def hear(self, text: str, command_id: str = "") -> None:
        """A text was said, or a goal with an id."""
        with self._lock:
            self._texts.hear(text, command_id, ros_s=rospy.Time.now().to_sec())

    def hear_reply(self, reply: Reply) -> None:
        """A command was answered: whoever took its text may have been killed before it could tell so."""
        command = reply.command
        if is_spoken(command.id) and not came_by_action(command.id):
            with self._lock:
                self._texts.hear_answered(
                    command.id, command.text, stamp_s=command.stamp.to_sec(), ros_s=rospy.Time.now().to_sec()
                )

    def _hear_taken(self, message: String) -> None:
        try:
            sign = Taken.of_line(message.data)
        except ValueError:
            rospy.logwarn_once("a line on %s is ignored: %r", self._signs.resolved_name, message.data)
            return
        with self._lock:
            self._texts.hear_taken(sign)

    def _hear_start(self, message: Duration) -> None:
        start_s = time.monotonic() - message.data.to_sec()
        self._on_start()
        # Of two starts, the later one tells for both.
        self._telling.cancel()
        self._telling = threading.Timer(
            max(0.0, start_s + TOLD_S - time.monotonic()), self._tell, args=(start_s + LISTENING_S,)
        )
        self._telling.daemon = True
        self._telling.start()

    def _tell(self, before_s: float) -> None:
        if newest_link(self._starts) == ("", ""):
            # It has died meanwhile, and may have kept what it took: the next start decides.
            return
        with self._lock:
            untaken = self._texts.take(before_s=before_s)
        for said in untaken:
            self._on_untaken(said)
