"""The words of ``words.yaml``."""

import os
from functools import lru_cache
from typing import FrozenSet, Mapping, Optional

import yaml

from typed_arguments import TypedArgument
from word_classes import without_determiner, word_class

_PATH = os.path.join(os.path.dirname(os.path.realpath(__file__)), "words.yaml")


@lru_cache(maxsize=1)
def _file() -> Mapping[str, FrozenSet[str]]:
    with open(_PATH, encoding="utf-8") as file:
        return {name: frozenset(words) for name, words in yaml.safe_load(file).items() if name != "hours"}


@lru_cache(maxsize=1)
def _hours() -> Mapping[str, int]:
    with open(_PATH, encoding="utf-8") as file:
        return dict(yaml.safe_load(file)["hours"])


def words(name: str) -> FrozenSet[str]:
    """Return a list of the file.

    Raises:
        KeyError: there is no such list
    """
    return _file()[name]


def hour(name: str) -> Optional[int]:
    """Return the hour that a word names, 0 to 23; None if it names none."""
    return _hours().get(name)


def robots() -> FrozenSet[str]:
    """Return the words for the robot."""
    return words("robots") | word_class("hearers")


def is_one_of(argument: TypedArgument, name: str) -> bool:
    """Whether an argument names one of the words of a list."""
    return not names_of(argument).isdisjoint(words(name))


def names_of(argument: TypedArgument) -> FrozenSet[str]:
    """Return the words that an argument may be listed under, in lower case."""
    text = without_determiner(argument.text).lower()
    found = {text, argument.head.lower(), argument.lemma.lower()}
    if not argument.head and text:
        found.add(text.split()[-1])
    return frozenset(found - {""})
