"""Programs in the shapes of public tutorials and books; they use the documented interface of SMACH only."""

import threading

import pytest

import smach

DEADLINE_S = 20.0


class Act(smach.State):
    """Notes its name and gives one outcome."""

    def __init__(self, name, log, outcome="succeeded"):
        super().__init__(outcomes=["succeeded", "aborted", "preempted"])
        self._name, self._log, self._outcome = name, log, outcome

    def execute(self, userdata):
        self._log.append(self._name)
        return self._outcome


class Give(smach.State):
    """Gives one outcome and has no other."""

    def __init__(self, outcome="succeeded"):
        super().__init__(outcomes=[outcome])
        self._outcome = outcome

    def execute(self, userdata):
        return self._outcome


class Wait(smach.State):
    """Waits until it is asked to stop."""

    def __init__(self):
        super().__init__(outcomes=["succeeded", "preempted"])
        self.started, self._asked = threading.Event(), threading.Event()

    def request_preempt(self):
        smach.State.request_preempt(self)
        self._asked.set()

    def execute(self, userdata):
        self.started.set()
        assert self._asked.wait(DEADLINE_S)
        self._asked.clear()
        self.service_preempt()
        return "preempted"


def concurrence(outcomes=("done",), default="done", states=None, **kwargs):
    both = smach.Concurrence(list(outcomes), default, **kwargs)
    with both:
        for label, state in (states or {}).items():
            smach.Concurrence.add(label, state)
    return both


# Transitions


def test_rounds_of_a_patrol_whose_last_transitions_are_empty():
    """Each round visits the corners; a state counts the rounds and ends the machine by an empty transition."""
    log = []

    class Count(smach.State):
        def __init__(self, rounds):
            super().__init__(outcomes=["again", "succeeded"], input_keys=["round"], output_keys=["round"])
            self._rounds = rounds

        def execute(self, userdata):
            userdata.round += 1
            return "again" if userdata.round < self._rounds else "succeeded"

    patrol = smach.StateMachine(outcomes=["succeeded", "aborted", "preempted"])
    patrol.userdata.round = 0
    with patrol:
        smach.StateMachine.add("COUNT", Count(3), transitions={"again": "CORNER_0", "succeeded": ""})
        for number, following in enumerate(["CORNER_1", "CORNER_2", "COUNT"]):
            smach.StateMachine.add(
                f"CORNER_{number}",
                Act(number, log, outcome="aborted" if number == 1 else "succeeded"),
                transitions={"succeeded": following, "aborted": following, "preempted": ""},
            )
    assert patrol.execute() == "succeeded"
    assert log == [0, 1, 2, 0, 1, 2]


def test_rooms_of_a_house_that_end_by_empty_transitions_fail_when_a_task_does():
    log = []

    def room(*tasks, outcome="succeeded"):
        machine = smach.StateMachine(outcomes=["succeeded", "aborted", "preempted"])
        with machine:
            for task, following in zip(tasks, [*tasks[1:], ""]):
                smach.StateMachine.add(
                    task, Act(task, log, outcome), {"succeeded": following, "aborted": "", "preempted": ""}
                )
        return machine

    house = smach.StateMachine(outcomes=["succeeded", "aborted", "preempted"])
    with house:
        smach.StateMachine.add("KITCHEN", room("mop", "wipe"), {"succeeded": "BATH", "aborted": "BATH"})
        smach.StateMachine.add("BATH", room("scrub", "rinse", outcome="aborted"), {"succeeded": "HALL", "aborted": ""})
        smach.StateMachine.add("HALL", room("sweep"), {"succeeded": "", "aborted": "", "preempted": ""})
    assert house.execute() == "aborted"
    assert log == ["mop", "wipe", "scrub"]


def test_empty_transition_of_an_outcome_that_the_machine_lacks_is_a_mistake():
    machine = smach.StateMachine(outcomes=["finished"])
    with machine:
        smach.StateMachine.add("ONLY", Give("succeeded"), {"succeeded": ""})
    assert machine.execute() is None


def test_sequence_whose_last_state_has_no_connector_outcome():
    sequence = smach.Sequence(outcomes=["succeeded", "finished"], connector_outcome="succeeded")
    with sequence:
        smach.Sequence.add("FIRST", Give("succeeded"))
        smach.Sequence.add("LAST", Give("finished"))
    assert sequence.execute() == "finished"


