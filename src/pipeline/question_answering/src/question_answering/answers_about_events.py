"""Answers questions about deeds with elements: whether, when, where, why, how often, who, or which element.

The question holds the frame that is asked about. It is compared with what was tried, what runs, what is planned, and
what can be done now. What none of these tells is not known, and the answer says so.
"""

from dataclasses import replace
from datetime import datetime, timedelta
from typing import Callable, Dict, FrozenSet, List, Optional, Sequence, Tuple

from question_answering.answers_about_deeds import reason
from question_answering.deed_log import PlannedNode, TriedClause
from question_answering.robot_knowledge import RobotKnowledge
from question_answering.wording import MOST_NAMED, Arguments, day_and_time, full_name
from referring_expressions import fitting
from referring_expressions.deeds import filled, is_about
from referring_expressions.describing import noun_of
from roboframenet_ros.spoken_text import join_with_and, with_capital
from semantic_types import Fit, shipped_types
from typed_arguments import EmbeddedFrame, FilledFrame, TypedArgument
from word_classes import word_class
from world_model import WorldObject
from world_model.world_object import ROBOT_ID

QUESTION_OF_EVENT = "question_of_event"
_ROBOT, _WHO = "robot", "who"
_RUNNING, _PLANNED, _ABLE = "running", "planned", "able"
_WHETHER, _WHEN, _WHY, _HOW_OFTEN, _HOW_LONG, _WHERE = "whether", "when", "why", "how_often", "how_long", "where"
_ANY = word_class("indefinite_articles")
#: Types that say nothing of what can be carried, opened or switched on.
_ANY_THING = frozenset(["Physical_entity", "Physical_object"])
_QUESTION_WORDS = word_class("question_words")
_TIMES = ("never", "once", "twice")
_HOUR_OF_NOON, _HOUR_OF_EVENING = 12, 18


def event(arguments: Arguments, known: RobotKnowledge) -> str:
    """Answer a question about a deed."""
    (asked,) = arguments["deed"].frames
    about = _About(asked, arguments, known)
    aspect = arguments["aspect"].text
    if aspect == _ABLE:
        return about.able()
    if aspect == _RUNNING:
        return about.running()
    if aspect == _PLANNED:
        return about.planned()
    return about.done()


def was_done(deed: TypedArgument, known: RobotKnowledge) -> bool:
    """Whether the robot has done a deed, as far as it remembers."""
    (asked,) = deed.frames
    return _About(asked, {"deed": deed, "asks": TypedArgument("asks", _WHETHER)}, known).is_done()


