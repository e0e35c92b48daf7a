"""Converts between userdata and messages, for action states and service states."""

import copy
import traceback
from typing import Any, Callable, Dict, Iterable, Mapping, Optional, Tuple

import genpy

import smach


class _MessageCallback:
    """A function of the user, and its arguments after those of the state."""

    def __init__(
        self,
        what: str,
        callback: Optional[Callable[..., Any]],
        args: Iterable[Any],
        kwargs: Optional[Mapping[str, Any]],
    ) -> None:
        self._what = what
        self._callback = callback
        self._args: Tuple[Any, ...] = tuple(args or ())
        self._kwargs: Dict[str, Any] = dict(kwargs or {})
        if callback is not None and not callable(callback):
            raise smach.InvalidStateError(f"The {what} callback cannot be called: {callback!r}")

    def register(self, state: smach.State, *, with_outcomes: bool) -> None:
        """Add the keys that the function declares (see smach.cb_interface) to the state, and its outcomes if wanted."""
        if smach.has_smach_interface(self._callback):
            if with_outcomes:
                state.register_outcomes(self._callback.get_registered_outcomes())
            state.register_input_keys(self._callback.get_registered_input_keys())
            state.register_output_keys(self._callback.get_registered_output_keys())

    def __call__(self, *args: Any) -> Any:
        if self._callback is None:
            return None
        try:
            return self._callback(*args, *self._args, **self._kwargs)
        except Exception as error:  # boundary: the callback is code of the user
            raise smach.InvalidUserCodeError(f"The {self._what} callback raised:\n{traceback.format_exc()}") from error


def _check_fields(what: str, message_class: type, fields: Iterable[str]) -> Tuple[str, ...]:
    """Return the fields, or raise InvalidStateError when the message has not all of them."""
    fields = tuple(fields or ())
    unknown = [field for field in fields if field not in message_class.__slots__]
    if unknown:
        raise smach.InvalidStateError(
            f"The {what} of type {message_class._type} has no fields {unknown}; its fields "
            f"are: {list(message_class.__slots__)}"
        )
    return fields


class MessageSource:
    """Builds the message that a state sends.

    It starts as a copy of the fixed message, or as an empty one; a message in the userdata replaces it, fields in the
    userdata are filled in, and last the callback changes it or returns another one.

    Args:
        what: what the message is, for errors: goal, request
        message_class: its class
        message: the fixed message, None for an empty one
        key: userdata key of a whole message, None for none
        fields: names of fields, which are keys of the userdata too
        callback: called with the userdata, the message and the arguments below; returns a message, or None when it
            changed the one it got
        args: more positional arguments
        kwargs: more keyword arguments
        takes_values: whether the value of the only field may be given in place of a message, as services of rospy do

    Raises:
        InvalidStateError: the message is of another class, a field is unknown, or the callback cannot be called
    """

    def __init__(
        self,
        what: str,
        message_class: type,
        message: Any,
        key: Optional[str],
        fields: Iterable[str],
        callback: Optional[Callable[..., Any]],
        args: Iterable[Any],
        kwargs: Optional[Mapping[str, Any]],
        *,
        takes_values: bool = False,
    ) -> None:
        self._what = what
        self._class = message_class
        self._takes_values = takes_values
        try:
            self._message = message_class() if message is None else copy.deepcopy(self._converted(message))
        except TypeError as error:
            hint = f"; a function is given as {what}_cb" if callable(message) else ""
            raise smach.InvalidStateError(
                f"The {what} has to be of type {message_class._type}, not {type(message).__name__}{hint}."
            ) from error
        self._key = key
        self._fields = _check_fields(what, message_class, fields)
        self._callback = _MessageCallback(what, callback, args, kwargs)

    def register(self, state: smach.State) -> None:
        """Add the keys that are read, and those that the callback declares, to the state."""
        state.register_input_keys(([] if self._key is None else [self._key]) + list(self._fields))
        # It makes a message; what it returns is no outcome.
        self._callback.register(state, with_outcomes=False)

    def build(self, userdata: Any) -> Any:
        """Return a message of its own for this run.

        Raises:
            InvalidUserCodeError: the userdata holds no value, the userdata or the callback gave something else than a
                message of the class, or the callback raised
        """
        # Copies, because the callback may change the message, and neither the next run nor the userdata may see that.
        message = copy.deepcopy(self._message)
        if self._key is not None:
            message = self._checked(copy.deepcopy(_value(userdata, self._key)), f"userdata key '{self._key}'")
        for field in self._fields:
            setattr(message, field, copy.deepcopy(_value(userdata, field)))
        returned = self._callback(userdata, message)
        return message if returned is None else self._checked(returned, "callback")

    def _checked(self, given: Any, origin: str) -> Any:
        try:
            return self._converted(given)
        except TypeError as error:
            raise smach.InvalidUserCodeError(
                f"The {origin} gave a {type(given).__name__} as {self._what}, which has "
                f"to be of type {self._class._type}."
            ) from error

    def _converted(self, given: Any) -> Any:
        """The message, or one whose only field has the value given; TypeError when it is neither."""
        if isinstance(given, self._class):
            return given
        types = self._class._slot_types if self._takes_values else []
        if len(types) != 1 or callable(given) or (isinstance(given, genpy.Message) and given._type != types[0]):
            raise TypeError(given)
        return self._class(given)


def _value(userdata: Any, key: str) -> Any:
    try:
        return userdata[key]
    except KeyError as error:
        raise smach.InvalidUserCodeError(str(error)) from error


class MessageSink:
    """Stores the message that a state received where the user wants it.

    The callback comes first; then the message, and fields of it, are written to the userdata.

    Args:
        what: what the message is, for errors: result, response
        message_class: its class
        key: userdata key of the whole message, None for none
        fields: names of fields, which are keys of the userdata too
        callback: called with the userdata, what the state adds, the message and the arguments below; returns an
            outcome, or None to leave it to the state
        args: more positional arguments
        kwargs: more keyword arguments

    Raises:
        InvalidStateError: a field is unknown, or the callback cannot be called
    """

    def __init__(
        self,
        what: str,
        message_class: type,
        key: Optional[str],
        fields: Iterable[str],
        callback: Optional[Callable[..., Any]],
        args: Iterable[Any],
        kwargs: Optional[Mapping[str, Any]],
    ) -> None:
        self._what = what
        self._key = key
        self._fields = _check_fields(what, message_class, fields)
        self._callback = _MessageCallback(what, callback, args, kwargs)

    def register(self, state: smach.State) -> None:
        """Add the keys that are written, and what the callback declares, to the state."""
        state.register_output_keys(([] if self._key is None else [self._key]) + list(self._fields))
        self._callback.register(state, with_outcomes=True)

    def store(self, state: smach.State, userdata: Any, *args: Any) -> Optional[str]:
        """Take a message, the last of `args`, and return the outcome that the callback chose, or None.

        Without a message (None), the callback is called and nothing is written.

        Raises:
            InvalidUserCodeError: the callback raised, or returned no outcome of the state
        """
        outcome = self._callback(userdata, *args)
        if outcome is not None and outcome not in state.get_registered_outcomes():
            raise smach.InvalidUserCodeError(
                f"The {self._what} callback returned '{outcome}', which is not registered as an outcome: "
                f"{sorted(state.get_registered_outcomes())}"
            )
        message = args[-1]
        if message is None:
            return outcome
        if self._key is not None:
            userdata[self._key] = message
        for field in self._fields:
            userdata[field] = getattr(message, field)
        return outcome
