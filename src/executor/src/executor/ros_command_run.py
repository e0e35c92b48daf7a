"""Runs one plan, in a thread of its own."""

import threading
import time
from dataclasses import dataclass
from typing import Callable, Dict, Optional, Tuple

import rospy

import smach
from arbitrator.node_runs import NodeEvent
from arbitrator.plan import Candidate, Condition, Do, Plan, walk, with_candidates
from arbitrator.rest_of_plan import Progress, Rest
from arbitrator.scopes import Scope
from arbitrator.state_machine import build_state_machine, plan_label
from arbitrator.watching import Observation
from executor.command_queue import AfterStop
from executor.goal_tracking import Goal, GoalDeadlines, as_sentence
from executor.patience import Patience
from executor.quarantine import Quarantine
from executor.ready_thread import ReadyThread
from executor.ros_action_clients import ActionClients
from executor.ros_action_step import ActionStep, StepContext
from executor.ros_condition_watch import ConditionWatch, WatchContext
from executor.ros_driver_settings import DriverSettings
from executor.ros_introspection import Introspection
from executor.ros_running_goals import RunningGoals
from executor.ros_server_profiles import ServerProfiles
from executor.run_record import NodeRecord, RunRecord
from roboframenet_ros.spoken_text import join_with_and
from roboframenet_ros.suspension import SuspensionWatch
from typed_arguments import FilledFrame

#: Introspection starts a thread for each machine, and each candidate is a machine.
_MOST_SHOWN = 256


@dataclass(frozen=True)
class RunResult:
    """How a run ended.

    Attributes:
        outcome: succeeded, aborted or preempted; empty when the machine broke
        records: what became of each node of the plan
        error: why the machine broke, empty if it did not
        is_without_master: whether it ended because the master is gone
        rest: what was not done; None for nothing
    """

    outcome: str
    records: Tuple[NodeRecord, ...]
    error: str = ""
    is_without_master: bool = False
    rest: Optional[Rest] = None


