"""StateMachine: one state after the other, as the outcomes say."""

import traceback
from typing import Any, Dict, Iterable, List, Mapping, Optional, Tuple

from smach.container import Container
from smach.exceptions import InvalidTransitionError, InvalidUserCodeError
from smach.log import logerr, loginfo, logwarn
from smach.state import State
from smach.user_data import Remapper, UserData
from smach.util import is_shutdown


class StateMachine(Container):
    """Container that runs one state at a time.

    A transition leads from an outcome of a state to the label of the next state or to an outcome of the machine;
    without one, or with None or an empty text, the outcome of the state becomes the outcome of the machine.

    A preempt request goes to the state that runs. When that state services it, the machine counts as having serviced
    it too; when it does not, the next state is asked before it starts.
    """

    def __init__(
        self, outcomes: Iterable[str], input_keys: Iterable[str] = (), output_keys: Iterable[str] = ()
    ) -> None:
        Container.__init__(self, outcomes, input_keys, output_keys)
        self._states: Dict[str, State] = {}
        self._transitions: Dict[str, Dict[str, Optional[str]]] = {}
        self._remappings: Dict[str, Dict[str, str]] = {}
        self._initial_state_label: Optional[str] = None
        self._current_label: Optional[str] = None
        # The state that was asked last to stop; None while nobody was.
        self._preempted_state: Optional[State] = None
        # The state whose connector outcomes lead to whatever is added next.
        self._unconnected: Optional[Tuple[str, Tuple[str, ...]]] = None

    # Construction

    @staticmethod
    def add(
        label: str,
        state: State,
        transitions: Optional[Mapping[str, Optional[str]]] = None,
        remapping: Optional[Mapping[str, str]] = None,
    ) -> State:
        """Add a state to the machine that is open. The first state added is the initial one.

        Args:
            label: name of the state in the machine
            transitions: from outcomes of the state to labels of states or outcomes of the machine; None or an empty
                text for an outcome that becomes the outcome of the machine
            remapping: from userdata keys of the state to keys of the machine

        Returns:
            the state

        Raises:
            InvalidConstructionError: no machine is open
            InvalidStateError: the label is taken, or `state` is no state
            InvalidTransitionError: a transition names an outcome that the state does not have
        """
        machine = StateMachine._currently_opened_container()
        machine._add(label, state, transitions, remapping)
        return state

    @staticmethod
    def add_auto(
        label: str,
        state: State,
        connector_outcomes: Iterable[str],
        transitions: Optional[Mapping[str, Optional[str]]] = None,
        remapping: Optional[Mapping[str, str]] = None,
    ) -> State:
        """Add a state whose connector outcomes lead to the state that is added next; else like add()."""
        machine = StateMachine._currently_opened_container()
        machine._add(label, state, transitions, remapping, tuple(connector_outcomes))
        return state

    def _add(
        self,
        label: str,
        state: State,
        transitions: Optional[Mapping[str, Optional[str]]],
        remapping: Optional[Mapping[str, str]],
        connector_outcomes: Tuple[str, ...] = (),
    ) -> None:
        given = {outcome: target or None for outcome, target in (transitions or {}).items()}
        self._check_child(label, state, self._states)
        self.check_state_spec(label, state, given)
        self.check_state_spec(label, state, dict.fromkeys(connector_outcomes))
        if self._unconnected is not None:
            previous, outcomes = self._unconnected
            for outcome in outcomes:
                self._transitions[previous][outcome] = label
        # An empty text says where the outcome leads; None does not.
        free = tuple(outcome for outcome in connector_outcomes if (transitions or {}).get(outcome) is None)
        self._unconnected = (label, free)
        self._transitions[label] = {**dict.fromkeys(state.get_registered_outcomes()), **given}
        self._states[label] = state
        self._remappings[label] = dict(remapping or {})
        if self._initial_state_label is None:
            self._initial_state_label = label

    def check_state_spec(self, label: str, state: State, transitions: Mapping[str, Optional[str]]) -> None:
        """Raise InvalidTransitionError when a transition names an outcome that the state does not have."""
        registered = state.get_registered_outcomes()
        for outcome in transitions:
            if outcome not in registered:
                raise InvalidTransitionError(
                    f"State '{label}' has no outcome '{outcome}'; its outcomes are: {sorted(registered)}"
                )

    def check_consistency(self) -> None:
        """Check that there is an initial state and that every outcome leads somewhere.

        Raises:
            InvalidTransitionError: not so; the text names every outcome that leads nowhere
        """
        problems = []
        if self._initial_state_label is None:
            problems.append("No initial state set.")
        elif self._initial_state_label not in self._states:
            problems.append(f"The initial state '{self._initial_state_label}' is not in the machine.")
        ends = self.get_registered_outcomes()
        for outcome, label, target in self.get_internal_edges():
            if target is None and outcome not in ends:
                problems.append(
                    f"Outcome '{outcome}' of state '{label}' leads nowhere and is no outcome of the machine."
                )
            elif target is not None and target not in self._states and target not in ends:
                problems.append(
                    f"Outcome '{outcome}' of state '{label}' leads to '{target}', which is neither a "
                    "state nor an outcome of the machine."
                )
        if problems:
            raise InvalidTransitionError(
                "State machine failed consistency check: "
                + "\n\t".join(problems + [f"Available states: {sorted(self._states)}", f"Outcomes: {sorted(ends)}"])
            )

    # Running

    def execute(self, parent_ud: Any = None) -> Optional[str]:
        """Run from the initial state to an outcome of the machine.

        Args:
            parent_ud: userdata from which the input keys and to which the output keys are copied

        Returns:
            the outcome; None when the machine is not consistent or the program shuts down

        Raises:
            InvalidUserCodeError: a state raised
            InvalidTransitionError: a state returned an outcome that it did not register
        """
        if not self._is_consistent():
            return None
        with self._marked_as_running():
            with self._lock:
                self._preempted_state = None
                self._current_label = self._initial_state_label
            try:
                self._copy_input_keys(parent_ud, self.userdata)
                loginfo(
                    f"State machine starting in initial state '{self._current_label}' with userdata: "
                    f"{self.userdata.keys()}"
                )
                self.call_start_cbs()
                outcome = None
                while outcome is None and not is_shutdown():
                    outcome = self._step()
                self._copy_output_keys(self.userdata, parent_ud)
                return outcome
            finally:
                with self._lock:
                    self._end_preempt()
                    self._current_label = None

    def _step(self) -> Optional[str]:
        """Run the current state and move on; return the outcome of the machine, or None to go on."""
        with self._lock:
            label = self._current_label
            assert label is not None, "execute() sets the first label, and each step the next"
            state = self._states[label]
            if self._preempt_requested:
                self._hand_on_preempt(label, state)
        outcome = self._execute_child(label, state)
        if outcome is None and is_shutdown():
            return None
        if outcome not in state.get_registered_outcomes():
            raise InvalidTransitionError(
                f"State '{label}' of type {type(state).__name__} ended with the outcome '{outcome}', which is not "
                f"registered; its outcomes are: {sorted(state.get_registered_outcomes())}"
            )
        target = self._target(label, outcome)
        if target in self._states:
            loginfo(f"State machine transitioning '{label}':'{outcome}'-->'{target}'")
            with self._lock:
                self._current_label = target
            self.call_transition_cbs()
            return None
        loginfo(f"State machine terminating '{label}':'{outcome}':'{target}'")
        with self._lock:
            self._current_label = None
            self._end_preempt()
        self.call_termination_cbs([label], target)
        return target

    def _target(self, label: str, outcome: str) -> str:
        """Where an outcome leads: a label of a state, or else an outcome of the machine."""
        ends = self.get_registered_outcomes()
        target = self._transitions[label].get(outcome)
        if target in self._states or target in ends:
            return target
        if outcome in ends:
            return outcome
        raise InvalidTransitionError(
            f"Outcome '{outcome}' of state '{label}' leads to '{target}', which is neither a state nor an outcome of "
            "the machine."
        )

    def _execute_child(self, label: str, state: State) -> Optional[str]:
        view = Remapper(
            self.userdata,
            state.get_registered_input_keys(),
            state.get_registered_output_keys(),
            self._remappings[label],
        )
        try:
            return state.execute(view)
        except InvalidUserCodeError:
            logerr(f"State '{label}' failed to execute.")
            raise
        except Exception as error:  # boundary: a state is code of the user
            raise InvalidUserCodeError(
                f"State '{label}' of type {type(state).__name__} raised:\n{traceback.format_exc()}"
            ) from error

    # Preemption; each with the lock held

    def request_preempt(self) -> None:
        """Ask the state that runs to stop, or the next one when none runs."""
        with self._lock:
            self._preempt_requested = True
            if self._current_label is not None:
                self._preempt(self._states[self._current_label])

    def _preempt(self, state: State) -> None:
        self._preempted_state = state
        try:
            state.request_preempt()
        except Exception:  # boundary: a state is code of the user
            logerr(
                f"A state of type {type(state).__name__} raised when it was asked to stop:\n{traceback.format_exc()}"
            )

    def _hand_on_preempt(self, label: str, state: State) -> None:
        """Before `state` starts: end the request when the last state serviced it, else ask `state`."""
        last = self._preempted_state
        if last is None:
            self._preempt(state)
        elif last is not state and last.preempt_requested():
            logwarn(f"The last state did not service the preempt request: state '{label}' is asked before it starts.")
            last.recall_preempt()
            self._preempt(state)
        elif not last.preempt_requested():
            self._preempt_requested = False
            self._preempted_state = None

    def _end_preempt(self) -> None:
        """At the end: a request that the last state serviced is serviced by the machine, else it stays open."""
        last = self._preempted_state
        if last is not None:
            if last.preempt_requested():
                last.recall_preempt()
            else:
                self._preempt_requested = False
        self._preempted_state = None

    # Introspection

    def get_children(self) -> Dict[str, State]:
        """States by label."""
        return self._states

    def set_initial_state(self, initial_states: List[str], userdata: Optional[UserData] = None) -> None:
        """Choose the state to start with, and add values to the userdata.

        Args:
            initial_states: one label; of several the first counts
            userdata: values to add
        """
        if len(initial_states) > 1:
            logwarn(f"A state machine starts in one state: of {initial_states} the first is taken.")
        if initial_states:
            self._initial_state_label = initial_states[0]
        if userdata is not None:
            self.userdata.update(userdata)

    def get_active_states(self) -> List[str]:
        """Label of the state that runs, in a list; empty when none does."""
        label = self._current_label
        return [] if label is None else [label]

    def get_initial_states(self) -> List[str]:
        """Label of the initial state, in a list; empty when there is none."""
        return [] if self._initial_state_label is None else [self._initial_state_label]

    def get_internal_edges(self) -> List[Tuple[str, str, Optional[str]]]:
        """Transitions as (outcome, label of the state, label of the next state or outcome of the machine).

        The target is None where the outcome of the state becomes the outcome of the machine.
        """
        return [
            (outcome, label, target)
            for label, transitions in self._transitions.items()
            for outcome, target in transitions.items()
        ]
