"""The last commands as view models."""

from collections import OrderedDict
from dataclasses import replace
from typing import Callable, Iterable, Mapping, Optional, Sequence, Tuple

from command_server.answers import answers_to
from web_console.arcs import ParsedWord, draw_arcs, tell_arcs
from web_console.progress import Progress, conclude, is_machine_of, light, ordered
from web_console.telling import now_of, tasks_of
from web_console.views import ClauseView, CommandView, PlanView, QuestionView, ReplyView, StageView

#: How many commands are kept.
MOST_COMMANDS = 50
_MOST_STAGES = 16
_LONGEST_TEXT = 1000
_MOST_DID = 40


class History:
    """The last commands. Not thread-safe: one thread owns it.

    Every method takes the id of a command and changes its view; the text and the stamp make a view that is not there.
    """

    def __init__(self, *, is_own: Callable[[str], bool], most: int = MOST_COMMANDS) -> None:
        """Start empty.

        Args:
            is_own: whether a command of this id came by action, so that the page can cancel it
            most: how many commands are kept; older ones are dropped
        """
        self._is_own = is_own
        self._most = most
        self._views: OrderedDict[str, CommandView] = OrderedDict()
        self._progress = Progress()
        self._running = ""
        #: Names that may answer a question, by its first word.
        self.names: Mapping[str, Tuple[str, ...]] = {}

    def views(self) -> Tuple[CommandView, ...]:
        """Return all views, the oldest first."""
        return tuple(self._views.values())

    def view(self, command_id: str) -> CommandView:
        """Return the view of a command.

        Raises:
            KeyError: there is no such command, or it was dropped
        """
        return self._views[command_id]

    def knows(self, command_id: str) -> bool:
        """Whether a command is among the last."""
        return command_id in self._views

    def heard(self, command_id: str, text: str, stamp_s: float) -> None:
        """A command was said."""
        if command_id not in self._views:
            self._views[command_id] = CommandView(
                id=command_id, text=text[:_LONGEST_TEXT], stamp_s=stamp_s, is_cancellable=self._is_own(command_id)
            )
            while len(self._views) > self._most:
                self._views.popitem(last=False)

    def _change(self, command_id: str, change: Callable[[CommandView], CommandView]) -> None:
        view = change(self._views[command_id])
        tasks = tasks_of(view.plan) if view.plan else ()
        now = "" if view.reply else now_of(view.stages, tasks, view.did)
        self._views[command_id] = replace(view, tasks=tasks, now=now)

    def reported(self, command_id: str, stage: StageView) -> None:
        """A stage reported; what it said before about the command is replaced, but its trace stays if it has none."""

        def change(view: CommandView) -> CommandView:
            before = next((one for one in view.stages if one.name == stage.name), None)
            if before is None:
                return replace(view, stages=(view.stages + (stage,))[-_MOST_STAGES:])
            new = replace(stage, after_s=before.after_s if before.sentence == stage.sentence else stage.after_s)
            new = new if new.trace else replace(new, trace=before.trace)
            return replace(view, stages=tuple(new if one.name == stage.name else one for one in view.stages))

        self._change(command_id, change)

    def parsed(self, command_id: str, words: Sequence[ParsedWord]) -> None:
        """The parser has parsed it."""
        self._change(command_id, lambda view: replace(view, parse=draw_arcs(words), parse_words=tell_arcs(words)))

    def understood(self, command_id: str, clauses: Iterable[ClauseView]) -> None:
        """The framer has understood it."""
        self._change(command_id, lambda view: replace(view, clauses=tuple(clauses)))

    def planned(self, command_id: str, plan: PlanView) -> None:
        """The registrar has made a plan."""
        self._running, self._progress = command_id, Progress()
        self._change(command_id, lambda view: replace(view, plan=plan))

    def arbitrated(self, sequences: Sequence[Sequence[Tuple[str, str]]]) -> str:
        """The arbitrator has ordered the candidates of the newest plan; returns the command, empty for none.

        Args:
            sequences: of frames and servers, for combinations of candidates, as in `progress.ordered`
        """
        view = self._views.get(self._running)
        if view is None or view.plan is None or self._progress.states:
            return ""
        plan = ordered(view.plan, sequences)
        self._change(self._running, lambda view: replace(view, plan=plan))
        return self._running

    def moved(self, path: str, active: Sequence[str], info: str) -> str:
        """A container of the machine of the newest plan published its status; returns the command, empty for none."""
        view = self._views.get(self._running)
        if view is None or view.plan is None or view.reply is not None or not is_machine_of(path, view.plan):
            return ""
        progress = self._progress.heard(path, active, info)
        if progress == self._progress:
            return ""
        self._progress = progress
        self._change(self._running, lambda view: replace(view, plan=light(view.plan, progress) if view.plan else None))
        return self._running

    def doing(self, words: str) -> str:
        """The robot says what it is doing; returns the command that runs, empty for none."""
        view = self._views.get(self._running)
        if not words or view is None or view.plan is None or view.reply is not None or view.did[-1:] == (words,):
            return ""
        self._change(self._running, lambda view: replace(view, did=(*view.did, words)[-_MOST_DID:]))
        return self._running

    def replied(self, command_id: str, reply: ReplyView) -> Tuple[str, ...]:
        """The reply has come; returns the commands that have changed. A question lasts until the next command."""
        changed = self._close_questions(command_id)

        def change(view: CommandView) -> CommandView:
            question = None
            if reply.outcome == "NEEDS_INFORMATION":
                question = QuestionView(reply.sentence, answers_to(reply.code, reply.sentence, self.names))
            plan = view.plan and conclude(view.plan, reply.outcome)
            return replace(view, reply=reply, plan=plan, question=question, is_cancellable=False)

        self._change(command_id, change)
        return (*changed, command_id)

    def close_questions(self) -> Tuple[str, ...]:
        """No question is open any more; returns the commands that have changed."""
        return self._close_questions("")

    def _close_questions(self, command_id: str) -> Tuple[str, ...]:
        asked = [view.id for view in self._views.values() if view.question is not None and view.id != command_id]
        for one in asked:
            self._change(one, lambda view: replace(view, question=None))
        return tuple(asked)

    @property
    def question(self) -> Optional[QuestionView]:
        """The open question."""
        return next((view.question for view in reversed(self._views.values()) if view.question is not None), None)
