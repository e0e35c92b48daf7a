"""Says sentences to the robot, and collects what the stages publish about them."""

import queue
import time
from typing import Callable, Dict, List, Optional

import rospy
from roboframenet_msgs.msg import CommandLexicalUnits, CommandPlan, FrameServers, Reply, StageEvent
from std_msgs.msg import String


class Conversation:
    """Publishes sentences, and keeps the readings, plans and replies of their commands.

    Publishes:
        text (std_msgs/String)
    Subscribes:
        stage_events, reply, frame_servers, command_lexical_units, command_plan
    """

    def __init__(self, on_event: Callable[[StageEvent], None]) -> None:
        """
        Args:
            on_event: called with every stage event, from a thread of rospy
        """
        self._replies: queue.Queue[Reply] = queue.Queue()
        self._plans: Dict[str, CommandPlan] = {}
        self._readings: Dict[str, CommandLexicalUnits] = {}
        self._registered_s: Optional[float] = None
        self._text = rospy.Publisher("text", String, queue_size=10)
        self._subscribers = [
            rospy.Subscriber("stage_events", StageEvent, on_event, queue_size=100),
            rospy.Subscriber("frame_servers", FrameServers, self._on_servers, queue_size=1),
            rospy.Subscriber("reply", Reply, self._replies.put, queue_size=100),
            rospy.Subscriber("command_lexical_units", CommandLexicalUnits, self._on_reading, queue_size=100),
            rospy.Subscriber("command_plan", CommandPlan, self._on_plan, queue_size=100),
        ]

    def wait_until_heard(self, listeners: int, timeout_s: float) -> bool:
        """Wait until this many nodes subscribe to ``text``; returns whether they do."""
        end = time.monotonic() + timeout_s
        while time.monotonic() < end and not rospy.is_shutdown():
            if self._text.get_num_connections() >= listeners:
                return True
            time.sleep(0.1)
        return False

    def quiet_s(self) -> float:
        """Seconds since the last registration of a server; 0 before the first."""
        return time.monotonic() - self._registered_s if self._registered_s is not None else 0.0

    def say(self, text: str) -> None:
        """Publish a sentence."""
        self._text.publish(String(data=text))

    def wait_for_replies(self, texts: List[str], timeout_s: float) -> Dict[str, Reply]:
        """Collect the replies to sentences.

        Args:
            texts: the sentences
            timeout_s: how long to wait for all of them
        Returns:
            the replies by sentence; a sentence without a reply is missing
        """
        end = time.monotonic() + timeout_s
        replies: Dict[str, Reply] = {}
        while len(replies) < len(texts) and not rospy.is_shutdown():
            try:
                reply = self._replies.get(timeout=max(0.01, min(0.5, end - time.monotonic())))
            except queue.Empty:
                if time.monotonic() >= end:
                    break
                continue
            if reply.command.text in texts:
                replies[reply.command.text] = reply
        return replies

    def plan(self, command_id: str) -> Optional[CommandPlan]:
        """Return the plan of a command from the arbitrator; None for none."""
        return self._plans.get(command_id)

    def reading(self, command_id: str) -> Optional[CommandLexicalUnits]:
        """Return the readings of a command from the framer; None for none."""
        return self._readings.get(command_id)

    def _on_servers(self, message: FrameServers) -> None:
        if any(callback.is_alive for callback in message.callbacks):
            self._registered_s = time.monotonic()

    def _on_reading(self, message: CommandLexicalUnits) -> None:
        self._readings[message.command.id] = message

    def _on_plan(self, message: CommandPlan) -> None:
        self._plans[message.command.id] = message
