"""Concurrence: all states at once."""

import threading
import time
import traceback
from typing import Any, Callable, Dict, Iterable, List, Mapping, Optional, Tuple, Union

from smach.container import Container
from smach.exceptions import InvalidStateError, InvalidTransitionError, InvalidUserCodeError
from smach.log import logerr, loginfo, logwarn
from smach.state import State
from smach.user_data import Remapper, UserData
from smach.util import is_shutdown

# How often a waiting concurrence checks whether the program ends; nothing else depends on it.
SHUTDOWN_POLL_S = 0.2
# How long states may take to end once the program ends.
SHUTDOWN_GRACE_S = 5.0

ChildOutcomes = Dict[str, Optional[str]]
ChildTerminationCallback = Callable[[ChildOutcomes], Union[bool, List[str]]]


class ConcurrentStateError(InvalidUserCodeError, InvalidStateError):
    """A state of a concurrence raised, returned an unknown outcome or did not end; it is invalid either way."""


class Concurrence(Container):
    """Container that runs all its states at once, each in a thread, and ends when all have ended.

    The outcome is the first that one of these gives: `outcome_cb`, `outcome_map`, `default_outcome`. When several
    entries of the map hold, the one that names most states decides, and of those the first. An empty entry never holds.

    Args:
        outcomes: outcomes of the container
        default_outcome: outcome if nothing else decides
        input_keys: userdata to copy in
        output_keys: userdata to copy out
        outcome_map: from an outcome to the outcomes that states, by label, must have had for it
        outcome_cb: called at the end with the outcomes by label, returns an outcome, or None to leave it to the map
        child_termination_cb: called when a state has ended, with the outcomes by label (None for those that run);
            returns True to preempt the states that still run, a list of labels to preempt only those, else False

    Raises:
        InvalidStateError: the default outcome or one of the map is not among the outcomes, or a callback cannot be
            called
    """

    def __init__(
        self,
        outcomes: Iterable[str],
        default_outcome: str,
        input_keys: Iterable[str] = (),
        output_keys: Iterable[str] = (),
        outcome_map: Optional[Mapping[str, Mapping[str, str]]] = None,
        outcome_cb: Optional[Callable[[ChildOutcomes], Optional[str]]] = None,
        child_termination_cb: Optional[ChildTerminationCallback] = None,
    ) -> None:
        Container.__init__(self, outcomes, input_keys, output_keys)
        self._outcome_map = {outcome: dict(children) for outcome, children in (outcome_map or {}).items()}
        registered = self.get_registered_outcomes()
        problems = [
            f"the outcome '{outcome}' is not registered: {sorted(registered)}"
            for outcome in (default_outcome, *self._outcome_map)
            if outcome not in registered
        ]
        problems += [
            f"the callback {callback!r} cannot be called"
            for callback in (outcome_cb, child_termination_cb)
            if callback is not None and not callable(callback)
        ]
        if problems:
            raise InvalidStateError("The concurrence is not described in a valid way: " + "; ".join(problems))
        self._default_outcome = default_outcome
        self._outcome_cb = outcome_cb
        self._child_termination_cb = child_termination_cb
        self._states: Dict[str, State] = {}
        self._remappings: Dict[str, Dict[str, str]] = {}
        self._outcomes_by_label: ChildOutcomes = {}
        self._threads: Dict[str, threading.Thread] = {}
        self._errors: Dict[str, BaseException] = {}

    def __getstate__(self) -> Dict[str, Any]:
        return {**super().__getstate__(), "_threads": {}}

    @staticmethod
    def add(label: str, state: State, remapping: Optional[Mapping[str, str]] = None) -> State:
        """Add a state to the concurrence that is open; it replaces the one that has its label.

        Raises:
            InvalidConstructionError: no concurrence is open
            InvalidStateError: `state` is no state
        """
        concurrence = Concurrence._currently_opened_container()
        concurrence._check_child(label, state, {})
        if label in concurrence._states:
            logwarn(f"The state '{label}' of the concurrence is replaced: its label was used already.")
        concurrence._states[label] = state
        concurrence._remappings[label] = dict(remapping or {})
        return state

    def check_consistency(self) -> None:
        """Check the outcome map.

        Raises:
            InvalidTransitionError: an outcome or a label in it is unknown
        """
        problems = [
            f"The map of '{outcome}' names the state '{label}', which is missing."
            for outcome, label in self._missing_states()
        ]
        for outcome, children in self._outcome_map.items():
            for label, child_outcome in children.items():
                if label in self._states and child_outcome not in self._states[label].get_registered_outcomes():
                    problems.append(f"State '{label}' in the map of '{outcome}' has no outcome '{child_outcome}'.")
        if problems:
            raise InvalidTransitionError("Concurrence failed consistency check: " + "\n\t".join(problems))

    def _missing_states(self) -> List[Tuple[str, str]]:
        """Outcomes of the map with the labels that they name and no state has."""
        return [
            (outcome, label)
            for outcome, children in self._outcome_map.items()
            for label in children
            if label not in self._states
        ]

    def execute(self, parent_ud: Any = None) -> Optional[str]:
        """Run all states and wait until they have ended.

        Returns:
            the outcome; None when the outcome map names a state that is missing, or the program shuts down and a state
            says so

        Raises:
            InvalidStateError: there is no state to run
            InvalidUserCodeError: a state or a callback raised; the other states are preempted and waited for
        """
        if not self._states:
            raise InvalidStateError("The concurrence holds no states.")
        if not self._is_consistent() and self._missing_states():
            return None
        self._copy_input_keys(parent_ud, self.userdata)
        with self._lock:
            self._outcomes_by_label = dict.fromkeys(self._states)
            self._errors = {}
            self._threads = {
                label: threading.Thread(target=self._run, args=(label,), name=f"concurrence_{label}", daemon=True)
                for label in self._states
            }
        with self._marked_as_running():
            try:
                return self._run_threads(parent_ud)
            finally:
                with self._lock:
                    self._end_preempt()

    def _run_threads(self, parent_ud: Any) -> Optional[str]:
        """Start the threads of the states, wait for them, and return the outcome; None when the program shuts down."""
        loginfo(f"Concurrence starting with userdata: {self.userdata.keys()}")
        self.call_start_cbs()
        with self._lock:
            if self._preempt_requested:
                self._preempt(list(self._states))
        for thread in self._threads.values():
            thread.start()
        self._join()
        if self._errors:
            reasons = "\n".join(f"State '{label}': {error}" for label, error in self._errors.items())
            raise ConcurrentStateError(f"A concurrent state failed.\n{reasons}")
        if None in self._outcomes_by_label.values():
            return None
        loginfo(f"Concurrent Outcomes: {self._outcomes_by_label}")
        outcome = self._decide()
        self._copy_output_keys(self.userdata, parent_ud)
        self.call_termination_cbs(list(self._states), outcome)
        return outcome

    def _run(self, label: str) -> None:
        """Thread of one state."""
        state = self._states[label]
        view = Remapper(
            self.userdata,
            state.get_registered_input_keys(),
            state.get_registered_output_keys(),
            self._remappings[label],
        )
        outcome: Optional[str] = None
        failure: Optional[Exception] = None
        try:
            outcome = state.execute(view)
            # Containers return None when the program ends.
            if outcome is None and not is_shutdown():
                failure = InvalidTransitionError("it returned no outcome")
            elif outcome is not None:
                loginfo(f"Concurrent state '{label}' returned outcome '{outcome}' on termination.")
                self._tell_unregistered(f"State '{label}' of the concurrence", outcome, state)
        except Exception as error:  # boundary: a state is code of the user
            failure = error
            logerr(f"Concurrent state '{label}' raised:\n{traceback.format_exc()}")
        with self._lock:
            self._outcomes_by_label[label] = outcome
            if failure is not None:
                self._errors[label] = failure
                # The concurrence fails in any case, so the other states need not go on.
                self._preempt(self.get_active_states())
                return
            outcomes = dict(self._outcomes_by_label)
        self.call_transition_cbs()
        if self._child_termination_cb is not None:
            self._ask_child_termination_cb(self._child_termination_cb, label, outcomes)

    def _ask_child_termination_cb(self, cb: ChildTerminationCallback, label: str, outcomes: ChildOutcomes) -> None:
        try:
            answer = cb(outcomes)
        except Exception as error:  # boundary: the callback is code of the user
            logerr(f"The child termination callback raised:\n{traceback.format_exc()}")
            with self._lock:
                self._errors[label] = InvalidUserCodeError(f"the child termination callback raised {error!r}")
                self._preempt(self.get_active_states())
            return
        if not answer:
            return
        with self._lock:
            active = self.get_active_states()
            self._preempt(active if answer is True else [name for name in active if name in answer])

    def _join(self) -> None:
        """Wait for every thread; once the program ends, ask the states to stop and wait no longer than the grace."""
        give_up_at = None
        for label, thread in self._threads.items():
            while thread.is_alive():
                thread.join(SHUTDOWN_POLL_S)
                if not is_shutdown():
                    continue
                if give_up_at is None:
                    give_up_at = time.monotonic() + SHUTDOWN_GRACE_S
                    with self._lock:
                        self._preempt(self.get_active_states())
                elif time.monotonic() > give_up_at:
                    self._errors[label] = InvalidUserCodeError("did not end when the program did")
                    break

    def _decide(self) -> str:
        """Outcome of the container from those of the states."""
        outcomes = dict(self._outcomes_by_label)
        if self._outcome_cb is not None:
            try:
                outcome = self._outcome_cb(dict(outcomes))
            except Exception as error:  # boundary: the callback is code of the user
                raise InvalidUserCodeError(f"The outcome callback raised:\n{traceback.format_exc()}") from error
            if outcome:
                self._tell_unregistered("The outcome callback of the concurrence", outcome, self)
                return outcome
        held = [
            outcome
            for outcome, children in self._outcome_map.items()
            if children and all(outcomes[label] == child_outcome for label, child_outcome in children.items())
        ]
        # max() takes the first of equals.
        return max(held, key=lambda outcome: len(self._outcome_map[outcome]), default=self._default_outcome)

    @staticmethod
    def _tell_unregistered(who: str, outcome: str, state: State) -> None:
        """Log an outcome that was not registered; it counts all the same."""
        registered = state.get_registered_outcomes()
        if outcome not in registered:
            logerr(f"{who} returned the outcome '{outcome}', which is not registered: {sorted(registered)}")

    def is_run_by_this_thread(self) -> bool:
        """Tell whether the thread that asks executes the concurrence or a state in it."""
        return threading.current_thread() in self._threads.values() or super().is_run_by_this_thread()

    # Preemption

    def request_preempt(self) -> None:
        """Ask every running state to stop."""
        with self._lock:
            self._preempt_requested = True
            if self._is_running:
                self._preempt(self.get_active_states())

    def _preempt(self, labels: Iterable[str]) -> None:
        """With the lock held: ask states to stop."""
        for label in labels:
            try:
                self._states[label].request_preempt()
            except Exception:  # boundary: a state is code of the user
                logerr(f"State '{label}' raised when it was asked to stop:\n{traceback.format_exc()}")

    def _end_preempt(self) -> None:
        """With the lock held: the request is serviced when no state left it open."""
        unserviced = [state for state in self._states.values() if state.preempt_requested()]
        for state in unserviced:
            state.recall_preempt()
        if not unserviced:
            self._preempt_requested = False

    # Introspection

    def get_children(self) -> Dict[str, State]:
        """States by label."""
        return self._states

    def set_initial_state(self, initial_states: List[str], userdata: Optional[UserData] = None) -> None:
        """Add values to the userdata; all states start, so their labels say nothing more.

        Raises:
            InvalidStateError: a label is unknown
        """
        unknown = [label for label in initial_states if label not in self._states]
        if unknown:
            raise InvalidStateError(f"The concurrence holds no states {unknown}.")
        if userdata is not None:
            self.userdata.update(userdata)

    def get_active_states(self) -> List[str]:
        """Labels of the states that have not ended; empty when the container does not run."""
        with self._lock:
            if not self._is_running:
                return []
            return [
                label
                for label, outcome in self._outcomes_by_label.items()
                if outcome is None and label not in self._errors
            ]

    def get_initial_states(self) -> List[str]:
        """Labels of all states."""
        return list(self._states)

    def get_internal_edges(self) -> List[Tuple[str, str, Optional[str]]]:
        """The outcome map as (outcome of a state, its label, outcome of the container)."""
        return [
            (child_outcome, label, outcome)
            for outcome, children in self._outcome_map.items()
            for label, child_outcome in children.items()
        ]
