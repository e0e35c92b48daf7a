"""Finds the things, persons and places of the world that a phrase refers to."""

from referring_expressions.describing import describe, question_of, unknown_of
from referring_expressions.fitting import Situation, fitting
from referring_expressions.resolving import Referents, resolve, with_referents

__all__ = ["Referents", "Situation", "describe", "fitting", "question_of", "resolve", "unknown_of", "with_referents"]
