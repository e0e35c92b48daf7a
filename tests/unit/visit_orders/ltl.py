"""Interprets formulas of linear temporal logic over lassos: runs that end in a loop."""

import re
from dataclasses import dataclass
from typing import Callable, Dict, FrozenSet, List, Sequence, Tuple

_TOKENS = re.compile(r"\s*(->|[()!&|]|\w+)")
_UNARY = frozenset("!XFG")


@dataclass(frozen=True)
class Lasso:
    """A run without an end.

    Attributes:
        states: what is true in each
        loop: position of the state behind the last one

    Raises:
        ValueError: no states, or the loop begins at none of them
    """

    states: Tuple[FrozenSet[str], ...]
    loop: int

    def __post_init__(self) -> None:
        if not 0 <= self.loop < len(self.states):
            raise ValueError(f"a loop at {self.loop} of {len(self.states)} states")


def holds(formula: str, run: Lasso) -> bool:
    """Whether a formula holds at the first state of a run.

    Args:
        formula: of names, `!`, `X`, `F`, `G`, `U`, `&`, `|` and `->`, each of which binds more tightly than the next
        run: its states name what is true
    Raises:
        ValueError: the formula is malformed
    """
    tokens = _TOKENS.findall(formula)
    if "".join(tokens) != re.sub(r"\s", "", formula):
        raise ValueError(f"unknown signs in {formula!r}")
    parser = _Parser(tokens, run)
    truth = parser.implication()
    if parser.rest:
        raise ValueError(f"{parser.rest[0]!r} is left over in {formula!r}")
    return truth[0]


class _Parser:
    """Reads a formula from left to right; each method returns the truth of what it read at each state of the run."""

    def __init__(self, tokens: Sequence[str], run: Lasso) -> None:
        self.rest: List[str] = list(tokens)
        self._run = run

    def implication(self) -> List[bool]:
        left = self._disjunction()
        if not self._takes("->"):
            return left
        return [not one or other for one, other in zip(left, self.implication())]

    def _disjunction(self) -> List[bool]:
        return self._chain("|", self._conjunction, lambda one, other: one or other)

    def _conjunction(self) -> List[bool]:
        return self._chain("&", self._until, lambda one, other: one and other)

    def _chain(self, sign: str, part: Callable[[], List[bool]], join: Callable[[bool, bool], bool]) -> List[bool]:
        truth = part()
        while self._takes(sign):
            truth = [join(one, other) for one, other in zip(truth, part())]
        return truth

    def _until(self) -> List[bool]:
        left = self._unary()
        return self._holds_until(left, self._until()) if self._takes("U") else left

    def _unary(self) -> List[bool]:
        if not self.rest:
            raise ValueError("the formula ends too soon")
        sign = self.rest.pop(0)
        if sign == "(":
            truth = self.implication()
            if not self._takes(")"):
                raise ValueError("a bracket is not closed")
            return truth
        if sign in _UNARY:
            return self._applied(sign, self._unary())
        if not re.fullmatch(r"\w\w+", sign):
            raise ValueError(f"{sign!r} is no name")
        return [sign in state for state in self._run.states]

    def _applied(self, sign: str, truth: List[bool]) -> List[bool]:
        always = [True] * len(truth)
        operators: Dict[str, Callable[[], List[bool]]] = {
            "!": lambda: [not one for one in truth],
            "X": lambda: self._next(truth),
            "F": lambda: self._holds_until(always, truth),
            "G": lambda: [not one for one in self._holds_until(always, [not one for one in truth])],
        }
        return operators[sign]()

    def _next(self, truth: List[bool]) -> List[bool]:
        return [*truth[1:], truth[self._run.loop]]

    def _holds_until(self, left: List[bool], right: List[bool]) -> List[bool]:
        """The least fixed point of `right or (left and next)`."""
        truth, before = list(right), []  # type: List[bool], List[bool]
        while truth != before:
            before = truth
            truth = [now or (still and then) for now, still, then in zip(right, left, self._next(truth))]
        return truth

    def _takes(self, sign: str) -> bool:
        is_next = self.rest[:1] == [sign]
        del self.rest[:is_next]
        return is_next
