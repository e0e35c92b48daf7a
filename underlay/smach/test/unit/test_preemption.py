"""Nested containers stop when they are asked to."""

import threading

import pytest

import smach

DEADLINE_S = 20.0


class Patient(smach.State):
    """Runs until it is asked to stop; then it services the request, or leaves it open and gives `ignored`."""

    def __init__(self, services=True, ignored="done"):
        super().__init__(outcomes=["done", "preempted"])
        self.started, self.runs = threading.Event(), 0
        self._asked, self._services, self._ignored = threading.Event(), services, ignored

    def request_preempt(self):
        super().request_preempt()
        self._asked.set()

    def execute(self, userdata):
        self.runs += 1
        self.started.set()
        assert self._asked.wait(DEADLINE_S)
        self._asked.clear()
        if not self._services:
            return self._ignored
        self.service_preempt()
        return "preempted"


def run_and_preempt(container, *patients):
    """Execute, ask to stop once every patient runs, return the outcome or the error."""
    outcomes = []

    def execute():
        try:
            outcomes.append(container.execute())
        except smach.SmachError as error:
            outcomes.append(error)

    thread = threading.Thread(target=execute, daemon=True)
    thread.start()
    for patient in patients:
        assert patient.started.wait(DEADLINE_S)
    container.request_preempt()
    thread.join(DEADLINE_S)
    assert not thread.is_alive()
    assert not container.is_running() and container.get_active_states() == []
    return outcomes[0]


def machine(label, state, outcomes=("done", "preempted"), **kwargs):
    built = smach.StateMachine(list(outcomes), **kwargs)
    with built:
        smach.StateMachine.add(label, state)
    return built


def iterator(state, outcomes=("preempted", "exhausted"), count=3, **kwargs):
    built = smach.Iterator(list(outcomes), [], [], it=range(count), it_label="index")
    with built:
        smach.Iterator.set_contained_state("EACH", state, **kwargs)
    return built


def concurrence(outcomes=("done", "preempted"), default="done", outcome_map=None, **states):
    built = smach.Concurrence(list(outcomes), default, outcome_map=outcome_map or {})
    with built:
        for label, state in states.items():
            smach.Concurrence.add(label, state)
    return built


def test_iterator_ends_with_the_outcome_of_the_state_that_services_the_request():
    patient = Patient()
    built = iterator(patient, loop_outcomes=["done"])
    assert run_and_preempt(built, patient) == "preempted"
    assert patient.runs == 1
    assert not built.preempt_requested() and not patient.preempt_requested()


def test_iterator_maps_the_outcome_of_the_preempted_state():
    patient = Patient()
    built = iterator(
        patient, outcomes=("stopped", "exhausted"), loop_outcomes=["done"], final_outcome_map={"preempted": "stopped"}
    )
    assert run_and_preempt(built, patient) == "stopped"


def test_iterator_stops_between_items_when_the_state_leaves_the_request_open():
    patient = Patient(services=False)
    built = iterator(patient, loop_outcomes=["done"])
    assert run_and_preempt(built, patient) == "preempted"
    assert patient.runs == 1 and not built.preempt_requested()


def test_iterator_without_the_outcome_preempted_asks_before_the_next_item():
    patient = Patient(services=False)
    built = iterator(patient, outcomes=("exhausted",), loop_outcomes=["done"])
    assert run_and_preempt(built, patient) == "exhausted"
    assert patient.runs == 3
    assert built.preempt_requested(), "nobody serviced the request"


def test_iterator_that_is_asked_before_it_starts():
    patient = Patient()
    built = iterator(patient, loop_outcomes=["done"])
    built.request_preempt()
    assert built.execute() == "preempted"
    assert patient.runs == 1 and not built.preempt_requested()


def test_iterator_refuses_an_end_that_is_not_its_outcome():
    built = iterator(smach.CBState(lambda ud: "other", outcomes=["other"]), break_outcomes=["other"])
    with pytest.raises(smach.InvalidTransitionError, match="other"):
        built.execute()
    assert not built.is_running()


def test_concurrence_asks_every_state():
    first, second = Patient(), Patient()
    built = concurrence(
        FIRST=first, SECOND=second, outcome_map={"preempted": {"FIRST": "preempted", "SECOND": "preempted"}}
    )
    assert run_and_preempt(built, first, second) == "preempted"
    assert not built.preempt_requested()


def test_concurrence_keeps_a_request_open_that_one_state_ignores():
    first, second = Patient(), Patient(services=False)
    built = concurrence(FIRST=first, SECOND=second)
    assert run_and_preempt(built, first, second) == "done"
    assert built.preempt_requested()
    assert not first.preempt_requested() and not second.preempt_requested()


