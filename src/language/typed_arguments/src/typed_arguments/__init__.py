"""Typed arguments of frame elements: words and meaning."""

from typed_arguments.argument import EmbeddedFrame, Measure, Modifier, Source, TimeExpression, TypedArgument
from typed_arguments.filled_frame import FilledFrame
from typed_arguments.goal_text import GoalArguments, from_goal_text, to_goal_text

__all__ = [
    "EmbeddedFrame",
    "FilledFrame",
    "GoalArguments",
    "Measure",
    "Modifier",
    "Source",
    "TimeExpression",
    "TypedArgument",
    "from_goal_text",
    "to_goal_text",
]
