"""Logging of SMACH: the standard logger "smach", or functions that the user sets."""

import logging
from typing import Any, Callable

_LOGGER = logging.getLogger("smach")

LogFunction = Callable[..., Any]


def _info(msg: Any, *args: Any) -> None:
    """Log to the standard logger; print when the program has not set up logging, which would drop the message."""
    if _LOGGER.hasHandlers():
        _LOGGER.info(msg, *args)
    else:
        print(str(msg) % args if args else msg, flush=True)


class _Loggers:
    """The four functions in use; the program has one log, so this is one object."""

    def __init__(self) -> None:
        self.info: LogFunction = _info
        self.warn: LogFunction = _LOGGER.warning
        self.debug: LogFunction = _LOGGER.debug
        self.error: LogFunction = _LOGGER.error


_loggers = _Loggers()


def set_loggers(info: LogFunction, warn: LogFunction, debug: LogFunction, error: LogFunction) -> None:
    """Send the messages of SMACH to other functions.

    SMACH calls each with one text. What a program gives to loginfo() and the others goes to them unchanged.
    """
    _loggers.info, _loggers.warn, _loggers.debug, _loggers.error = info, warn, debug, error


# A percent sign in a message must not be taken for a format by a logger that accepts arguments: without arguments
# each gets the text alone, which leaves it as it is.
def loginfo(msg: Any, *args: Any, **kwargs: Any) -> None:
    """Log normal progress; the logger formats the message with the arguments, if there are any."""
    _loggers.info(msg, *args, **kwargs)


def logwarn(msg: Any, *args: Any, **kwargs: Any) -> None:
    """Log a possible mistake."""
    _loggers.warn(msg, *args, **kwargs)


def logdebug(msg: Any, *args: Any, **kwargs: Any) -> None:
    """Log detail for debugging."""
    _loggers.debug(msg, *args, **kwargs)


def logerr(msg: Any, *args: Any, **kwargs: Any) -> None:
    """Log an error."""
    _loggers.error(msg, *args, **kwargs)
