"""Decides which robots an utterance is for, from its words, the robots that are there, and the dialogue so far."""

import math
from dataclasses import dataclass, replace
from typing import Dict, FrozenSet, List, Optional, Sequence, Tuple, Union

from command_server.cries import Kind as Cries
from command_server.stop_words import find_cry
from roboframenet_ros.spoken_text import with_capital
from robot_fleet.address_text import Part, split_by_address
from robot_fleet.address_words import address_words
from robot_fleet.designators import Group, Kind, tokens_of
from robot_fleet.robot_names import Names, is_titled
from robot_fleet.stops import stopped_by

#: More names than this are not listed in a question.
_MOST_LISTED = 6


@dataclass(frozen=True)
class Robot:
    """A robot that takes part.

    Attributes:
        name: that of its namespace
        spoken: what people call it, beside its name
        is_free: no command is open
        place: where it is, metres in the frame of the map; None if that is unknown
    """

    name: str
    spoken: Tuple[str, ...] = ()
    is_free: bool = True
    place: Optional[Tuple[float, float]] = None


@dataclass(frozen=True)
class Company:
    """The robots of a language service.

    Attributes:
        robots: those that take part, by name
        absent: names of robots that have left
        verbs: with which commands begin
    """

    robots: Tuple[Robot, ...] = ()
    absent: Tuple[str, ...] = ()
    verbs: FrozenSet[str] = frozenset()

    @property
    def present(self) -> Tuple[str, ...]:
        """The names of the robots that take part."""
        return tuple(robot.name for robot in self.robots)

    @property
    def names(self) -> Names:
        """The names of all robots, also of those that have left."""
        named: Dict[str, Sequence[str]] = dict.fromkeys(self.absent, ())
        named.update({robot.name: robot.spoken for robot in self.robots})
        return Names(named)


@dataclass(frozen=True)
class Order:
    """Words for robots.

    Attributes:
        robots: who acts; with ``is_any`` the first of them that can
        text: what is said to them
        is_any: one of them is enough
        is_after: when the orders before it are done
    """

    robots: Tuple[str, ...]
    text: str
    is_any: bool = False
    is_after: bool = False


@dataclass(frozen=True)
class Pending:
    """An utterance that waits for the answer to "Who should do that?".

    Attributes:
        text: what is to be done
        among: who may be meant
        expires_s: when the question is forgotten, monotonic seconds
    """

    text: str
    among: Tuple[str, ...]
    expires_s: float


@dataclass(frozen=True)
class Dialogue:
    """What was said before.

    Attributes:
        last: the robots that were last spoken to
        asking: the robots that have asked something, the last one last
        pending: what waits for a name
        said_s: when something was last said, monotonic seconds
    """

    last: Tuple[str, ...] = ()
    asking: Tuple[str, ...] = ()
    pending: Optional[Pending] = None
    said_s: float = -math.inf


@dataclass(frozen=True)
class Addressed:
    """The orders of an utterance.

    Attributes:
        orders: who does what
        dialogue: the state after it
        remark: what the reply says before the answers: of a stop, who is not here; empty for nothing
    """

    orders: Tuple[Order, ...]
    dialogue: Dialogue
    remark: str = ""


@dataclass(frozen=True)
class Unaddressed:
    """Nobody does anything: the reply to the person.

    Attributes:
        code: WHO (a question), NO_ROBOT, UNKNOWN_ROBOT, DECLINED, ATTENTION (an address alone)
        sentence: for the person
        dialogue: the state after it
    """

    code: str
    sentence: str
    dialogue: Dialogue


@dataclass(frozen=True)
class _Open:
    """It is not clear who is meant: a question among some robots, or a refusal."""

    code: str
    sentence: str
    among: Tuple[str, ...] = ()


def spoken(name: str) -> str:
    """Return the name of a robot for a sentence: "Alpha"."""
    return with_capital(name.replace("_", " ").strip())


def listed(names: Sequence[str], word: str = "and") -> str:
    """Return names for a sentence: "Alpha, Beta and Gamma"."""
    shown = [spoken(name) for name in names]
    return shown[0] if len(shown) == 1 else f"{', '.join(shown[:-1])} {word} {shown[-1]}" if shown else "nobody"


