"""The voice of a stage on ``stage_events``."""

import threading
from typing import Callable

import rospy
from roboframenet_msgs.msg import Command, Reply, StageEvent

from roboframenet_ros.bounded_text import bounded
from roboframenet_ros.recent import Recent

# As long as the command server waits for a stage by default: after that it has answered without the event.
_MAX_AGE_S = 15.0
# As many as the command server keeps open by default.
_MAX_COUNT = 1000


class Stage(rospy.SubscribeListener):
    """Says what becomes of each command in a stage; one in a node.

    Publishes: ``stage_events``. A final event is told again to every listener that connects within 15 s: a message that
    is published before somebody listens is lost otherwise, and with it the reply to the command.
    """

    def __init__(self, name: str) -> None:
        """Begin to publish.

        Args:
            name: of the stage: the name of its package
        """
        self._name = name
        self._final_events: Recent[StageEvent] = Recent(max_count=_MAX_COUNT, max_age_s=_MAX_AGE_S)
        # rospy calls peer_subscribe() without the lock of the publisher, whose one buffer both ways of publishing fill.
        self._lock = threading.Lock()
        # What is told again must not push out of the queue what comes just after it.
        self._publisher = rospy.Publisher(
            "stage_events", StageEvent, subscriber_listener=self, queue_size=2 * _MAX_COUNT
        )

    def passes_on(self, command: Command, sentence: str, *, trace: str = "") -> None:
        """Say what the stage made of a command that goes on.

        Args:
            command: as it came
            sentence: for the person
            trace: what each rule of the stage did, one a line
        """
        event = StageEvent(
            command=command, stage=self._name, stamp=rospy.Time.now(), sentence=sentence, trace=bounded(trace)
        )
        with self._lock:
            self._publisher.publish(event)

    def ends(self, command: Command, *, outcome: int, code: str, sentence: str, trace: str = "") -> None:
        """Say that a command ends in the stage.

        Args:
            command: as it came
            outcome: one of the constants of Reply
            code: stable name of the reason
            sentence: for the person
            trace: what each rule of the stage did, one a line
        """
        now = rospy.Time.now()
        reply = Reply(command=command, outcome=outcome, stage=self._name, code=code, sentence=sentence, stamp=now)
        event = StageEvent(
            command=command,
            stage=self._name,
            stamp=now,
            sentence=sentence,
            is_final=True,
            reply=reply,
            trace=bounded(trace),
        )
        with self._lock:
            self._final_events.add(event)
            self._publisher.publish(event)

    def peer_subscribe(
        self, topic_name: str, topic_publish: Callable[[StageEvent], None], peer_publish: Callable[[StageEvent], None]
    ) -> None:
        """Tell a new listener the final events that it may have missed; called by rospy."""
        with self._lock:
            for event in self._final_events.values():
                peer_publish(event)
