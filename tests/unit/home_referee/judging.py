"""Judges what came of a command: the state of the home, what was said and to whom, and whether the reply is true."""

import re
from dataclasses import dataclass
from enum import Enum
from typing import Dict, List, Mapping, Optional, Sequence, Tuple, Union

from .commands import Command
from .home_slots import HomeSlots
from .logical_forms import Description, Form
from .walking import Walk

Truth = Mapping[str, Union[str, bool, float]]
ROBOT = "robot"
#: Whoever is guided or followed opens doors, and closes none.
_MOVING_PEOPLE = ("guide", "follow", "sequence")
_NUMBERS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine")
_DAYS = "monday|tuesday|wednesday|thursday|friday|saturday|sunday"
#: What a saying must contain, by a word of what was to be said; the words themselves say nothing.
_SAYINGS = (
    ("time", re.compile(r"\d")),
    ("day", re.compile(_DAYS)),
    ("joke", re.compile(r".{30}")),
    ("yourself", re.compile(r"robot")),
    ("name", re.compile(r"robot")),
)
#: Properties of a home that say how something is; all others are measured from the robot, or written for people.
_PROPERTIES = ("is_open", "is_on", "is_locked", "level", "setting", "contents", "is_unplugged", "form", "cooked")


class Verdict(Enum):
    """What came of a command.

    RIGHT: the state is as the command wants it, and the reply says so
    ASKED: the robot asked or refused, and did nothing
    FAILED: it did not get there, said so with the true reason, and left nothing that nobody asked for
    UNTOLD: it did not get there, and the reply does not say why, or says another reason
    WRONG: the home is in a state that nobody asked for, or the reply says that something was done that was not
    """

    RIGHT = "right"
    ASKED = "asked"
    FAILED = "failed"
    UNTOLD = "untold"
    WRONG = "wrong"


@dataclass(frozen=True)
class Saying:
    """What the robot said, and who heard it."""

    text: str
    to: Tuple[str, ...]


@dataclass(frozen=True)
class Run:
    """A command that was carried out, or not.

    Attributes:
        command: with its annotation
        before, after: the truth of the home
        sayings: of the robot, meanwhile; the reply is one of them, to the speaker
        outcome: of the reply: DONE, FAILED, REFUSED, NEEDS_INFORMATION, SUPERSEDED
        sentence: of the reply
        reasons: the sentences with which the home refused actions, meanwhile
        was_stopped: whether the referee ended it, because nothing else ends it
    """

    command: Command
    before: Truth
    after: Truth
    sayings: Tuple[Saying, ...]
    outcome: str
    sentence: str
    reasons: Tuple[str, ...] = ()
    was_stopped: bool = False


@dataclass(frozen=True)
class Judgement:
    """A verdict, and what is not as it must be."""

    run: Run
    verdict: Verdict
    reasons: Tuple[str, ...]


def judge(run: Run, slots: HomeSlots) -> Judgement:
    """Judge a run by the annotation of its command."""
    referee = _Referee(run, slots)
    form = run.command.form
    missing = referee.missing(form)
    unasked = referee.unasked()
    if unasked:
        return Judgement(run, Verdict.WRONG, tuple(unasked))
    is_done = run.outcome == "DONE" or run.was_stopped
    if form.predicate == "UNKNOWN" or "UNKNOWN" in form.arguments:
        # Nobody can know what is meant: whoever asks or says so is right.
        return Judgement(
            run, Verdict.WRONG if is_done else Verdict.RIGHT, ("done, whatever it was",) if is_done else ()
        )
    if not missing:
        # What is done in part may be told as a failure of the rest; here all is done.
        verdict = Verdict.RIGHT if is_done else Verdict.UNTOLD
        return Judgement(run, verdict, () if is_done else (f"done, and told otherwise: {run.sentence}",))
    if is_done:
        return Judgement(run, Verdict.WRONG, ("told as done", *missing))
    if run.outcome == "SUPERSEDED":
        # The referee ended what would go on for ever.
        return Judgement(run, Verdict.FAILED, ("ended by the referee", *missing))
    if run.outcome in ("REFUSED", "NEEDS_INFORMATION"):
        return Judgement(run, Verdict.ASKED, (run.sentence, *missing))
    if referee.is_reason_true():
        return Judgement(run, Verdict.FAILED, (run.sentence, *missing))
    return Judgement(run, Verdict.UNTOLD, (run.sentence, *missing))