def others_addressed(text: str, robot: str, names: Names, verbs: FrozenSet[str]) -> Tuple[str, ...]:
    """Return the robots that an utterance names which was said to another robot alone; empty if that is meant too.

    Args:
        text: what was said to the robot
        robot: its name
        names: of all robots
        verbs: with which commands begin
    """
    groups = [part.group for part in split_by_address(text, names, verbs)]
    named = [
        group.names + group.unknown
        for group in groups
        if group is not None
        and group.kinds <= {Kind.NAME, Kind.UNKNOWN}
        and robot not in group.names
        and not group.excepted
    ]
    return tuple(dict.fromkeys(name for group_names in named for name in group_names))


def address(
    text: str,
    company: Company,
    dialogue: Dialogue,
    *,
    now_s: float,
    timeout_s: float = 600.0,
    answer_timeout_s: float = 60.0,
    near: Optional[Tuple[float, float]] = None,
) -> Union[Addressed, Unaddressed]:
    """Decide who is to do what.

    Args:
        text: what was said to all robots
        company: the robots
        dialogue: what was said before
        now_s: monotonic seconds
        timeout_s: how long the robot that was last spoken to is meant
        answer_timeout_s: how long an answer to "Who should do that?" is waited for
        near: where something is to be done, if that is known: of several robots, the nearest does it
    """
    return _Addressing(company, dialogue, now_s, timeout_s, answer_timeout_s, near).decide(text)


