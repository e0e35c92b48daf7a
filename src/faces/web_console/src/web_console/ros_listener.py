"""Hears the pipeline, and keeps the views of its commands."""

import threading
import time
from collections import OrderedDict
from typing import Any, Callable, Iterable, List, Tuple

import rospy
from roboframenet_msgs.msg import (
    Command,
    CommandLexicalUnits,
    CommandParse,
    CommandSemanticFrames,
    CommandStatus,
    FileProblems,
    Learned,
    Procedure,
    Reply,
    StageEvent,
    StandingOrders,
    StopReport,
)
from smach_msgs.msg import SmachContainerStatus
from std_msgs.msg import String

from web_console.board import Board
from web_console.conversations import Conversation, Frame
from web_console.history import History
from web_console.ros_hearing import show, show_raw
from web_console.ros_values import (
    clause_views,
    frames_of,
    learned_view,
    orders_view,
    parsed_words,
    plan_view,
    problem_view,
    reply_view,
    seconds,
    sequences_of,
    stage_view,
)
from web_console.views import ProblemsView, ProblemView, StatusView

#: Messages are read when a command has passed most stages. A page may be late by less than a person sees.
_PATIENCE_S = 0.03
_LONGEST_DOING = 200
#: Commands whose reply is awaited, at most; the oldest are forgotten.
_MOST_OPEN = 1000