# Concurrence


@pytest.mark.parametrize(
    "left,right,expected", [("won", "won", "all"), ("won", "lost", "part"), ("lost", "won", "none")]
)
def test_entry_of_the_outcome_map_that_names_most_states_decides(left, right, expected):
    for entries in (["part", "all"], ["all", "part"]):
        outcome_map = {"part": {"LEFT": "won"}, "all": {"LEFT": "won", "RIGHT": "won"}}
        both = concurrence(
            ["part", "all", "none"],
            "none",
            {"LEFT": Give(left), "RIGHT": smach.CBState(lambda ud: right, outcomes=["won", "lost"])},
            outcome_map={entry: outcome_map[entry] for entry in entries},
        )
        if left == "lost":
            # The map may name an outcome that this state never gives.
            both.get_children()["LEFT"].register_outcomes(["won"])
        assert both.execute() == expected


def test_empty_entry_of_the_outcome_map_never_holds():
    assert concurrence(["any", "done"], "done", {"A": Give()}, outcome_map={"any": {}}).execute() == "done"


def test_empty_concurrence_is_refused_when_it_runs():
    with pytest.raises(smach.InvalidStateError):
        concurrence().execute()


@pytest.mark.parametrize(
    "default,kwargs",
    [
        ("unknown", {}),
        ("done", {"outcome_map": {"unknown": {"A": "succeeded"}}}),
        ("done", {"outcome_cb": "no function"}),
        ("done", {"child_termination_cb": "no function"}),
    ],
)
def test_wrong_outcome_policy_is_refused_by_the_constructor(default, kwargs):
    with pytest.raises(smach.InvalidStateError):
        smach.Concurrence(["done"], default, **kwargs)


def test_state_of_a_concurrence_is_replaced_by_one_of_its_label():
    log = []
    both = smach.Concurrence(["done"], "done")
    with both:
        smach.Concurrence.add("A", Act("old", log))
        smach.Concurrence.add("A", Act("new", log))
    assert both.execute() == "done" and log == ["new"]


def test_outcomes_that_nobody_registered_pass_through_a_concurrence():
    seen = []
    both = concurrence(
        states={"A": smach.CBState(lambda ud: "odd", outcomes=["even"])},
        outcome_cb=lambda outcomes: seen.append(outcomes["A"]) or "surprise",
    )
    assert (both.execute(), seen) == ("surprise", ["odd"])


def test_patrol_beside_a_watch_that_stops_it_and_recharges():
    """A monitor ends first and stops the patrol; the outcome callback sends the robot to its charger."""
    patrol, log = Wait(), []

    def watch(userdata):
        assert patrol.started.wait(DEADLINE_S)
        return "invalid"

    guarded = smach.Concurrence(
        outcomes=["succeeded", "recharge", "stop"],
        default_outcome="succeeded",
        child_termination_cb=lambda outcomes: outcomes["WATCH"] == "invalid" or outcomes["PATROL"] == "succeeded",
        outcome_cb=lambda outcomes: "recharge" if outcomes["WATCH"] == "invalid" else "succeeded",
    )
    with guarded:
        smach.Concurrence.add("WATCH", smach.CBState(watch, outcomes=["valid", "invalid", "preempted"]))
        smach.Concurrence.add("PATROL", patrol)
    top = smach.StateMachine(outcomes=["succeeded", "aborted", "preempted"])
    with top:
        smach.StateMachine.add("GUARDED", guarded, {"succeeded": "", "recharge": "CHARGE", "stop": "aborted"})
        smach.StateMachine.add("CHARGE", Act("charge", log), {"succeeded": "", "aborted": "", "preempted": ""})
    assert top.execute() == "succeeded" and log == ["charge"]
    assert not patrol.preempt_requested()


# Constructors


