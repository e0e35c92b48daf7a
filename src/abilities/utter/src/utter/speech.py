"""Makes a sentence from the elements of a filled frame."""

import datetime
from typing import Optional

from word_classes import without_determiner, word_class

#: Characters of the longest text; nobody listens to more.
LONGEST_TEXT = 500
_DETERMINERS = word_class("determiners_and_possessives")
#: Words for an addressee without a name.
_PARTICIPANTS = word_class("participants")


class NothingToSay(ValueError):
    """The frame gives no sentence; the message is the reason, for a person."""


def spoken_text(message: str, addressee: str = "") -> str:
    """Make the sentence that the robot says aloud.

    Args:
        message: what to say, "hello"
        addressee: to whom, "the class"; empty or "me" for nobody by name
    Returns:
        "Hello, class."
    Raises:
        NothingToSay: the message is empty or too long
    """
    words = " ".join(message.split()).strip(" .\"'")
    if not words:
        raise NothingToSay("There is nothing to say.")
    if len(words) > LONGEST_TEXT:
        raise NothingToSay(f"That is too long to say: {len(words)} characters, at most {LONGEST_TEXT}.")
    name = _name_of(addressee)
    end = "" if words[-1] in "!?" else "."
    called = f", {name}" if name else ""
    return words[0].upper() + words[1:].rstrip("!?") + called + (end or words[-1])


def told_statement(message: str, addressee: str = "", *, is_own: bool = False) -> str:
    """Return what somebody is to be told. "I" in it is the person who commands, so the robot says that it only tells.

    Args:
        message: a statement, "dinner is ready"
        addressee: whom to tell, "Anna"; empty or "me" for whoever commands
        is_own: whether "I" in it is the robot: "I see Bob"
    Returns:
        "Anna, I was asked to tell you: dinner is ready."
    Raises:
        NothingToSay: the message is empty or too long
    """
    text, name = spoken_text(message), _name_of(addressee)
    if not name:
        return text
    # Only a name has its capital inside the sentence.
    words = message.strip()[:1] + text[1:]
    return f"{name[0].upper()}{name[1:]}, {'' if is_own else 'I was asked to tell you: '}{words}"


def told_fact(message: str, now: datetime.datetime, addressee: str = "") -> str:
    """Return a sentence about something that the robot itself knows.

    Args:
        message: what to tell, "the time"
        now: local time
        addressee: whom to tell, "Anna"; empty or "me" for nobody by name
    Returns:
        "Anna, it is 12:00."
    Raises:
        NothingToSay: the robot does not know it
    """
    topic = without_determiner(message.lower(), _DETERMINERS)
    facts = {
        "time": f"It is {now:%H:%M}.",
        "date": f"It is {now:%A}, {now.day} {now:%B %Y}.",
        "day": f"It is {now:%A}.",
        "name": "My name is Robo.",
    }
    fact: Optional[str] = facts.get(topic)
    if fact is None:
        raise NothingToSay(f"I do not know {message.strip()}; I can tell the {', the '.join(sorted(facts))}.")
    name = _name_of(addressee)
    return f"{name[0].upper()}{name[1:]}, {fact[0].lower()}{fact[1:]}" if name else fact


def _name_of(addressee: str) -> str:
    """Return how to call an addressee; empty for the one who speaks."""
    name = without_determiner(addressee, _DETERMINERS)
    return name if name.lower() not in _PARTICIPANTS else ""
