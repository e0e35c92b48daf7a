"""Publishes the events of a pipeline stage on ``stage_events``."""

import threading
from typing import Callable

import rospy
from roboframenet_msgs.msg import Command, Reply, StageEvent

from roboframenet_ros.bounded_text import bounded, one_line
from roboframenet_ros.recent import Recent
from roboframenet_ros.ros_robots import PublisherOfEachRobot, own_robot, topic_of

# In one process, all stages share the publisher of this topic and its buffer. rospy calls peer_subscribe() without the
# lock of the publisher, so this lock keeps all ways of publishing apart.
_PUBLISHING = threading.Lock()
# The default deadline of the command server for a stage; after it, the command is answered without the event.
_MAX_AGE_S = 15.0
# The command server keeps this many commands open by default.
_MAX_COUNT = 1000


class Stage(rospy.SubscribeListener):
    """Reports what became of each command in a stage; one in a node.

    Publishes: ``stage_events``, in the namespace of the robot of the command. A final event is resent to every
    subscriber that connects within 15 s; otherwise it would be lost, and the reply to the command with it.
    """

    def __init__(self, name: str) -> None:
        """Advertise the topic.

        Args:
            name: of the stage, which is that of its package
        """
        self._name = name
        self._final_events: Recent[StageEvent] = Recent(max_count=_MAX_COUNT, max_age_s=_MAX_AGE_S)
        self._own = own_robot()
        # Resent events must not push newer ones out of the queue.
        self._publisher = PublisherOfEachRobot(
            "stage_events", StageEvent, own=self._own, subscriber_listener=self, queue_size=2 * _MAX_COUNT
        )

    def passes_on(self, command: Command, sentence: str, *, trace: str = "") -> None:
        """Report a command that is passed on to the next stage.

        Args:
            command: as it was received
            sentence: for the person
            trace: one line for each rule that did something
        """
        event = StageEvent(
            command=command, stage=self._name, stamp=rospy.Time.now(), sentence=one_line(sentence), trace=bounded(trace)
        )
        with _PUBLISHING:
            self._publisher.publish(command.robot, event)

    def ends(
        self, command: Command, *, outcome: int, code: str, sentence: str, trace: str = "", is_kept: bool = True
    ) -> None:
        """Report a command that ends in this stage.

        Args:
            command: as it was received
            outcome: one of the constants of Reply
            code: stable name of the reason
            sentence: for the person
            trace: one line for each rule that did something
            is_kept: whether a command server that is started anew gets it, which tells twice what nobody waits for
        """
        now = rospy.Time.now()
        sentence = one_line(sentence)
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
        with _PUBLISHING:
            if is_kept:
                self._final_events.add(event)
            self._publisher.publish(command.robot, event)

    def peer_subscribe(
        self, topic_name: str, topic_publish: Callable[[StageEvent], None], peer_publish: Callable[[StageEvent], None]
    ) -> None:
        """Resend the final events that a new subscriber may have missed; called by rospy."""
        with _PUBLISHING:
            for event in self._final_events.values():
                robot = event.command.robot
                if rospy.resolve_name(topic_of(robot, "stage_events", own=self._own)) == topic_name:
                    peer_publish(event)