class Listener:
    """Subscribers of everything that is said about commands.

    Subscribes: ``status``, ``stage_events``, ``command_parse``, ``command_lexical_units``,
    ``command_semantic_frames``, ``procedure``, ``reply``, ``stop_report``, ``file_problems``,
    ``executor/smach/container_status``, ``standing_orders``, ``learned``, ``doing``. Not ``command_text`` and
    ``command_plan``: their publishers wait for the first subscriber, which has to be the next stage.
    """

    def __init__(
        self,
        board: Board,
        history: History,
        *,
        call_soon: Callable[..., None],
        call_later: Callable[..., object],
        on_change: Callable[[], None],
        on_reply: Callable[[Conversation], None],
        on_stop_report: Callable[[StopReport], None],
    ) -> None:
        """Prepare; `start` subscribes.

        Args:
            board: receives the views
            history: of the commands
            call_soon: calls a function in the thread of the event loop, from any thread
            call_later: calls a function in that thread after some seconds
            on_change: called in that thread after each change of the board
            on_reply: called in that thread after each reply, with what was said
            on_stop_report: called in that thread
        """
        self._board = board
        self._history = history
        self._call_soon = call_soon
        self._call_later = call_later
        self._on_change = on_change
        self._on_reply_change = on_reply
        self._on_stop_report = on_stop_report
        self._lock = threading.Lock()
        self._waiting: List[Tuple[Any, Callable[[Any], None], rospy.AnyMsg]] = []
        self._frames: OrderedDict[str, Tuple[Frame, ...]] = OrderedDict()
        self._problems: dict[str, Tuple[ProblemView, ...]] = {}
        self._subscribers: List[rospy.Subscriber] = []

    def start(self) -> None:
        """Subscribe."""
        self._hear("stage_events", StageEvent, self._on_event)
        self._hear("command_parse", CommandParse, self._on_parse)
        self._hear("command_lexical_units", CommandLexicalUnits, self._on_units)
        self._hear("command_semantic_frames", CommandSemanticFrames, self._on_plan)
        self._hear("procedure", Procedure, self._on_procedure)
        self._hear("reply", Reply, self._on_reply)
        self._hear("status", CommandStatus, self._on_status)
        self._hear("standing_orders", StandingOrders, self._on_orders)
        self._hear("learned", Learned, self._on_learned)
        self._hear("doing", String, self._on_doing)
        self._hear("executor/smach/container_status", SmachContainerStatus, self._on_container)
        self._subscribers.append(
            rospy.Subscriber(
                "stop_report", StopReport, lambda message: self._call_soon(show, self._on_stop_report, message)
            )
        )
        # Two nodes publish it, each its own problems.
        self._subscribers.append(
            rospy.Subscriber(
                "file_problems", FileProblems, lambda message: self._call_soon(show, self._on_problems, message)
            )
        )

    def _hear(self, topic: str, kind: Any, callback: Callable[[Any], None]) -> None:
        # Read later: the stages need the processor now.
        self._subscribers.append(
            rospy.Subscriber(
                topic, rospy.AnyMsg, lambda message: self._arrived(kind, callback, message), queue_size=200
            )
        )

    def _arrived(self, kind: Any, callback: Callable[[Any], None], message: rospy.AnyMsg) -> None:
        with self._lock:
            self._waiting.append((kind, callback, message))
            is_first = len(self._waiting) == 1
        if is_first:
            self._call_soon(self._call_later, _PATIENCE_S, self._read)

    def _read(self) -> None:
        """Read what has arrived, in its order."""
        with self._lock:
            waiting, self._waiting = self._waiting, []
        for kind, callback, message in waiting:
            show_raw(kind, callback, message)

    def show(self, command_ids: Iterable[str]) -> None:
        """Show commands that have changed."""
        for command_id in command_ids:
            self._board.show("command", self._history.view(command_id), which=command_id)
        self._on_change()

    def _heard(self, command: Command) -> str:
        self._history.heard(command.id, command.text, seconds(command.stamp))
        return str(command.id)

    def _on_event(self, event: StageEvent) -> None:
        command_id = self._heard(event.command)
        self._history.reported(command_id, stage_view(event))
        self.show([command_id])

    def _on_parse(self, message: CommandParse) -> None:
        command_id = self._heard(message.command)
        self._history.parsed(command_id, parsed_words(message))
        self.show([command_id])

    def _on_units(self, message: CommandLexicalUnits) -> None:
        command_id = self._heard(message.command)
        self._history.understood(command_id, clause_views(message))
        self._frames[command_id] = frames_of(message)
        while len(self._frames) > _MOST_OPEN:
            self._frames.popitem(last=False)
        self.show([command_id])

    def _on_plan(self, message: CommandSemanticFrames) -> None:
        command_id = self._heard(message.command)
        self._history.planned(command_id, plan_view(message.plan))
        self.show([command_id])

    def _on_procedure(self, message: Procedure) -> None:
        arbitrated = self._history.arbitrated(sequences_of(message))
        if arbitrated:
            self.show([arbitrated])

    def _on_container(self, status: SmachContainerStatus) -> None:
        moved = self._history.moved(status.path, tuple(status.active_states), status.info)
        if moved:
            self.show([moved])

    def _on_doing(self, message: String) -> None:
        doing = self._history.doing(message.data[:_LONGEST_DOING].strip())
        if doing:
            self.show([doing])

    def _on_reply(self, reply: Reply) -> None:
        self._heard(reply.command)
        view = reply_view(reply)
        self.show(self._history.replied(reply.command.id, view))
        self._on_reply_change(
            Conversation(
                id=reply.command.id,
                # The clock of a simulation begins with 0; a person looks for a day.
                stamp_s=round(time.time(), 3),
                text=reply.command.text,
                frames=self._frames.pop(reply.command.id, ()),
                outcome=view.outcome,
                code=view.code,
                sentence=view.sentence,
            )
        )

    def _on_status(self, status: CommandStatus) -> None:
        for command in status.active:
            if not self._history.knows(command.id):
                self.show((*self._history.close_questions(), self._heard(command)))
        view = StatusView(status.sentence, tuple(command.id for command in status.active))
        if self._board.show("status", view):
            self._on_change()

    def _on_orders(self, message: StandingOrders) -> None:
        if self._board.show("orders", orders_view(message)):
            self._on_change()

    def _on_learned(self, message: Learned) -> None:
        if self._board.show("learned", learned_view(message)):
            self._on_change()

    def _on_problems(self, message: FileProblems) -> None:
        publisher = (message._connection_header or {}).get("callerid", "")
        self._problems[publisher] = tuple(map(problem_view, message.problems))
        everyone = [problem for problems in self._problems.values() for problem in problems]
        if self._board.show("problems", ProblemsView(tuple(dict.fromkeys(everyone)))):
            self._on_change()