@pytest.mark.parametrize(
    "construct",
    [
        lambda self: smach.Container.__init__(self, ["done"], ["in"]),
        lambda self: smach.StateMachine.__init__(self, outcomes=["done"], input_keys=["in"]),
        lambda self: smach.Sequence.__init__(self, ["done"], "done", ["in"]),
        lambda self: smach.Concurrence.__init__(self, ["done"], "done", ["in"]),
        lambda self: smach.Iterator.__init__(self, ["done"], ["in"], [], exhausted_outcome="done"),
        lambda self: smach.CBState.__init__(self, len, outcomes=["done"], input_keys=["in"]),
    ],
    ids=["container", "machine", "sequence", "concurrence", "iterator", "callback"],
)
@pytest.mark.parametrize("base", [smach.State, smach.StateMachine])
def test_constructor_of_another_class_serves_any_state(construct, base):
    class Wait(base):
        def __init__(self):
            construct(self)

        def execute(self, userdata):
            return "done"

    machine = smach.StateMachine(["done"], input_keys=["in"])
    with machine:
        smach.StateMachine.add("WAIT", Wait())
    machine.userdata["in"] = 1
    assert machine.execute() == "done"
    assert machine["WAIT"].get_registered_input_keys() == ("in",)


# Concurrence


def of_two(outcome_map):
    ran = []
    both = smach.Concurrence(["won", "lost"], "lost", outcome_map=outcome_map)
    with both:
        for label in ("A", "B"):
            state = smach.CBState(lambda userdata, label=label: ran.append(label) or "done", outcomes=["done"])
            smach.Concurrence.add(label, state)
    return both, ran


def test_concurrence_runs_with_a_map_that_names_an_unknown_outcome_of_a_state():
    both, ran = of_two({"won": {"A": "done", "B": "never"}})
    with pytest.raises(smach.InvalidTransitionError, match="no outcome 'never'"):
        both.check_consistency()
    assert both.execute() == "lost" and sorted(ran) == ["A", "B"]


def test_concurrence_with_a_map_that_names_a_missing_state_does_not_begin():
    both, ran = of_two({"won": {"A": "done", "C": "done"}})
    assert both.execute() is None and ran == []


# Iterator


def iterator(state, outcomes=("succeeded",), exhausted="succeeded", loop=("succeeded",), **kwargs):
    built = smach.Iterator(list(outcomes), [], [], exhausted_outcome=exhausted, **kwargs)
    with built:
        smach.Iterator.set_contained_state("EACH", state, loop_outcomes=list(loop))
    return built


def test_items_are_set_in_the_block_of_the_iterator():
    seen = []

    def see(userdata):
        seen.append(userdata.it_data)
        return "succeeded"

    built = smach.Iterator(["succeeded"], [], [], exhausted_outcome="succeeded")
    with built:
        smach.Iterator.set_iteritems([1, 2])
        smach.Iterator.set_contained_state("SEE", smach.CBState(see, outcomes=["succeeded"]), ["succeeded"])
    assert built.execute() == "succeeded" and seen == [1, 2]


def test_items_are_set_by_a_start_callback():
    seen = []

    def see(userdata):
        seen.append(userdata.number)
        return "succeeded"

    built = iterator(smach.CBState(see, outcomes=["succeeded"], input_keys=["number"]), it=[])

    def set_items(userdata, initial_states):
        with built:
            smach.Iterator.set_iteritems(range(userdata.count), "number")

    built.register_start_cb(set_items)
    for count in (2, 3):
        built.userdata.count = count
        assert built.execute() == "succeeded"
    assert seen == [0, 1, 0, 1, 2]


def test_state_of_an_iterator_declares_no_keys():
    def add(userdata):
        userdata.total = userdata.total + userdata.number
        return "succeeded"

    built = iterator(smach.CBState(add, outcomes=["succeeded"]), it=range(4), it_label="number")
    built.userdata.total = 0
    assert built.execute() == "succeeded" and built.userdata.total == 6


def test_edges_of_an_iterator_are_the_transitions_of_its_state():
    built = smach.Iterator(["stop", "found", "stop_at_end"], [], [], it=range(3), exhausted_outcome="stop_at_end")
    assert built.get_internal_edges() == []
    with built:
        state = smach.CBState(lambda userdata: "go", outcomes=["go", "stop", "seen"])
        smach.Iterator.set_contained_state(
            "EACH", state, loop_outcomes=["go"], final_outcome_map={"seen": "found", "stop_at_end": "found"}
        )
    # None: the outcome of the state is that of the iterator. To run out of items is no outcome of the state.
    assert built.get_internal_edges() == [("go", "EACH", "EACH"), ("stop", "EACH", None), ("seen", "EACH", "found")]


