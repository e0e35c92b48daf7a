"""Says the sentences of a script to a running robot, shows every stage, and prints a table at the end."""

import sys
import threading
import time
from typing import List, Optional, Sequence, Tuple

import rospy
import yaml
from roboframenet_msgs.msg import FilledSemanticFrameActionFeedback, Reply, StageEvent
from std_msgs.msg import String

from roboframenet_demo.ros_conversation import Conversation
from roboframenet_demo.ros_observer import RobotObserver
from roboframenet_demo.ros_pipeline import is_pipeline_complete
from roboframenet_demo.script import Line, judge, read_line
from roboframenet_demo.stage_order import StageOrder
from roboframenet_demo.table import format_table

OUTCOME_NAMES = {
    Reply.DONE: "DONE",
    Reply.FAILED: "FAILED",
    Reply.REFUSED: "REFUSED",
    Reply.NEEDS_INFORMATION: "NEEDS_INFORMATION",
    Reply.SUPERSEDED: "SUPERSEDED",
}
#: How long the base may take to come to rest, and the arms to return to their safe pose, after a reply; seconds.
ROLL_OUT_S = 8.0
#: All servers count as registered when none has registered for this time, seconds.
SETTLED_S = 3.0
#: Events of the stages may arrive this much later than the reply, seconds.
LATE_EVENTS_S = 0.2
HEADER = ("sentence", "domain", "frame and elements", "RFNServer", "what the robot did", "verdict")
WIDTHS = (24, 10, 30, 18, 30, 10)


