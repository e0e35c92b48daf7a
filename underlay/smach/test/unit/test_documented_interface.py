"""The programs of the SMACH tutorials, in the shapes in which people write them."""

import inspect

import pytest

import smach
from smach.user_data import Const, Remapper, UserData

SIGNATURES = {
    smach.State: "outcomes input_keys output_keys io_keys",
    smach.CBState: "cb cb_args cb_kwargs outcomes input_keys output_keys io_keys",
    smach.StateMachine: "outcomes input_keys output_keys",
    smach.StateMachine.add: "label state transitions remapping",
    smach.StateMachine.add_auto: "label state connector_outcomes transitions remapping",
    smach.Sequence: "outcomes connector_outcome input_keys output_keys",
    smach.Sequence.add: "label state transitions remapping",
    smach.Concurrence: "outcomes default_outcome input_keys output_keys outcome_map outcome_cb child_termination_cb",
    smach.Concurrence.add: "label state remapping",
    smach.Iterator: "outcomes input_keys output_keys it it_label exhausted_outcome",
    smach.Iterator.set_contained_state: "label state loop_outcomes break_outcomes final_outcome_map",
    smach.Iterator.set_iteritems: "it it_label",
    smach.CBInterface: "cb outcomes input_keys output_keys io_keys",
    smach.Container.register_start_cb: "self start_cb cb_args",
    smach.Container.register_transition_cb: "self transition_cb cb_args",
    smach.Container.register_termination_cb: "self termination_cb cb_args",
    smach.Container.set_initial_state: "self initial_states userdata",
    Remapper: "ud input_keys output_keys remapping",
    UserData.extract: "self keys remapping",
    UserData.merge: "self ud keys remapping",
    smach.set_loggers: "info warn debug error",
}


@pytest.mark.parametrize("function", SIGNATURES, ids=lambda function: function.__qualname__)
def test_arguments_have_the_documented_names_in_the_documented_order(function):
    assert " ".join(inspect.signature(function).parameters) == SIGNATURES[function]


def test_numbers_are_sorted_by_an_iterator_around_a_machine():
    machine = smach.StateMachine(outcomes=["succeeded", "aborted", "preempted"])
    machine.userdata.nums = range(25, 88, 3)
    machine.userdata.even_nums = []
    machine.userdata.odd_nums = []
    with machine:
        numbers = smach.Iterator(
            outcomes=["succeeded", "preempted", "aborted"],
            input_keys=["nums", "even_nums", "odd_nums"],
            output_keys=["even_nums", "odd_nums"],
            it=lambda: range(len(machine.userdata.nums)),
            it_label="index",
            exhausted_outcome="succeeded",
        )
        with numbers:
            inner = smach.StateMachine(
                outcomes=["succeeded", "preempted", "aborted", "continue"],
                input_keys=["nums", "index", "even_nums", "odd_nums"],
                output_keys=["even_nums", "odd_nums"],
            )
            with inner:

                @smach.cb_interface(input_keys=["nums", "index"], outcomes=["odd", "even"])
                def ask(ud):
                    return "odd" if ud.nums[ud.index] % 2 else "even"

                @smach.cb_interface(
                    input_keys=["nums", "index", "odd_nums"], output_keys=["odd_nums"], outcomes=["succeeded"]
                )
                def keep_odd(ud):
                    ud.odd_nums.append(ud.nums[ud.index])
                    return "succeeded"

                # Declared as an input only: a list can be changed all the same.
                @smach.cb_interface(input_keys=["nums", "index", "even_nums"], outcomes=["succeeded"])
                def keep_even(ud):
                    ud.even_nums.append(ud.nums[ud.index])
                    return "succeeded"

                smach.StateMachine.add("ASK", smach.CBState(ask), {"odd": "ODD", "even": "EVEN"})
                smach.StateMachine.add("ODD", smach.CBState(keep_odd), {"succeeded": "continue"})
                smach.StateMachine.add("EVEN", smach.CBState(keep_even), {"succeeded": "continue"})
            smach.Iterator.set_contained_state("CONTAINER_STATE", inner, loop_outcomes=["continue"])
        smach.StateMachine.add("NUMBERS", numbers, {"succeeded": "succeeded", "aborted": "aborted"})
    assert machine.execute() == "succeeded"
    assert machine.userdata.even_nums == [n for n in range(25, 88, 3) if n % 2 == 0]
    assert machine.userdata.odd_nums == [n for n in range(25, 88, 3) if n % 2]


def test_callback_gets_its_arguments_and_declared_outcomes():
    @smach.cb_interface(input_keys=["q"], output_keys=["xyz"], outcomes=["foo"])
    def callback(ud, x, y, z):
        ud.xyz = ud.q + x + y + z
        return "foo"

    state = smach.CBState(callback, cb_args=[10], cb_kwargs={"z": 2, "y": 3})
    assert smach.has_smach_interface(callback) and not smach.has_smach_interface(len)
    assert set(state.get_registered_outcomes()) == {"foo"}
    machine = smach.StateMachine(["done"])
    machine.userdata.q = 1
    with machine:
        smach.StateMachine.add("MUX", state, {"foo": "done"})
    assert machine.execute() == "done" and machine.userdata.xyz == 16


