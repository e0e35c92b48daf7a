"""The words of the emergency stop. They are a safety rule: a list, decided without a parser."""

from typing import FrozenSet, Tuple

from command_server.spoken_words import words_of
from command_server.stop_words import is_stop

#: A cry with one of these engages the emergency stop.
ENGAGING: Tuple[str, ...] = ("emergency stop", "emergency halt", "estop", "e stop")
#: Who releases it says one of these, one of the names of the emergency stop, and nothing else but politeness.
RELEASING: Tuple[str, ...] = ("release", "reset", "lift", "clear", "unlock", "disengage", "deactivate")
RELEASED: Tuple[str, ...] = ("the emergency stop", "emergency stop", "the estop", "estop", "the e stop", "e stop")
_AROUND: FrozenSet[str] = frozenset("please ok okay robot turtlebot now hey".split())
_RELEASES: FrozenSet[str] = frozenset(f"{verb} {name}" for verb in RELEASING for name in RELEASED)
#: The reply to a release that is not said by a person now.
NOT_A_PERSON = "Only what a person says now releases the emergency stop."


def is_emergency_stop(text: str) -> bool:
    """Whether an utterance engages the emergency stop: a cry that names it.

    Args:
        text: in any spelling
    """
    said = f" {words_of(text)} "
    return any(f" {phrase} " in said for phrase in ENGAGING) and is_stop(text)


def is_release(text: str) -> bool:
    """Whether an utterance releases the emergency stop.

    A question, a condition, a negation, or any other word beside these means something else.

    Args:
        text: in any spelling
    """
    if "?" in text:
        return False
    return " ".join(word for word in words_of(text).split() if word not in _AROUND) in _RELEASES


def may_release(text: str) -> bool:
    """Whether an utterance may release the emergency stop of a robot that it names, whatever else is said.

    Args:
        text: in any spelling
    """
    said = f" {words_of(text)} "
    return any(f" {phrase} " in said for phrase in _RELEASES)
