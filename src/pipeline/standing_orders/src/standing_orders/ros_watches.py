"""Watches the conditions of standing orders; orders with the same condition share a watch."""

import threading
import time
from dataclasses import dataclass, field
from typing import Callable, Dict, Mapping, Optional, Set

import rospy

from arbitrator.plan import AnyCondition
from arbitrator.plan import Condition as WatchedCondition
from arbitrator.watching import Observation, Watching
from executor.goal_tracking import GoalDeadlines
from executor.ros_action_clients import ActionClients
from executor.ros_condition_watch import ConditionWatch, WatchContext
from executor.ros_running_goals import RunningGoals
from executor.ros_server_profiles import ServerProfiles
from standing_orders.book import Condition

#: A dead source is noticed this much late at most, seconds; each watch costs a turn as often.
_TURN_S = 1.0
_UNKNOWN = Condition(None, "nobody has said yet whether it holds")


@dataclass
class _Watch:
    watching: Watching
    orders: Set[str] = field(default_factory=set)
    held: Optional[bool] = None
    retry_s: Optional[float] = None


class Watches:
    """Watches conditions, each again a while after its source has died."""

    def __init__(
        self,
        on_event: Callable[[str], None],
        on_change: Callable[[], None],
        *,
        retry_s: float,
        silence_s: float,
        max_clients: int,
        private: str,
    ) -> None:
        """
        Args:
            on_event: called with the id of an order when its condition begins to hold, from any thread
            on_change: called when something else is known of a condition, from any thread
            retry_s: from the death of a source to the next try
            silence_s: between two observations, unless the server states another time
            max_clients: connections to servers that are kept
            private: prefix of the private names of the node
        """
        self._on_event, self._on_change = on_event, on_change
        self._retry_s = retry_s
        self._lock = threading.RLock()
        self._watches: Dict[object, _Watch] = {}
        self._running_goals = RunningGoals(private + "running_goals")
        self._profiles = ServerProfiles(default_silence_s=silence_s)
        self._context = WatchContext(
            ActionClients(max_kept=max_clients),
            self._running_goals,
            GoalDeadlines(),
            self._profiles.longest_silence_s,
            lambda sentence: rospy.logdebug("%s", sentence),
            turn_s=_TURN_S,
        )

    def start(self) -> None:
        """Listen to the catalogue, and cancel the watches of a run that was killed."""
        self._running_goals.start()
        self._profiles.start()

    def set(self, conditions: Mapping[str, AnyCondition]) -> None:
        """Watch these conditions, and no others.

        Args:
            conditions: by the id of the order
        """
        with self._lock:
            for order_id, condition in conditions.items():
                watch = self._watches.get(condition)
                if watch is None:
                    watch = self._watches[condition] = self._open(condition)
                watch.orders.add(order_id)
            for condition, watch in list(self._watches.items()):
                watch.orders = {name for name in watch.orders if conditions.get(name) == condition}
                if not watch.orders:
                    del self._watches[condition]
                    watch.watching.close()

    def conditions(self) -> Dict[str, Condition]:
        """Return what is known of the condition of each order."""
        with self._lock:
            return {name: _known(watch.watching) for watch in self._watches.values() for name in watch.orders}

    @property
    def is_any_blind(self) -> bool:
        """Whether nobody can tell whether a condition holds: its source is tried again soon."""
        with self._lock:
            return any(watch.watching.fault or watch.watching.holds is None for watch in self._watches.values())

    def turn(self) -> None:
        """Watch again what nobody watches any more."""
        now_s = time.monotonic()
        with self._lock:
            for watch in self._watches.values():
                if not watch.watching.fault:
                    watch.retry_s = None
                elif watch.retry_s is None:
                    watch.retry_s = now_s + self._retry_s
                elif now_s >= watch.retry_s:
                    watch.retry_s, watch.held = None, None
                    watch.watching.close()
                    watch.watching.open()

    def close(self) -> None:
        """End all watches."""
        self.set({})
        self._context.clients.close()
        self._running_goals.close(timeout_s=1.0)

    def _open(self, condition: AnyCondition) -> _Watch:
        watching = Watching(condition, self._watch, on_change=lambda: self._hear(watch))
        watch = _Watch(watching)
        watching.open()
        return watch

    def _watch(self, condition: WatchedCondition, on_observation: Callable[[Observation], None]) -> Callable[[], None]:
        return ConditionWatch(condition, on_observation, self._context).close

    def _hear(self, watch: _Watch) -> None:
        with self._lock:
            holds = watch.watching.holds
            has_begun = holds is True and watch.held is False
            watch.held = holds
            orders = tuple(watch.orders) if has_begun else ()
        for order_id in orders:
            self._on_event(order_id)
        self._on_change()


def _known(watching: Watching) -> Condition:
    if watching.fault:
        return Condition(None, watching.fault)
    holds = watching.holds
    return _UNKNOWN if holds is None else Condition(holds)
