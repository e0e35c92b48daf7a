"""The mood matrix shares nothing with the framer, and knows what the shipped servers do and see."""

import ast
from pathlib import Path
from typing import Any, FrozenSet, Iterator, Mapping

import pytest
import yaml

from home_servers.conditions import FRAMES as WATCHED_IN_HOME
from home_servers.conditions import STATEMENTS
from home_servers.frames import FRAMES as DONE_IN_HOME
from roboframenet_testing.workspace import package

MODULES = package("mood_matrix") / "src" / "mood_matrix"
SERVED: Mapping[str, Any] = yaml.safe_load((MODULES / "served.yaml").read_text(encoding="utf-8"))
#: What makes the sentences and the right answers.
MAKERS = ("english.py", "units.py", "constructions.py")


def imported(path: Path) -> Iterator[str]:
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name.split(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield str(node.module).split(".")[0]


def strings(name: str) -> FrozenSet[str]:
    """Return the strings in the modules of a package."""
    return frozenset(
        node.value
        for path in (package(name) / "src").glob("**/*.py")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
    )


@pytest.mark.parametrize("module", MAKERS)
def test_right_answers_are_made_without_the_project(module: str) -> None:
    standard = {"dataclasses", "enum", "functools", "pathlib", "re", "typing", "yaml", "zlib"}
    assert set(imported(MODULES / module)) <= standard | {"mood_matrix"}


def test_frames_that_the_home_does_are_known() -> None:
    assert set(SERVED["acts"]["home_servers"]) == set(DONE_IN_HOME)


@pytest.mark.parametrize("name", sorted(set(SERVED["acts"]) - {"home_servers"}))
def test_frames_that_another_server_does_are_named_in_its_package(name: str) -> None:
    assert set(SERVED["acts"][name]) <= strings(name)


def test_states_that_the_home_sees_are_known() -> None:
    text = (package("home_servers") / "src" / "home_servers" / "states.yaml").read_text(encoding="utf-8")
    assert SERVED["states"] == {word: state for word, state in yaml.safe_load(text).items() if word != "out"}


def test_perceivers_are_those_that_the_home_states() -> None:
    assert SERVED["perceivers"] == STATEMENTS["condition_of_perceiving"]["heeds"]["perceiver"]


def test_events_that_are_noticed_are_conditions_that_a_server_watches() -> None:
    watched = set(WATCHED_IN_HOME) | strings("condition_watchers")
    assert {condition for conditions in SERVED["events"].values() for condition in conditions} <= watched
