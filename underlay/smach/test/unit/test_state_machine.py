"""A state machine handles outcomes, userdata and preempt requests."""

import threading

import pytest

import smach


class Give(smach.State):
    """Gives one outcome."""

    def __init__(self, outcome="done", outcomes=("done",)):
        super().__init__(outcomes=outcomes)
        self._outcome = outcome

    def execute(self, userdata):
        return self._outcome


class Waiter(smach.State):
    """Waits to be asked to stop."""

    def __init__(self, services=True):
        super().__init__(outcomes=["done", "preempted"])
        self.started, self._asked, self._services = threading.Event(), threading.Event(), services

    def request_preempt(self):
        super().request_preempt()
        self._asked.set()

    def execute(self, userdata):
        self.started.set()
        assert self._asked.wait(10.0)
        if self._services:
            self.service_preempt()
            return "preempted"
        return "done"


def machine(*specs, outcomes=("done", "preempted"), **kwargs):
    built = smach.StateMachine(list(outcomes), **kwargs)
    with built:
        for spec in specs:
            smach.StateMachine.add(*spec)
    return built


def test_transitions_lead_to_an_outcome():
    built = machine(("A", Give(), {"done": "B"}), ("B", Give()))
    assert built.execute() == "done"
    assert not built.is_running() and built.get_active_states() == []


def test_callbacks_get_documented_arguments():
    seen = []
    built = machine(("A", Give(), {"done": "B"}), ("B", Give()))
    built.register_start_cb(lambda ud, labels, extra: seen.append(("start", labels, extra)), [1])
    built.register_transition_cb(lambda ud, labels: seen.append(("transition", labels)))
    built.register_termination_cb(lambda ud, labels, outcome: seen.append(("end", labels, outcome)))
    built.execute()
    assert seen == [("start", ["A"], 1), ("transition", ["B"]), ("end", ["B"], "done")]


def test_missing_state_is_found_before_anything_runs():
    ran = []
    built = machine(
        ("A", smach.CBState(lambda ud: ran.append(1) or "done", outcomes=["done"]), {"done": "NOWHERE"}),
        outcomes=("other",),
    )
    with pytest.raises(smach.InvalidTransitionError, match="NOWHERE"):
        built.check_consistency()
    assert built.execute() is None and ran == []


def test_add_refuses_unknown_outcome_and_used_label():
    built = smach.StateMachine(["done"])
    with built:
        with pytest.raises(smach.InvalidTransitionError):
            smach.StateMachine.add("A", Give(), {"nothing": "A"})
        smach.StateMachine.add("A", Give())
        with pytest.raises(smach.InvalidStateError):
            smach.StateMachine.add("A", Give())
    with pytest.raises(smach.InvalidConstructionError):
        smach.StateMachine.add("B", Give())


def test_state_errors():
    def fail(ud):
        raise RuntimeError("broken")

    with pytest.raises(smach.InvalidUserCodeError, match="broken"):
        machine(("A", smach.CBState(fail, outcomes=["done"]))).execute()
    broken = machine(("A", Give(outcome="what")))
    with pytest.raises(smach.InvalidTransitionError):
        broken.execute()
    assert not broken.is_running()


def test_userdata_is_remapped_and_guarded():
    @smach.cb_interface(input_keys=["x"], output_keys=["y"], outcomes=["done"])
    def add_one(ud):
        with pytest.raises(smach.InvalidUserCodeError):
            _ = ud.z
        ud.y = ud.x + 1
        return "done"

    inner = machine(("A", smach.CBState(add_one), {}, {"x": "a", "y": "b"}), input_keys=["a"], output_keys=["b"])
    outer = machine(
        ("INNER", inner, {"done": "A"}, {"a": "start", "b": "middle"}),
        ("A", smach.CBState(add_one), {}, {"x": "middle", "y": "end"}),
    )
    outer.userdata.start = 1
    assert outer.execute() == "done"
    assert (outer.userdata.middle, outer.userdata["end"]) == (2, 3)


