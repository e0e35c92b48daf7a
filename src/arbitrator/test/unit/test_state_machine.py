"""What the machine of a plan does, with steps whose outcome is given."""

import pytest

import smach
from arbitrator.node_runs import OUTCOMES
from arbitrator.plan import Candidate, Do, InSequence, walk
from arbitrator.state_machine import build_state_machine, candidate_label, child_label, plan_label, step_label
from typed_arguments import FilledFrame


class Step(smach.State):
    """Writes down that it ran and gives the outcome of its frame."""

    def __init__(self, frame, clause, outcomes_by_frame, log):
        super().__init__(outcomes=list(OUTCOMES))
        self._name, self._clause, self._answers, self._log = frame.name, clause, outcomes_by_frame, log

    def execute(self, userdata):
        self._log.append(self._name)
        answer = self._answers.get(self._name, "succeeded")
        return answer.pop(0) if isinstance(answer, list) else answer


def frame(name):
    return FilledFrame(name=name, server="server")


def do(*ways):
    """A clause; each way is the names of its frames, one letter each."""
    return Do(" or ".join(ways), tuple(Candidate(frames=tuple(frame(name) for name in way)) for way in ways))


def sequence(*children):
    return InSequence("all", tuple(child if isinstance(child, InSequence) else do(*child) for child in children))


def run(plan, outcomes_by_frame):
    log, ends = [], []
    machine = build_state_machine(
        plan,
        lambda frame, clause, scope: Step(frame, clause, outcomes_by_frame, log),
        observe=lambda event: ends.append((event.number, event.outcome)) if event.outcome else None,
    )
    numbers = [number for number, part in enumerate(walk(plan)) if isinstance(part, Do)]
    outcome = machine.execute()
    # Clauses by their place among the clauses.
    return outcome, "".join(log), [(numbers.index(number), how) for number, how in ends if number in numbers]


@pytest.mark.parametrize(
    "ways,outcomes,result,log",
    [
        (["a"], {}, "succeeded", "a"),
        (["ab"], {}, "succeeded", "ab"),
        (["a", "b"], {}, "succeeded", "a"),
        (["a", "b"], {"a": "aborted"}, "succeeded", "ab"),
        (["ab", "cd"], {"b": "aborted"}, "succeeded", "abcd"),
        (["ab", "ad"], {"b": "aborted"}, "succeeded", "abad"),
        (["a", "b"], {"a": "aborted", "b": "aborted"}, "aborted", "ab"),
        (["ab", "c"], {"a": "preempted"}, "preempted", "a"),
        (["a", "bc", "d"], {"a": "aborted", "c": "preempted"}, "preempted", "abc"),
        (["aa"], {}, "succeeded", "aa"),
    ],
)
def test_one_clause(ways, outcomes, result, log):
    assert run(do(*ways), outcomes) == (result, log, [(0, result)])


@pytest.mark.parametrize(
    "plan,outcomes,result,log,ends",
    [
        (sequence("a", "b"), {}, "succeeded", "ab", [(0, "succeeded"), (1, "succeeded")]),
        # A clause that was done is not done again, whatever becomes of the next one.
        (sequence("a", "bc"), {"b": "aborted"}, "succeeded", "abc", [(0, "succeeded"), (1, "succeeded")]),
        (
            sequence("a", "bc", "d"),
            {"b": "aborted"},
            "succeeded",
            "abcd",
            [(0, "succeeded"), (1, "succeeded"), (2, "succeeded")],
        ),
        (
            sequence("ab", "cd"),
            {"a": "aborted", "c": "aborted"},
            "succeeded",
            "abcd",
            [(0, "succeeded"), (1, "succeeded")],
        ),
        # Not even when another candidate of it could still be tried.
        (sequence("ab", "c"), {"c": "aborted"}, "aborted", "ac", [(0, "succeeded"), (1, "aborted")]),
        (
            sequence("a", "bc", "d"),
            {"b": "aborted", "c": "aborted"},
            "aborted",
            "abc",
            [(0, "succeeded"), (1, "aborted")],
        ),
        (sequence("a", "b"), {"a": "aborted"}, "aborted", "a", [(0, "aborted")]),
        (
            sequence("a", sequence("bc", "d"), "e"),
            {"b": "aborted"},
            "succeeded",
            "abcde",
            [(number, "succeeded") for number in range(4)],
        ),
        (
            sequence("a", sequence("b", "c"), "d"),
            {"c": "aborted"},
            "aborted",
            "abc",
            [(0, "succeeded"), (1, "succeeded"), (2, "aborted")],
        ),
        (sequence("a", "a"), {}, "succeeded", "aa", [(0, "succeeded"), (1, "succeeded")]),
        (sequence("a", "a"), {"a": ["succeeded", "aborted"]}, "aborted", "aa", [(0, "succeeded"), (1, "aborted")]),
    ],
)
def test_clauses_in_sequence(plan, outcomes, result, log, ends):
    assert run(plan, outcomes) == (result, log, ends)