class Demonstration:
    """Runs the lines of a script one after the other, and collects the rows of the table."""

    def __init__(self) -> None:
        self._print_lock = threading.Lock()
        self._order = StageOrder(longest_s=LATE_EVENTS_S / 2.0)
        self._following = threading.Event()
        self._conversation = Conversation(on_event=self._show_event)
        self._observer = RobotObserver()
        self._person = rospy.Publisher("person/act", String, queue_size=1)
        self._feedback = rospy.Subscriber(
            "following/feedback", FilledSemanticFrameActionFeedback, self._on_following, queue_size=1
        )
        self.rows: List[Sequence[str]] = []
        self.failures = 0

    def wait_until_ready(self, timeout_s: float) -> bool:
        """Wait until the pipeline is connected and the servers have registered; returns whether they have."""
        end = time.monotonic() + timeout_s
        if not self._conversation.wait_until_heard(2, timeout_s):
            return False
        while time.monotonic() < end and not rospy.is_shutdown():
            if is_pipeline_complete() and self._conversation.quiet_s() > SETTLED_S:
                return True
            time.sleep(0.2)
        return False

    def run(self, line: Line) -> None:
        """Say a sentence, compare what the robot does with what is expected, and add a row to the table."""
        self._show(f'\n>>> "{line.text}"')
        self._observer.begin()
        self._following.clear()
        self._conversation.say(line.text)
        texts = [line.text]
        if line.person:
            # The robot does not follow a person who walks away before it has seen them.
            self._following.wait(line.timeout_s)
            self._person.publish(String(data=line.person))
        if line.interruption is not None:
            self._wait_for_motion(line.timeout_s)
            time.sleep(line.interruption.after_s)
            self._show(f'>>> "{line.interruption.text}"    (in mid-action)')
            self._conversation.say(line.interruption.text)
            texts.append(line.interruption.text)
        replies = self._conversation.wait_for_replies(texts, line.timeout_s)
        self._wait_for_rest()
        time.sleep(LATE_EVENTS_S)
        self._show_due()
        reply = replies.get(line.text)
        outcome = OUTCOME_NAMES[reply.outcome] if reply else "NO REPLY"
        is_right, reason = judge(line, outcome, self._observer.observe())
        if line.interruption is not None:
            second = replies.get(line.interruption.text)
            second_outcome = OUTCOME_NAMES[second.outcome] if second else "NO REPLY"
            if second_outcome != line.interruption.outcome:
                is_right, reason = False, f"interruption: {second_outcome}"
        self.failures += not is_right
        self._show(f"    reply: {outcome}: {reply.sentence if reply else '-'}")
        self._show(f"    robot: {self._observer.observe().describe()}")
        self._remember(line, reply, outcome, is_right, reason)

    def _remember(self, line: Line, reply: Optional[Reply], outcome: str, is_right: bool, reason: str) -> None:
        frame, server, domain = self._frame_of(reply)
        spoken = line.text + (f" / {line.interruption.text}" if line.interruption else "")
        self.rows.append(
            (
                spoken,
                domain,
                frame or f"({reply.code if reply else outcome})",
                server,
                self._observer.observe().describe(),
                "ok" if is_right else f"WRONG: {reason}",
            )
        )

    def _frame_of(self, reply: Optional[Reply]) -> Tuple[str, str, str]:
        """Return the frames with their elements, the servers, and the domain of a command; empty texts for none."""
        if reply is None:
            return "", "", ""
        reading = self._conversation.reading(reply.command.id)
        source = (
            reading.clauses[0].readings[0].source if reading and reading.clauses and reading.clauses[0].readings else ""
        )
        domain = source.split("/")[-3] if source.count("/") >= 3 else ""
        plan = self._conversation.plan(reply.command.id)
        if plan is None:
            return "", "", domain
        frames = [frame for node in plan.plan.nodes for candidate in node.candidates[:1] for frame in candidate.frames]
        text = "; ".join(
            f"{frame.name}({', '.join(f'{e.name}={e.argument}' for e in frame.frame_elements)})" for frame in frames
        )
        return text, ", ".join(topic for frame in frames for topic in frame.action_server_topics), domain

    def _wait_for_motion(self, timeout_s: float) -> None:
        end = time.monotonic() + timeout_s
        while not self._observer.is_moving() and time.monotonic() < end and not rospy.is_shutdown():
            time.sleep(0.02)

    def _wait_for_rest(self) -> None:
        end = time.monotonic() + ROLL_OUT_S
        while not self._observer.observe().is_still and time.monotonic() < end and not rospy.is_shutdown():
            time.sleep(0.02)

    def _on_following(self, message: FilledSemanticFrameActionFeedback) -> None:
        if message.feedback.is_succeeding:
            self._following.set()

    def _show_event(self, event: StageEvent) -> None:
        # The executor publishes this event every second while a command runs.
        if event.sentence.startswith(("Doing ", "Waiting (")):
            return
        text = f"    {event.stage:<20} {event.sentence}"
        with self._print_lock:
            self._print(*self._order.add(event.command.id, event.stage, text, now_s=time.monotonic()))

    def _show_due(self) -> None:
        with self._print_lock:
            self._print(*self._order.due(now_s=time.monotonic()))

    def _show(self, text: str) -> None:
        with self._print_lock:
            self._print(text)

    @staticmethod
    def _print(*texts: str) -> None:
        for text in texts:
            print(text, flush=True)


def main() -> int:
    """Run the script that the argument names; returns the exit status, 0 when every sentence did what it should."""
    arguments = rospy.myargv()[1:]
    if len(arguments) != 1:
        print("usage: roboframenet_demo SCRIPT.yaml", file=sys.stderr)
        return 2
    with open(arguments[0], encoding="utf-8") as file:
        lines = [read_line(entry) for entry in yaml.safe_load(file)]
    rospy.init_node("roboframenet_demo", anonymous=True)
    demonstration = Demonstration()
    print("[demo] waiting for the pipeline (loading the parser takes a few seconds) ...", flush=True)
    if not demonstration.wait_until_ready(timeout_s=90.0):
        print("[demo] the pipeline did not come up within 90 s; see its log.", file=sys.stderr)
        return 1
    for line in lines:
        if rospy.is_shutdown():
            return 130
        demonstration.run(line)
    print("\n" + format_table(HEADER, demonstration.rows, widths=WIDTHS))
    print(f"\n{len(lines) - demonstration.failures} of {len(lines)} sentences did what they should.")
    return 1 if demonstration.failures else 0
