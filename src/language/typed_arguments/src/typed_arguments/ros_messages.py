"""Converts typed arguments to messages and back."""

import math
from dataclasses import fields, replace
from typing import Dict, List, Optional, Sequence, Tuple, Union

import genpy
from roboframenet_msgs import msg

from typed_arguments.argument import (
    MOST_PHRASES,
    EmbeddedFrame,
    Measure,
    Modifier,
    Source,
    TimeExpression,
    TypedArgument,
)
from typed_arguments.filled_frame import FilledFrame

#: Attributes of a phrase that equal fields of the message: strings, flags and numbers that are never None.
_SAME = tuple(
    field.name for field in fields(TypedArgument) if type(field.default) in (str, bool, int) and field.name != "name"
)


class SharedArguments:
    """The typed arguments of a node of a plan: its candidates share them, and refer to them by position.

    Attributes:
        messages: the arguments, each once
    """

    #: Position of an argument that has only its text.
    ONLY_TEXT = -1

    def __init__(self) -> None:
        self.messages: List[msg.TypedArgument] = []
        self._positions: Dict[TypedArgument, int] = {}

    def positions(self, frames: Sequence[FilledFrame]) -> List[int]:
        """Add the arguments of some frames, and return the position of each; nothing when all have only text."""
        found = [self._position(argument) for frame in frames for argument in frame.arguments]
        return found if any(position != self.ONLY_TEXT for position in found) else []

    def _position(self, argument: TypedArgument) -> int:
        # The same words may fill elements of different names, as "goal" of one frame and "location" of another.
        nameless = replace(argument, name="")
        if nameless == TypedArgument(text=argument.text):
            return self.ONLY_TEXT
        if nameless not in self._positions:
            self._positions[nameless] = len(self.messages)
            self.messages.append(to_message(argument))
        return self._positions[nameless]


def frame_to_message(frame: FilledFrame) -> msg.FilledSemanticFrame:
    """Return a frame as the message of 2012, which has the texts of its arguments."""
    return msg.FilledSemanticFrame(
        name=frame.name,
        action_server_topics=[frame.server] if frame.server else [],
        frame_elements=[
            msg.FilledFrameElement(name=argument.name, argument=argument.text) for argument in frame.arguments
        ],
    )


def frame_that_was_tried(message: msg.TriedFrame) -> FilledFrame:
    """Return the frame of a message of the executor, with its typed arguments and its server.

    Raises:
        ValueError: an argument is malformed
    """
    arguments = tuple(from_message(argument) for argument in message.arguments)
    return FilledFrame(message.frame.name, arguments, next(iter(message.frame.action_server_topics), ""))


def frames_from_messages(
    frames: Sequence[msg.FilledSemanticFrame], shared: Sequence[TypedArgument], positions: Sequence[int]
) -> Tuple[FilledFrame, ...]:
    """Return frames with their typed arguments.

    Args:
        frames: as in 2012; each names one action server
        shared: typed arguments of the node
        positions: for each element of each frame, the position in `shared`, or -1; empty when all have only text
    Raises:
        ValueError: the positions or the texts do not fit the frames, or a frame does not name exactly one server
    """
    count = sum(len(frame.frame_elements) for frame in frames)
    if positions and len(positions) != count:
        raise ValueError(f"{len(positions)} positions of arguments stand for {count} elements")
    left = iter(positions or [SharedArguments.ONLY_TEXT] * count)
    found = []
    for frame in frames:
        servers = list(frame.action_server_topics)
        if len(servers) != 1:
            raise ValueError(f"frame {frame.name!r} must name exactly one action server, got {servers}")
        arguments = tuple(
            _shared_argument(element, shared, position) for element, position in zip(frame.frame_elements, left)
        )
        found.append(FilledFrame(name=frame.name, arguments=arguments, server=servers[0]))
    return tuple(found)


def _shared_argument(element: msg.FilledFrameElement, shared: Sequence[TypedArgument], position: int) -> TypedArgument:
    if position == SharedArguments.ONLY_TEXT:
        return TypedArgument(name=element.name, text=element.argument)
    if not 0 <= position < len(shared):
        raise ValueError(f"the element {element.name!r} refers to argument {position} of {len(shared)}")
    argument = shared[position]
    if argument.text != element.argument:
        raise ValueError(f"{element.name!r} is {element.argument!r}, but its typed argument is {argument.text!r}")
    return argument if argument.name == element.name else replace(argument, name=element.name)


def to_message(argument: TypedArgument) -> msg.TypedArgument:
    """Convert a value to a message."""
    phrases: List[msg.Phrase] = []
    _add_phrase(argument, phrases)
    return msg.TypedArgument(name=argument.name, phrases=phrases)


def from_message(message: msg.TypedArgument) -> TypedArgument:
    """Convert a message to a value.

    Raises:
        ValueError: the phrases are not an argument with its parts, or one of them is malformed; the message is the
            reason
    """
    phrases = message.phrases
    if not 1 <= len(phrases) <= MOST_PHRASES:
        raise ValueError(f"an argument has 1 to {MOST_PHRASES} phrases, got {len(phrases)}")
    values: Dict[int, TypedArgument] = {}
    # Parts follow the phrase that they belong to. Going backwards, the parts of each phrase are known before it.
    for position in range(len(phrases) - 1, -1, -1):
        try:
            values[position] = _from_phrase(message.name if position == 0 else "", phrases[position], position, values)
        except ValueError as error:
            raise ValueError(f"phrase {position} of the argument {message.name!r} is wrong: {error}") from error
    if len(values) > 1:
        raise ValueError(f"phrases {sorted(values)[1:]} of the argument {message.name!r} are parts of nothing")
    return values[0]


