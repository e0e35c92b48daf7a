"""What the robot says about standing orders."""

from datetime import datetime, tzinfo
from typing import Mapping, Optional, Sequence

from standing_orders.order import StandingOrder
from standing_orders.schedule import Daily, Every, Once, Schedule
from word_classes import turned_round

_DAYS = ("Monday", "Tuesday", "Wednesday", "Thursday", "Friday", "Saturday", "Sunday")
_UNITS = ((86_400.0, "day"), (3600.0, "hour"), (60.0, "minute"), (1.0, "second"))


def _deed(words: str) -> str:
    first, _, rest = turned_round(words).partition(" ")
    # Only the beginning of a sentence has its capital from there.
    return f"{first[:1].lower()}{first[1:]} {rest}".strip()


def sentence_of_whenever(deed: str, condition: str, *, is_negated: bool = False) -> str:
    """Return what the robot will do whenever something happens.

    Args:
        deed: what is to be done: "go to the door"
        condition: what must happen: "the bell rings"
        is_negated: whether the opposite must happen
    """
    happens = turned_round(condition, is_clause=True)
    first, _, rest = happens.partition(" ")
    happens = f"{first if first == 'I' else first[:1].lower() + first[1:]} {rest}".strip()
    return f"I will {_deed(deed)} whenever {'this is over: ' if is_negated else ''}{happens}."


def sentence_of_time(deed: str, schedule: Schedule, due_s: float, now_s: float, zone: tzinfo) -> str:
    """Return what the robot will do at a time.

    Args:
        deed: what is to be done
        schedule: of the order
        due_s: when it is due first, seconds since 1970
        now_s: now, seconds since 1970
        zone: of the clock of the robot
    """
    first = moment(due_s, now_s, zone)
    if isinstance(schedule, Every):
        return f"I will {_deed(deed)} every {span(schedule.period_s)}, first {first}."
    if isinstance(schedule, Daily):
        days = " and ".join(_DAYS[day] for day in schedule.weekdays)
        return f"I will {_deed(deed)} every {days or 'day'} at {schedule.at:%H:%M}."
    if isinstance(schedule, Once):
        return f"I will {_deed(deed)} {first}."
    return f"I will {_deed(deed)} in {span(due_s - now_s)}, {first}."


def moment(due_s: float, now_s: float, zone: tzinfo) -> str:
    """Return a moment in words: "at 20:00", "tomorrow at 09:00", "on Monday at 09:00", "on 2026-12-24 at 18:00"."""
    due, now = datetime.fromtimestamp(due_s, zone), datetime.fromtimestamp(now_s, zone)
    days = (due.date() - now.date()).days
    clock = f"{due:%H:%M}" if due.second == 0 else f"{due:%H:%M:%S}"
    if days == 0:
        return f"at {clock}"
    if days == 1:
        return f"tomorrow at {clock}"
    if 1 < days < 7:
        return f"on {_DAYS[due.weekday()]} at {clock}"
    return f"on {due:%Y-%m-%d} at {clock}"


def span(seconds: float) -> str:
    """Return a span of time in words: "10 minutes", "1 hour and 30 minutes"."""
    left, parts = max(1, round(seconds)), []
    for length, unit in _UNITS:
        count, left = divmod(left, int(length))
        if count:
            parts.append(f"{count} {unit}{'s' if count > 1 else ''}")
    return " and ".join(parts[:2])


def listing(
    orders: Sequence[StandingOrder],
    now_s: float,
    zone: tzinfo,
    *,
    blind: Mapping[str, str],
    due_ids: Sequence[str] = (),
) -> str:
    """Return what the robot waits for, for "What are you waiting for?".

    Args:
        orders: that are kept, oldest first
        now_s: now, seconds since 1970
        zone: of the clock of the robot
        blind: why nobody can tell whether a condition holds, by the id of its order
        due_ids: orders that wait until nothing else runs
    """
    if not orders:
        return "I have no standing order."
    told = [_told(order, now_s, zone, blind.get(order.order_id, ""), order.order_id in due_ids) for order in orders]
    count = f"I have {len(orders)} standing orders. " if len(orders) > 1 else ""
    stopped = [order for order in orders if order.is_suspended]
    rest = ""
    if stopped:
        which = "It is" if len(orders) == 1 else "They are" if len(stopped) == len(orders) else f"{len(stopped)} are"
        rest = f' {which} suspended since you stopped me; say "go on".'
    return f"{count}{' '.join(told)}{rest}"


def _told(order: StandingOrder, now_s: float, zone: tzinfo, fault: str, is_due: bool) -> str:
    remark: Optional[str] = None
    if fault and not order.is_suspended:
        remark = f"I cannot tell at the moment: {fault}"
    elif order.begun:
        remark = "I do it now"
    elif is_due:
        remark = "it is due now"
    elif isinstance(order.schedule, Every) and order.next_s is not None and not order.is_suspended:
        remark = f"next {moment(order.next_s, now_s, zone)}"
    if isinstance(order.schedule, Every):
        sentence = order.sentence.partition(", first ")[0] + "."
    elif order.schedule is not None and not isinstance(order.schedule, Daily) and order.next_s is not None:
        sentence = f"I will {_deed(order.deed)} {moment(order.next_s, now_s, zone)}."
    else:
        sentence = order.sentence
    return f"{sentence[:-1]} ({remark})." if remark else sentence
