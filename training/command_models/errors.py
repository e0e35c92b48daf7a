"""The exception for everything that the user can correct."""


class TrainingError(Exception):
    """A wrong file, argument or state; the message says where, what was expected, and what to do."""
