"""State: something that runs once and ends with one of its outcomes."""

from typing import Any, Callable, Iterable, Mapping, Optional, Tuple

from smach.util import SmachInterface


class State:
    """Base of every state.

    Args:
        outcomes: what `execute` may return
        input_keys: userdata that the state reads
        output_keys: userdata that the state writes
        io_keys: userdata that the state reads and writes
    """

    def __init__(
        self,
        outcomes: Iterable[str] = (),
        input_keys: Iterable[str] = (),
        output_keys: Iterable[str] = (),
        io_keys: Iterable[str] = (),
    ) -> None:
        # Dictionaries keep the order in which the user named things; the values do not matter.
        self._outcomes = dict.fromkeys(outcomes)
        self._input_keys = dict.fromkeys(input_keys)
        self._output_keys = dict.fromkeys(output_keys)
        self.register_io_keys(io_keys)
        self._preempt_requested = False

    def execute(self, ud: Any) -> Optional[str]:
        """Do the work and return an outcome; a subclass says how.

        Args:
            ud: userdata with the declared keys

        Returns:
            one of the outcomes; None from a container that could not run or whose program ends
        """
        raise NotImplementedError(f"{type(self).__name__} does not say what it executes")

    def register_outcomes(self, new_outcomes: Iterable[str]) -> None:
        """Add outcomes."""
        self._outcomes.update(dict.fromkeys(new_outcomes))

    def get_registered_outcomes(self) -> Tuple[str, ...]:
        """Outcomes that the state may end with."""
        return tuple(self._outcomes)

    def register_io_keys(self, keys: Iterable[str]) -> None:
        """Add keys that are read and written."""
        keys = tuple(keys)
        self.register_input_keys(keys)
        self.register_output_keys(keys)

    def register_input_keys(self, keys: Iterable[str]) -> None:
        """Add keys that are read."""
        self._input_keys.update(dict.fromkeys(keys))

    def get_registered_input_keys(self) -> Tuple[str, ...]:
        """Keys that the state reads."""
        return tuple(self._input_keys)

    def register_output_keys(self, keys: Iterable[str]) -> None:
        """Add keys that are written."""
        self._output_keys.update(dict.fromkeys(keys))

    def get_registered_output_keys(self) -> Tuple[str, ...]:
        """Keys that the state writes."""
        return tuple(self._output_keys)

    def request_preempt(self) -> None:
        """Ask the state to stop early. It stays asked until service_preempt or recall_preempt."""
        self._preempt_requested = True

    def service_preempt(self) -> None:
        """Say, from inside the state, that it stops because it was asked to."""
        self._preempt_requested = False

    def recall_preempt(self) -> None:
        """Take the request back, from outside the state."""
        self._preempt_requested = False

    def preempt_requested(self) -> bool:
        """Tell whether the state was asked to stop early and did not answer yet."""
        return self._preempt_requested


class CBState(State):
    """A state that calls a function.

    The outcomes and keys that the function declares (see cb_interface) are added to the given ones.

    Args:
        cb: called with the userdata and the arguments below, returns an outcome
        cb_args: more positional arguments
        cb_kwargs: more keyword arguments
    """

    def __init__(
        self,
        cb: Callable[..., str],
        cb_args: Iterable[Any] = (),
        cb_kwargs: Optional[Mapping[str, Any]] = None,
        outcomes: Iterable[str] = (),
        input_keys: Iterable[str] = (),
        output_keys: Iterable[str] = (),
        io_keys: Iterable[str] = (),
    ) -> None:
        State.__init__(self, outcomes, input_keys, output_keys, io_keys)
        self._cb = cb
        self._cb_args = tuple(cb_args)
        self._cb_kwargs = dict(cb_kwargs or {})
        if isinstance(cb, SmachInterface):
            self.register_outcomes(cb.get_registered_outcomes())
            self.register_input_keys(cb.get_registered_input_keys())
            self.register_output_keys(cb.get_registered_output_keys())

    def execute(self, ud: Any) -> str:
        """Call the function."""
        return self._cb(ud, *self._cb_args, **self._cb_kwargs)
