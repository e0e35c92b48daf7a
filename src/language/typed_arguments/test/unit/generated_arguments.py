"""Arguments made by chance, of every shape that a value allows; the same seed makes the same ones."""

import functools
import random
from typing import Callable, Optional, Tuple, TypeVar

from typed_arguments import EmbeddedFrame, Measure, Modifier, Source, TimeExpression, TypedArgument

T = TypeVar("T")
#: Letters of several lengths in UTF-8, and what JSON has to escape.
_LETTERS = 'aB7 _"\\\n\tßü語🙂{}[]'


class Maker:
    """Makes values."""

    def __init__(self, seed: int) -> None:
        self._chance = random.Random(seed)

    def argument(self, *, name: str = "", levels: int = 3) -> TypedArgument:
        """An argument, or a part of one when it has no name."""
        return TypedArgument(
            name=name,
            text=self._text(),
            source=self._chance.choice(list(Source)),
            words=self._text(),
            positions=self._positions(),
            head=self._text(),
            lemma=self._text(),
            head_position=self._chance.randrange(5),
            is_plural=self._flag(),
            relation=self._text(),
            quantifier=self._text(),
            count=self._maybe(lambda: self._chance.randrange(2**31)),
            count_bound=self._text(),
            is_negated=self._flag(),
            is_asked=self._flag(),
            direction=self._text(),
            measure=self._maybe(self._measure),
            time=self._maybe(self._time),
            modifiers=tuple(self._modifier() for _ in range(self._chance.randrange(3))),
            possessor=self._part(levels),
            complement=self._part(levels),
            members=self._parts(levels, self._chance.choice([0, 0, 2, 3])),
            conjunction=self._text(),
            exceptions=self._parts(levels, self._chance.choice([0, 0, 1, 2])),
            frames=tuple(self._frame(levels) for _ in range(self._chance.choice([0, 0, 1, 2]))),
            semantic_type=self._text(),
            referents=tuple(self._text() for _ in range(self._chance.randrange(3))),
            referent_count=self._chance.randrange(-1, 4),
            world_version=self._text(),
        )

    def _part(self, levels: int) -> Optional[TypedArgument]:
        return self._maybe(lambda: self.argument(levels=levels - 1)) if levels > 1 else None

    def _parts(self, levels: int, count: int) -> Tuple[TypedArgument, ...]:
        return tuple(self.argument(levels=levels - 1) for _ in range(count)) if levels > 1 else ()

    def _frame(self, levels: int) -> EmbeddedFrame:
        names = [f"element_{number}" for number in range(self._chance.randrange(3))] if levels > 1 else []
        return EmbeddedFrame(
            role=self._chance.choice(["describes", "says"]),
            frame_name=self._text(),
            words=self._text(),
            positions=self._positions(),
            head_element=self._text(),
            mood=self._text(),
            is_negated=self._flag(),
            frame_elements=tuple(self.argument(name=name, levels=levels - 1) for name in names),
        )

    def _measure(self) -> Measure:
        return Measure(
            kind=self._chance.choice(["length", "angle"]),
            words=self._text(),
            amount=self._maybe(self._number),
            unit=self._text(),
            si=self._maybe(self._number),
            bound=self._text(),
            change=self._text(),
            is_assumed=self._flag(),
        )

    def _time(self) -> TimeExpression:
        begin_s = self._maybe(self._seconds)
        return TimeExpression(
            kind=self._chance.choice(["time", "set"]),
            words=self._text(),
            relation=self._text(),
            value=self._text(),
            time_zone=self._text(),
            begin_s=begin_s,
            end_s=None if begin_s is None else begin_s + self._chance.choice([0.0, 3600.0]),
            offset_s=self._maybe(lambda: self._chance.choice([-1.0, 1.0]) * self._seconds()),
            length_s=self._maybe(self._seconds),
            period_s=self._maybe(self._seconds),
        )

    def _modifier(self) -> Modifier:
        return Modifier(
            kind=self._chance.choice(["adjective", "ordinal"]),
            word=self._text(),
            lemma=self._text(),
            degree=self._text(),
            number=self._chance.choice([-1, 0, 2, -(2**31), 2**31 - 1]),
            position=self._chance.randrange(5),
        )

    def _maybe(self, make: Callable[[], T]) -> Optional[T]:
        return make() if self._flag() else None

    def _flag(self) -> bool:
        return self._chance.random() < 0.5

    def _text(self) -> str:
        return "".join(self._chance.choice(_LETTERS) for _ in range(self._chance.choice([0, 0, 1, 6])))

    def _positions(self) -> Tuple[int, ...]:
        return tuple(sorted(self._chance.sample(range(1, 50), self._chance.randrange(4))))

    def _number(self) -> float:
        return self._chance.choice([0.0, -0.5, 3.0, 1e-300, -1e300, self._chance.uniform(-1e6, 1e6)])

    def _seconds(self) -> float:
        # Nanoseconds of ROS hold multiples of 1/512 s exactly.
        return self._chance.randrange(1, 2**39) / 512.0


@functools.lru_cache(maxsize=None)
def arguments(count: int) -> Tuple[TypedArgument, ...]:
    """So many arguments that may be made: those with too many parts are made again."""
    found = []
    seed = 0
    while len(found) < count:
        try:
            found.append(Maker(seed).argument(name=f"element_{seed}"))
        except ValueError as error:
            if "phrases" not in str(error):
                raise
        seed += 1
    return tuple(found)
