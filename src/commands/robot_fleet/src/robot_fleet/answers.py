"""One answer of several robots, and the order in which they are asked."""

import enum
from dataclasses import asdict, dataclass, field, replace
from typing import Any, Dict, List, Mapping, Sequence, Tuple

from robot_fleet.addressing import Order, listed


class Outcome(enum.IntEnum):
    """How a command ended; the numbers are those of the message ``Reply``."""

    DONE = 0
    FAILED = 1
    REFUSED = 2
    NEEDS_INFORMATION = 3
    SUPERSEDED = 4


#: Refusals of a robot that cannot do a thing, after which another one is asked.
CANNOT = frozenset(["NO_SERVER", "UNKNOWN_FRAME"])
#: The answers of several robots count in this order.
_WORST = (Outcome.FAILED, Outcome.NEEDS_INFORMATION, Outcome.REFUSED, Outcome.SUPERSEDED, Outcome.DONE)


@dataclass(frozen=True)
class Answer:
    """What a robot replied."""

    robot: str
    outcome: Outcome
    code: str
    sentence: str
    stage: str = ""


@dataclass(frozen=True)
class Sending:
    """Words that are sent to a robot now."""

    robot: str
    text: str
    order: int


@dataclass
class OpenUtterance:
    """What was said to all robots and has no reply yet.

    Attributes:
        orders: its orders
        remark: what the reply says before the answers; empty for nothing
        answers: those that count
    """

    orders: Tuple[Order, ...]
    remark: str = ""
    answers: List[Answer] = field(default_factory=list)
    _waiting: Dict[Tuple[int, str], None] = field(default_factory=dict)
    _begun: int = 0
    _tried: Dict[int, int] = field(default_factory=dict)

    def begin(self) -> Tuple[Sending, ...]:
        """Return what is to be sent now: the orders up to one that waits for those before it."""
        sendings: List[Sending] = []
        while self._begun < len(self.orders):
            order = self.orders[self._begun]
            if order.is_after and (self._waiting or any(one.outcome is not Outcome.DONE for one in self.answers)):
                break
            robots = order.robots[:1] if order.is_any else order.robots
            sendings += [Sending(robot, order.text, self._begun) for robot in robots]
            self._waiting.update({(self._begun, robot): None for robot in robots})
            self._tried[self._begun] = 1
            self._begun += 1
        return tuple(sendings)

    def hear(self, order: int, answer: Answer) -> Tuple[Sending, ...]:
        """A robot has answered; returns what is to be sent next."""
        if (order, answer.robot) not in self._waiting:
            return ()
        del self._waiting[order, answer.robot]
        wanted = self.orders[order]
        tried = self._tried[order]
        if wanted.is_any and answer.code in CANNOT and tried < len(wanted.robots):
            following = wanted.robots[tried]
            self._tried[order] = tried + 1
            self._waiting[order, following] = None
            return (Sending(following, wanted.text, order),)
        self.answers.append(answer)
        return self.begin()

    def record(self) -> Dict[str, Any]:
        """Return it as JSON can hold it."""
        return {
            "orders": [asdict(order) for order in self.orders],
            "remark": self.remark,
            "answers": [{**asdict(answer), "outcome": int(answer.outcome)} for answer in self.answers],
            "waiting": [list(one) for one in self._waiting],
            "begun": self._begun,
            "tried": list(self._tried.items()),
        }

    @classmethod
    def of_record(cls, record: Mapping[str, Any]) -> "OpenUtterance":
        """Return the one of a record.

        Raises:
            KeyError: a value is missing
            TypeError: a value is of a wrong type
            ValueError: a value cannot be
        """
        return cls(
            orders=tuple(Order(**{**order, "robots": tuple(order["robots"])}) for order in record["orders"]),
            remark=str(record["remark"]),
            answers=[Answer(**{**answer, "outcome": Outcome(answer["outcome"])}) for answer in record["answers"]],
            _waiting={(int(order), str(robot)): None for order, robot in record["waiting"]},
            _begun=int(record["begun"]),
            _tried={int(order): int(count) for order, count in record["tried"]},
        )

    @property
    def waiting(self) -> Tuple[Tuple[int, str], ...]:
        """The orders and robots whose answers are missing."""
        return tuple(self._waiting)

    @property
    def is_complete(self) -> bool:
        """Whether nothing is missing, and nothing will be sent any more."""
        return not self._waiting

    def whole_answer(self) -> Answer:
        """Return the one answer of all; an order that was not begun is named."""
        answers = sorted(self.answers, key=lambda one: _WORST.index(one.outcome))
        if not answers:
            return Answer("", Outcome.FAILED, "STAGE_ERROR", "Nobody answered.")
        worst = answers[0]
        addressed = [robot for order in self.orders for robot in order.robots]
        sentence = _told(sorted(self.answers, key=lambda one: addressed.index(one.robot)))
        for order in self.orders[self._begun :]:
            sentence += f' I did not ask {listed(order.robots)} to do this: "{order.text}".'
        return replace(worst, sentence=f"{self.remark} {sentence}".strip())


def _told(answers: Sequence[Answer]) -> str:
    by_sentence: Dict[str, List[str]] = {}
    for answer in answers:
        by_sentence.setdefault(answer.sentence, []).append(answer.robot)
    return " ".join(f"{listed(sorted(robots))}: {sentence}" for sentence, robots in by_sentence.items())


def robot_of_question(answers: Sequence[Answer]) -> Tuple[str, ...]:
    """Return the robots that ask something."""
    return tuple(answer.robot for answer in answers if answer.outcome is Outcome.NEEDS_INFORMATION)


def missing_answer(robot: str, sentence: str, code: str = "STAGE_SILENT") -> Answer:
    """Return the answer in the place of a robot that gives none."""
    return Answer(robot, Outcome.FAILED, code, sentence)
