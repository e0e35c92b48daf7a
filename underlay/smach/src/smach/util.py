"""Callbacks that declare their outcomes and keys, and the check for the end of the program."""

import functools
import inspect
from typing import Any, Callable, Iterable, Optional, Protocol, Tuple, runtime_checkable


class _ShutdownCheck:
    """Tells whether the program ends; the program has one end, so this is one object."""

    def __init__(self) -> None:
        self.check: Callable[[], bool] = lambda: False


_shutdown = _ShutdownCheck()


def set_shutdown_check(cb: Callable[[], bool]) -> None:
    """Set the function that tells whether the program ends; containers stop then."""
    _shutdown.check = cb


def is_shutdown() -> bool:
    """Tell whether the program ends, as far as the function given to set_shutdown_check knows."""
    return bool(_shutdown.check())


@runtime_checkable
class SmachInterface(Protocol):
    """What declares input keys, output keys and outcomes as a state does."""

    def get_registered_input_keys(self) -> Iterable[str]:
        """Keys that are read."""

    def get_registered_output_keys(self) -> Iterable[str]:
        """Keys that are written."""

    def get_registered_outcomes(self) -> Iterable[str]:
        """Outcomes that may be returned."""


def has_smach_interface(obj: Any) -> bool:
    """Tell whether an object declares input keys, output keys and outcomes as a state does."""
    return isinstance(obj, SmachInterface)


def _is_method(function: Callable[..., Any]) -> bool:
    """Tell whether a function is written to be called with the instance of its class."""
    try:
        return next(iter(inspect.signature(function).parameters), None) == "self"
    except (TypeError, ValueError):
        # Some functions written in C do not tell their parameters.
        return False


class CBInterface:
    """A callback together with the outcomes it may return and the userdata keys it reads and writes.

    Calls go to the callback unchanged. As an attribute of a class it binds to the instance when its first parameter is
    called `self`, like a method. Any other function is called as it is written, without the instance.
    """

    def __init__(
        self,
        cb: Callable[..., Any],
        outcomes: Optional[Iterable[str]] = None,
        input_keys: Optional[Iterable[str]] = None,
        output_keys: Optional[Iterable[str]] = None,
        io_keys: Optional[Iterable[str]] = None,
    ) -> None:
        self._cb = cb
        self._outcomes = tuple(outcomes or ())
        self._input_keys = tuple(input_keys or ()) + tuple(io_keys or ())
        self._output_keys = tuple(output_keys or ()) + tuple(io_keys or ())
        functools.update_wrapper(self, cb)

    def __call__(self, *args: Any, **kwargs: Any) -> Any:
        return self._cb(*args, **kwargs)

    def __get__(self, instance: Any, owner: Any = None) -> "CBInterface":
        if not (isinstance(self._cb, (staticmethod, classmethod)) or (instance is not None and _is_method(self._cb))):
            return self
        bound = self._cb.__get__(instance, owner)
        return CBInterface(bound, self._outcomes, self._input_keys, self._output_keys)

    def get_registered_outcomes(self) -> Tuple[str, ...]:
        """Outcomes that the callback may return."""
        return self._outcomes

    def get_registered_input_keys(self) -> Tuple[str, ...]:
        """Userdata keys that the callback reads."""
        return self._input_keys

    def get_registered_output_keys(self) -> Tuple[str, ...]:
        """Userdata keys that the callback writes."""
        return self._output_keys


class cb_interface:  # noqa: N801 (the documented name of the decorator)
    """Decorator that gives a callback its outcomes and keys; see CBInterface."""

    def __init__(
        self,
        outcomes: Optional[Iterable[str]] = None,
        input_keys: Optional[Iterable[str]] = None,
        output_keys: Optional[Iterable[str]] = None,
        io_keys: Optional[Iterable[str]] = None,
    ) -> None:
        self._declared = {
            "outcomes": tuple(outcomes or ()),
            "input_keys": tuple(input_keys or ()),
            "output_keys": tuple(output_keys or ()),
            "io_keys": tuple(io_keys or ()),
        }

    def __call__(self, cb: Callable[..., Any]) -> CBInterface:
        return CBInterface(cb, **self._declared)
