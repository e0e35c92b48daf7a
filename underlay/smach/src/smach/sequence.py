"""Sequence: a state machine whose states follow each other in the order in which they are added."""

from typing import Any, Iterable, Mapping, Optional

from smach.state import State
from smach.state_machine import StateMachine


class Sequence(StateMachine):
    """State machine in which the connector outcome of each state leads to the state that is added next.

    The connector outcome of the last state ends the sequence with that outcome, as does every outcome that has no
    transition of its own.
    """

    def __init__(
        self,
        outcomes: Iterable[str],
        connector_outcome: str,
        input_keys: Iterable[str] = (),
        output_keys: Iterable[str] = (),
    ) -> None:
        super().__init__(outcomes, input_keys, output_keys)
        self._connector_outcome = connector_outcome

    @staticmethod
    def add(
        label: str,
        state: State,
        transitions: Optional[Mapping[str, Optional[str]]] = None,
        remapping: Optional[Mapping[str, str]] = None,
    ) -> Any:
        """Add a state to the sequence that is open; see StateMachine.add."""
        sequence = Sequence._currently_opened_container()
        return StateMachine.add_auto(label, state, [sequence._connector_outcome], transitions, remapping)
