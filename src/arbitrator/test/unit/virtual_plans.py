"""Plans on a virtual clock: servers and sources of conditions that follow a script.

The clock runs one thread at a time and lets time pass only when all wait, so a run takes no time and always goes the
same way.
"""

import itertools
import math
import threading
import time
from dataclasses import dataclass, field
from typing import Callable, Dict, List, Tuple

import smach
from arbitrator.node_runs import NodeEvent
from arbitrator.scopes import Clock
from arbitrator.state_machine import OUTCOMES, build_state_machine
from arbitrator.watching import Observation

#: A test that hangs fails after this time, in which no thread did anything.
STUCK_S = 20.0


@dataclass(frozen=True)
class Attempt:
    """What a server does with a goal: how long it takes, how it ends, and how long it needs to end when cancelled."""

    duration_s: float
    outcome: str = "succeeded"
    cancel_s: float = 0.0
    heeds_cancel: bool = True


@dataclass(frozen=True)
class Source:
    """What the source of a condition says: changes at their times; a fault is a text."""

    changes: Tuple[Tuple[float, object], ...]
    answer_s: float = 0.0

    def at(self, now_s: float) -> object:
        """Its value at a time; None when it has none yet."""
        return next((value for at_s, value in reversed(self.changes) if at_s <= now_s), None)


@dataclass
class World:
    """The script of one case.

    Attributes:
        attempts: of each frame, by its name, the last one again and again
        sources: of each condition, by the name of its frame
        preempt_s: when the plan is preempted; infinite for never
    """

    attempts: Dict[str, Tuple[Attempt, ...]]
    sources: Dict[str, Source] = field(default_factory=dict)
    preempt_s: float = math.inf

    def attempt(self, name: str, number: int) -> Attempt:
        """The attempt with a number, from 0, at a frame."""
        known = self.attempts.get(name, (Attempt(1.0),))
        return known[min(number, len(known) - 1)]

    def source(self, name: str) -> Source:
        """The source of a condition; one that nobody wrote a script for holds at once."""
        return self.sources.get(name, Source(((-1.0, True),)))


class VirtualClock(Clock):
    """Time that passes when all threads wait; of those that may go on, the one with the least rank goes on first."""

    def __init__(self) -> None:
        super().__init__()
        self._now_s = 0.0
        self._waiting: Dict[int, Tuple[Callable[[], bool], float, threading.Event]] = {}
        self._events: List[Tuple[float, int, Callable[[], None]]] = []
        self._order = itertools.count()
        self.is_stuck = False

    def now_s(self) -> float:
        return self._now_s

    def at(self, at_s: float, call: Callable[[], None]) -> None:
        """Call a function at a time, before any thread goes on."""
        with self.lock:
            self._events.append((at_s, next(self._order), call))
            self._events.sort(key=lambda event: event[:2])

    def wait(self, rank: int, is_over: Callable[[], bool], until_s: float) -> None:
        with self.lock:
            released = self._add(rank, is_over, until_s)
            self._release()
        self._sleep(released, rank)

    def fork(self, ranks) -> None:
        with self.lock:
            for rank in ranks:
                self._add(rank, lambda: True, math.inf)
            self._release()

    def begin(self, rank: int) -> None:
        with self.lock:
            released = self._waiting[rank][2]
        self._sleep(released, rank)

    def end(self, *, is_last: bool) -> None:
        with self.lock:
            # After the last one, the thread that started all has the turn.
            if not is_last:
                self._release()

    def _add(self, rank: int, is_over: Callable[[], bool], until_s: float) -> threading.Event:
        assert rank not in self._waiting, f"two parts wait as {rank}"
        released = threading.Event()
        self._waiting[rank] = (is_over, until_s, released)
        return released

    def _sleep(self, released: threading.Event, rank: int) -> None:
        if not released.wait(STUCK_S):
            self.is_stuck = True
        if self.is_stuck:
            raise RuntimeError("the plan is stuck")
        with self.lock:
            del self._waiting[rank]

    def _release(self) -> None:
        """Give the turn to the next thread; let time pass until there is one."""
        while True:
            while self._events and self._events[0][0] <= self._now_s:
                self._events.pop(0)[2]()
            ready = [
                (rank, released)
                for rank, (is_over, until_s, released) in self._waiting.items()
                if not released.is_set() and (until_s <= self._now_s or is_over())
            ]
            if ready:
                min(ready)[1].set()
                return
            times = [until_s for _, until_s, released in self._waiting.values() if not released.is_set()]
            times += [self._events[0][0]] if self._events else []
            if not times or min(times) == math.inf:
                self.is_stuck = True
                for _, _, released in self._waiting.values():
                    released.set()
                return
            self._now_s = max(self._now_s, min(times))


