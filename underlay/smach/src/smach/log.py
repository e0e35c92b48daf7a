"""Logging of SMACH: the standard logger "smach", or functions that the user sets."""

import logging
from typing import Callable

_LOGGER = logging.getLogger("smach")

LogFunction = Callable[[str], None]


class _Loggers:
    """The four functions in use; the program has one log, so this is one object."""

    def __init__(self) -> None:
        self.info: LogFunction = _LOGGER.info
        self.warn: LogFunction = _LOGGER.warning
        self.debug: LogFunction = _LOGGER.debug
        self.error: LogFunction = _LOGGER.error


_loggers = _Loggers()


def set_loggers(info: LogFunction, warn: LogFunction, debug: LogFunction, error: LogFunction) -> None:
    """Send the messages of SMACH to other functions, each called with one text."""
    _loggers.info, _loggers.warn, _loggers.debug, _loggers.error = info, warn, debug, error


# A percent sign in a message must not be taken for a format by a logger that accepts arguments: each gets the
# text as its only argument, which leaves it alone.
def loginfo(msg: str) -> None:
    """Log normal progress."""
    _loggers.info(msg)


def logwarn(msg: str) -> None:
    """Log a possible mistake."""
    _loggers.warn(msg)


def logdebug(msg: str) -> None:
    """Log detail for debugging."""
    _loggers.debug(msg)


def logerr(msg: str) -> None:
    """Log an error."""
    _loggers.error(msg)
