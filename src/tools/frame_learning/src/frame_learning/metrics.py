"""Figures for the understanding of commands, as in the literature on HuRIC."""

from collections import Counter
from dataclasses import dataclass
from typing import Counter as CounterType
from typing import Dict, FrozenSet, Iterable, List, Mapping, Optional, Sequence, Tuple, TypeVar

from frame_learning.annotated_commands import AnnotatedCommand, AnnotatedFrame
from frame_learning.argument_convention import Argument, annotated_arguments

#: Stands for a missing frame in a row or column of the confusion.
NOTHING = "(none)"


@dataclass(frozen=True)
class Answer:
    """The result of the system for a command, in the names and positions of the corpus.

    Attributes:
        frames: recognised frames, even if the reply refuses or asks
        is_answered: whether the command would be carried out
        milliseconds: time to understand the command
        arguments: as the corpus writes them; None if the mapping does not say how it does
    """

    frames: Tuple[AnnotatedFrame, ...]
    is_answered: bool
    milliseconds: float
    arguments: Optional[Tuple[Argument, ...]] = None


@dataclass(frozen=True)
class Count:
    """Right, predicted and annotated items."""

    right: int = 0
    predicted: int = 0
    annotated: int = 0

    def plus(self, right: int, predicted: int, annotated: int) -> "Count":
        """Return the sum of two counts."""
        return Count(self.right + right, self.predicted + predicted, self.annotated + annotated)

    @property
    def f1(self) -> float:
        """F1 in percent; 0 if nothing was predicted and nothing was annotated."""
        total = self.predicted + self.annotated
        return 200.0 * self.right / total if total else 0.0


@dataclass(frozen=True)
class FrameRow:
    """A frame of the corpus: its counts, and the frames that it was taken for."""

    frame: Count
    exact: Count
    head: Count
    taken_for: Mapping[str, int]


@dataclass(frozen=True)
class Score:
    """Figures over the commands of a corpus; all but the first and the last three are percentages.

    Attributes:
        commands: number of commands
        fp: frame prediction, micro-F1 over (command, frame)
        aic_exact: argument identification and classification, micro-F1 over (frame, element, span)
        aic_head: the same over (frame, element, head word)
        em: exact match, share of commands with all frames, elements and spans right, and no others
        coverage: share of commands that are answered, that is, would be carried out
        precision_answered: over the answered commands, share of the recognised frames that are right: the precision
            that goes into ``fp``
        right_answered: share of the answered commands with all frames right and no other
        right_answered_heads: share of the answered commands with all frames and all head words right and no others
        ms_per_command: mean time to parse and understand a command
        per_frame: figures of each frame, by its name in the corpus
        arguments: arguments in the convention of the corpus; right when task, trigger text, type and text are equal;
            None if the mapping does not say how the corpus writes them
    """

    commands: int
    fp: float
    aic_exact: float
    aic_head: float
    em: float
    coverage: float
    precision_answered: float
    right_answered: float
    right_answered_heads: float
    ms_per_command: float
    per_frame: Mapping[str, FrameRow]
    arguments: Optional[Count] = None


Element = Tuple[str, str, object]
Counted = TypeVar("Counted")


def score(pairs: Iterable[Tuple[AnnotatedCommand, Answer]]) -> Score:
    """Compare answers with the annotation.

    A frame or element that occurs twice in a command counts twice. If an element has no annotated head, the head of the
    answer is right when it is one of its words.
    """
    frame_count = exact_count = head_count = answered_count = argument_count = Count()
    are_arguments_written = False
    commands = exact_commands = answered = answered_frames = answered_heads = 0
    milliseconds = 0.0
    rows: Dict[str, FrameRow] = {}
    for command, answer in pairs:
        commands += 1
        milliseconds += answer.milliseconds
        frames = _compare(_frames(command.frames), _frames(answer.frames))
        exact = _compare(_spans(command.frames), _spans(answer.frames))
        annotated_heads, answered_head = _heads(command.frames, answer.frames)
        heads = _compare(annotated_heads, answered_head)
        frame_count = frame_count.plus(*frames)
        exact_count = exact_count.plus(*exact)
        head_count = head_count.plus(*heads)
        exact_commands += _is_all(frames) and _is_all(exact)
        if answer.arguments is not None:
            are_arguments_written = True
            written = _compare(Counter(annotated_arguments(command)), Counter(answer.arguments))
            argument_count = argument_count.plus(*written)
        answered += answer.is_answered
        answered_count = answered_count.plus(*frames) if answer.is_answered else answered_count
        answered_frames += answer.is_answered and _is_all(frames)
        answered_heads += answer.is_answered and _is_all(frames) and _is_all(heads)
        _add_rows(rows, command.frames, answer.frames)
    return Score(
        commands=commands,
        fp=frame_count.f1,
        aic_exact=exact_count.f1,
        aic_head=head_count.f1,
        em=_percent(exact_commands, commands),
        coverage=_percent(answered, commands),
        precision_answered=_percent(answered_count.right, answered_count.predicted),
        right_answered=_percent(answered_frames, answered),
        right_answered_heads=_percent(answered_heads, answered),
        ms_per_command=milliseconds / commands if commands else 0.0,
        per_frame=dict(sorted(rows.items())),
        arguments=argument_count if are_arguments_written else None,
    )