@pytest.mark.parametrize(
    "lists,count",
    [
        ({"loop_outcomes": ["go"]}, 1),
        ({"break_outcomes": ["stop"]}, 3),
        ({"loop_outcomes": ["go"], "break_outcomes": ["stop"]}, 3),
    ],
)
def test_break_outcomes_of_an_iterator_override_the_loop_outcomes(lists, count):
    seen = []
    built = smach.Iterator(["other", "exhausted"], [], [], it=range(3))
    with built:
        state = smach.CBState(lambda userdata: seen.append(1) or "other", outcomes=["go", "stop", "other"])
        smach.Iterator.set_contained_state("EACH", state, **lists)
    assert built.execute() == ("other" if count == 1 else "exhausted") and len(seen) == count


def test_iterator_without_the_outcome_preempted_ends_with_that_of_the_state():
    class Obedient(Wait):
        def execute(self, userdata):
            super().execute(userdata)
            return "succeeded"

    state = Obedient()
    built = iterator(state, it=range(3), outcomes=["done"], exhausted="done")
    outcomes = []
    thread = threading.Thread(target=lambda: outcomes.append(built.execute()), daemon=True)
    thread.start()
    assert state.started.wait(DEADLINE_S)
    built.request_preempt()
    thread.join(DEADLINE_S)
    assert outcomes == ["succeeded"]


# Construction


def test_containers_are_opened_again():
    log = []
    outer = smach.StateMachine(["succeeded", "aborted", "preempted"])
    inner = smach.StateMachine(["succeeded", "aborted", "preempted"])
    with outer:
        smach.StateMachine.add("A", Act("a", log), {"succeeded": "INNER"})
        with outer:
            smach.StateMachine.add("INNER", inner, {"succeeded": "B"})
        with inner:
            smach.StateMachine.add("ONLY", Act("inner", log))
            with outer:
                smach.StateMachine.add("B", Act("b", log), {"succeeded": "C"})
        with outer.opened():
            smach.StateMachine.add("C", Act("c", log))
        assert outer.is_opened()
    assert not outer.is_opened()
    assert outer.execute() == "succeeded" and log == ["a", "inner", "b", "c"]


def test_methods_of_a_state_are_what_makes_it_one():
    class Duck:
        def execute(self, userdata):
            return "done"

        def get_registered_outcomes(self):
            return ("done",)

        def nothing(self):
            return ()

        get_registered_input_keys = get_registered_output_keys = nothing
        request_preempt = recall_preempt = service_preempt = preempt_requested = nothing

    machine = smach.StateMachine(["done"])
    with machine:
        smach.StateMachine.add("DUCK", Duck())
    assert machine.execute() == "done"


# Callbacks and userdata


def test_function_in_a_class_is_called_without_the_instance():
    class Program:
        @smach.cb_interface(outcomes=["done"], input_keys=["number"])
        def plain(userdata):  # noqa: N805 (not a method)
            return "done" if userdata.number == 3 else "wrong"

        @smach.cb_interface(outcomes=["done"], output_keys=["seen"])
        def given(userdata, program):  # noqa: N805 (not a method)
            userdata.seen = program.name
            return "done"

        def __init__(self):
            self.name = "program"
            self.machine = smach.StateMachine(["done"])
            self.machine.userdata.number = 3
            with self.machine:
                smach.StateMachine.add("PLAIN", smach.CBState(self.plain), {"done": "GIVEN"})
                smach.StateMachine.add("GIVEN", smach.CBState(self.given, cb_args=[self]), {"done": "done"})

    program = Program()
    assert program.machine.execute() == "done" and program.machine.userdata.seen == "program"


def test_write_to_a_key_that_is_no_output_is_lost():
    def write(userdata):
        userdata.kept = 1
        userdata.lost = 1
        userdata["number"] = 5
        return "done"

    machine = smach.StateMachine(["done"])
    machine.userdata.number = 3
    with machine:
        smach.StateMachine.add(
            "WRITE", smach.CBState(write, outcomes=["done"], input_keys=["number"], output_keys=["kept"])
        )
    assert machine.execute() == "done"
    assert (machine.userdata.kept, machine.userdata.number) == (1, 3) and "lost" not in machine.userdata


def test_extracted_keys_have_the_names_of_the_source():
    here = smach.UserData()
    here.a, here.b = [1], 2
    taken = here.extract(["a", "b"], {"x": "a"})
    assert (taken.x, taken.b, "a" in taken) == ([1], 2, False)
    assert taken.x is not here.a