class QuickClock(Clock):
    """Real time that runs faster: `factor` seconds of the plan in each second."""

    def __init__(self, factor: float) -> None:
        super().__init__()
        self._factor = factor
        self._start_s = time.monotonic()

    def now_s(self) -> float:
        return (time.monotonic() - self._start_s) * self._factor

    def wait(self, rank: int, is_over: Callable[[], bool], until_s: float) -> None:
        with self.lock:
            if not is_over():
                self.lock.wait(max(0.0, min((until_s - self.now_s()) / self._factor, STUCK_S)))

    def at(self, at_s: float, call: Callable[[], None]) -> None:
        """Call a function at a time."""
        timer = threading.Timer(max(0.0, at_s - self.now_s()) / self._factor, call)
        timer.daemon = True
        timer.start()


class ScriptedStep(smach.State):
    """Does what the script says about its frame."""

    def __init__(self, stage: "Stage", frame, number, scope) -> None:
        super().__init__(outcomes=list(OUTCOMES))
        self._stage, self._frame, self._number, self._scope = stage, frame, number, scope

    def execute(self, userdata: object) -> str:
        outcome = self._stage.carry_out(self._frame.name, self._number, self._scope)
        if self.preempt_requested():
            self.service_preempt()
        return outcome


class Stage:
    """Runs a plan in a world, and writes down what happens."""

    def __init__(
        self,
        plan,
        world: World,
        clock: Clock,
        *,
        longest_wait_s: float = 1000.0,
        also_observe: Callable[[NodeEvent], None] = lambda event: None,
    ) -> None:
        self.clock = clock
        self._also_observe = also_observe
        self.world = world
        self.log: List[Tuple[float, str]] = []
        self.running: List[str] = []
        self.watched: List[str] = []
        self.result = ""
        self._numbers: Dict[str, int] = {}
        self._lock = threading.Lock()
        self.machine = build_state_machine(
            plan,
            lambda frame, number, scope: ScriptedStep(self, frame, number, scope),
            watch=self.watch,
            observe=self.observe,
            clock=clock,
            longest_wait_s=longest_wait_s,
        )

    def run(self, at: Callable[[float, Callable[[], None]], None]) -> str:
        """Run to the end.

        Args:
            at: calls a function at a time after the start
        """
        self._at = at
        if self.world.preempt_s < math.inf:
            at(self.world.preempt_s, self.machine.request_preempt)
        return self.machine.execute()

    def write(self, text: str) -> None:
        with self._lock:
            self.log.append((self.clock.now_s(), text))

    def observe(self, event) -> None:
        ending = f"{event.outcome} by {event.ended_by.value}" if event.outcome else "begins"
        self.write(f"{event.number} {ending}")
        self._also_observe(event)

    def carry_out(self, name: str, rank: int, scope) -> str:
        scope.tick()
        if scope.is_cancelled:
            return "preempted"
        with self._lock:
            number = self._numbers.get(name, 0)
            self._numbers[name] = number + 1
        attempt = self.world.attempt(name, number)
        self.write(f"goal {name}")
        self.running.append(name)
        end_s = self.clock.now_s() + attempt.duration_s
        scope.wait(rank, lambda: False, end_s)
        outcome = attempt.outcome
        if scope.is_cancelled and self.clock.now_s() < end_s:
            outcome = "preempted"
            # Without the scope, which is cancelled: the server needs its time.
            until_s = self.clock.now_s() + attempt.cancel_s if attempt.heeds_cancel else end_s
            while self.clock.now_s() < until_s:
                self.clock.wait(rank, lambda: False, until_s)
            if not attempt.heeds_cancel:
                outcome = attempt.outcome
        self.running.remove(name)
        self.write(f"goal {name} {outcome}")
        return outcome

    def watch(self, condition, on_observation):
        """The source of a condition: its value when it answers, then each change."""
        name = condition.candidates[0].frames[0].name
        source = self.world.source(name)
        self.watched.append(name)
        is_open = [True]
        answer_s = self.clock.now_s() + source.answer_s

        def tell(value: object) -> None:
            if is_open[0]:
                on_observation(Observation(fault=value) if isinstance(value, str) else Observation(holds=bool(value)))

        def answer() -> None:
            value = source.at(answer_s)
            if value is not None:
                tell(value)

        if source.answer_s:
            self._at(answer_s, answer)
        else:
            answer()
        for at_s, value in source.changes:
            if at_s > answer_s:
                self._at(at_s, lambda value=value: tell(value))

        def close() -> None:
            is_open[0] = False
            self.watched.remove(name)

        return close


def run_on(clock, plan, world: World) -> Stage:
    """Run a plan on a clock that has `at`; returns the stage, whose `result` is the outcome."""
    stage = Stage(plan, world, clock)
    stage.result = stage.run(clock.at)
    return stage


def run_virtually(plan, world: World) -> Stage:
    """Run a plan on the virtual clock."""
    clock = VirtualClock()
    stage = run_on(clock, plan, world)
    assert not clock.is_stuck, "the plan is stuck"
    return stage
