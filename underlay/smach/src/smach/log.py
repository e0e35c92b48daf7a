"""Logging of SMACH: the standard logger "smach", or functions that the user sets."""

import logging
import sys
from typing import Any, Callable, Optional

_LOGGER = logging.getLogger("smach")

LogFunction = Callable[..., Any]


def _is_for_files_alone() -> bool:
    """Whether no handler but those of files gets what is logged: ROS sets up such a log for a node, and no screen."""
    logger: Optional[logging.Logger] = _LOGGER
    while logger is not None:
        if any(not isinstance(handler, logging.FileHandler) for handler in logger.handlers):
            return False
        logger = logger.parent if logger.propagate else None
    return True


def _log(level: int, msg: Any, *args: Any) -> None:
    """Log to the standard logger, and print what nobody would see: a program may have no log, or one in files alone."""
    if _LOGGER.hasHandlers():
        _LOGGER.log(level, msg, *args)
    if level >= logging.INFO and _is_for_files_alone():
        print(str(msg) % args if args else msg, flush=True, file=sys.stdout if level == logging.INFO else sys.stderr)


def _info(msg: Any, *args: Any) -> None:
    _log(logging.INFO, msg, *args)


def _warn(msg: Any, *args: Any) -> None:
    _log(logging.WARNING, msg, *args)


def _error(msg: Any, *args: Any) -> None:
    _log(logging.ERROR, msg, *args)


class _Loggers:
    """The four functions in use; the program has one log, so this is one object."""

    def __init__(self) -> None:
        self.info: LogFunction = _info
        self.warn: LogFunction = _warn
        self.debug: LogFunction = _LOGGER.debug
        self.error: LogFunction = _error


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
