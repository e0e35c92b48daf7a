"""Container: a state that holds other states."""

import contextlib
import threading
import traceback
from typing import Any, Callable, Dict, Iterable, Iterator, List, Optional, Tuple

from smach.exceptions import InvalidConstructionError, InvalidStateError
from smach.log import logerr, logwarn
from smach.state import State
from smach.user_data import UserData

# What containers call; an object that has these is a state, whatever its class.
_METHODS_OF_STATES = (
    "execute",
    "get_registered_outcomes",
    "get_registered_input_keys",
    "get_registered_output_keys",
    "request_preempt",
    "recall_preempt",
    "preempt_requested",
)


# Each thread builds its own containers: `with` blocks of two threads do not see each other.
class _Construction(threading.local):
    """The containers that a thread has open, the innermost last."""

    def __init__(self) -> None:
        self.stack: List[Container] = []


_construction = _Construction()


def _opened_containers() -> List["Container"]:
    """Containers that this thread has open, the innermost last."""
    return _construction.stack


class Container(State):
    """Base of the states that hold other states.

    States are added between open() and close(), best in a `with` block. Each container has userdata of its own, into
    which its input keys are copied when it starts and from which its output keys are copied when it ends.
    """

    def __init__(
        self,
        outcomes: Iterable[str] = (),
        input_keys: Iterable[str] = (),
        output_keys: Iterable[str] = (),
        io_keys: Iterable[str] = (),
    ) -> None:
        # Not super(): programs call the constructor of a container with a state that is none, as SMACH allows.
        State.__init__(self, outcomes, input_keys, output_keys, io_keys)
        self.userdata = UserData()
        # Guards what request_preempt, introspection and the running thread share. Reentrant: callbacks of the user
        # run in it and may ask the container about itself.
        self._lock = threading.RLock()
        self._is_running = False
        self._running_thread: Optional[int] = None
        self._start_cbs: List[Tuple[Callable[..., Any], Tuple[Any, ...]]] = []
        self._transition_cbs: List[Tuple[Callable[..., Any], Tuple[Any, ...]]] = []
        self._termination_cbs: List[Tuple[Callable[..., Any], Tuple[Any, ...]]] = []

    def __getstate__(self) -> Dict[str, Any]:
        return {name: value for name, value in self.__dict__.items() if name != "_lock"}

    def __setstate__(self, state: Dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._lock = threading.RLock()

    # Userdata

    def _copy_input_keys(self, parent_ud: Any, ud: UserData) -> None:
        if parent_ud is None:
            return
        for key in self.get_registered_input_keys():
            try:
                ud[key] = parent_ud[key]
            except KeyError:
                logwarn(f"Input key '{key}' has no value in the userdata that the container was started with.")

    def _copy_output_keys(self, ud: UserData, parent_ud: Any) -> None:
        if parent_ud is None:
            return
        for key in self.get_registered_output_keys():
            try:
                parent_ud[key] = ud[key]
            except KeyError:
                logwarn(f"Output key '{key}' has no value at the end of the container.")

    # Callbacks

    def register_start_cb(self, start_cb: Callable[..., Any], cb_args: Iterable[Any] = ()) -> None:
        """Have `start_cb(userdata, initial_states, *cb_args)` called when the container starts."""
        self._start_cbs.append((start_cb, tuple(cb_args)))

    def register_transition_cb(self, transition_cb: Callable[..., Any], cb_args: Iterable[Any] = ()) -> None:
        """Have `transition_cb(userdata, active_states, *cb_args)` called after each transition."""
        self._transition_cbs.append((transition_cb, tuple(cb_args)))

    def register_termination_cb(self, termination_cb: Callable[..., Any], cb_args: Iterable[Any] = ()) -> None:
        """Have `termination_cb(userdata, terminal_states, container_outcome, *cb_args)` called at the end."""
        self._termination_cbs.append((termination_cb, tuple(cb_args)))

    def _call(self, kind: str, callbacks: List[Tuple[Callable[..., Any], Tuple[Any, ...]]], *args: Any) -> None:
        for callback, callback_args in list(callbacks):
            try:
                callback(self.userdata, *args, *callback_args)
            except Exception:  # boundary: an observer must not be able to stop a container
                logerr(f"A {kind} callback of the container raised:\n{traceback.format_exc()}")

    def call_start_cbs(self) -> None:
        """Call the start callbacks; one that raises is logged."""
        self._call("start", self._start_cbs, self.get_initial_states())

    def call_transition_cbs(self) -> None:
        """Call the transition callbacks; one that raises is logged."""
        self._call("transition", self._transition_cbs, self.get_active_states())

    def call_termination_cbs(self, terminal_states: List[str], outcome: Optional[str]) -> None:
        """Call the termination callbacks; one that raises is logged."""
        self._call("termination", self._termination_cbs, terminal_states, outcome)

    # What a subclass offers for introspection

    def get_children(self) -> Dict[str, State]:
        """Contained states by label."""
        raise NotImplementedError

    def __getitem__(self, key: str) -> State:
        """Contained state with that label."""
        return self.get_children()[key]

    def set_initial_state(self, initial_states: List[str], userdata: Optional[UserData] = None) -> None:
        """Choose where the container starts next time, and add values to its userdata."""
        raise NotImplementedError

    def get_initial_states(self) -> List[str]:
        """Labels of the states that the container starts with."""
        raise NotImplementedError

    def get_active_states(self) -> List[str]:
        """Labels of the states that run now."""
        raise NotImplementedError

    def get_internal_edges(self) -> List[Tuple[str, str, Optional[str]]]:
        """Transitions as (outcome, label of the state, label of the next state or outcome of the container).

        The target is None where the outcome of the state becomes the outcome of the container.
        """
        raise NotImplementedError

    def check_consistency(self) -> None:
        """Check that the container can run.

        Raises:
            InvalidStateError: it cannot; the text says why
        """
        raise NotImplementedError

    def is_running(self) -> bool:
        """Tell whether the container executes now."""
        return self._is_running

    def is_run_by_this_thread(self) -> bool:
        """Tell whether the thread that asks executes the container or a state in it: it must not wait for the end."""
        if self._running_thread == threading.get_ident():
            return True
        children = self.get_children().values() if self._is_running else ()
        return any(isinstance(child, Container) and child.is_run_by_this_thread() for child in children)

    @contextlib.contextmanager
    def _marked_as_running(self) -> Iterator[None]:
        """Mark the container as running; the lock is free inside."""
        with self._lock:
            self._is_running = True
            self._running_thread = threading.get_ident()
        try:
            yield
        finally:
            with self._lock:
                self._is_running = False
                self._running_thread = None

    # Construction

    def open(self) -> None:
        """Open the container, so that states can be added by this thread; each open() needs a close()."""
        _opened_containers().append(self)

    def close(self) -> None:
        """Close the container; the last close() checks it. What is wrong is logged, and found again by `execute`.

        Raises:
            InvalidConstructionError: it is not the container that this thread opened last
        """
        opened = _opened_containers()
        if not opened or opened[-1] is not self:
            raise InvalidConstructionError("Closing a container that is not the one opened last.")
        opened.pop()
        if not self.is_opened():
            self._is_consistent()

    def _is_consistent(self) -> bool:
        """Check the container and log what is wrong."""
        try:
            self.check_consistency()
        except InvalidStateError as error:
            logerr(f"{type(error).__name__}: {error}")
            logerr("Container consistency check failed.")
            return False
        return True

    def is_opened(self) -> bool:
        """Tell whether this thread has the container open."""
        return any(container is self for container in _opened_containers())

    def assert_opened(self, msg: str = "") -> None:
        """Raise InvalidConstructionError unless this thread has the container open."""
        if not self.is_opened():
            raise InvalidConstructionError(msg or "The container is not open.")

    @contextlib.contextmanager
    def opened(self, **kwargs: Any) -> Iterator["Container"]:
        """Open the container for a `with` block; it stays open behind it if it was open before.

        Args:
            kwargs: accepted for programs that give them; they mean nothing
        """
        with self:
            yield self

    def __enter__(self) -> "Container":
        self.open()
        return self

    def __exit__(self, exc_type: Any, exc_value: Any, exc_traceback: Any) -> None:
        if exc_type is None:
            self.close()
        else:
            # The container is incomplete because of this error, so report the error and not what is missing.
            opened = _opened_containers()
            while opened and opened.pop() is not self:
                pass

    @classmethod
    def _currently_opened_container(cls) -> Any:
        """Container that this thread opened last.

        Raises:
            InvalidConstructionError: none is open, or it is of another type than the one asked
        """
        opened = _opened_containers()
        if not opened:
            raise InvalidConstructionError(
                f"No container is open in this thread: call {cls.__name__}'s class methods in its `with` block."
            )
        if not isinstance(opened[-1], cls):
            raise InvalidConstructionError(
                f"The container that is open is a {type(opened[-1]).__name__}, not a {cls.__name__}."
            )
        return opened[-1]

    @classmethod
    def _check_child(cls, label: str, state: Any, children: Dict[str, State]) -> None:
        """Raise InvalidStateError for a child that cannot be added."""
        if label in children:
            raise InvalidStateError(f"The label '{label}' is used already in this container.")
        if not all(callable(getattr(state, name, None)) for name in _METHODS_OF_STATES):
            raise InvalidStateError(f"'{label}' is not a state but {state!r}.")
