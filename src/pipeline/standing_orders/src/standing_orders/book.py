"""The book of standing orders: which of them are due, in which order they are done, and which are missed.

Every function returns what changes: the caller writes that first, and sends what is due after that. So what was sent
once is not sent again after a crash, and an order is over when its command has ended.
"""

from dataclasses import dataclass, replace
from datetime import tzinfo
from typing import Collection, Dict, Iterable, List, Mapping, Optional, Tuple

from standing_orders.order import Firing, StandingOrder
from standing_orders.schedule import is_once, moved, next_due_s

#: A clock that differs by this much from the time that went by was set, seconds.
JUMP_S = 2.0
#: A clock that is set back by more than this was wrong before, seconds.
_WRONG_CLOCK_S = 12 * 3600.0
_UNKNOWN = "I was restarted when it began, and I do not know whether it was done"


@dataclass(frozen=True)
class Rules:
    """How orders are carried out.

    Attributes:
        most_orders: how many are kept
        longest_delay_s: how long an order that is due waits until nothing else runs; it is missed then
        fresh_s: for how long an event counts that is over
        pause_s: from one beginning of an order that waits for a condition to the next
    """

    most_orders: int = 100
    longest_delay_s: float = 60.0
    fresh_s: float = 2.0
    pause_s: float = 1.0


@dataclass(frozen=True)
class Change:
    """What becomes of orders.

    Attributes:
        kept: new or changed
        dropped: ids of those that are over
        due: what is to be sent
    """

    kept: Tuple[StandingOrder, ...] = ()
    dropped: Tuple[str, ...] = ()
    due: Tuple[Firing, ...] = ()

    @property
    def is_empty(self) -> bool:
        """Whether nothing changes."""
        return not (self.kept or self.dropped or self.due)


@dataclass(frozen=True)
class Condition:
    """What is known of the condition of an order.

    Attributes:
        holds: None while nobody can tell
        reason: why nobody can tell
    """

    holds: Optional[bool] = None
    reason: str = ""


@dataclass(frozen=True)
class _Due:
    """An order that waits until nothing else runs; times are monotonic seconds."""

    since_s: float
    event_s: Optional[float] = None