def test_callback_interface_accepts_none_and_binds_as_a_method():
    class Robot:
        @smach.cb_interface(outcomes=["done"], input_keys=None, output_keys=None)
        def act(self, ud):
            return "done" if isinstance(self, Robot) else "what"

    assert smach.CBState(Robot().act).execute(smach.UserData()) == "done"
    assert smach.CBInterface(len, outcomes=None).get_registered_outcomes() == ()


@pytest.mark.parametrize("given,expected", [("mapped", "from_map"), ("callback", "from_callback"), ("else", "default")])
def test_concurrence_takes_callback_then_map_then_default(given, expected):
    both = smach.Concurrence(
        outcomes=["default", "from_map", "from_callback"],
        default_outcome="default",
        input_keys=["given"],
        output_keys=["seen"],
        outcome_map={"from_map": {"FOO": "mapped", "BAR": "done"}},
        outcome_cb=lambda outcomes: "from_callback" if outcomes["FOO"] == "callback" else None,
    )
    with both:
        smach.Concurrence.add(
            "FOO",
            smach.CBState(lambda ud: ud.what, outcomes=["mapped", "callback", "else"], input_keys=["what"]),
            {"what": "given"},
        )

        def see(ud):
            ud.seen = "bar was here"
            return "done"

        smach.Concurrence.add("BAR", smach.CBState(see, outcomes=["done"], output_keys=["seen"]))
    userdata = smach.UserData()
    userdata.given = given
    assert both.execute(userdata) == expected
    assert userdata.seen == "bar was here"
    assert sorted(both.get_initial_states()) == ["BAR", "FOO"] and both["FOO"] is both.get_children()["FOO"]
    assert ("mapped", "FOO", "from_map") in both.get_internal_edges()


def test_sequence_transition_of_its_own_overrides_the_connector():
    ran = []

    def state(label):
        return smach.CBState(lambda ud: ran.append(label) or "succeeded", outcomes=["succeeded", "aborted"])

    sequence = smach.Sequence(outcomes=["succeeded", "aborted"], connector_outcome="succeeded")
    with sequence:
        smach.Sequence.add("A", state("A"), {"succeeded": "C"})
        smach.Sequence.add("B", state("B"))
        smach.Sequence.add("C", state("C"))
    assert sequence.execute() == "succeeded" and ran == ["A", "C"]


def test_initial_state_and_userdata_are_set_from_outside():
    machine = smach.StateMachine(["done"])
    with machine:
        smach.StateMachine.add("A", smach.CBState(lambda ud: "done", outcomes=["done"]), {"done": "B"})
        smach.StateMachine.add(
            "B",
            smach.CBState(
                lambda ud: "done" if ud.value == 7 else "wrong", outcomes=["done", "wrong"], input_keys=["value"]
            ),
            {"wrong": "done"},
        )
    added = smach.UserData()
    added.value = 7
    seen = []
    machine.register_start_cb(lambda ud, labels: seen.append(("start", labels)))
    machine.register_termination_cb(lambda ud, labels, outcome: seen.append((ud.value, labels, outcome)))
    machine.set_initial_state(["B"], added)
    assert machine.execute() == "done"
    assert seen == [("start", ["B"]), (7, ["B"], "done")]
    assert machine.get_initial_states() == ["B"] and "value" in machine.userdata


def test_machine_starts_anew_each_time():
    machine = smach.StateMachine(["done"])
    machine.userdata.count = 0

    def count(ud):
        ud.count += 1
        return "done"

    with machine:
        smach.StateMachine.add("COUNT", smach.CBState(count, outcomes=["done"], io_keys=["count"]))
    assert [machine.execute() for _ in range(3)] == ["done"] * 3
    assert machine.userdata.count == 3


def test_userdata_is_copied_and_merged_under_other_names():
    here = smach.UserData()
    here.a, here["b"] = 1, 2
    taken = here.extract(["a", "b"], {"x": "a"})
    assert (taken.x, taken.b) == (1, 2)
    there = smach.UserData()
    there.merge(taken, ["x"], {"x": "z"})
    assert there.z == 1 and there.keys() == ["z"]
    with pytest.raises(KeyError):
        there["missing"]
    assert not hasattr(there, "missing")


def test_const_shows_and_does_not_change():
    class Box:
        def __init__(self):
            self.content, self.inner = 1, [1]

    box = Box()
    view = Const(box)
    assert view.content == 1 and smach.get_const(view) is view and smach.get_const(3) == 3
    with pytest.raises(TypeError):
        view.content = 2
    with pytest.raises(TypeError):
        del view.content
    assert box.content == 1


def test_messages_go_to_the_loggers_that_were_set():
    said = {"info": [], "warn": [], "debug": [], "error": []}
    before = [getattr(smach.log._loggers, name) for name in ("info", "warn", "debug", "error")]
    smach.set_loggers(*(said[name].append for name in ("info", "warn", "debug", "error")))
    try:
        smach.loginfo("i 100%")
        smach.logwarn("w")
        smach.logdebug("d")
        smach.logerr("e")
    finally:
        smach.set_loggers(*before)
    assert said == {"info": ["i 100%"], "warn": ["w"], "debug": ["d"], "error": ["e"]}
