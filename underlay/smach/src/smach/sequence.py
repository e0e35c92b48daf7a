"""Sequence: a state machine whose states follow each other in the order in which they are added."""

from typing import Any, Iterable, Mapping, Optional

from smach.log import logerr
from smach.state import State
from smach.state_machine import StateMachine


class Sequence(StateMachine):
    """State machine in which the connector outcome of each state leads to the state that is added next.

    The connector outcome of the last state ends the sequence with that outcome, as does every outcome that has no
    transition of its own. A state without the connector outcome is a mistake unless it is the last one: it is logged.
    """

    def __init__(
        self,
        outcomes: Iterable[str],
        connector_outcome: str,
        input_keys: Iterable[str] = (),
        output_keys: Iterable[str] = (),
    ) -> None:
        StateMachine.__init__(self, outcomes, input_keys, output_keys)
        self._connector_outcome = connector_outcome
        # The state added last, if nothing leads from it to the next one.
        self._dead_end: Optional[str] = None

    @staticmethod
    def add(
        label: str,
        state: State,
        transitions: Optional[Mapping[str, Optional[str]]] = None,
        remapping: Optional[Mapping[str, str]] = None,
    ) -> Any:
        """Add a state to the sequence that is open; see StateMachine.add."""
        sequence = Sequence._currently_opened_container()
        sequence._check_child(label, state, sequence._states)
        connector = sequence._connector_outcome
        is_connected = connector in state.get_registered_outcomes()
        StateMachine.add_auto(label, state, [connector] if is_connected else [], transitions, remapping)
        if sequence._dead_end is not None:
            logerr(f"State '{sequence._dead_end}' has no outcome '{connector}': nothing leads from it to '{label}'.")
        sequence._dead_end = None if is_connected else label
        return state
