"""The stage of questions: sends each question to a server that answers it, beside whatever the robot does."""

import contextlib
import queue
import threading
import time
from typing import Callable, Dict, List, Optional, Tuple

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from roboframenet_msgs.msg import Command, CommandPlan, FilledSemanticFrameAction, FilledSemanticFrameGoal, Reply

from roboframenet_ros.ros_action_connection import ActionConnection
from roboframenet_ros.ros_stage import Stage
from typed_arguments import FilledFrame, to_goal_text
from typed_arguments.ros_messages import frame_to_message, frames_from_messages, from_message

#: Questions that wait for the one before; nobody asks faster.
_MOST_WAITING = 20


class Asking:
    """Answers one question after the other; a question preempts no command, and no stop ends it.

    Subscribes:
        command_question (CommandPlan)
    Publishes:
        stage_events (StageEvent)
    """

    def __init__(self, *, timeout_s: float, before: Callable[[Command], None]) -> None:
        """
        Args:
            timeout_s: for a server to answer, seconds
            before: called with each question before a server is asked
        """
        self._timeout_s = timeout_s
        self._before = before
        self._connections: Dict[str, ActionConnection] = {}
        self._waiting: queue.Queue[Optional[CommandPlan]] = queue.Queue(_MOST_WAITING)
        self._stage = Stage("question_answering")
        self._thread = threading.Thread(target=self._work, name="answer questions", daemon=True)
        self._thread.start()
        self._subscriber = rospy.Subscriber("command_question", CommandPlan, self._hear, queue_size=_MOST_WAITING)
        rospy.on_shutdown(self._shutdown)

    def _shutdown(self) -> None:
        with contextlib.suppress(queue.Full):
            self._waiting.put_nowait(None)
        self._thread.join(self._timeout_s + 1.0)

    def _hear(self, message: CommandPlan) -> None:
        try:
            self._waiting.put_nowait(message)
        except queue.Full:
            self._end(message.command, Reply.FAILED, "BUSY", "Too many questions wait for an answer.")

    def _work(self) -> None:
        while not rospy.is_shutdown():
            message = self._waiting.get()
            if message is None:
                return
            try:
                self._answer(message)
            except Exception as error:  # boundary: each command gets its reply, whatever fails
                reason = f"The answer failed: {type(error).__name__}: {error}"
                self._end(message.command, Reply.FAILED, "STAGE_ERROR", reason)

    def _answer(self, message: CommandPlan) -> None:
        self._before(message.command)
        failures: List[str] = []
        for node in message.plan.nodes:
            shared = [from_message(argument) for argument in node.arguments]
            for candidate in node.candidates:
                for frame in frames_from_messages(candidate.frames, shared, candidate.arguments):
                    answer, reason = self._ask(frame)
                    if reason is None:
                        self._end(message.command, Reply.DONE, "DONE", answer or "Done.")
                        return
                    failures.append(f"{frame.server} {reason}")
        reasons = "; ".join(failures) or "nobody can answer"
        self._end(message.command, Reply.FAILED, "ALL_CANDIDATES_FAILED", f"I have no answer: {reasons}.")

    def _ask(self, frame: FilledFrame) -> Tuple[str, Optional[str]]:
        """Return the answer of a server, and None; or why it has none."""
        end_s = time.monotonic() + self._timeout_s
        connection = self._connections.get(frame.server)
        if connection is None:
            connection = self._connections[frame.server] = ActionConnection(frame.server, FilledSemanticFrameAction)
        while not connection.is_ready():
            if time.monotonic() >= end_s or rospy.is_shutdown():
                return "", "is not running"
            time.sleep(0.01)
        ended: queue.Queue[actionlib.ClientGoalHandle] = queue.Queue()

        def hear(handle: actionlib.ClientGoalHandle) -> None:
            if handle.get_comm_state() == actionlib.CommState.DONE:
                ended.put(handle)

        sent = connection.send(
            FilledSemanticFrameGoal(frame=frame_to_message(frame)),
            header_text=to_goal_text(frame.arguments),
            on_transition=hear,
            on_feedback=lambda _feedback: None,
        )
        try:
            handle = ended.get(timeout=max(0.01, end_s - time.monotonic()))
        except queue.Empty:
            connection.cancel(sent)
            return "", f"did not answer within {self._timeout_s:g} s"
        text = handle.get_goal_status_text().strip()
        if handle.get_goal_status() == GoalStatus.SUCCEEDED:
            return text, None
        return "", f"failed: {text}" if text else "failed"

    def _end(self, command: Command, outcome: int, code: str, sentence: str) -> None:
        rospy.loginfo("cmd=%s -> %s: %s", command.id, code, sentence)
        self._stage.ends(command, outcome=outcome, code=code, sentence=sentence)
