"""One thread follows the goals of all watches: each keeps its deadlines, whatever the others do."""

import threading
import time
from typing import Callable, List, Optional

from executor.ros_watch_goals import WatchEnd, WatchGoals
from roboframenet_testing import wait_until

TURN_S = 0.02


class Goal:
    """A goal that ends when it is told to, or at a time; it counts how often it is looked at."""

    def __init__(self, *, ends_s: float = float("inf"), look_s: Callable[[], float] = lambda: float("inf")) -> None:
        self.ends_s, self.look_s = ends_s, look_s
        self.reason: Optional[str] = None
        self.looks = 0
        self.ended: List[str] = []
        self.threads: List[str] = []
        self.is_closed = False

    def step(self) -> Optional[WatchEnd]:
        self.looks += 1
        self.threads.append(threading.current_thread().name)
        if self.reason == "raise":
            raise RuntimeError("as asked for")
        reason = "was late" if time.monotonic() >= self.ends_s else self.reason
        return WatchEnd(reason) if reason is not None else None

    def postpone(self, by_s: float) -> None:
        self.ends_s += by_s

    def next_s(self) -> float:
        return self.look_s()

    def close(self) -> None:
        self.is_closed = True

    def on_end(self, end: WatchEnd) -> None:
        self.ended.append(end.reason)


def test_all_goals_share_a_thread_that_ends_with_the_last() -> None:
    goals, many = WatchGoals(turn_s=TURN_S), [Goal() for _ in range(20)]
    for goal in many:
        goals.follow(goal)  # type: ignore[arg-type]
    wait_until(lambda: all(goal.looks >= 3 for goal in many))
    assert {name for goal in many for name in goal.threads} == {"condition_watches"}
    assert sum(thread.name == "condition_watches" for thread in threading.enumerate()) == 1
    for goal in many:
        goal.reason = "has ended its watch"
        goals.wake(goal)  # type: ignore[arg-type]
    wait_until(lambda: all(goal.ended == ["has ended its watch"] and goal.is_closed for goal in many))
    wait_until(lambda: all(thread.name != "condition_watches" for thread in threading.enumerate()))


def test_goal_that_comes_when_the_thread_has_ended_is_followed() -> None:
    goals = WatchGoals(turn_s=TURN_S)
    for _ in range(50):
        goal = Goal(ends_s=0.0)
        goals.follow(goal)  # type: ignore[arg-type]
        wait_until(lambda goal=goal: goal.ended == ["was late"])  # type: ignore[misc]


def test_goal_with_much_news_does_not_keep_others_from_their_deadlines() -> None:
    goals, late = WatchGoals(turn_s=TURN_S), Goal(ends_s=time.monotonic() + 0.2)
    chatty = Goal()
    goals.follow(late)  # type: ignore[arg-type]
    goals.follow(chatty)  # type: ignore[arg-type]
    is_over = threading.Event()

    def chat() -> None:
        while not is_over.is_set():
            goals.wake(chatty)  # type: ignore[arg-type]
            time.sleep(0.0)

    chatter = threading.Thread(target=chat)
    chatter.start()
    try:
        wait_until(lambda: late.ended == ["was late"])
    finally:
        is_over.set()
        chatter.join()
    chatty.reason = "over"
    goals.wake(chatty)  # type: ignore[arg-type]
    wait_until(lambda: chatty.ended == ["over"])


def test_deadline_before_the_end_of_a_turn_is_kept() -> None:
    goals, end_s = WatchGoals(turn_s=3600.0), time.monotonic() + 0.1
    goal = Goal(ends_s=end_s, look_s=lambda: end_s)
    goals.follow(goal)  # type: ignore[arg-type]
    wait_until(lambda: goal.ended == ["was late"])


def test_goal_that_breaks_ends_alone() -> None:
    goals, sound, broken = WatchGoals(turn_s=TURN_S), Goal(), Goal()
    goals.follow(sound)  # type: ignore[arg-type]
    goals.follow(broken)  # type: ignore[arg-type]
    broken.reason = "raise"
    wait_until(lambda: broken.ended == ["cannot be watched: as asked for"])
    looks = sound.looks
    wait_until(lambda: sound.looks > looks)
    assert sound.ended == []
    sound.reason = "over"
    wait_until(lambda: sound.ended == ["over"])