def is_exact(command: AnnotatedCommand, answer: Answer) -> bool:
    """Whether a whole command is right: its frames, elements and spans, and no others."""
    return _frames(command.frames) == _frames(answer.frames) and _spans(command.frames) == _spans(answer.frames)


def are_attached_alike(command: AnnotatedCommand, answer: Answer) -> bool:
    """Whether the same words are divided among the elements as in the annotation, whatever frames and elements are
    called: "the book on the table" and "in the kitchen", or "the book" and "on the table in the kitchen". True, too, if
    the elements hold other words in all: then more than an attachment is wrong.
    """
    wanted, given = _divided(command.frames), _divided(answer.frames)
    return wanted == given or frozenset().union(*wanted) != frozenset().union(*given)


def _divided(frames: Sequence[AnnotatedFrame]) -> FrozenSet[FrozenSet[int]]:
    verbs = frozenset(position for frame in frames for position in frame.lexical_unit)
    return frozenset(element.tokens - verbs for frame in frames for element in frame.elements)


def _percent(part: int, whole: int) -> float:
    return 100.0 * part / whole if whole else 0.0


def _compare(annotated: CounterType[Counted], answered: CounterType[Counted]) -> Tuple[int, int, int]:
    return sum((annotated & answered).values()), sum(answered.values()), sum(annotated.values())


def _is_all(counts: Tuple[int, int, int]) -> bool:
    return counts[0] == counts[1] == counts[2]


def _frames(frames: Sequence[AnnotatedFrame]) -> CounterType[str]:
    return Counter(frame.name for frame in frames)


def _spans(frames: Sequence[AnnotatedFrame]) -> CounterType[Tuple[str, str, FrozenSet[int]]]:
    return Counter((frame.name, element.name, element.tokens) for frame in frames for element in frame.elements)


def _heads(
    annotated: Sequence[AnnotatedFrame], answered: Sequence[AnnotatedFrame]
) -> Tuple[CounterType[Element], CounterType[Element]]:
    """Return the heads of both. If none is annotated, the head of the answer replaces it when it is in the span."""
    given: List[Element] = [(frame.name, item.name, item.head) for frame in answered for item in frame.elements]
    free = list(given)
    wanted: List[Element] = []
    for frame in annotated:
        for element in frame.elements:
            head: Optional[object] = element.head
            if head is None:
                inside = [item for item in free if item[:2] == (frame.name, element.name) and item[2] in element.tokens]
                head = inside[0][2] if inside else tuple(sorted(element.tokens))
            if (frame.name, element.name, head) in free:
                free.remove((frame.name, element.name, head))
            wanted.append((frame.name, element.name, head))
    return Counter(wanted), Counter(given)


def _add_rows(
    rows: Dict[str, FrameRow], annotated: Sequence[AnnotatedFrame], answered: Sequence[AnnotatedFrame]
) -> None:
    for name in {frame.name for frame in annotated} | {frame.name for frame in answered}:
        here = [frame for frame in annotated if frame.name == name]
        there = [frame for frame in answered if frame.name == name]
        row = rows.get(name, FrameRow(Count(), Count(), Count(), {}))
        annotated_heads, answered_heads = _heads(here, there)
        rows[name] = FrameRow(
            frame=row.frame.plus(*_compare(_frames(here), _frames(there))),
            exact=row.exact.plus(*_compare(_spans(here), _spans(there))),
            head=row.head.plus(*_compare(annotated_heads, answered_heads)),
            taken_for=row.taken_for,
        )
    for name, taken in _taken_for(annotated, answered):
        row = rows[name] if name in rows else FrameRow(Count(), Count(), Count(), {})
        rows[name] = FrameRow(row.frame, row.exact, row.head, {**row.taken_for, taken: row.taken_for.get(taken, 0) + 1})


def _taken_for(annotated: Sequence[AnnotatedFrame], answered: Sequence[AnnotatedFrame]) -> List[Tuple[str, str]]:
    """Pair annotated frames with those of the answer that the same word evokes, then with those of the same name."""
    pairs: List[Tuple[str, str]] = []
    free = list(answered)
    open_frames: List[AnnotatedFrame] = []
    for frame in annotated:
        match = next((other for other in free if set(other.lexical_unit) & set(frame.lexical_unit)), None)
        if match is None:
            open_frames.append(frame)
            continue
        free.remove(match)
        pairs.append((frame.name, match.name))
    for frame in open_frames:
        match = next((other for other in free if other.name == frame.name), None)
        if match is not None:
            free.remove(match)
        pairs.append((frame.name, match.name if match is not None else NOTHING))
    return pairs + [(NOTHING, other.name) for other in free]
