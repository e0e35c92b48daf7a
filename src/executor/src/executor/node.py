"""The executor node: the newest command first; another one follows what runs, or runs beside it, if it says so.

Callbacks only enqueue; one worker thread owns the commands. Each machine has a thread, and one waits for the next one.
"""

import queue
import threading
import time
from dataclasses import dataclass, replace
from typing import Dict, List, Optional, Tuple, Union

import rospy
from roboframenet_msgs.msg import Command, CommandPlan, StoppedPlan, StopReport
from std_msgs.msg import Duration

import smach
from arbitrator.node_runs import PREEMPTED
from arbitrator.plan import Plan
from arbitrator.rest_of_plan import Rest, said
from arbitrator.ros_messages import plan_from_message, plan_to_message
from arbitrator.state_machine import plan_label
from executor import command_queue, replies
from executor.command_queue import Beginning, Cause, CommandKey, CommandQueue, Order, Preempt, Start, Step, Supersede
from executor.commander_watch import CommanderWatch
from executor.ros_command_run import CommandRun, RunResult
from executor.ros_master_watch import MasterWatch
from executor.ros_run_starter import RunStarter
from executor.settings import OnMasterLost, Settings
from roboframenet_ros.health import Health, Level
from roboframenet_ros.ros_hand_over import HandOver
from roboframenet_ros.ros_node import read_parameters, run_node
from roboframenet_ros.ros_place import Place
from roboframenet_ros.ros_replays import ReplayWatch
from roboframenet_ros.ros_server_links import newest_link
from roboframenet_ros.ros_stage import Stage
from robot_stop.emergency import Emergency
from robot_stop.ros_emergency import EmergencyWatch

# The stage promises an event each second; half of that leaves room for a busy machine.
_EVENT_PERIOD_S = 0.5
#: How often it looks, while commands are carried out, whether their commander is there.
_BUSY_PERIOD_S = 0.1
# A stop cancels all goals before it reports itself, so a goal may be gone before its reason is known.
_EXPLANATION_S = 1.0


@dataclass(frozen=True)
class _Job:
    """A command as it was received, and its plan."""

    command: Command
    plan: Plan


@dataclass(frozen=True)
class _Note:
    """A run reports its progress."""

    run: CommandRun
    sentence: str


@dataclass(frozen=True)
class _RunEnded:
    """The thread of a run has ended; whether a stop may still explain why its goal was cancelled."""

    run: CommandRun
    result: RunResult
    may_be_explained: bool = True


@dataclass(frozen=True)
class _MasterLost:
    """The master is gone."""


_Event = Union[CommandPlan, StopReport, Command, Emergency, _Note, _RunEnded, _MasterLost, None]


