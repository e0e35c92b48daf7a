"""What all runs share: connections and settings of servers, what the servers stated, and who is out of use."""

from typing import Callable, FrozenSet, Optional, Set, Tuple

import rospy
from roboframenet_msgs.msg import Command, CommandPlan, TriedFrame

from arbitrator.plan import Do, Plan, walk
from arbitrator.ros_messages import plan_to_message
from executor.command_queue import AfterStop
from executor.patience import Patience
from executor.quarantine import Quarantine
from executor.ready_thread import ReadyThread
from executor.ros_action_clients import ActionClients
from executor.ros_command_run import CommandRun, RunResult
from executor.ros_driver_settings import DriverSettings
from executor.ros_introspection import Introspection
from executor.ros_running_goals import RunningGoals
from executor.ros_server_profiles import ServerProfiles
from executor.ros_tried_frames import tried_frame
from executor.settings import Settings
from roboframenet_ros.suspension import SuspensionWatch

_HIDDEN = Introspection(is_enabled=False)
# A longer turn of the worker means that the process was suspended.
_LONGEST_TURN_S = 1.0


class RunStarter:
    """Makes the runs of commands. One thread at a time calls.

    Publishes: ``tried_frames``, ``running_plan``. Subscribes: ``frame_servers``.
    """

    def __init__(self, settings: Settings, *, private: str) -> None:
        """
        Args:
            settings: of the executor
            private: prefix of its private names
        """
        self._settings = settings
        self._server_settings = DriverSettings(
            timeout_s=settings.settings_timeout_s, parameter=private + "applied_settings"
        )
        self._clients = ActionClients(max_kept=settings.max_clients, prepare=self._server_settings.prepare)
        self._running_goals = RunningGoals(private + "running_goals")
        self._profiles = ServerProfiles(self._clients.hear_living, default_silence_s=settings.condition_silence_s)
        self._quarantine = Quarantine(duration_s=settings.quarantine_s)
        self._introspection = Introspection(is_enabled=settings.introspection)
        self._suspension = SuspensionWatch(longest_turn_s=_LONGEST_TURN_S)
        self._threads = ReadyThread("command_run")
        self._tried = rospy.Publisher("tried_frames", TriedFrame, queue_size=1000)
        self._begun = rospy.Publisher("running_plan", CommandPlan, queue_size=20)

    def start(self) -> None:
        """Cancel what an executor that was killed has left, undo its settings, and hear of servers."""
        self._running_goals.start()
        self._server_settings.start()
        self._profiles.start()

    def turn(self) -> None:
        """The worker is at work: called at each of its turns."""
        self._suspension.turn()

    @property
    def servers_out_of_use(self) -> Tuple[str, ...]:
        """The servers that are not asked for a while."""
        return tuple(self._quarantine.servers)

    def resources(self, plan: Plan) -> Optional[FrozenSet[str]]:
        """Return what the servers of a plan may occupy; None for everything."""
        found: Set[str] = set()
        for part in walk(plan):
            if not isinstance(part, Do):
                continue
            for frame in (frame for candidate in part.candidates for frame in candidate.frames):
                resources = self._profiles.resources(frame)
                if resources is None:
                    return None
                found |= resources
        return frozenset(found)

    def make(
        self,
        command: Command,
        plan: Plan,
        *,
        after_stop: AfterStop,
        is_shown: bool,
        on_note: Callable[[CommandRun, str], None],
        on_end: Callable[[CommandRun, RunResult], None],
    ) -> CommandRun:
        """Return the run of a command; it begins when it is started.

        Args:
            command: the command
            plan: what to carry out
            after_stop: what it heeds right after a stop
            is_shown: whether a viewer sees its machine
            on_note: called when there is something to tell of the run, in its thread
            on_end: called when it has ended, in its thread
        """
        # An observer of command_plan might take a plan that waits for an executor that starts anew.
        self._begun.publish(CommandPlan(command=command, plan=plan_to_message(plan)))
        run = CommandRun(
            plan,
            clients=self._clients,
            settings=self._server_settings,
            running_goals=self._running_goals,
            deadlines=self._settings.deadlines,
            quarantine=self._quarantine,
            patience=Patience(command_s=self._settings.longest_command_s, search_s=self._settings.longest_search_s),
            profiles=self._profiles,
            longest_wait_s=self._settings.longest_wait_s,
            after_stop=after_stop,
            on_note=lambda sentence: on_note(run, sentence),
            on_tried=lambda *tried: self._tried.publish(tried_frame(command, *tried)),
            on_end=on_end,
            introspection=self._introspection if is_shown else _HIDDEN,
            suspension=self._suspension,
            threads=self._threads,
        )
        return run

    def close(self) -> None:
        """End what the runs shared; each of them has ended."""
        self._clients.close()
        self._server_settings.close(timeout_s=1.0)
        self._running_goals.close(timeout_s=1.0)
