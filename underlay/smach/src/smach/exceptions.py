"""Errors of states and containers.

A transition or a construction that is not valid makes the state invalid that it belongs to: whoever catches
InvalidStateError catches those too.
"""


class SmachError(Exception):
    """Base of every error of SMACH."""


class InvalidStateError(SmachError):
    """A state or a container is used or described in a way that is not valid."""


class InvalidTransitionError(InvalidStateError):
    """An outcome leads nowhere, or was never registered."""


class InvalidConstructionError(InvalidStateError):
    """A container is built in a way that is not valid: not opened, opened twice, or of another type."""


class InvalidUserCodeError(SmachError):
    """Code that the user gave raised, or broke its promise about the userdata that it touches."""