class ExecutorNode:
    """Carries out plans.

    Subscribes: ``command_plan``, ``command_cancel``, ``stop_report``, ``emergency_stop``, ``command_server_started``,
    ``status``. Publishes: ``stage_events``, ``stopped_plan``. Calls the action servers that the plans name. Its
    `RunStarter` knows the servers.
    """

    def __init__(self, settings: Settings, *, private: str = "~") -> None:
        """
        Args:
            settings: its own
            private: prefix of its private names
        """
        self._settings = settings
        self._starter = RunStarter(settings, private=private)
        self._master = MasterWatch(lambda: self._inbox.put(_MasterLost()), silence_s=settings.master_timeout_s)
        self._commands: CommandQueue[_Job] = CommandQueue()
        self._runs: Dict[str, CommandRun] = {}
        # Runs whose goal somebody else cancelled, and until when a stop may explain that.
        self._unexplained: List[Tuple[float, _RunEnded]] = []
        self._next_event_s = 0.0
        self._inbox: queue.SimpleQueue[_Event] = queue.SimpleQueue()
        self._emergency = EmergencyWatch(self._inbox.put)
        self._stopped = HandOver("stopped_plan", StoppedPlan)
        self._stage = Stage("executor")
        self._replays = ReplayWatch(self._stage)
        self._worker = threading.Thread(target=self._work, name="executor_worker")
        self._commander = CommanderWatch()
        # Of all that the command server publishes, this tells the least; nobody else publishes it.
        self._sign_of_commander = rospy.Subscriber("command_server_started", Duration, lambda _: None)

    def start(self) -> None:
        """Start to take commands."""
        rospy.on_shutdown(self._shutdown)
        self._starter.start()
        self._worker.start()
        self._replays.start()
        self._master.start()
        self._subscribers = [
            rospy.Subscriber("stop_report", StopReport, self._inbox.put),
            rospy.Subscriber("command_cancel", Command, self._inbox.put),
            rospy.Subscriber("command_plan", CommandPlan, self._inbox.put),
        ]

    def health(self) -> Health:
        """How the node is."""
        runs, servers = list(self._runs.values()), self._starter.servers_out_of_use
        doing = " ".join(run.describe() for run in runs) or "Waits for a command."
        if servers:
            return Health(Level.WARN, f"{doing} Out of use: {', '.join(servers)}.")
        return Health(message=doing)

    def _shutdown(self) -> None:
        self._master.close()
        self._inbox.put(None)
        self._worker.join(self._settings.preempt_timeout_s + 2.0)

    def _work(self) -> None:
        while True:
            try:
                is_idle = not (self._commands.running or self._commands.waiting)
                event = self._inbox.get(timeout=_EVENT_PERIOD_S if is_idle else _BUSY_PERIOD_S)
            except queue.Empty:
                self._starter.turn()
                self._look_around()
                continue
            if event is None:
                self._end_all()
                return
            self._starter.turn()
            try:
                self._handle(event)
            except Exception as error:  # boundary: one message must not end the work on all others
                rospy.logerr("could not handle a %s: %s: %s", type(event).__name__, type(error).__name__, error)
            self._look_around()

    def _look_around(self) -> None:
        """Do what no event tells of."""
        self._cancel_without_commander()
        self._pass_on_explained()
        self._report_progress()

    def _cancel_without_commander(self) -> None:
        """Cancel everything when the command server is gone; one that is started again would only do the same."""
        if rospy.is_shutdown() or not self._commander.is_lost(newest_link(self._sign_of_commander) != ("", "")):
            return
        if self._cancel_all():
            rospy.logwarn("who gave the commands is gone; they are cancelled")

    def _cancel_all(self) -> int:
        """Cancel everything; returns how many commands that are."""
        orders = (*self._commands.waiting, *(one.order for one in self._commands.running))
        for order in orders:
            self._follow(command_queue.cancel(self._commands, order.key.command_id))
        return len(orders)

    def _handle(self, event: _Event) -> None:
        if isinstance(event, CommandPlan):
            self._hear_plan(event)
        elif isinstance(event, StopReport):
            now_ns = rospy.Time.now().to_nsec()
            self._follow(command_queue.stop(self._commands, event.stop_stamp.to_nsec(), now_ns=now_ns))
        elif isinstance(event, Command):
            self._follow(command_queue.cancel(self._commands, event.id))
        elif isinstance(event, Emergency):
            if event.is_engaged:
                # The report of the stop says the same, unless the stop server was killed before.
                self._cancel_all()
        elif isinstance(event, _Note):
            order = self._order_of(event.run)
            if order is not None:
                rospy.loginfo("cmd=%s %s", order.key.command_id, event.sentence)
                self._stage.passes_on(order.job.command, event.sentence)
        elif isinstance(event, _RunEnded):
            if event.may_be_explained and self._lacks_cause(event):
                self._unexplained.append((time.monotonic() + _EXPLANATION_S, event))
            else:
                self._hear_end(event)
        elif isinstance(event, _MasterLost):
            for run in self._runs.values():
                run.end_without_master(at_once=self._settings.on_master_lost is OnMasterLost.STOP)

    def _hear_plan(self, message: CommandPlan) -> None:
        if message.command.id not in self._commands.cancelled_ids and self._replays.refuses(message.command):
            return
        try:
            plan = plan_from_message(message.plan)
        except ValueError as error:
            self._end(message.command, replies.ending_of_malformed(str(error)))
            return
        key = CommandKey(command_id=message.command.id, stamp_ns=message.command.stamp.to_nsec())
        job = _Job(command=message.command, plan=plan)
        order = Order(key, job, Beginning(message.plan.beginning), self._starter.resources(plan))
        self._follow(command_queue.submit(self._commands, order, now_ns=rospy.Time.now().to_nsec()))

    def _order_of(self, run: CommandRun) -> "Optional[Order[_Job]]":
        return next(
            (one.order for one in self._commands.running if self._runs.get(one.order.key.command_id) is run), None
        )

    def _pass_on_explained(self) -> None:
        """Let the runs end whose preemption has a reason now, or no more time to get one."""
        waiting, self._unexplained = self._unexplained, []
        for until_s, ended in waiting:
            if self._lacks_cause(ended) and time.monotonic() < until_s:
                self._unexplained.append((until_s, ended))
            else:
                self._inbox.put(replace(ended, may_be_explained=False))

    def _lacks_cause(self, ended: _RunEnded) -> bool:
        """Whether the run was preempted and neither the queue nor the lost master says why."""
        order, result = self._order_of(ended.run), ended.result
        if order is None or result.outcome != PREEMPTED or result.is_without_master:
            return False
        return self._commands.cause_of(order.key.command_id) is None

    def _hear_end(self, ended: _RunEnded) -> None:
        order = self._order_of(ended.run)
        if order is None:
            return
        command_id = order.key.command_id
        del self._runs[command_id]
        result, cause = ended.result, self._commands.cause_of(command_id)
        ending = replies.ending_of_run(
            result.outcome,
            order.job.plan,
            result.records,
            cause=cause,
            error=result.error,
            is_without_master=result.is_without_master,
        )
        if cause is Cause.STOPPED:
            self._offer(order.job.command, result.rest)
        self._end(order.job.command, ending)
        is_done = ending.outcome is replies.ReplyOutcome.DONE
        self._follow(command_queue.finish(self._commands, command_id, is_done=is_done))

    def _follow(self, step: Step) -> None:
        """Keep the next queue, and take its actions."""
        self._commands, actions = step
        for action in actions:
            held = self._emergency.state.sentence
            if isinstance(action, Start) and (held or self._master.is_lost):
                ending = replies.ending_of_held(held) if held else replies.ending_without_master()
                self._end(action.order.job.command, ending)
                command_id = action.order.key.command_id
                self._follow(command_queue.finish(self._commands, command_id, is_done=False))
            elif isinstance(action, Start):
                self._start_run(action.order)
            elif isinstance(action, Preempt):
                rospy.loginfo("cmd=%s is preempted: %s", action.order.key.command_id, action.cause.value)
                self._runs[action.order.key.command_id].preempt()
            elif isinstance(action, Supersede):
                if action.cause is Cause.STOPPED:
                    self._offer(action.order.job.command, Rest(action.order.job.plan, said(action.order.job.plan)))
                blocking = "" if action.blocking is None else plan_label(action.blocking.job.plan)
                self._end(action.order.job.command, replies.ending_of_unstarted(action.cause, blocking=blocking))

    def _offer(self, command: Command, rest: Optional[Rest]) -> None:
        """Tell what a stop has left undone: a person may say to go on with it."""
        if rest is not None:
            self._stopped.publish(StoppedPlan(command=command, plan=plan_to_message(rest.plan), said=rest.said))

    def _start_run(self, order: "Order[_Job]") -> None:
        run = self._starter.make(
            order.job.command,
            order.job.plan,
            after_stop=command_queue.after_stop(self._commands, now_ns=rospy.Time.now().to_nsec()),
            # One machine at a time is shown.
            is_shown=not self._runs,
            on_note=lambda noted, sentence: self._inbox.put(_Note(noted, sentence)),
            on_end=lambda ended, result: self._inbox.put(_RunEnded(ended, result)),
        )
        self._runs[order.key.command_id] = run
        # The run says itself what begins.
        self._next_event_s = time.monotonic() + _EVENT_PERIOD_S
        run.start()

    def _report_progress(self) -> None:
        if time.monotonic() < self._next_event_s:
            return
        self._next_event_s = time.monotonic() + _EVENT_PERIOD_S
        for one in self._commands.running:
            run = self._runs.get(one.order.key.command_id)
            if run is not None:
                self._stage.passes_on(one.order.job.command, run.describe())
        for order in self._commands.waiting:
            self._stage.passes_on(order.job.command, "Waiting for the previous command to end.")

    def _end(self, command: Command, ending: replies.Ending) -> None:
        rospy.loginfo("cmd=%s -> %s %s: %s", command.id, ending.outcome.name, ending.code, ending.sentence)
        self._stage.ends(command, outcome=int(ending.outcome), code=ending.code, sentence=ending.sentence)

    def _end_all(self) -> None:
        """Cancel everything before the node exits, so that the robot does not go on without it."""
        self._cancel_all()
        self._pass_on_explained()
        # The end of each run comes through the inbox; its thread has deadlines for everything it waits for.
        end_s = time.monotonic() + self._settings.preempt_timeout_s + 1.0
        for run in list(self._runs.values()):
            run.join(timeout_s=max(0.0, end_s - time.monotonic()))
        while self._runs:
            try:
                event = self._inbox.get(timeout=0.5)
            except queue.Empty:
                break
            if isinstance(event, _RunEnded):
                self._hear_end(event)
        self._starter.close()


def start(place: Place) -> ExecutorNode:
    """Start the stage.

    Raises:
        ParameterError: a parameter is wrong
    """
    # The notes of the run say what matters; each transition of its machines is detail.
    smach.set_loggers(rospy.logdebug, rospy.logwarn, rospy.logdebug, rospy.logerr)
    settings = read_parameters(Settings, prefix=place.private)
    rospy.loginfo("executor: %s", settings)
    node = ExecutorNode(settings, private=place.private)
    node.start()
    return node


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("executor", lambda: start(Place()))
