"""The plan lights up as SMACH says."""

import pytest

from web_console.progress import Progress, conclude, is_machine_of, light, ordered, place_of
from web_console.views import CandidateView, PlanView, StepView


def step(name):
    return StepView(name, f"{name}_server", ())


def do(label, *candidates):
    return PlanView("DO", label, candidates=tuple(CandidateView(tuple(map(step, names))) for names in candidates))


PLAN = PlanView(
    "SEQUENCE", "Ping and wave", children=(do("Ping", ["pinging"]), do("wave", ["raising", "waving"], ["waving"]))
)
ROOT = "/Ping and wave"


def after(*statuses):
    progress = Progress()
    for path, active, info in statuses:
        progress = progress.heard(path, active, info)
    return light(PLAN, progress)


def states(plan):
    return [
        (child.state, [(one.state, [step.state for step in one.steps]) for one in child.candidates])
        for child in plan.children
    ]


@pytest.mark.parametrize(
    ("path", "place"),
    [
        ("/Ping and wave", ()),
        ("/Ping and wave/2 wave", (1,)),
        ("/Ping and wave/2 wave/candidate_1", (1, 0)),
        ("/20 metres/1 go/candidate_12", (0, 11)),
        ("/x/loop/1 a", (0,)),
        ("/2 steps/2 steps/1 a", (0,)),
        ("", ()),
    ],
)
def test_path_of_a_container_is_a_place(path, place):
    assert place_of(path) == place


def test_active_step_is_lit():
    lit = after(
        (ROOT, ["2 wave"], "HEARTBEAT"),
        (f"{ROOT}/2 wave", ["candidate_1"], "HEARTBEAT"),
        (f"{ROOT}/2 wave/candidate_1", ["2_waving_by_waving_server"], "HEARTBEAT"),
    )
    assert states(lit)[1] == ("active", [("active", ["waiting", "active"]), ("waiting", ["waiting"])])


def test_what_is_left_is_done():
    lit = after((ROOT, ["1 Ping"], ""), (ROOT, ["2 wave"], ""))
    assert [child.state for child in lit.children] == ["done", "active"]


def test_failed_candidate_is_marked_and_the_next_is_lit():
    one, two = f"{ROOT}/2 wave/candidate_1", f"{ROOT}/2 wave/candidate_2"
    lit = after(
        (ROOT, ["2 wave"], ""),
        (f"{ROOT}/2 wave", ["candidate_1"], ""),
        (one, ["1_raising_by_x"], ""),
        (one, [], "Terminated 1_raising_by_x with outcome aborted"),
        (f"{ROOT}/2 wave", ["candidate_2"], ""),
        (two, ["1_waving_by_x"], ""),
    )
    assert states(lit)[1] == ("active", [("failed", ["failed", "waiting"]), ("active", ["active"])])


def test_single_clause_is_the_root():
    plan = do("Ping", ["pinging"])
    progress = Progress().heard("/Ping", ["candidate_1"], "").heard("/Ping/candidate_1", ["1_pinging_by_ping"], "")
    lit = light(plan, progress)
    assert (lit.state, lit.candidates[0].state, lit.candidates[0].steps[0].state) == ("active",) * 3


def test_done_command_has_nothing_active_or_waiting():
    ended = conclude(PLAN, "DONE")
    assert states(ended) == [
        ("done", [("done", ["done"])]),
        ("done", [("done", ["done", "done"]), ("waiting", ["waiting"])]),
    ]


def test_failed_command_keeps_what_was_done():
    ended = conclude(after((ROOT, ["1 Ping"], ""), (ROOT, ["2 wave"], "")), "FAILED")
    assert [child.state for child in ended.children] == ["done", "failed"]
    assert ended.state == "failed"


def test_stopped_command_is_stopped():
    assert conclude(after((ROOT, ["1 Ping"], "")), "SUPERSEDED").children[0].state == "stopped"


def test_flood_of_states_is_bounded():
    progress = Progress()
    for number in range(9000):
        progress = progress.heard("/x", [f"{number + 1} y"], "")
    assert len(progress.states) <= 4000


def test_candidates_of_each_clause_are_ordered():
    sequences = [
        [("pinging", "pinging_server"), ("waving", "waving_server")],
        [("pinging", "pinging_server"), ("raising", "raising_server"), ("waving", "waving_server")],
    ]
    waving = ordered(PLAN, sequences).children[1]
    assert [len(one.steps) for one in waving.candidates] == [1, 2]
    assert ordered(PLAN, []) == PLAN


@pytest.mark.parametrize(
    ("path", "is_own"),
    [
        ("/Ping and wave/1 Ping", True),
        ("/Ping and ...", True),
        ("/plan", True),
        ("/Go to the office", False),
        ("/Ping and wave at Bob", False),
    ],
)
def test_machine_is_known_by_its_words(path, is_own):
    assert is_machine_of(path, PLAN) == is_own