class _Addressing:
    def __init__(
        self,
        company: Company,
        dialogue: Dialogue,
        now_s: float,
        timeout_s: float,
        answer_timeout_s: float,
        near: Optional[Tuple[float, float]],
    ) -> None:
        self._company, self._now_s, self._near = company, now_s, near
        self._answer_timeout_s = answer_timeout_s
        present = frozenset(company.present)
        is_fresh = now_s - dialogue.said_s <= timeout_s
        pending = dialogue.pending
        self._before = replace(
            dialogue,
            last=dialogue.last if is_fresh else (),
            asking=tuple(name for name in dialogue.asking if name in present),
            pending=pending if pending is not None and now_s <= pending.expires_s else None,
            said_s=now_s,
        )

    def decide(self, text: str) -> Union[Addressed, Unaddressed]:
        """Return the orders, or the reply."""
        company = self._company
        if not company.robots:
            return self._reply("NO_ROBOT", "No robot is here.")
        names = company.names
        parts = split_by_address(text, names, company.verbs)
        if len(parts) == 1 and self._before.pending is not None:
            answered = self._answer(parts[0], self._before.pending)
            if answered is not None:
                return answered
        stopped = stopped_by(text, company.present, names)
        if stopped:
            return self._stop(parts, stopped)
        orders: List[Order] = []
        for part in parts:
            found = self._order(part, orders)
            if isinstance(found, _Open):
                return self._ask(found, text if len(parts) > 1 else part.text, whole=len(parts) > 1)
            orders.append(found)
        # "Thanks, Alpha. Beta, come here." tells Alpha nothing.
        orders = [order for order in orders if order.text] or orders[:1]
        spoken_to = tuple(dict.fromkeys(name for order in orders for name in order.robots))
        if len(orders) == 1 and not orders[0].text:
            attentive = replace(self._before, last=spoken_to, pending=None)
            are = "are" if len(spoken_to) > 1 else "is"
            return Unaddressed("ATTENTION", f"{listed(spoken_to)} {are} listening.", attentive)
        return Addressed(tuple(orders), self._after(orders, spoken_to))

    def _stop(self, parts: Sequence[Part], stopped: Tuple[str, ...]) -> Addressed:
        """Return the orders of an utterance that stops robots, which their stop servers have done already.

        Whoever they stop is named in the reply, also if the words are not clear; whom the words name and who is not
        here, too.
        """
        orders: List[Order] = []
        remarks: List[str] = []
        crying: List[str] = []
        for part in parts:
            is_cry = find_cry(part.text) is not None
            found = self._order(part, orders)
            if isinstance(found, _Open):
                missing = _missing(part.group, self._company) if part.group is not None else ""
                remarks.append(missing or ("" if is_cry else f'I did not do this: "{part.text}". {found.sentence}'))
                names = part.group.names if part.group is not None and is_cry else ()
                found = Order(tuple(name for name in names if name in stopped), part.text)
            if is_cry and not found.is_any:
                crying += found.robots
            if found.robots and not (is_cry and found.is_any):
                orders.append(self._without_stopped(found) if is_cry else found)
        others = tuple(name for name in stopped if name not in crying)
        kinds = {cry.kind for cry in map(find_cry, [part.text for part in parts]) if cry is not None}
        # What one robot is to forget, another one is not told.
        if others and kinds != {Cries.FORGET}:
            orders.append(Order(others, "Stop."))
        spoken_to = tuple(dict.fromkeys(name for order in orders for name in order.robots))
        is_unaddressed = parts[0].group is None and find_cry(parts[0].text) is not None
        dialogue = self._after(orders, spoken_to, is_cry=is_unaddressed or bool(others))
        remark = " ".join(dict.fromkeys(filter(None, remarks)))
        return Addressed(tuple(orders), dialogue, remark)

    def _without_stopped(self, order: Order) -> Order:
        """Return a cry without the names of the robots that it stops, too: each of them is told, and none is left."""
        parts = split_by_address(order.text, self._company.names, self._company.verbs)
        is_told = len(parts) == 1 and parts[0].group is not None and find_cry(parts[0].text) is not None
        return replace(order, text=parts[0].text) if is_told else order

    def _after(self, orders: Sequence[Order], spoken_to: Tuple[str, ...], *, is_cry: bool = False) -> Dialogue:
        last = orders[-1].robots if len(orders) > 1 and not orders[-1].is_any else spoken_to
        if is_cry:
            last = self._before.last
        asking = tuple(name for name in self._before.asking if name not in spoken_to)
        return replace(self._before, last=last, asking=asking, pending=None)

    def _reply(self, code: str, sentence: str) -> Unaddressed:
        return Unaddressed(code, sentence, replace(self._before, pending=None))

    def _ask(self, open_one: _Open, text: str, *, whole: bool) -> Unaddressed:
        if open_one.code != "WHO" or whole or not text:
            return self._reply(open_one.code, open_one.sentence)
        pending = Pending(text, open_one.among, self._now_s + self._answer_timeout_s)
        return Unaddressed("WHO", open_one.sentence, replace(self._before, pending=pending))

    def _answer(self, part: Part, pending: Pending) -> Optional[Union[Addressed, Unaddressed]]:
        """Return what an answer to "Who should do that?" means; None if the utterance is no answer."""
        words = " ".join(token.word for token in tokens_of(part.text) if token.word.isalpha() or " " in token.word)
        if part.group is None and words in address_words().phrases["nobody"]:
            return self._reply("DECLINED", "All right. Nobody does that.")
        if part.group is None or part.text.strip(" .!?"):
            return None
        found = self._resolve(part.group, pending.among)
        if isinstance(found, _Open):
            return self._ask(found, pending.text, whole=False)
        order = Order(found[0], pending.text, is_any=found[1])
        return Addressed((order,), self._after([order], order.robots))

    def _order(self, part: Part, before: Sequence[Order]) -> Union[Order, _Open]:
        if part.group is None and not before and find_cry(part.text) is not None:
            # Who cries "Stop!" means whatever moves.
            return Order(self._company.present, part.text)
        if part.group is None:
            found = self._unaddressed(before)
        else:
            last = before[-1].robots if before else self._before.last
            found = self._resolve(part.group, self._company.present, last)
        if isinstance(found, _Open):
            return found
        robots, is_any = found
        text = part.text
        if part.is_told:
            told_by = before[-1].robots if before else self._before.last
            if part.told_by is not None:
                told_by = part.told_by.names
            reworded = _with_names(text, told_by)
            if reworded is None:
                return _Open("UNKNOWN_ROBOT", 'I do not know whom you mean by "you".')
            text = reworded
        return Order(robots, text, is_any=is_any, is_after=part.is_after)

    def _unaddressed(self, before: Sequence[Order]) -> Union[Tuple[Tuple[str, ...], bool], _Open]:
        """Who is meant if the words do not say it: who asks, who was spoken to last, the only one, or a question."""
        present, asking, last = self._company.present, self._before.asking, self._before.last
        if before:
            return before[-1].robots, before[-1].is_any
        if len(asking) == 1:
            return asking, False
        if len(asking) > 1:
            return _Open("WHO", f"Whom do you mean: {listed(asking, 'or')}?", asking)
        gone = [name for name in last if name not in present]
        if last and not gone:
            return last, False
        if len(present) == 1 and not gone:
            return present, False
        remark = f"{listed(gone)} {'are' if len(gone) > 1 else 'is'} gone. " if gone else ""
        return _Open("WHO", f"{remark}Who should do that{_choice(present)}?", present)

    def _resolve(
        self, group: Group, among: Tuple[str, ...], last: Optional[Tuple[str, ...]] = None
    ) -> Union[Tuple[Tuple[str, ...], bool], _Open]:
        """Return the robots of an address and whether one of them is enough."""
        present = self._company.present
        last = self._before.last if last is None else last
        others = tuple(name for name in present if name not in last)
        missing = _missing(group, self._company)
        if missing:
            return _Open("UNKNOWN_ROBOT" if group.unknown else "NO_ROBOT", missing)
        found: List[str] = list(group.names)
        if Kind.EVERYBODY in group.kinds:
            found += present
        if Kind.LAST in group.kinds:
            found += last
        if Kind.OTHERS in group.kinds or Kind.OTHER_ONE in group.kinds:
            if not last or not others:
                return _Open("WHO", f"Whom do you mean{_choice(others or present)}?", others or present)
            if Kind.OTHER_ONE in group.kinds and len(others) > 1:
                return _Open("WHO", f"Which one: {listed(others, 'or')}?", others)
            found += others
        if Kind.BOTH in group.kinds:
            both = present if len(present) == 2 else last
            if len(both) != 2:
                return _Open("WHO", f"Which two{_choice(present)}?", present)
            found += both
        if Kind.SOMEBODY in group.kinds and not found:
            return self._somebody(tuple(name for name in among if name not in group.excepted))
        robots = tuple(name for name in dict.fromkeys(found) if name not in group.excepted)
        if not robots:
            return _Open("NO_ROBOT", "Nobody is left to do that.")
        return (self._ordered(robots), True) if group.is_any else (robots, False)

    def _somebody(self, among: Tuple[str, ...]) -> Union[Tuple[Tuple[str, ...], bool], _Open]:
        """Who is free, the nearest first; a question if nobody is: it matters what is given up."""
        free = tuple(robot.name for robot in self._company.robots if robot.is_free and robot.name in among)
        if free:
            return self._ordered(free), True
        if not among:
            return _Open("NO_ROBOT", "Nobody is left to do that.")
        return _Open("WHO", f"Everybody is busy. Who should stop and do that{_choice(among)}?", among)

    def _ordered(self, names: Tuple[str, ...]) -> Tuple[str, ...]:
        robots = [robot for robot in self._company.robots if robot.name in names]
        return tuple(robot.name for robot in sorted(robots, key=lambda one: (not one.is_free, self._distance(one))))

    def _distance(self, robot: Robot) -> float:
        if self._near is None or robot.place is None:
            return math.inf
        return math.hypot(robot.place[0] - self._near[0], robot.place[1] - self._near[1])