def test_concurrence_that_is_asked_before_it_starts():
    first, second = Patient(), Patient()
    built = concurrence(FIRST=first, SECOND=second, outcome_map={"preempted": {"FIRST": "preempted"}})
    built.request_preempt()
    assert built.execute() == "preempted"


def test_child_termination_callback_preempts_only_the_states_it_names():
    quick, watched, other = smach.CBState(lambda ud: "done", outcomes=["done"]), Patient(), Patient()
    seen = []

    def ended(outcomes):
        seen.append(dict(outcomes))
        if outcomes["WATCHED"] is None:
            return ["WATCHED"]
        return outcomes["OTHER"] is None

    built = smach.Concurrence(["done"], "done", child_termination_cb=ended)
    with built:
        smach.Concurrence.add("QUICK", quick)
        smach.Concurrence.add("WATCHED", watched)
        smach.Concurrence.add("OTHER", other)
    assert built.execute() == "done"
    assert {"QUICK": "done", "WATCHED": None, "OTHER": None} in seen
    assert {"QUICK": "done", "WATCHED": "preempted", "OTHER": None} in seen
    assert not built.preempt_requested()


@pytest.mark.parametrize("services", [True, False])
def test_request_reaches_the_leaves_of_nested_containers(services):
    leaf, beside = Patient(services), Patient(services)
    items = iterator(leaf, loop_outcomes=["done"])
    both = concurrence(
        ITEMS=items,
        BESIDE=machine("BESIDE", beside),
        outcome_map={"preempted": {"ITEMS": "preempted", "BESIDE": "preempted" if services else "done"}},
    )
    outer = machine("BOTH", both)
    assert run_and_preempt(outer, leaf, beside) == "preempted"
    assert (leaf.runs, beside.runs) == (1, 1)
    assert not items.preempt_requested() and not leaf.preempt_requested() and not beside.preempt_requested()
    # One leaf left the request open: so do the containers above it.
    assert outer.preempt_requested() == (not services)


def test_machine_goes_on_behind_a_state_that_serviced_the_request():
    patient, cleaned = Patient(), []
    built = smach.StateMachine(["tidy"])
    with built:
        smach.StateMachine.add("WORK", patient, {"done": "tidy", "preempted": "CLEAN"})
        smach.StateMachine.add(
            "CLEAN", smach.CBState(lambda ud: cleaned.append(built.preempt_requested()) or "tidy", outcomes=["tidy"])
        )
    assert run_and_preempt(built, patient) == "tidy"
    assert cleaned == [False]


def test_state_that_raises_after_a_request_does_not_keep_it():
    class Broken(Patient):
        def execute(self, userdata):
            super().execute(userdata)
            raise RuntimeError("broken")

    broken = Broken(services=False)
    built = machine("BROKEN", broken)
    assert isinstance(run_and_preempt(built, broken), smach.InvalidUserCodeError)
    assert not broken.preempt_requested()


def test_containers_end_without_an_outcome_when_the_program_ends():
    patient, ends = Patient(), threading.Event()
    items = iterator(smach.CBState(lambda ud: ends.set() or "done", outcomes=["done"]))
    both = concurrence(ITEMS=items, PATIENT=patient)
    outer = machine("BOTH", both)
    smach.set_shutdown_check(ends.is_set)
    try:
        assert outer.execute() is None
    finally:
        smach.set_shutdown_check(lambda: False)
    assert patient.runs == 1 and not outer.is_running() and not both.is_running()


def test_threads_of_a_machine_and_of_its_states_must_not_wait_for_its_end():
    told = []

    def tell(userdata):
        told.append(outer.is_run_by_this_thread())
        return "done"

    both = concurrence(LEFT=smach.CBState(tell, outcomes=["done"]))
    outer = smach.StateMachine(["done", "preempted"])
    with outer:
        smach.StateMachine.add("HERE", smach.CBState(tell, outcomes=["done"]), {"done": "BOTH"})
        smach.StateMachine.add("BOTH", both, {"done": "PATIENT"})
        patient = smach.StateMachine.add("PATIENT", Patient())
    assert not outer.is_run_by_this_thread()
    assert run_and_preempt(outer, patient) == "preempted"
    assert told == [True, True]
    thread = threading.Thread(target=outer.execute, daemon=True)
    patient.started.clear()
    thread.start()
    assert patient.started.wait(DEADLINE_S)
    assert outer.is_running() and not outer.is_run_by_this_thread()
    outer.request_preempt()
    thread.join(DEADLINE_S)
