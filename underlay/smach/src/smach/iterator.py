"""Iterator: one state, once for each item."""

import traceback
from typing import Any, Callable, Dict, Iterable, List, Mapping, Optional, Tuple, Union

from smach.container import Container
from smach.exceptions import InvalidStateError, InvalidTransitionError, InvalidUserCodeError
from smach.log import logerr, loginfo
from smach.state import State
from smach.user_data import UserData
from smach.util import is_shutdown

# Outcome of an iterator that is preempted between two items, if it has that outcome.
_PREEMPTED = "preempted"

Items = Union[Iterable[Any], Callable[[], Iterable[Any]]]


class Iterator(Container):
    """Container that runs one state for each of some items.

    The state gets the userdata of the iterator itself, with the item in it: its keys need no declaration.

    Args:
        outcomes: outcomes of the iterator; the exhausted outcome is added
        input_keys: userdata to copy in
        output_keys: userdata to copy out
        it: the items, or a function that returns them, called at each start
        it_label: userdata key under which the state finds the item
        exhausted_outcome: outcome when there are no more items
    """

    def __init__(
        self,
        outcomes: Iterable[str],
        input_keys: Iterable[str],
        output_keys: Iterable[str],
        it: Items = (),
        it_label: str = "it_data",
        exhausted_outcome: str = "exhausted",
    ) -> None:
        Container.__init__(self, outcomes, input_keys, output_keys)
        self.register_outcomes([exhausted_outcome])
        self._items = it
        self._items_label = it_label
        self._exhausted_outcome = exhausted_outcome
        self._label = ""
        self._state: Optional[State] = None
        self._loop_outcomes: Tuple[str, ...] = ()
        self._break_outcomes: Tuple[str, ...] = ()
        self._final_outcome_map: Dict[str, str] = {}

    @staticmethod
    def set_iteritems(it: Items, it_label: str = "it_data") -> None:
        """Set the items of the iterator that is open, or the function that returns them, and the key of the item.

        A callback may do this for the next run: `with iterator: Iterator.set_iteritems(items, "item")`.
        """
        iterator = Iterator._currently_opened_container()
        iterator._items, iterator._items_label = it, it_label

    @staticmethod
    def set_contained_state(
        label: str,
        state: State,
        loop_outcomes: Iterable[str] = (),
        break_outcomes: Iterable[str] = (),
        final_outcome_map: Optional[Mapping[str, str]] = None,
    ) -> None:
        """Set the state of the iterator that is open.

        Args:
            label: its name in the iterator
            state: what runs for each item
            loop_outcomes: outcomes that lead to the next item; when given, every other outcome ends the iteration
            break_outcomes: outcomes that end the iteration; when given, every other outcome leads to the next item
            final_outcome_map: from the outcome that ended the iteration to the outcome of the iterator
        """
        iterator = Iterator._currently_opened_container()
        iterator._check_child(label, state, {})
        iterator._label, iterator._state = label, state
        iterator._loop_outcomes = tuple(loop_outcomes)
        iterator._break_outcomes = tuple(break_outcomes)
        iterator._final_outcome_map = dict(final_outcome_map or {})

    def check_consistency(self) -> None:
        """Check that there is a state and that the outcomes named for it are its own.

        Raises:
            InvalidStateError: there is no state
            InvalidTransitionError: an outcome is not one of the state
        """
        if self._state is None:
            raise InvalidStateError("Iterator failed consistency check: no state is contained.")
        registered = self._state.get_registered_outcomes()
        unknown = sorted(set(self._loop_outcomes + self._break_outcomes).difference(registered))
        if unknown:
            raise InvalidTransitionError(
                f"Iterator failed consistency check: state '{self._label}' has no outcomes {unknown}; its outcomes "
                f"are: {sorted(registered)}"
            )

    def _ends(self, outcome: str) -> bool:
        if self._break_outcomes:
            return outcome in self._break_outcomes
        return bool(self._loop_outcomes) and outcome not in self._loop_outcomes

    def execute(self, parent_ud: Any = None) -> Optional[str]:
        """Run the state for each item.

        Returns:
            the outcome; None when the iterator is not consistent or the program shuts down

        Raises:
            InvalidUserCodeError: the state or the items raised
            InvalidTransitionError: the state returned an outcome that it did not register, or the iteration ended with
                one that is not an outcome of the iterator
        """
        if not self._is_consistent() or self._state is None:
            return None
        with self._marked_as_running():
            self._copy_input_keys(parent_ud, self.userdata)
            self.call_start_cbs()
            outcome = self._iterate(self._state)
            self._copy_output_keys(self.userdata, parent_ud)
            if outcome is not None:
                self.call_termination_cbs([self._label], outcome)
            return outcome

    def _next_items(self) -> Iterable[Any]:
        """The items, with an error of the user's code told as such."""
        try:
            yield from (self._items() if callable(self._items) else self._items)
        except Exception as error:  # boundary: the items come from code of the user
            raise InvalidUserCodeError(f"The items of the iterator raised:\n{traceback.format_exc()}") from error

    def _final(self, outcome: str) -> str:
        """Outcome of the iterator for the outcome that ended the iteration."""
        return self._final_outcome_map.get(outcome, outcome)

    def _end(self, outcome: str) -> str:
        """Outcome of the iterator, as _final(); InvalidTransitionError when the iterator has no such outcome."""
        final = self._final(outcome)
        if final not in self.get_registered_outcomes():
            raise InvalidTransitionError(
                f"The iteration of '{self._label}' ended with '{final}', which is no "
                f"outcome of the iterator: {sorted(self.get_registered_outcomes())}"
            )
        return final

    def _preempted_end(self, outcome: str) -> str:
        """Outcome of the iterator when its state serviced a request to stop and gave an outcome for the next item."""
        registered = self.get_registered_outcomes()
        final = self._final(outcome)
        if final in registered or _PREEMPTED not in registered:
            # A machine around the iterator refuses an outcome that the iterator does not have.
            return final
        return _PREEMPTED

    def _iterate(self, state: State) -> Optional[str]:
        """Outcome of the iterator, or None when the program shuts down."""
        for item in self._next_items():
            if is_shutdown():
                return None
            self.userdata[self._items_label] = item
            loginfo(f"Iterator runs '{self._label}' for {item!r}")
            with self._lock:
                # A request between two items went to the state that had just ended.
                state.recall_preempt()
                if self._preempt_requested:
                    state.request_preempt()
            outcome = self._execute_child(state)
            if outcome is None:
                return None
            with self._lock:
                is_serviced = self._preempt_requested and not state.preempt_requested()
                state.recall_preempt()
                # The state may leave a request open; an iterator that can say so stops between two items.
                stops_here = self._preempt_requested and _PREEMPTED in self.get_registered_outcomes()
                if is_serviced or (stops_here and not self._ends(outcome)):
                    self._preempt_requested = False
            if self._ends(outcome):
                return self._end(outcome)
            if is_serviced:
                return self._preempted_end(outcome)
            if stops_here:
                return _PREEMPTED
            self.call_transition_cbs()
        return self._end(self._exhausted_outcome)

    def _execute_child(self, state: State) -> Optional[str]:
        try:
            # The userdata itself, unlike in other containers: so programs that declare no keys here run.
            outcome = state.execute(self.userdata)
        except InvalidUserCodeError:
            logerr(f"State '{self._label}' failed to execute.")
            raise
        except Exception as error:  # boundary: a state is code of the user
            raise InvalidUserCodeError(
                f"State '{self._label}' of type {type(state).__name__} raised:\n{traceback.format_exc()}"
            ) from error
        if outcome is None and is_shutdown():
            return None
        if outcome not in state.get_registered_outcomes():
            raise InvalidTransitionError(
                f"State '{self._label}' ended with the outcome '{outcome}', which is not "
                f"registered: {sorted(state.get_registered_outcomes())}"
            )
        return outcome

    def request_preempt(self) -> None:
        """Ask the state to stop; the iteration ends with the outcome with which the state services the request.

        When the state does not service it and its outcome leads to the next item, an iterator with the outcome
        preempted ends with that; any other asks the state again before the next item.
        """
        with self._lock:
            self._preempt_requested = True
            if self._is_running and self._state is not None:
                self._state.request_preempt()

    def get_children(self) -> Dict[str, State]:
        """The one state by its label."""
        return {} if self._state is None else {self._label: self._state}

    def set_initial_state(self, initial_states: List[str], userdata: Optional[UserData] = None) -> None:
        """Add values to the userdata; there is one state to start with.

        Raises:
            InvalidStateError: another label is named
        """
        if any(label != self._label for label in initial_states):
            raise InvalidStateError(f"The iterator holds '{self._label}', not {initial_states}.")
        if userdata is not None:
            self.userdata.update(userdata)

    def get_active_states(self) -> List[str]:
        """Label of the state while the iterator runs, in a list."""
        return [self._label] if self._is_running else []

    def get_initial_states(self) -> List[str]:
        """Label of the state, in a list."""
        return list(self.get_children())

    def get_internal_edges(self) -> List[Tuple[str, str, Optional[str]]]:
        """Transitions as (outcome, label of the state, label of the state or outcome of the iterator).

        The target is None where the outcome of the state becomes the outcome of the iterator. An iterator that has no
        more items ends by no outcome of the state, so that is no transition.
        """
        if self._state is None:
            return []
        edges: List[Tuple[str, str, Optional[str]]] = []
        for outcome in self._state.get_registered_outcomes():
            final = self._final(outcome)
            end = None if final == outcome else final
            edges.append((outcome, self._label, end if self._ends(outcome) else self._label))
        return edges