def _missing(group: Group, company: Company) -> str:
    """Return a sentence about those whom a group names and who are not here; empty if all are."""
    away = [name for name in group.names if name not in company.present]
    sentences = [f"{listed(away)} {'are' if len(away) > 1 else 'is'} not here."] if away else []
    if group.unknown:
        nobody = " and ".join(f"no {_described(said)}" for said in group.unknown)
        known = f"; I know {listed(company.present)}" if len(company.robots) <= _MOST_LISTED else ""
        sentences.append(f"There is {nobody} here{known}.")
    return " ".join(sentences)


def _described(said: str) -> str:
    """Return what was said of an unknown robot for a sentence: "robot four", "fourth robot", "robot called Luna"."""
    words = [token.word for token in tokens_of(said)]
    if any(is_titled(words, at) for at in range(1, len(words) + 1)):
        return said
    return said if words[-1:] == ["one"] else f"robot called {with_capital(said)}"


def _choice(names: Sequence[str]) -> str:
    return f": {listed(names, 'or')}" if len(names) <= _MOST_LISTED else ""


def _with_names(text: str, told_by: Tuple[str, ...]) -> Optional[str]:
    """Return an order that somebody is to pass on, with names in the place of "you"; None if nobody is meant."""
    you = [token for token in tokens_of(text) if token.word in address_words().words["you"]]
    if you and not told_by:
        return None
    for token in reversed(you):
        name = listed(told_by) + ("'s" if token.word.endswith("r") else "")
        text = text[: token.start] + name + text[token.end :]
    return text