def test_failover_in_a_sequence_of_frames_starts_that_sequence_again():
    plan = InSequence("all", (do("a"), do("bc", "bd")))
    assert run(plan, {"c": "aborted"}) == ("succeeded", "abcbd", [(0, "succeeded"), (1, "succeeded")])


PLAN = InSequence("all", (do("ab", "c"), InSequence("inner", (do("d", "ef"), do("g")))))


@pytest.mark.parametrize("number", range(6))
def test_preempted_in_each_place_nothing_more_begins(number):
    whole = "abdefg"  # what runs when d fails
    name = whole[number]
    result, log, ends = run(PLAN, {"d": "aborted", name: "preempted"})
    assert (result, log) == ("preempted", whole[: number + 1])
    assert [outcome for _, outcome in ends[:-1]] == ["succeeded"] * (len(ends) - 1)
    assert ends[-1][1] == "preempted"


class StepThatHears(Step):
    """Ends as preempted when its machine was asked to end, as a step of the executor does."""

    def execute(self, userdata):
        outcome = super().execute(userdata)
        if self.preempt_requested():
            self.service_preempt()
            return "preempted"
        return outcome


@pytest.mark.parametrize("number", range(6))
def test_machine_that_is_asked_to_end_ends_where_it_is(number):
    whole, log = "abdefg", []

    def make_step(frame, clause, scope):
        step = StepThatHears(frame, clause, {"d": "aborted"}, log)
        if frame.name == whole[number]:
            execute = step.execute
            step.execute = lambda userdata: machine.request_preempt() or execute(userdata)
        return step

    machine = build_state_machine(PLAN, make_step)
    assert machine.execute() == "preempted"
    assert "".join(log) == whole[: number + 1]


def test_steps_are_told_the_number_of_their_clause():
    numbers = {}

    def make_step(frame, clause, scope):
        numbers[frame.name] = clause
        return Step(frame, clause, {}, [])

    build_state_machine(PLAN, make_step)
    assert numbers == {"a": 1, "b": 1, "c": 1, "d": 3, "e": 3, "f": 3, "g": 4}


def test_labels_are_the_words_and_show_in_the_machine():
    plan = InSequence("Ping and wave at Alice.", (do("a"), Do("wave at Alice", do("b").candidates)))
    machine = build_state_machine(plan, lambda frame, clause, scope: Step(frame, clause, {}, []))
    assert list(machine.get_children()) == ["1 a", "2 wave at Alice"]
    assert list(machine["2 wave at Alice"].get_children()) == ["candidate_1"]
    assert list(machine["2 wave at Alice"]["candidate_1"].get_children()) == ["1_b_by_server"]


@pytest.mark.parametrize(
    "words,label",
    [
        ("turn left", "turn left"),
        ("go to the and/or gate", "go to the and or gate"),
        ('say "hello"\n{now}', "say hello now"),
        ("", "plan"),
        ("///", "plan"),
        ("gå till köket", "gå till köket"),
        ("go " * 100, "go " * 20 + "..."),
    ],
)
def test_labels_are_readable(words, label):
    assert plan_label(Do(words, do("a").candidates)) == label


def test_labels_hold_no_slash():
    turning = FilledFrame(name="turning", server="/robot/turn")
    labels = step_label(0, turning) + candidate_label(0) + child_label(0, Do("a/b", do("a").candidates))
    assert "/" not in labels