class _Referee:
    """Compares one run with the annotation of its command."""

    def __init__(self, run: Run, slots: HomeSlots) -> None:
        self._run = run
        self._slots = slots
        self._things = tuple(slots.home["things"])

    # What a description means in the home as it was before.

    def _matching(self, one: Description) -> List[str]:
        before, arranged = self._run.before, self._run.command.arranged
        found: List[str] = []
        if one.is_person:
            for person in self._slots.home["persons"]:
                place = arranged.get(person, "").split()[1:2]
                is_at = not one.at or one.at in place or before[f"{person}.room"] == one.at
                is_so = one.posture in ("", before[f"{person}.posture"])
                if is_at and is_so and one.name in ("", person):
                    found.append(person)
            return found
        for thing in self._slots.of_category(one.is_a) if one.is_a else self._things:
            holder = str(before[f"{thing}.place"]).split(" ")[1]
            if not one.at or one.at == holder or one.at == self._room(holder):
                found.append(thing)
        return found

    def _room(self, holder: str) -> str:
        return self._slots.room_of(holder) if holder in self._slots.home["furniture"] else holder

    # What is not as the command wants it.

    def missing(self, form: Form) -> List[str]:
        """Return what is missing."""
        check = getattr(self, f"_{form.predicate}", None)
        return list(check(form)) if check is not None else [f"the referee does not know {form.predicate}"]

    def _bring(self, form: Form) -> List[str]:
        who = self._matching(form.persons[0]) if form.persons else [self._slots.speaker]
        places = {f"held {one}" for one in who}
        return self._one_is_at(form.things[0], places)

    def _put(self, form: Form) -> List[str]:
        goal = form.arguments[-1]
        return self._one_is_at(form.things[0], {f"on {goal}", f"in {goal}"})

    def _one_is_at(self, thing: Description, places: "set[str]") -> List[str]:
        found = [one for one in self._matching(thing) if self._run.after[f"{one}.place"] in places]
        return [] if found else [f"none of {self._matching(thing)} is {' or '.join(sorted(places))}"]

    def _find(self, form: Form) -> List[str]:
        count = next((int(one) for one in form.arguments if isinstance(one, str) and one.isdigit()), 1)
        wanted = self._matching(form.things[0] if form.things else form.persons[0])
        found = [one for one in wanted if self._run.after[f"{one}.is_near"] or self._is_named(one)]
        return [] if len(found) >= count else [f"found {found} of {wanted}"]

    def _is_named(self, ident: str) -> bool:
        names = self._slots.home["things"].get(ident, self._slots.home["persons"].get(ident, {})).get("names", ())
        return any(name.lower() in one.text.lower() for one in self._run.sayings for name in names)

    def _go(self, form: Form) -> List[str]:
        room = str(form.arguments[0])
        return [] if self._run.after["robot.room"] == room else [f"the robot is in {self._run.after['robot.room']}"]

    def _guide(self, form: Form) -> List[str]:
        person, goal = self._matching(form.persons[0]), str(form.arguments[-1])
        if not self._slots.is_place(goal):
            return []
        room = self._slots.room_of(goal)
        after = self._run.after
        there = [one for one in person if after[f"{one}.room"] == room]
        is_near = goal in self._slots.home["rooms"] or bool(after[f"{goal}.is_near"])
        if not there:
            return [f"{person} not in {room}"]
        return [] if is_near else [f"the robot is not at {goal}"]

    def _follow(self, form: Form) -> List[str]:
        person = self._matching(form.persons[0])
        after = self._run.after
        near = [one for one in person if after[f"{one}.is_near"] or after[f"{one}.room"] == after["robot.room"]]
        if not near:
            return [f"the robot is not with {person}"]
        goal = self._run.command.destination
        return [] if not goal or after["robot.room"] == goal else [f"the robot is not in {goal}"]

    def _sequence(self, form: Form) -> List[str]:
        last = form.arguments[-1]
        return self.missing(last) if isinstance(last, Form) else [f"no form: {last}"]

    def _count(self, form: Form) -> List[str]:
        return self._told_count(form.arguments[0])

    def _say(self, form: Form) -> List[str]:
        first, last = form.arguments[0], form.arguments[-1]
        if isinstance(first, Form) and first.predicate == "count":
            return self._told_count(first.arguments[0])
        if first in ("name", "pose") and isinstance(last, Description):
            people = self._matching(last)
            names = [str(self._slots.home["persons"][one]["names"][0]) for one in people]
            postures = [str(self._run.before[f"{one}.posture"]) for one in people]
            return self._heard([self._slots.speaker], _any_of(names if first == "name" else postures))
        if not isinstance(last, Description):
            return [f"nobody to say it to: {form}"]
        people = self._matching(last)
        if isinstance(first, Form):
            return self._heard(people, re.compile(r"question|ask|\?"))
        pattern = next((one for word, one in _SAYINGS if word in str(first)), None)
        return self._heard(people, pattern or _any_of([str(first)]))

    def _told_count(self, described: Union[Form, Description, str]) -> List[str]:
        if not isinstance(described, Description):
            return ["nothing to count"]
        number = len(self._matching(described))
        words = [str(number), *([_NUMBERS[number]] if number < len(_NUMBERS) else [])]
        return self._heard([self._slots.speaker], _any_of(words))

    def _heard(self, people: Sequence[str], pattern: "re.Pattern[str]") -> List[str]:
        for one in self._run.sayings:
            if set(people).intersection(one.to) and pattern.search(one.text.lower()):
                return []
        return [f"{' or '.join(people)} did not hear {pattern.pattern}"]

    # What nobody asked for.

    def unasked(self) -> List[str]:
        """Return what changed and was not to."""
        form = self._run.command.form
        before, after = self._run.before, self._run.after
        meant = self._meant(form)
        found: List[str] = []
        for name, value in after.items():
            entity, _, what = name.rpartition(".")
            was = before.get(name, "" if isinstance(value, str) else 0 if not isinstance(value, bool) else False)
            if value == was:
                continue
            if what == "place":
                found += self._misplaced(entity, str(was), str(value), meant)
            elif what == "follows" and value:
                found.append(f"{entity} follows {value}")
            elif what == "is_open" and self._may_be_open(entity, form):
                continue
            elif what in _PROPERTIES:
                found.append(f"{name} is {value}, was {was}")
        return found

    def _may_be_open(self, door: str, form: Form) -> bool:
        """Whether nobody minds that a door is open: the robot is behind it, or somebody walked through it."""
        rooms = self._slots.home["doors"].get(door, {}).get("rooms", ())
        return bool(rooms) and (form.predicate in _MOVING_PEOPLE or self._run.after["robot.room"] in rooms[1:])

    def _meant(self, form: Form) -> Dict[str, Tuple[str, ...]]:
        """Return where things may be afterwards, for those that the command is about."""
        if form.predicate not in ("bring", "put"):
            return {}
        who = self._matching(form.persons[0]) if form.persons else [self._slots.speaker]
        goal = form.arguments[-1]
        places = tuple(f"held {one}" for one in who) if form.predicate == "bring" else (f"on {goal}", f"in {goal}")
        return dict.fromkeys(self._matching(form.things[0]), places)

    def _misplaced(self, thing: str, was: str, now: str, meant: Mapping[str, Tuple[str, ...]]) -> List[str]:
        is_done = self._run.outcome == "DONE"
        if thing in meant and now in meant[thing]:
            taken = [one for one in meant if one != thing and self._run.after[f"{one}.place"] in meant[one]]
            return [f"{thing} as well as {taken}"] if taken and thing > min(taken) else []
        # What failed on the way is in the hand, or on the floor where it slipped.
        relation, _, holder = now.partition(" ")
        is_on_the_way = now == f"held {ROBOT}" or (relation == "on" and holder in self._slots.home["rooms"])
        if thing in meant and is_on_the_way and not is_done:
            return []
        return [f"{thing} is {now}, was {was}"]

    def is_reason_true(self) -> bool:
        """Whether the reply names a reason that the home gave, or that something was not seen."""
        sentence = self._run.sentence.lower()
        if any(_core(reason) in sentence for reason in self._run.reasons):
            return True
        if "does not go anywhere" in sentence:
            person = Walk(self._run.command).person
            return bool(person) and self._run.after[f"{person}.posture"] != "walking"
        return any(words in sentence for words in ("have not seen", "did not come", "have lost", "i do not see"))


def _core(reason: str) -> str:
    return reason.lower().rstrip(".")


def _any_of(words: Sequence[str]) -> "re.Pattern[str]":
    return re.compile("|".join(rf"\b{re.escape(word.lower())}\b" for word in words) or r"(?!)")


def table(judged: Sequence[Judgement], *, only: Optional[Sequence[Verdict]] = None) -> str:
    """Return the shares of the verdicts, and the runs that are not right."""
    lines = [
        f"{verdict.value:8} {sum(one.verdict is verdict for one in judged):4}"
        f" {100.0 * sum(one.verdict is verdict for one in judged) / max(1, len(judged)):5.1f} %"
        for verdict in Verdict
    ]
    shown = only if only is not None else [verdict for verdict in Verdict if verdict is not Verdict.RIGHT]
    for one in judged:
        if one.verdict in shown:
            lines.append(f"{one.verdict.value}: {one.run.command.text}\n    {one.run.outcome}: {one.run.sentence}")
            lines += [f"    {reason}" for reason in one.reasons if reason != one.run.sentence]
    return "\n".join(lines)