class CommandRun:
    """Runs the SMACH machine of a plan and shows it to smach_viewer."""

    def __init__(
        self,
        plan: Plan,
        *,
        clients: ActionClients,
        settings: DriverSettings,
        running_goals: RunningGoals,
        deadlines: GoalDeadlines,
        quarantine: Quarantine,
        patience: Patience,
        profiles: ServerProfiles,
        longest_wait_s: float,
        after_stop: AfterStop,
        on_note: Callable[[str], None],
        on_tried: Callable[[FilledFrame, int, Goal, float], None],
        on_end: Callable[["CommandRun", RunResult], None],
        introspection: Introspection,
        suspension: SuspensionWatch,
        threads: ReadyThread,
    ) -> None:
        """Prepare; `start` begins.

        Args:
            plan: what to carry out
            clients: connections to servers
            settings: what the servers need of other nodes
            running_goals: goals that are cancelled after this process was killed
            deadlines: of each goal
            quarantine: servers that are out of use
            patience: how long the command may go on
            profiles: what the servers stated when they registered
            longest_wait_s: after which a wait for a condition fails, if it does not say a limit
            after_stop: what it heeds right after a stop
            on_note: called from the thread of the run with a sentence for each step
            on_tried: called from the threads of the run with each frame that has ended, the number of its clause, its
                goal, and how long it took, seconds
            on_end: called with the result, last, from the thread of the run
            introspection: of the machine
            suspension: whether this process has just been resumed
            threads: that run plans
        """
        self._plan = plan
        self._clients = clients
        self._on_note = on_note
        self._on_tried = on_tried
        self._longest_wait_s = longest_wait_s
        self._pause_s = after_stop.pause_s
        self._watches = WatchContext(clients, running_goals, deadlines, profiles.longest_silence_s, on_note)
        self._on_end = on_end
        self._introspection = introspection
        self._record = RunRecord(plan)
        self._progress = Progress(plan)
        self._lock = threading.Lock()
        self._labels = [part.label for part in walk(plan)]
        # The clauses that run now, and since when; several at a time in branches of the plan.
        self._steps: Dict[FilledFrame, Tuple[int, float]] = {}
        self._since_s = time.monotonic()
        self._is_preempt_asked = threading.Event()
        self._is_without_master = False
        self._machine: Optional[smach.Container] = None
        self._context = StepContext(
            clients=clients,
            settings=settings,
            running_goals=running_goals,
            deadlines=deadlines,
            profiles=profiles,
            quarantine=quarantine,
            patience=patience,
            suspension=suspension,
            earliest_stamp_ns=after_stop.stamp_ns,
            begin=self._begin_step,
            on_sent=lambda frame: on_note(f"The server {frame.server} begins the frame {frame.name}."),
            on_end=self._end_step,
        )
        self._threads = threads
        self._has_ended = threading.Event()

    def start(self) -> None:
        """Begin."""
        self._threads.run(self._run)

    def preempt(self) -> None:
        """Ask the run to end; returns at once."""
        self._is_preempt_asked.set()
        machine = self._machine
        if machine is not None:
            machine.request_preempt()

    def end_without_master(self, *, at_once: bool) -> None:
        """The master is gone: what runs ends, and nothing else begins; returns at once.

        Args:
            at_once: whether what runs is cancelled instead
        """
        with self._lock:
            self._is_without_master = True
            is_over = at_once or not self._steps
        if is_over:
            self.preempt()

    def join(self, *, timeout_s: float) -> bool:
        """Wait for the end; returns whether it has come."""
        return self._has_ended.wait(timeout_s)

    def describe(self) -> str:
        """Return a sentence that says what is done now, in the words of the person, and for how long."""
        is_ending = self._is_preempt_asked.is_set()
        with self._lock:
            steps = dict(self._steps)
        now_s = time.monotonic()
        if not steps:
            return f"{'Stopping' if is_ending else 'Waiting'} ({now_s - self._since_s:.0f} s)."
        what = [
            f'"{self._labels[number].strip(" .!")}" ({now_s - since_s:.0f} s)' for number, since_s in steps.values()
        ]
        return f"{'Stopping' if is_ending else 'Doing'} {join_with_and(what)}."

    def _begin_step(self, frame: FilledFrame, number: int) -> bool:
        with self._lock:
            if self._is_without_master:
                return False
            self._steps[frame] = (number, time.monotonic())
        return True

    def _end_step(self, frame: FilledFrame, number: int, goal: Goal) -> None:
        with self._lock:
            now_s = time.monotonic()
            took_s = now_s - self._steps.pop(frame, (number, now_s))[1]
            self._since_s = now_s
            is_over = self._is_without_master and not self._steps
        if is_over:
            # Before the machine goes on.
            self.preempt()
        self._record.hear_goal(number, goal)
        self._on_tried(frame, number, goal, took_s)
        how = f"{frame.server} {goal.reason}" if goal.reason else f"{frame.server} has done {frame.name}"
        self._on_note(as_sentence(f"The server {how}"))

    def _make_step(self, frame: FilledFrame, number: int, scope: Scope) -> ActionStep:
        return ActionStep(frame, number, scope, self._context)

    def _watch(self, condition: Condition, on_observation: Callable[[Observation], None]) -> Callable[[], None]:
        return ConditionWatch(condition, on_observation, self._watches).close

    def _observe(self, event: NodeEvent) -> None:
        self._record.hear(event)
        self._progress.hear(event)

    def _run(self) -> None:
        outcome, error = "", ""
        if self._pause_s > 0.0:
            self._is_preempt_asked.wait(self._pause_s)
        try:
            self._machine = build_state_machine(
                self._with_living_first(),
                self._make_step,
                watch=self._watch,
                observe=self._observe,
                longest_wait_s=self._longest_wait_s,
            )
            if self._is_preempt_asked.is_set():
                self._machine.request_preempt()
            self._show(self._machine)
            outcome = self._machine.execute()
        except Exception as fault:  # boundary: the command must be answered, however the machine broke
            rospy.logerr("the state machine failed: %s: %s", type(fault).__name__, fault)
            error = f"{type(fault).__name__}: {fault}"
        finally:
            result = RunResult(outcome, self._record.records(), error, self._is_without_master, self._progress.rest())
            self._on_end(self, result)
            self._introspection.hide()
            self._has_ended.set()

    def _with_living_first(self) -> Plan:
        """Return the plan with the candidates last whose servers are missing, among those of the same reading."""
        candidates = [one for part in walk(self._plan) if isinstance(part, (Do, Condition)) for one in part.candidates]
        missing = self._clients.missing({frame.server for one in candidates for frame in one.frames})

        def order(ways: Tuple[Candidate, ...]) -> Tuple[Candidate, ...]:
            return tuple(
                sorted(ways, key=lambda one: (one.preference, any(frame.server in missing for frame in one.frames)))
            )

        ordered: Plan = with_candidates(self._plan, order) if missing else self._plan
        return ordered

    def _show(self, machine: smach.Container) -> None:
        parts = list(walk(self._plan))
        machines = 1 + len(parts) + sum(len(part.candidates) for part in parts if isinstance(part, Do))
        if machines > _MOST_SHOWN:
            rospy.loginfo("introspection is off for a plan of %d machines", machines)
            return
        self._introspection.show(machine, label=plan_label(self._plan))
