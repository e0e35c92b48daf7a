"""What somebody says about how things are: "the door is closed", "no light is on", "nobody is in the garage"."""

from dataclasses import dataclass
from typing import List, Optional, Tuple

from home_servers.places import RELATIONS
from typed_arguments import TypedArgument
from word_classes import word_class

_NO_PERSONS = word_class("indefinite_persons_denied")
_NO_THINGS = word_class("no_things")
_NOT = word_class("not")
_BE = word_class("forms_of_be")
_ALL = word_class("determiners_of_all")
_OPENING = word_class("before_statements")
_NOWHERE = TypedArgument()


@dataclass(frozen=True)
class Statement:
    """What is said of things.

    Attributes:
        about: the things
        is_denied: whether it is said that there are no such things: "nobody", "no light"
        is_negated: whether the opposite of the state is said: "is not open"
        is_of_all: whether all things of that name are meant
        state: how they are; empty for a place
        place: where they are; its text is empty for a state
    """

    about: TypedArgument
    is_denied: bool = False
    is_negated: bool = False
    is_of_all: bool = False
    state: str = ""
    place: TypedArgument = _NOWHERE


def statement_of(text: str) -> Optional[Statement]:
    """Return what a clause says; None for a clause of another form."""
    words = text.lower().strip(" .!?").replace("n't", " not").replace("no one", "nobody").split()
    at = next((index for index, word in enumerate(words) if word in _BE), None)
    if at is None:
        return None
    subject, behind = [word for word in words[:at] if word not in _OPENING], words[at + 1 :]
    if not subject:
        # "There is nobody in the garage": what is there stands behind the verb.
        cut = next((index for index, word in enumerate(behind) if word in RELATIONS), len(behind))
        subject, behind = behind[:cut], behind[cut:]
    is_negated = bool(behind) and behind[0] in _NOT
    behind = behind[1:] if is_negated else behind
    if not subject or not behind:
        return None
    is_denied, named = _without_denial(subject)
    is_of_all = is_denied or words[at].endswith("re") or named[0] in _ALL
    named = named[1:] if named[0] in _ALL else named
    state, place = _predicate(behind)
    is_which = is_of_all and RELATIONS.keys() & set(named)
    if is_which or not named or named[0] in _NOT or not (state or place.text):
        return None
    return Statement(TypedArgument(text=" ".join(named)), is_denied, is_negated, is_of_all, state, place)


def _without_denial(subject: List[str]) -> Tuple[bool, List[str]]:
    """Return whether a subject denies that there is such a thing, and the thing: "no lights", "none of the doors"."""
    if subject[0] not in _NO_THINGS:
        return False, subject
    if subject[0] in _NO_PERSONS and not subject[1:]:
        return True, ["person"]
    rest = subject[2:] if subject[1:2] == ["of"] else subject[1:]
    return True, rest or ["thing"]


def _predicate(behind: List[str]) -> Tuple[str, TypedArgument]:
    """Return the state or the place that is said: "closed", "on the table"."""
    if len(behind) == 1:
        return behind[0], _NOWHERE
    if behind[0] not in RELATIONS:
        return "", _NOWHERE
    place = " ".join(behind[1:])
    return "", TypedArgument(text=place, relation=behind[0])