class Book:
    """The standing orders. One thread owns it; no time passes inside."""

    def __init__(self, orders: Iterable[StandingOrder], zone: tzinfo, rules: Rules = Rules(), *, tag: str = "") -> None:
        """
        Args:
            orders: that were kept
            zone: of the clock of the robot
            rules: how they are carried out
            tag: part of the ids of commands; another one for each run of the program
        """
        self._zone = zone
        self._rules = rules
        self._tag = tag
        self._orders = {order.order_id: order for order in orders}
        self._due: Dict[str, _Due] = {}
        self._begun_s: Dict[str, float] = {}
        self._last: Optional[Tuple[float, float]] = None
        self._sent = 0
        self._is_first = True
        self._clock_note = ""

    @property
    def orders(self) -> Tuple[StandingOrder, ...]:
        """All that are kept, oldest first."""
        return tuple(sorted(self._orders.values(), key=lambda order: order.given_s))

    @property
    def is_full(self) -> bool:
        """Whether no other order is kept."""
        return len(self._orders) >= self._rules.most_orders

    @property
    def due_ids(self) -> Tuple[str, ...]:
        """The orders that wait until nothing else runs."""
        return tuple(self._due)

    def same_as(self, order: StandingOrder) -> Optional[StandingOrder]:
        """Return an order that was given before and says the same; None for none."""
        key = _meaning(order)
        return next((one for one in self._orders.values() if _meaning(one) == key), None)

    def give(self, order: StandingOrder) -> Change:
        """Keep an order; the caller has asked whether the book is full."""
        self._orders[order.order_id] = order
        return Change(kept=(order,))

    def drop(self, order_ids: Iterable[str]) -> Change:
        """Take orders back."""
        dropped = tuple(order_id for order_id in order_ids if self._orders.pop(order_id, None) is not None)
        for order_id in dropped:
            self._forget(order_id)
        return Change(dropped=dropped)

    def suspend(self) -> Change:
        """Do nothing until `resume`: somebody said "Stop."."""
        changed = tuple(replace(order, is_suspended=True) for order in self._orders.values() if not order.is_suspended)
        self._orders.update((order.order_id, order) for order in changed)
        self._due.clear()
        return Change(kept=changed)

    def resume(self, now_s: float) -> Change:
        """Wait again; what was due meanwhile, and comes again, is not done late."""
        changed = []
        for order in self._orders.values():
            if order.is_suspended:
                changed.append(self._put_off(replace(order, is_suspended=False), now_s))
        self._orders.update((order.order_id, order) for order in changed)
        return Change(kept=tuple(changed))

    def happened(self, order_id: str, mono_s: float) -> None:
        """The condition of an order began to hold."""
        order = self._orders.get(order_id)
        if order is not None and not order.is_suspended:
            begun_s = self._due[order_id].since_s if order_id in self._due else mono_s
            self._due[order_id] = _Due(begun_s, mono_s)

    def ended(self, command_id: str) -> Change:
        """The command that carried an order out has its reply."""
        order = next((one for one in self._orders.values() if one.begun == command_id), None)
        return Change() if order is None else self._finish(order)

    def left_over(self, running: Collection[str]) -> Change:
        """Find the orders whose command the previous run of the program sent, and whose reply it has not heard.

        Args:
            running: ids of the commands that still run; their orders are left alone
        """
        changes = []
        for order in self.orders:
            if order.begun and order.begun not in running:
                told = Firing(self._command_id(order), order, _UNKNOWN)
                changes.append(replace(self._finish(order), due=(told,)))
        return Change(
            tuple(one for change in changes for one in change.kept),
            tuple(one for change in changes for one in change.dropped),
            tuple(one for change in changes for one in change.due),
        )

    def _finish(self, order: StandingOrder) -> Change:
        if order.schedule is not None and is_once(order.schedule):
            return self.drop((order.order_id,))
        self._orders[order.order_id] = replace(order, begun="")
        return Change(kept=(self._orders[order.order_id],))

    def turn(
        self, now_s: float, mono_s: float, *, busy_with: Optional[str] = None, conditions: Mapping[str, Condition] = {}
    ) -> Change:
        """Find what is due now; at most one order begins.

        Args:
            now_s: seconds since 1970
            mono_s: monotonic seconds
            busy_with: what runs now, a clause: "I did something else"; None if nothing runs
            conditions: what is known of the condition of each order that waits for one
        """
        kept: Dict[str, StandingOrder] = {}
        missed: List[Firing] = []
        self._watch_clock(now_s, mono_s, kept)
        for order in self.orders:
            if order.next_s is not None and order.next_s <= now_s and not order.begun:
                self._hear_time(order, now_s, mono_s, kept, missed)
        for order_id, due in list(self._due.items()):
            if mono_s - due.since_s > self._rules.longest_delay_s:
                missed.append(self._miss(order_id, busy_with or "I was not free", now_s, kept))
        begun = self._begin(now_s, mono_s, conditions, kept, missed) if busy_with is None else ()
        self._is_first, self._clock_note = False, ""
        dropped = tuple(order_id for order_id in kept if order_id not in self._orders)
        changed = tuple(order for order_id, order in kept.items() if order_id in self._orders)
        return Change(changed, dropped, (*missed, *begun))

    def _watch_clock(self, now_s: float, mono_s: float, kept: Dict[str, StandingOrder]) -> None:
        """Find out whether the clock was set, and move what does not depend on it."""
        last, self._last = self._last, (now_s, mono_s)
        jump_s = 0.0 if last is None else (now_s - last[0]) - (mono_s - last[1])
        if abs(jump_s) < JUMP_S:
            return
        self._clock_note = f"the clock was set {'forward' if jump_s > 0.0 else 'back'} by {_span(abs(jump_s))}"
        for order in self._orders.values():
            if order.schedule is None or order.next_s is None:
                continue
            schedule = moved(order.schedule, jump_s)
            next_s: Optional[float] = order.next_s
            if schedule != order.schedule:
                next_s = order.next_s + jump_s
            elif not is_once(schedule) and jump_s < -_WRONG_CLOCK_S:
                next_s = next_due_s(schedule, now_s, self._zone)
            if (schedule, next_s) != (order.schedule, order.next_s):
                self._keep(replace(order, schedule=schedule, next_s=next_s), kept)

    def _hear_time(
        self,
        order: StandingOrder,
        now_s: float,
        mono_s: float,
        kept: Dict[str, StandingOrder],
        missed: List[Firing],
    ) -> None:
        """The time of an order has come, or is over."""
        late_s = now_s - (order.next_s or 0.0)
        if order.is_suspended:
            if order.schedule is not None and is_once(order.schedule):
                missed.append(self._miss(order.order_id, 'you stopped me and did not say "go on"', now_s, kept))
            else:
                self._keep(self._put_off(order, now_s), kept)
        elif late_s > self._rules.longest_delay_s and order.order_id not in self._due:
            why = self._clock_note or ("I was off" if self._is_first else "I was not awake")
            missed.append(self._miss(order.order_id, why, now_s, kept))
        elif order.order_id not in self._due:
            self._due[order.order_id] = _Due(mono_s)

    def _begin(
        self,
        now_s: float,
        mono_s: float,
        conditions: Mapping[str, Condition],
        kept: Dict[str, StandingOrder],
        missed: List[Firing],
    ) -> Tuple[Firing, ...]:
        """Begin the order that has waited longest, if its condition holds at this moment."""
        for order_id, due in sorted(self._due.items(), key=lambda item: item[1].since_s):
            order = self._orders[order_id]
            if order.begun:
                continue
            if due.event_s is not None:
                if mono_s - self._begun_s.get(order_id, -self._rules.pause_s) < self._rules.pause_s:
                    continue
                condition = conditions.get(order_id, Condition())
                is_fresh = mono_s - due.event_s <= self._rules.fresh_s and not condition.reason
                if condition.holds is not True and not is_fresh:
                    why = condition.reason or "it was over when I was free"
                    missed.append(self._miss(order_id, why, now_s, kept))
                    continue
                self._begun_s[order_id] = mono_s
            del self._due[order_id]
            begun = replace(self._put_off(order, now_s), count=order.count + 1, begun=self._command_id(order))
            self._keep(begun, kept)
            return (Firing(begun.begun, begun),)
        return ()

    def _miss(self, order_id: str, why: str, now_s: float, kept: Dict[str, StandingOrder]) -> Firing:
        order = self._orders[order_id]
        self._due.pop(order_id, None)
        self._advance(order, now_s, kept)
        return Firing(self._command_id(order), order, not_done=why)

    def _advance(self, order: StandingOrder, now_s: float, kept: Dict[str, StandingOrder]) -> None:
        """An order was begun or missed: it comes again, or is over."""
        following = self._put_off(order, now_s)
        if order.schedule is not None and following.next_s is None:
            kept[order.order_id] = order
            del self._orders[order.order_id]
            self._forget(order.order_id)
            return
        self._keep(following, kept)

    def _put_off(self, order: StandingOrder, now_s: float) -> StandingOrder:
        if order.schedule is None or order.next_s is None:
            return order
        if is_once(order.schedule):
            return replace(order, next_s=None) if order.next_s <= now_s else order
        if order.next_s > now_s:
            return order
        return replace(order, next_s=next_due_s(order.schedule, now_s, self._zone))

    def _keep(self, order: StandingOrder, kept: Dict[str, StandingOrder]) -> None:
        if self._orders.get(order.order_id) != order:
            self._orders[order.order_id] = kept[order.order_id] = order

    def _forget(self, order_id: str) -> None:
        self._due.pop(order_id, None)
        self._begun_s.pop(order_id, None)

    def _command_id(self, order: StandingOrder) -> str:
        self._sent += 1
        return f"{order.order_id}-{self._tag}-{self._sent}"


def _meaning(order: StandingOrder) -> Tuple[object, ...]:
    schedule = None if order.schedule is None or is_once(order.schedule) else repr(order.schedule)
    if schedule is None and order.schedule is not None:
        # Two orders for the same moment are two orders: "in ten minutes" said twice.
        return (order.order_id,)
    return (order.text.lower().rstrip(" .!"), schedule)


def _span(seconds: float) -> str:
    minutes = round(seconds / 60.0)
    if minutes < 1:
        return f"{seconds:.0f} seconds"
    hours, rest = divmod(minutes, 60)
    return " ".join(
        f"{count} {unit}{'s' if count > 1 else ''}" for count, unit in ((hours, "hour"), (rest, "minute")) if count
    )
