"""What the watchers state fits the frames that they register for."""

import os

import pytest

from condition_watchers.surroundings import frames
from frame_bindings.binding_file import load_bindings
from semantic_frames import load_frame
from semantic_frames.server_profile import profile_problems
from semantic_frames.server_statement import stated_profile

SOURCES = os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..", "..")
FRAMES = os.path.join(SOURCES, "roboframenet_domains", "domains", "conditions", "frames")
BATTERY = os.path.join(SOURCES, "condition_watchers", "config", "battery.yaml")


def text_of(path: str) -> str:
    with open(path, encoding="utf-8") as file:
        return file.read()


def problems(frame_name: str, statement: object) -> object:
    path = os.path.join(FRAMES, f"{frame_name}.yaml")
    return profile_problems(stated_profile(dict(statement)), load_frame(text_of(path), path))  # type: ignore[call-overload]


@pytest.mark.parametrize("tells_persons", [True, False])
def test_surroundings(tells_persons: bool) -> None:
    for frame_name, statement in frames(tells_persons=tells_persons).items():
        assert problems(frame_name, {**statement, "purpose": "watches"}) == ()


def test_battery() -> None:
    conditions = load_bindings(text_of(BATTERY), BATTERY).conditions
    assert [condition.name for condition in conditions] == [
        "battery_low",
        "battery_full",
        "battery_above",
        "battery_below",
    ]
    for condition in conditions:
        assert problems(condition.frame_name, condition.statement) == ()