def _add_phrase(argument: TypedArgument, phrases: List[msg.Phrase]) -> int:
    """Append a phrase and its parts; returns the position of the phrase."""
    position = len(phrases)
    phrase = msg.Phrase()
    phrases.append(phrase)
    for field in _SAME:
        setattr(phrase, field, getattr(argument, field))
    phrase.source = int(argument.source)
    phrase.positions = list(argument.positions)
    phrase.referents = list(argument.referents)
    phrase.count = -1 if argument.count is None else argument.count
    if argument.measure is not None:
        phrase.measure = _measure_to_message(argument.measure)
    if argument.time is not None:
        phrase.time = time_to_message(argument.time)
    phrase.modifiers = [
        msg.Modifier(**{field: getattr(modifier, field) for field in msg.Modifier.__slots__})
        for modifier in argument.modifiers
    ]
    phrase.possessor = 0 if argument.possessor is None else _add_phrase(argument.possessor, phrases)
    phrase.complement = 0 if argument.complement is None else _add_phrase(argument.complement, phrases)
    phrase.members = [_add_phrase(part, phrases) for part in argument.members]
    phrase.exceptions = [_add_phrase(part, phrases) for part in argument.exceptions]
    phrase.frames = [
        msg.EmbeddedFrame(
            role=frame.role,
            frame_name=frame.frame_name,
            words=frame.words,
            positions=list(frame.positions),
            head_element=frame.head_element,
            mood=frame.mood,
            is_negated=frame.is_negated,
            element_names=[element.name for element in frame.frame_elements],
            element_phrases=[_add_phrase(element, phrases) for element in frame.frame_elements],
        )
        for frame in argument.frames
    ]
    return position


def _from_phrase(name: str, phrase: msg.Phrase, position: int, values: Dict[int, TypedArgument]) -> TypedArgument:
    """Make a value of a phrase, and take its parts out of `values`; raises ValueError."""

    def part(at: int) -> TypedArgument:
        if at not in values:
            raise ValueError(f"phrase {at} is missing, does not follow it, or is a part of something else")
        return values.pop(at)

    def frame(message: msg.EmbeddedFrame) -> EmbeddedFrame:
        if len(message.element_names) != len(message.element_phrases):
            raise ValueError("an embedded frame has not as many phrases as elements")
        return EmbeddedFrame(
            role=message.role,
            frame_name=message.frame_name,
            words=message.words,
            positions=tuple(message.positions),
            head_element=message.head_element,
            mood=message.mood,
            is_negated=bool(message.is_negated),
            frame_elements=tuple(
                replace(part(at), name=element) for element, at in zip(message.element_names, message.element_phrases)
            ),
        )

    if phrase.count < -1:
        raise ValueError(f"the count {phrase.count} is less than -1")
    return TypedArgument(
        name=name,
        source=Source(phrase.source),
        positions=tuple(phrase.positions),
        count=None if phrase.count == -1 else phrase.count,
        measure=_measure_from_message(phrase.measure) if phrase.measure.kind else None,
        time=time_from_message(phrase.time) if phrase.time.kind else None,
        modifiers=tuple(
            Modifier(**{field: getattr(modifier, field) for field in msg.Modifier.__slots__})
            for modifier in phrase.modifiers
        ),
        possessor=part(phrase.possessor) if phrase.possessor else None,
        complement=part(phrase.complement) if phrase.complement else None,
        members=tuple(part(at) for at in phrase.members),
        exceptions=tuple(part(at) for at in phrase.exceptions),
        frames=tuple(frame(message) for message in phrase.frames),
        referents=tuple(phrase.referents),
        **{field: getattr(phrase, field) for field in _SAME},
    )


def _measure_to_message(measure: Measure) -> msg.Measure:
    return msg.Measure(
        kind=measure.kind,
        words=measure.words,
        amount=math.nan if measure.amount is None else measure.amount,
        unit=measure.unit,
        si=math.nan if measure.si is None else measure.si,
        bound=measure.bound,
        change=measure.change,
        is_assumed=measure.is_assumed,
    )


def _measure_from_message(message: msg.Measure) -> Measure:
    return Measure(
        kind=message.kind,
        words=message.words,
        amount=None if math.isnan(message.amount) else message.amount,
        unit=message.unit,
        si=None if math.isnan(message.si) else message.si,
        bound=message.bound,
        change=message.change,
        is_assumed=message.is_assumed,
    )


def time_to_message(time: TimeExpression) -> msg.TimeExpression:
    """Turn a value into a message."""
    return msg.TimeExpression(
        kind=time.kind,
        words=time.words,
        relation=time.relation,
        value=time.value,
        time_zone=time.time_zone,
        begin=genpy.Time.from_sec(time.begin_s or 0.0),
        end=genpy.Time.from_sec(time.end_s or 0.0),
        offset=genpy.Duration.from_sec(time.offset_s or 0.0),
        length=genpy.Duration.from_sec(time.length_s or 0.0),
        period=genpy.Duration.from_sec(time.period_s or 0.0),
    )


def time_from_message(message: msg.TimeExpression) -> TimeExpression:
    """Turn a message into a value.

    Raises:
        ValueError: the time is impossible
    """
    return TimeExpression(
        kind=message.kind,
        words=message.words,
        relation=message.relation,
        value=message.value,
        time_zone=message.time_zone,
        begin_s=_seconds(message.begin),
        end_s=_seconds(message.end),
        offset_s=_seconds(message.offset),
        length_s=_seconds(message.length),
        period_s=_seconds(message.period),
    )


def _seconds(time: Union[genpy.Time, genpy.Duration]) -> Optional[float]:
    """Return seconds; None for zero, which means no time."""
    return None if time.is_zero() else time.to_sec()
