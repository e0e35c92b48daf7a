"""Commands in the running graph with the home: arranged before each, and watched until the reply."""

import json
import threading
from typing import Any, Dict, List, Mapping, Tuple

import rospy
from actionlib_msgs.msg import GoalStatus
from home_referee.commands import Command
from home_referee.judging import ROBOT, Run, Saying
from home_referee.walking import Walk
from roboframenet_msgs.msg import FilledSemanticFrameActionResult, Reply
from std_msgs.msg import String

from roboframenet_rostest import say
from roboframenet_testing.waiting import wait_until

OUTCOMES = {
    value: name
    for name, value in vars(Reply).items()
    if name in ("DONE", "FAILED", "REFUSED", "NEEDS_INFORMATION", "SUPERSEDED")
}
#: The robot looks around itself after the home was arranged, and what it said is heard; seconds of ROS time.
_LOOK_S = 3.0
_HEARD_S = 1.0
#: A command takes no longer; seconds of ROS time.
_MOST_S = 2400.0
#: Nobody is followed for longer.
_LONGEST_WALK_S = 300.0


class RosRuns:
    """Carries commands out in the running graph.

    Args:
        speaker: id of the person who speaks
    """

    def __init__(self, speaker: str) -> None:
        self._speaker = speaker
        self._lock = threading.Lock()
        self._truth: Dict[str, Any] = {}
        self._events: Dict[Tuple[float, str, str], Dict[str, Any]] = {}
        self._reasons: List[str] = []
        self._arrange = rospy.Publisher("home/arrange", String, queue_size=5)
        self._person = rospy.Publisher("home/person", String, queue_size=5)
        self._text = rospy.Publisher("text", String, queue_size=5)
        self._subscribers = [
            rospy.Subscriber("home/truth", String, self._on_truth, queue_size=1),
            rospy.Subscriber("home/act/result", FilledSemanticFrameActionResult, self._on_result, queue_size=50),
        ]
        wait_until(lambda: self._arrange.get_num_connections() > 0, message="the home may not be arranged")
        wait_until(lambda: bool(self._truth), message="no truth of the home")

    def _on_truth(self, message: String) -> None:
        found = json.loads(message.data)
        with self._lock:
            self._truth = found["truth"]
            for event in found["events"]:
                self._events.setdefault((event["time_s"], event["who"], event["what"]), event)

    def _on_result(self, message: FilledSemanticFrameActionResult) -> None:
        if message.status.status == GoalStatus.ABORTED:
            with self._lock:
                self._reasons.append(json.loads(message.status.text)["sentence"])

    def _now(self) -> Dict[str, Any]:
        with self._lock:
            return dict(self._truth)

    @property
    def truth(self) -> Dict[str, Any]:
        """What is true in the home."""
        return self._now()

    def arrange(self, arranged: Mapping[str, str]) -> None:
        """Let the home begin anew, and wait until the robot has looked around."""
        times = self._arranged_times()
        self._arrange.publish(json.dumps(dict(arranged)))
        wait_until(lambda: self._arranged_times() > times, message=f"the home is not as {arranged}")
        rospy.sleep(_LOOK_S)

    def run(self, command: Command) -> Run:
        """Carry a command out in a home that is arranged for it."""
        self.arrange(command.arranged)
        with self._lock:
            self._events.clear()
            self._reasons.clear()
            begin_s = rospy.get_time()
            before = dict(self._truth)
        walk = Walk(command)
        self._ends_s = begin_s + _LONGEST_WALK_S
        watcher = threading.Thread(target=self._watch, args=(walk,), daemon=True)
        if walk.person:
            watcher.start()
        reply = say(command.text, timeout_s=_MOST_S)
        walk.end()
        rospy.sleep(_HEARD_S)
        with self._lock:
            sayings = [
                Saying(event["what"], tuple(event["to"]))
                for event in self._events.values()
                if event["kind"] == "said" and event["who"] == ROBOT and event["time_s"] >= begin_s - 1.0
            ]
            return Run(
                command,
                before,
                dict(self._truth),
                (*sayings, Saying(reply.sentence, (self._speaker,))),
                OUTCOMES[reply.outcome],
                reply.sentence,
                tuple(self._reasons),
                walk.is_over,
            )

    def _arranged_times(self) -> int:
        with self._lock:
            return int(self._truth.get("home.arranged", 0))

    def _watch(self, walk: Walk) -> None:
        while not walk.has_ended and not rospy.is_shutdown():
            order = walk.order(self._now())
            if order:
                self._person.publish(order)
            if walk.must_end and rospy.get_time() > self._ends_s:
                self._text.publish("Stop.")
                return
            if walk.is_over:
                self._text.publish("Stop.")
                return
            rospy.sleep(0.5)