class _About:
    """What is known about the frame of a question."""

    def __init__(self, asked: EmbeddedFrame, arguments: Arguments, known: RobotKnowledge) -> None:
        self._asked = asked
        self._words = arguments["deed"].text
        self._deed = arguments["deed"]
        self._asks = arguments["asks"].text
        self._agent = arguments.get("agent")
        self._time = arguments.get("time")
        self._known = known
        #: The element that is asked for: "which lamps"; None if none is.
        self._wanted = next((one for one in asked.frame_elements if one.is_asked), None)

    # --- what was done

    def is_done(self) -> bool:
        """Whether the log has it."""
        return any(self._fits(one) and self._is_done(one) for one in self._known.tried)

    def done(self) -> str:
        """Answer from the log of deeds."""
        period = _period(self._time, self._known.now)
        if period is None:
            assert self._time is not None
            return f'I do not know which time you mean by "{self._time.text}".'
        tried = [one for one in self._known.tried if self._fits(one)]
        within = [one for one in tried if period[0] <= one.ended <= period[1]]
        found = [one for one in within if self._is_done(one)]
        if not self._is_of_robot():
            return self._by_others(found)
        if self._asks == _WHY:
            return self._why(found, within)
        if found:
            return self._of_found(found)
        return self._not_done(within)

    def _of_found(self, found: Sequence[TriedClause]) -> str:
        last = found[-1]
        when = day_and_time(last.ended, self._known.now)
        if self._asks == _WHEN:
            more = f" I did so {_times(len(found))} in all." if len(found) > 1 else ""
            return f"{'Last, ' + when if len(found) > 1 else with_capital(when)}.{more}"
        if self._asks == _HOW_OFTEN:
            return f"{with_capital(_times(len(found)))}."
        if self._asks == _HOW_LONG:
            return f"It took me {_duration(sum(one.took_s for one in last.tried))}, {when}."
        if self._asks == _WHERE:
            return f'I carried out "{last.text}" {when}, and do not remember where.'
        if self._asks == _WHO:
            return f"I did, {when}."
        if self._asks == _WHETHER:
            answer = "No, I did" if self._asked.is_negated else "Yes"
            return f'{answer}: I carried out "{last.text}" {when}.'
        return self._fillers(found)

    def _fillers(self, found: Sequence[TriedClause]) -> str:
        """Name what filled the element that is asked for."""
        names: List[str] = []
        for clause in found:
            for argument in filled([one.frame for one in clause.done], self._asks):
                names += self._names(argument)
        names = list(dict.fromkeys(names))
        if not names:
            return f'I carried out "{found[-1].text}", and do not remember that.'
        if self._wanted is not None and self._wanted.quantifier == "how_many":
            return f"{len(names)}: {join_with_and(names[:MOST_NAMED])}."
        return f"{with_capital(join_with_and(names[:MOST_NAMED]))}."

    def _names(self, argument: TypedArgument) -> List[str]:
        objects = self._known.situation.objects(argument.referents)
        if objects:
            where = f"{argument.relation.replace('_', ' ')} " if argument.relation else ""
            return [f"{where}{full_name(one)}" for one in objects]
        return [argument.words or argument.text]

    def _not_done(self, tried: Sequence[TriedClause]) -> str:
        if tried:
            last = tried[-1]
            why = next((one.reason for one in reversed(last.tried) if one.reason), "it was not finished")
            return f'No. I tried "{last.text}" {day_and_time(last.ended, self._known.now)}: {why}.'
        if self._asks == _HOW_OFTEN:
            return "Never, as far as I remember."
        if any(self._is_planned(one) for one in self._known.running):
            return f'Not yet: I am carrying out "{self._known.doing}".'
        nothing = {_WHETHER: "No", _WHO: "I did not do that, and do not know who did"}.get(
            self._asks, "I did not do that"
        )
        return f"{nothing}, as far as I remember."

    def _why(self, found: Sequence[TriedClause], tried: Sequence[TriedClause]) -> str:
        if found and self._asked.is_negated:
            return f'I did: I carried out "{found[-1].text}" {day_and_time(found[-1].ended, self._known.now)}.'
        if found:
            return f'Because you asked me to: "{found[-1].text}".'
        if tried:
            return self._not_done(tried)
        if any(self._is_planned(one) for one in (*self._known.running, *self._known.planned)):
            return f'I am carrying out "{self._known.doing}", because you asked me to.'
        told = reason({"deed": replace(self._deed, frames=())}, self._known)
        if self._asked.is_negated and told.startswith("I do not remember"):
            return "Nobody has asked me to, as far as I remember."
        return told

    def _by_others(self, found: Sequence[TriedClause]) -> str:
        agent = self._agent.text if self._agent is not None else _WHO
        if agent == _WHO and found:
            return self._of_found(found)
        if agent == _WHO:
            return "I did not do that, and do not know who did." if self._asks in (_WHO, _WHETHER) else "I do not know."
        return "I do not know: I only remember what I did myself."

    # --- what runs, and what comes

    def running(self) -> str:
        """Answer from the plans of what runs."""
        if not self._is_of_robot():
            return "I do not know."
        found = [one for one in self._known.running if self._is_planned(one)]
        if found and self._asks == _WHY:
            return f'Because you asked me to: "{self._known.doing}".'
        if found and self._asks == _WHETHER:
            return f'Yes, I am carrying out "{self._known.doing}".'
        if found:
            return self._of_planned(found)
        doing = f'I am carrying out "{self._known.doing}"' if self._known.doing else "I am doing nothing at the moment"
        return f"No, {doing}." if self._asks == _WHETHER else f"I am not doing that: {doing}."

    def planned(self) -> str:
        """Answer from what comes after what runs."""
        found = [one for one in self._known.planned if self._is_planned(one)]
        if any(self._is_planned(one) for one in self._known.running):
            return f'I am doing it now: "{self._known.doing}".'
        if found and self._asks == _WHEN:
            return f'After what I am doing now, as a part of "{self._known.doing}".'
        if found:
            return f'Yes, as a part of "{self._known.doing}".' if self._asks == _WHETHER else self._of_planned(found)
        return "No, nobody has asked me to." if self._asks == _WHETHER else "I have no such plan."

    def _of_planned(self, found: Sequence[PlannedNode]) -> str:
        filled = [one.find(self._asks) for node in found for one in node.frames[:1]]
        names = [name for one in filled if one is not None for name in self._names(one)]
        if not names:
            return f'I am carrying out "{self._known.doing}", and cannot tell more.'
        return f"{with_capital(join_with_and(list(dict.fromkeys(names))[:MOST_NAMED]))}."

    def _is_planned(self, node: PlannedNode) -> bool:
        return self._is_about(node.frames)

    # --- what can be done

    def able(self) -> str:
        """Answer from the registrations: whether somebody serves the frame, and what fits its elements."""
        if not self._is_of_robot():
            return "I only know what I can do myself."
        if self._asked.frame_name not in self._known.served:
            return "No: nothing that runs here can do that."
        if self._wanted is None:
            return f"Yes, I can {_without_generic(self._words)}."
        found = self._objects_for(self._wanted)
        if found is None:
            return f"Yes, I can {self._words} things, but I cannot tell which are too heavy or too large."
        if not found:
            return "I know of nothing like that at the moment."
        named = [full_name(one) for one in found[:MOST_NAMED]]
        more = f", and {len(found) - MOST_NAMED} more" if len(found) > MOST_NAMED else ""
        return f"As far as I know: {join_with_and(named)}{more}."

    def _objects_for(self, phrase: TypedArgument) -> Optional[Tuple[WorldObject, ...]]:
        """Return the objects that may fill the element that is asked for: of its types, and as the question has it.

        None where any thing may: whether it is too heavy stands in no type.
        """
        frame = self._known.frames.get(self._asked.frame_name)
        element = frame.element(phrase.name) if frame is not None else None
        objects = tuple(one for one in self._known.world.objects if one.id != ROBOT_ID)
        is_kind = phrase.head.lower() != phrase.quantifier and phrase.lemma not in _QUESTION_WORDS
        if is_kind:
            objects = fitting(replace(phrase, quantifier=""), self._known.situation, is_wide=True)
        types = element.semantic_types if element is not None else ()
        if not types or _ANY_THING.intersection(types):
            return None
        return tuple(one for one in objects if shipped_types().of_noun([noun_of(one)]).fit(types) is Fit.LIKELY)

    # --- what is the same

    def _is_of_robot(self) -> bool:
        return self._agent is None or self._agent.text == _ROBOT

    def _fits(self, clause: TriedClause) -> bool:
        return self._is_about([one.frame for one in clause.tried])

    def _is_done(self, clause: TriedClause) -> bool:
        return self._is_about([one.frame for one in clause.done])

    def _is_about(self, frames: Sequence[FilledFrame]) -> bool:
        return is_about(frames, self._asked, self._known.frames, self._ids)

    def _ids(self, phrase: TypedArgument) -> FrozenSet[str]:
        return frozenset(one.id for one in fitting(phrase, self._known.situation, is_wide=True))


