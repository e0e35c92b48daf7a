"""What people say of servers: never, or first. A rule holds under every policy, until it is taken back."""

import enum
import re
from dataclasses import dataclass
from typing import FrozenSet, Iterable, Optional, Sequence, Tuple

from typed_arguments import FilledFrame
from word_classes import word_class

_DETERMINERS = word_class("determiners")
_WORD = re.compile(r"[A-Z]?[a-z]+|[A-Z]+|[0-9]+")


class RuleKind(enum.IntEnum):
    """What a rule demands; the numbers are those of the message ``ServerRule``."""

    NEVER = 0
    FIRST = 1


@dataclass(frozen=True)
class Rule:
    """A rule about servers.

    Attributes:
        rule_id: stable
        kind: what it demands
        server: words of the names of the servers that are meant
        frame: of which frame; empty for all
        thing: lemma of an argument; empty for all
        is_once: whether it holds only until it was followed
        said: the words of the person
        stamp_s: when, ROS time
    """

    rule_id: str
    kind: RuleKind
    server: str
    frame: str = ""
    thing: str = ""
    is_once: bool = False
    said: str = ""
    stamp_s: float = 0.0

    def is_about(self, frame: FilledFrame) -> bool:
        """Whether a frame with its server is meant."""
        return (
            self.names(frame.server)
            and self.frame in ("", frame.name)
            and (not self.thing or any(self.thing in things_of(one.text, one.lemma) for one in frame.arguments))
        )

    def names(self, server: str) -> bool:
        """Whether a server is meant."""
        return is_named(self.server, server)

    @property
    def sentence(self) -> str:
        """The rule for a person: "never arm_a for glass"."""
        what = [self.frame.replace("_", " ")] if self.frame else []
        what += [self.thing] if self.thing else []
        when = "never" if self.kind is RuleKind.NEVER else "next time first" if self.is_once else "first"
        return f"{when} {self.server}" + (f" for {' of '.join(what)}" if what else "")


def words_of(name: str) -> Tuple[str, ...]:
    """Return the words of a name in lower case, without a determiner before them: ("left", "arm") of "/left_arm"."""
    found = tuple(word.lower() for word in _WORD.findall(name))
    return found[1:] if len(found) > 1 and found[0] in _DETERMINERS else found


def is_named(words: str, server: str) -> bool:
    """Whether the name of a server has all of some words."""
    asked = frozenset(words_of(words))
    return bool(asked) and asked <= frozenset(words_of(server))


def things_of(text: str, lemma: str) -> FrozenSet[str]:
    """Return the nouns by which a person may mean an argument."""
    return frozenset(word for word in (lemma.lower(), text.lower(), (text.lower().split() or [""])[-1]) if word)


def forbidden(frames: Iterable[FilledFrame], rules: Sequence[Rule]) -> Optional[Rule]:
    """Return the rule that forbids to carry out some frames; None if there is none."""
    never = [rule for rule in rules if rule.kind is RuleKind.NEVER]
    return next((rule for frame in frames for rule in never if rule.is_about(frame)), None)


def wanted(frames: Iterable[FilledFrame], rules: Sequence[Rule]) -> Optional[Rule]:
    """Return the newest rule that wants some frames to be tried first; None if there is none."""
    named = tuple(frames)
    first = [rule for rule in rules if rule.kind is RuleKind.FIRST]
    return next((rule for rule in reversed(first) if any(rule.is_about(frame) for frame in named)), None)
