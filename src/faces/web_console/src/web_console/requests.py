"""What a page may ask for: six verbs, and nothing else."""

import json
from dataclasses import dataclass
from typing import Union

from web_console.conversations import RIGHT, WRONG

#: A message of a page is not longer than this, in bytes; a text has at most four bytes a character.
LONGEST_MESSAGE = 16 * 1024
_LONGEST_ID = 200
#: Sound is sent in parts, bytes: 0.2 s at most.
LONGEST_SOUND = 6400


@dataclass(frozen=True)
class Say:
    """Say a sentence to the robot; an answer to a question is a sentence too."""

    text: str


@dataclass(frozen=True)
class Cancel:
    """End a command."""

    command_id: str


@dataclass(frozen=True)
class Listen:
    """Listen to one spoken command."""


@dataclass(frozen=True)
class Sound:
    """Sound of the microphone of the page.

    Attributes:
        pcm: 16 kHz, 16 bit, mono
    """

    pcm: bytes


@dataclass(frozen=True)
class Stop:
    """Stop the robot.

    Attributes:
        stays: whether it is the emergency stop, which holds until a person releases it
    """

    stays: bool = False


@dataclass(frozen=True)
class Judge:
    """Keep a person's verdict of a past conversation.

    Attributes:
        command_id: of the conversation
        verdict: right, wrong, or nothing
        meant: in other words, when it was wrong
    """

    command_id: str
    verdict: str
    meant: str = ""


Request = Union[Say, Cancel, Listen, Sound, Stop, Judge]


class BadRequest(ValueError):
    """A page asked for something that does not exist; the message says what is wrong."""


def read_sound(message: bytes) -> Sound:
    """Read a message of a page that is no text.

    Args:
        message: as it came over the wire

    Raises:
        BadRequest: it is no sound, or too much; for a person
    """
    if not message or len(message) % 2 or len(message) > LONGEST_SOUND:
        raise BadRequest("This is no sound.")
    return Sound(message)


def read_request(message: object, *, longest_text: int) -> Request:
    """Read the message of a page.

    Args:
        message: as it came over the wire
        longest_text: how many characters a sentence may have

    Raises:
        BadRequest: it is none of the six verbs with its argument; for a person
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
    if verb == "listen" and set(said) == {"verb"}:
        return Listen()
    if verb == "say" and set(said) == {"verb", "text"} and isinstance(said["text"], str):
        text = _in_words(said["text"], longest_text)
        if not text:
            raise BadRequest("There are no words in it.")
        return Say(text)
    if verb == "cancel" and set(said) == {"verb", "id"}:
        return Cancel(_id_of(said["id"]))
    if verb == "judge" and set(said) == {"verb", "id", "verdict", "meant"} and isinstance(said["meant"], str):
        if said["verdict"] not in (RIGHT, WRONG, ""):
            raise BadRequest("This is not a request.")
        return Judge(_id_of(said["id"]), said["verdict"], _in_words(said["meant"], longest_text))
    raise BadRequest("This is not a request.")


def _in_words(text: str, longest_text: int) -> str:
    if len(text) > longest_text:
        raise BadRequest(f"A sentence has at most {longest_text} characters; this one has {len(text)}.")
    return " ".join("".join(sign if sign.isprintable() else " " for sign in text).split())


def _id_of(said: object) -> str:
    if not isinstance(said, str):
        raise BadRequest("This is not a request.")
    if not 0 < len(said) <= _LONGEST_ID:
        raise BadRequest("There is no such command.")
    return said
