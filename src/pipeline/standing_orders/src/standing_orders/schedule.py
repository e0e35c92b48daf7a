"""When an order is due: times of the clock on the wall, and spans of time."""

from dataclasses import dataclass, replace
from datetime import date, datetime, time, timedelta, tzinfo
from typing import Optional, Sequence, Tuple, Union

from dateutil import tz

from typed_arguments import TimeExpression

_DAY_S = 86_400.0
#: No order is kept for longer than this, and none is due more often, seconds.
LATEST_S = 366 * _DAY_S
LEAST_PERIOD_S = 10.0
#: What TIMEX3 calls any day of a week; a number from 1, Monday, to 7 follows.
_ANY_WEEK = "XXXX-WXX-"


class NoSchedule(ValueError):
    """A time is not understood, over already, or too far away; the text is a sentence for the person."""


@dataclass(frozen=True)
class Once:
    """At a time of the clock: "at eight", "tomorrow at nine".

    Attributes:
        at: date and time on the clock of the robot, without a zone
    """

    at: datetime


@dataclass(frozen=True)
class After:
    """After a span of time: "in five minutes".

    Attributes:
        due_s: seconds since 1970; it moves with the clock, when that is set
    """

    due_s: float


@dataclass(frozen=True)
class Every:
    """Again and again after a span of time: "every ten minutes".

    Attributes:
        next_s: seconds since 1970; it moves with the clock, when that is set
        period_s: seconds
    """

    next_s: float
    period_s: float


@dataclass(frozen=True)
class Daily:
    """At a time of each day, or of some days of the week.

    Attributes:
        at: on the clock of the robot
        weekdays: 0 for Monday to 6; empty for each day
    """

    at: time
    weekdays: Tuple[int, ...] = ()


Schedule = Union[Once, After, Every, Daily]


def schedule_of(when: TimeExpression, now_s: float, zone: tzinfo) -> Schedule:
    """Return when something is due.

    Args:
        when: the time as it was said
        now_s: when it was said, seconds since 1970
        zone: of the clock of the robot

    Raises:
        NoSchedule: see there
    """
    of_clock = [part for part in when.value.split("/") if "T" in part and not part.startswith("P")]
    if when.period_s is not None and of_clock:
        weekdays, at = _weekday(of_clock[0]), _time(of_clock[0], when)
        if when.period_s not in (_DAY_S, 7 * _DAY_S) or (weekdays == () and when.period_s != _DAY_S):
            raise NoSchedule(f'I do not understand the time "{when.words}".')
        return Daily(at, weekdays)
    if when.period_s is not None:
        if when.period_s < LEAST_PERIOD_S:
            raise NoSchedule(f"I do nothing more often than every {LEAST_PERIOD_S:g} seconds.")
        _refuse_far(when.period_s, when)
        return Every(now_s + when.period_s, when.period_s)
    if of_clock:
        return _once(when, of_clock, now_s, zone)
    if when.offset_s is not None and when.offset_s > 0.0:
        _refuse_far(when.offset_s, when)
        return After(now_s + when.offset_s)
    raise NoSchedule(f'I do not understand the time "{when.words}".')


def _once(when: TimeExpression, of_clock: Sequence[str], now_s: float, zone: tzinfo) -> Once:
    now = datetime.fromtimestamp(now_s, zone).replace(tzinfo=None)
    found = []
    for part in of_clock:
        at, weekdays = _time(part, when), _weekday(part)
        day = _date(part)
        if day is not None:
            found.append(datetime.combine(day, at))
        elif when.offset_s is not None:
            found.append(datetime.combine(now.date() + timedelta(days=round(when.offset_s / _DAY_S)), at))
        else:
            days = (datetime.combine(now.date() + timedelta(days=count), at) for count in range(8))
            fits = [one for one in days if one > now and (not weekdays or one.weekday() in weekdays)]
            found.append(fits[0] if fits else datetime.combine(now.date() + timedelta(days=7), at))
    later = sorted(one for one in found if utc_s(one, zone) > now_s)
    if not later:
        raise NoSchedule(f"That is over: it is {now:%H:%M} now.")
    _refuse_far(utc_s(later[0], zone) - now_s, when)
    return Once(later[0])


def _refuse_far(span_s: float, when: TimeExpression) -> None:
    if span_s > LATEST_S:
        raise NoSchedule(f'"{when.words}" is too far away: I keep no order for longer than a year.')


def _time(part: str, when: TimeExpression) -> time:
    try:
        return time.fromisoformat(part.rpartition("T")[2])
    except ValueError as error:
        raise NoSchedule(f'I do not understand the time "{when.words}".') from error


def _weekday(part: str) -> Tuple[int, ...]:
    day = part.partition("T")[0]
    if not day.startswith(_ANY_WEEK):
        return ()
    return tuple(int(number) - 1 for number in day[len(_ANY_WEEK) :] if number in "1234567")


def _date(part: str) -> Optional[date]:
    try:
        return date.fromisoformat(part.partition("T")[0])
    except ValueError:
        return None


def zone_of(name: str) -> tzinfo:
    """Return a time zone.

    Args:
        name: of IANA ("Europe/Berlin"); empty for that of this machine

    Raises:
        ValueError: no such zone
    """
    zone: Optional[tzinfo] = tz.gettz(name) if name else tz.gettz() or tz.UTC
    if zone is None:
        raise ValueError(f"no time zone is called {name!r}")
    return zone


def utc_s(at: datetime, zone: tzinfo) -> float:
    """Return when the clock shows a date and a time, seconds since 1970.

    A time that the clock jumps over in spring is as much later; of one that comes twice in autumn the first is meant.
    """
    shown: datetime = tz.resolve_imaginary(at.replace(tzinfo=zone, fold=0))
    return shown.timestamp()


def next_due_s(schedule: Schedule, after_s: float, zone: tzinfo) -> Optional[float]:
    """Return when an order is due next.

    Args:
        schedule: of the order
        after_s: what was due up to this moment has been done or missed, seconds since 1970
        zone: of the clock of the robot

    Returns:
        seconds since 1970, after `after_s`; None for never again
    """
    if isinstance(schedule, Once):
        due_s = utc_s(schedule.at, zone)
        return due_s if due_s > after_s else None
    if isinstance(schedule, After):
        return schedule.due_s if schedule.due_s > after_s else None
    if isinstance(schedule, Every):
        if schedule.next_s > after_s:
            return schedule.next_s
        passed = int((after_s - schedule.next_s) // schedule.period_s) + 1
        due_s = schedule.next_s + passed * schedule.period_s
        # The product is rounded.
        return due_s if due_s > after_s else schedule.next_s + (passed + 1) * schedule.period_s
    day = datetime.fromtimestamp(after_s, zone).date()
    for count in range(9):
        one = datetime.combine(day + timedelta(days=count), schedule.at)
        is_day = not schedule.weekdays or one.weekday() in schedule.weekdays
        if is_day and utc_s(one, zone) > after_s:
            return utc_s(one, zone)
    return None


def moved(schedule: Schedule, jump_s: float) -> Schedule:
    """Return a schedule after the clock was set: spans of time stay as long as they were said."""
    if isinstance(schedule, After):
        return replace(schedule, due_s=schedule.due_s + jump_s)
    if isinstance(schedule, Every):
        return replace(schedule, next_s=schedule.next_s + jump_s)
    return schedule


def is_once(schedule: Schedule) -> bool:
    """Whether it is due only once."""
    return isinstance(schedule, (Once, After))
