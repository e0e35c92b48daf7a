"""What counts as read of a frame that a callback gets."""

from typing import Any, Callable, Set

import pytest

messages = pytest.importorskip("roboframenet_msgs.msg")

from rfnserver.arguments import argument, length_m, number  # noqa: E402
from rfnserver.ros_typed_frame import NotedFrame, TypedFrame  # noqa: E402
from typed_arguments import Measure, TypedArgument  # noqa: E402

ARGUMENTS = (
    TypedArgument("goal", "the office"),
    TypedArgument("distance", "3", measure=Measure("length", unit="metre", si=3.0)),
    TypedArgument("manner", "slowly"),
)
ALL = {"goal", "distance", "manner"}


def frame() -> TypedFrame:
    elements = [messages.FilledFrameElement(one.name, one.text) for one in ARGUMENTS]
    return TypedFrame(messages.FilledSemanticFrame("moving", elements, ["mover"]), ARGUMENTS)


@pytest.mark.parametrize(
    "callback, read",
    [
        (lambda noted: noted.name, set()),
        (lambda noted: noted["goal"].text, {"goal"}),
        (lambda noted: argument(noted, "goal"), {"goal"}),
        (lambda noted: number(noted, "distance"), {"distance"}),
        (lambda noted: length_m(noted, "distance"), {"distance"}),
        (lambda noted: [one.argument for one in noted.frame_elements if one.name == "manner"], {"manner"}),
        (lambda noted: {one.name: one.argument for one in noted.frame_elements}["goal"], ALL),
        (lambda noted: noted.arguments, ALL),
        (lambda noted: "manner" in noted and len(noted.frame_elements) == 3, set()),
        (lambda noted: f"{noted} {noted!r}", set()),
        (lambda noted: [one.name for one in noted.frame_elements], set()),
    ],
)
def test_what_is_read_is_noted(callback: Callable[[Any], Any], read: Set[str]) -> None:
    noted = NotedFrame(frame())
    callback(noted)
    # An element that the frame has not may be looked for.
    assert noted.read & ALL == read


def test_noted_frame_is_the_frame() -> None:
    noted = NotedFrame(frame())
    assert noted == frame()
    assert (noted["goal"], noted["speed"].text) == (ARGUMENTS[0], "")
    assert str(noted) == str(frame())