def _without_generic(words: str) -> str:
    """Return the words of an ability without what only asks: "close any doors"."""
    return " ".join(word for word in words.split() if word.lower() not in _ANY)


def _period(time: Optional[TypedArgument], now: datetime) -> Optional[Tuple[datetime, datetime]]:
    """Return the begin and the end of the time that a question names; None if it is not understood."""
    if time is None:
        return datetime.min, datetime.max
    if time.time is not None and time.time.begin_s and time.time.end_s:
        return datetime.fromtimestamp(time.time.begin_s), datetime.fromtimestamp(time.time.end_s)
    if time.time is not None and time.time.length_s:
        return now - timedelta(seconds=time.time.length_s), now
    midnight = now.replace(hour=0, minute=0, second=0, microsecond=0)
    noon, evening = midnight.replace(hour=_HOUR_OF_NOON), midnight.replace(hour=_HOUR_OF_EVENING)
    tomorrow = midnight + timedelta(days=1)
    periods: Dict[str, Tuple[datetime, datetime]] = {
        "today": (midnight, tomorrow),
        "yesterday": (midnight - timedelta(days=1), midnight),
        "this morning": (midnight, noon),
        "this afternoon": (noon, evening),
        "this evening": (evening, tomorrow),
        "tonight": (evening, tomorrow),
    }
    return periods.get(time.text.lower())


def _times(count: int) -> str:
    return _TIMES[count] if count < len(_TIMES) else f"{count} times"


def _duration(seconds: float) -> str:
    if seconds < 90:
        return f"{max(1, round(seconds))} second{'' if round(seconds) == 1 else 's'}"
    return f"{round(seconds / 60)} minutes"


ABOUT_EVENTS: Dict[str, Callable[[Arguments, RobotKnowledge], str]] = {QUESTION_OF_EVENT: event}
