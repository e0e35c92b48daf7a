"""What a page may ask for: four verbs, and nothing else."""

import json
from dataclasses import dataclass
from typing import Union

#: A message of a page is not longer than this, in bytes; a text has at most four bytes a character.
LONGEST_MESSAGE = 16 * 1024
_LONGEST_ID = 200


@dataclass(frozen=True)
class Say:
    """Say a sentence to the robot; an answer to a question is a sentence too."""

    text: str


@dataclass(frozen=True)
class Cancel:
    """End a command."""

    command_id: str


@dataclass(frozen=True)
class Stop:
    """Stop the robot.

    Attributes:
        stays: whether it is the emergency stop, which holds until a person releases it
    """

    stays: bool = False


Request = Union[Say, Cancel, Stop]


class BadRequest(ValueError):
    """A page asked for something that does not exist; the message says what is wrong."""


def read_request(message: object, *, longest_text: int) -> Request:
    """Read the message of a page.

    Args:
        message: as it came over the wire
        longest_text: how many characters a sentence may have

    Raises:
        BadRequest: it is none of the four verbs with its argument; for a person
    """
    if not isinstance(message, str) or len(message) > LONGEST_MESSAGE:
        raise BadRequest("This is not a request.")
    try:
        said = json.loads(message)
    except (ValueError, RecursionError):
        raise BadRequest("This is not a request.") from None
    if not isinstance(said, dict):
        raise BadRequest("This is not a request.")
    verb = said.get("verb")
    if verb in ("stop", "emergency_stop") and set(said) == {"verb"}:
        return Stop(stays=verb == "emergency_stop")
    if verb == "say" and set(said) == {"verb", "text"} and isinstance(said["text"], str):
        text = " ".join("".join(sign if sign.isprintable() else " " for sign in said["text"]).split())
        if not text:
            raise BadRequest("There are no words in it.")
        if len(said["text"]) > longest_text:
            raise BadRequest(f"A sentence has at most {longest_text} characters; this one has {len(said['text'])}.")
        return Say(text)
    if verb == "cancel" and set(said) == {"verb", "id"} and isinstance(said["id"], str):
        if not 0 < len(said["id"]) <= _LONGEST_ID:
            raise BadRequest("There is no such command.")
        return Cancel(said["id"])
    raise BadRequest("This is not a request.")