def test_input_only_value_cannot_be_changed():
    class Box:
        content = 1

    def change(ud):
        assert isinstance(ud.box, Box)
        ud.box.content = 2
        return "done"

    view = machine(("A", smach.CBState(change, outcomes=["done"], input_keys=["box"])))
    view.userdata.box = Box()
    with pytest.raises(smach.InvalidUserCodeError):
        view.execute()
    both = machine(("A", smach.CBState(change, outcomes=["done"], io_keys=["box"])))
    both.userdata.box = Box()
    assert both.execute() == "done" and both.userdata.box.content == 2


@pytest.mark.parametrize("services,ends", [(True, "preempted"), (False, "preempted")])
def test_preempt_reaches_the_running_state_or_else_the_next(services, ends):
    first = Waiter(services)
    outer = machine(("INNER", machine(("A", first, {"done": "B"}), ("B", Waiter()))))
    result = []
    thread = threading.Thread(target=lambda: result.append(outer.execute()), daemon=True)
    thread.start()
    assert first.started.wait(10.0)
    outer.request_preempt()
    thread.join(10.0)
    assert result == [ends]
    assert not outer.preempt_requested() and not first.preempt_requested()


def test_threads_build_their_own_machines():
    failures = []

    def build():
        try:
            for _ in range(200):
                assert list(machine(("A", Give()), ("B", Give())).get_children()) == ["A", "B"]
        except Exception as error:  # reported by the test
            failures.append(error)

    threads = [threading.Thread(target=build) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(30.0)
    assert failures == []


def test_sequence_and_auto():
    sequence = smach.Sequence(outcomes=["done", "failed"], connector_outcome="done")
    with sequence:
        smach.Sequence.add("A", Give())
        smach.Sequence.add("B", Give("aborted", ("done", "aborted")), transitions={"aborted": "failed"})
        smach.Sequence.add("C", Give())
    assert sequence.execute() == "failed"
    auto = smach.StateMachine(["done"])
    with auto:
        smach.StateMachine.add_auto("A", Give(), ["done"])
        smach.StateMachine.add("B", Give())
    assert ("done", "A", "B") in auto.get_internal_edges() and auto.execute() == "done"


def test_iterator_ends_by_outcome_or_exhaustion():
    def run(break_at):
        seen = []
        it = smach.Iterator(
            outcomes=["found", "exhausted"],
            input_keys=[],
            output_keys=[],
            it=lambda: range(5),
            it_label="index",
            exhausted_outcome="exhausted",
        )

        def look(ud):
            seen.append(ud.index)
            return "stop" if ud.index == break_at else "go"

        with it:
            smach.Iterator.set_contained_state(
                "LOOK",
                smach.CBState(look, outcomes=["go", "stop"], input_keys=["index"]),
                loop_outcomes=["go"],
                final_outcome_map={"stop": "found"},
            )
        return it.execute(), seen

    assert run(2) == ("found", [0, 1, 2])
    assert run(9) == ("exhausted", [0, 1, 2, 3, 4])


def test_concurrence_maps_outcomes_and_preempts_the_rest():
    waiter = Waiter()
    both = smach.Concurrence(
        ["won", "lost"],
        default_outcome="lost",
        outcome_map={"won": {"FAST": "done", "SLOW": "preempted"}},
        child_termination_cb=lambda outcomes: outcomes["FAST"] == "done",
    )
    with both:
        smach.Concurrence.add("FAST", Give())
        smach.Concurrence.add("SLOW", waiter)
    assert both.execute() == "won"
    assert both.get_active_states() == [] and not waiter.preempt_requested()


def test_concurrence_tells_of_a_child_that_raises():
    def fail(ud):
        raise RuntimeError("broken")

    both = smach.Concurrence(["done"], default_outcome="done")
    with both:
        smach.Concurrence.add("BAD", smach.CBState(fail, outcomes=["done"]))
        smach.Concurrence.add("SLOW", Waiter())
    with pytest.raises(smach.InvalidUserCodeError, match="broken"):
        both.execute()
    assert not both.is_running()


def test_core_knows_no_ros():
    import subprocess
    import sys

    code = "import sys, smach; sys.exit(any(name.split('.')[0] in ('rospy', 'roslib') for name in sys.modules))"
    assert subprocess.run([sys.executable, "-c", code], timeout=60, check=False).returncode == 0
