"""Order of the candidates."""

import math
import sys
import types

import pytest

from arbitrator.plan import Candidate, Do, InSequence
from arbitrator.policy import POLICIES, Forbidden, LearnedPolicy, Policy, PolicyError, arbitrate, load_policy, order
from experience.known import learned_from
from experience.rules import Rule, RuleKind
from experience.snapshot import Snapshot
from experience.trial import Circumstances, Outcome, Trial
from typed_arguments import FilledFrame


def make_candidate(name, coverage=1.0, steps=1, preference=0):
    frame = FilledFrame(name=name, server=f"{name}_server")
    return Candidate(frames=(frame,) * steps, coverage=coverage, preference=preference)


def names(candidates):
    return [candidate.frames[0].name for candidate in candidates]


MANY = [make_candidate(f"frame{index}") for index in range(20)]


def test_random_policy_with_a_seed_repeats_itself():
    one, other = load_policy("random", seed=7), load_policy("random", seed=7)
    first = [names(order(MANY, one)) for _ in range(3)]
    assert first == [names(order(MANY, other)) for _ in range(3)]
    assert first[0] != first[1]


def test_random_policy_gives_every_candidate_the_first_place():
    policy = load_policy("random", seed=1)
    firsts = {names(order(MANY[:4], policy))[0] for _ in range(200)}
    assert firsts == {"frame0", "frame1", "frame2", "frame3"}


@pytest.mark.parametrize("name", sorted(POLICIES))
def test_every_policy_tries_the_larger_coverage_first(name):
    candidates = [make_candidate("low", 0.5), make_candidate("high", 1.0), make_candidate("middle", 0.75)]
    assert names(order(candidates, load_policy(name))) == ["high", "middle", "low"]


@pytest.mark.parametrize("name", sorted(POLICIES))
@pytest.mark.parametrize("seed", range(50))
def test_no_policy_draws_lots_between_readings(name, seed):
    candidates = [
        make_candidate("third", 1.0, preference=2),
        make_candidate("second", 1.0, preference=1),
        make_candidate("first", 0.5, steps=3),
    ]
    assert names(order(candidates, load_policy(name, seed=seed))) == ["first", "second", "third"]


def test_random_policy_draws_lots_within_a_reading():
    candidates = [make_candidate("a"), make_candidate("b"), make_candidate("z", preference=1)]
    orders = {tuple(names(order(candidates, load_policy("random", seed=seed)))) for seed in range(50)}
    assert orders == {("a", "b", "z"), ("b", "a", "z")}


@pytest.mark.parametrize("name", ["in_order", "most_coverage"])
def test_stable_policies_keep_the_order_of_the_registrar(name):
    candidates = [make_candidate("c", 0.5), make_candidate("b"), make_candidate("d", 0.5), make_candidate("a")]
    assert names(order(candidates, load_policy(name))) == ["b", "a", "c", "d"]


def test_fewest_steps_prefers_short_sequences():
    candidates = [make_candidate("long", steps=3), make_candidate("short"), make_candidate("medium", steps=2)]
    assert names(order(candidates, load_policy("fewest_steps"))) == ["short", "medium", "long"]


def test_two_equal_candidates_both_stay():
    twin = make_candidate("twin")
    assert names(order([twin, twin], load_policy("random"))) == ["twin", "twin"]


class Reverse(Policy):
    def order(self, candidates):
        return list(reversed(candidates))


class Forgetful(Policy):
    def order(self, candidates):
        return list(candidates)[1:]


class Broken(Policy):
    def order(self, candidates):
        raise KeyError("no table")


class Unmade(Policy):
    """Abstract still."""


@pytest.fixture
def own_module(monkeypatch):
    module = types.ModuleType("own_policies")
    module.Reverse, module.Unmade, module.not_a_class = Reverse, Unmade, 3
    monkeypatch.setitem(sys.modules, "own_policies", module)


def test_own_policy_is_loaded_by_name(own_module):
    assert names(order(MANY[:3], load_policy("own_policies:Reverse"))) == ["frame2", "frame1", "frame0"]


@pytest.mark.parametrize(
    "name,part",
    [
        ("randm", "random"),
        ("", "random"),
        (":X", "package.module:ClassName"),
        ("no_such_module_here:X", "cannot import"),
        ("own_policies:Missing", "has no 'Missing'"),
        ("own_policies:not_a_class", "subclass"),
        ("own_policies:Unmade", "cannot be made"),
    ],
)
def test_wrong_policy_is_refused_with_the_reason(own_module, name, part):
    with pytest.raises(PolicyError, match=part):
        load_policy(name)


@pytest.mark.parametrize("policy,part", [(Forgetful(), "each of the 2 candidates"), (Broken(), "KeyError: 'no table'")])
def test_policy_that_misbehaves_is_named(policy, part):
    with pytest.raises(PolicyError, match=part):
        order(MANY[:2], policy)


@pytest.mark.parametrize("coverage", [-0.1, 1.1, math.nan, math.inf])
def test_coverage_out_of_range_is_refused(coverage):
    with pytest.raises(ValueError, match="coverage"):
        make_candidate("x", coverage)


def test_negative_preference_is_refused():
    with pytest.raises(ValueError, match="preference"):
        make_candidate("x", preference=-1)


def test_clauses_are_ordered_each_for_itself():
    one = Do("one", (make_candidate("b", 0.5), make_candidate("a")))
    two = Do("two", (make_candidate("d", preference=1), make_candidate("c")))
    plan = arbitrate(InSequence("all", (one, InSequence("inner", (two, one)))), load_policy("in_order"))
    inner = plan.children[1]
    assert [names(part.candidates) for part in (plan.children[0],) + inner.children] == [
        ["a", "b"],
        ["c", "d"],
        ["a", "b"],
    ]
    assert (plan.label, inner.label, plan.children[0].label) == ("all", "inner", "one")


def tried(name, place, *outcomes, took_s=1.0):
    """Trials of the server of a candidate of `make_candidate`."""
    about = Circumstances(place=place)
    return [
        Trial("c", "", 0.0, name, f"{name}_server", "", about, took_s, Outcome.SUCCEEDED if one else Outcome.FAILED)
        for one in outcomes
    ]


def learned(trials, **known):
    policy = LearnedPolicy(seed=1)
    policy.learn(Snapshot(learned_from(trials), **known))
    return policy


A, B = make_candidate("arm_a"), make_candidate("arm_b")
IN_KITCHEN = tried("arm_a", "kitchen", *[0, 0, 1, 0, 0, 1, 0, 0, 0]) + tried("arm_a", "office", *[1] * 9)


def test_learned_policy_without_experience_is_the_order_of_the_registrar():
    policy = learned([])
    assert names(order(MANY, policy)) == names(MANY)
    assert policy.reason() == ""


def test_learned_policy_asks_the_server_first_that_works_here():
    trials = IN_KITCHEN + tried("arm_b", "kitchen", 1, 1, 0, 1)
    policy = learned(trials, place="kitchen")
    trace = []
    assert names(order([A, B], policy, trace=trace)) == ["arm_b", "arm_a"]
    assert trace == ["policy: I asked arm_b_server first: arm_a_server failed 7 of 9 times in the kitchen."]
    assert names(order([A, B], learned(trials, place="office"))) == ["arm_a", "arm_b"]


def test_learned_policy_asks_the_faster_one_of_two_that_work():
    trials = tried("arm_a", "", *[1] * 6, took_s=20.0) + tried("arm_b", "", *[1] * 6, took_s=2.0)
    assert names(order([A, B], learned(trials))) == ["arm_b", "arm_a"]


def test_sequence_is_as_good_as_its_frames_together():
    pair = Candidate(A.frames + B.frames)
    short = make_candidate("direct")
    trials = [
        *tried("arm_a", "", *[1] * 6),
        *tried("arm_b", "", *[1, 0] * 6),
        *tried("direct", "", *[1, 1, 0, 1] * 3),
    ]
    assert order([pair, short], learned(trials)) == (short, pair)


def test_learned_policy_explores_only_where_failing_harms_nothing():
    known, new = tried("arm_a", "", *[0, 1] * 6, took_s=10.0), make_candidate("arm_c")
    assert names(order([new, A], learned(known))) == ["arm_a", "arm_c"]
    explorable = frozenset(["arm_a", "arm_c"])
    assert names(order([A, new], learned(known, explorable=explorable))) == ["arm_c", "arm_a"]


def test_learned_policy_stays_inside_the_reading():
    trials = tried("arm_a", "", *[0] * 9) + tried("arm_b", "", *[1] * 9)
    likelier = make_candidate("arm_a", coverage=0.5)
    other = make_candidate("arm_b", preference=1)
    assert names(order([other, likelier], learned(trials))) == ["arm_a", "arm_b"]


def test_same_knowledge_gives_the_same_order():
    trials = [trial for one in MANY for trial in tried(one.frames[0].name, "", 1, len(one.frames[0].name) % 2)]
    assert names(order(MANY, learned(trials))) == names(order(MANY, learned(trials)))


@pytest.mark.parametrize("name", sorted(POLICIES))
def test_forbidden_server_is_no_candidate_under_any_policy(name):
    rule = Rule("r", RuleKind.NEVER, "arm_a", said="Never use arm_a.")
    trace = []
    plan = arbitrate(Do("take", (A, B)), load_policy(name, seed=1), [rule], trace=trace)
    assert names(plan.candidates) == ["arm_b"]
    assert "rule: never arm_a: 2 -> 1 candidates" in trace


def test_rule_never_turns_a_command_into_another_reading():
    rule = Rule("r", RuleKind.NEVER, "arm_a", said="Never use arm_a.")
    other = make_candidate("arm_b", preference=1)
    with pytest.raises(Forbidden, match=r'you said: "Never use arm_a\."'):
        arbitrate(Do("take", (A, other)), load_policy("in_order"), [rule])


@pytest.mark.parametrize("name", sorted(POLICIES))
def test_wanted_server_comes_first_in_its_tier(name):
    rule = Rule("r", RuleKind.FIRST, "the arm b", is_once=True, said="Next time use arm b.")
    likelier = make_candidate("arm_c", preference=0)
    plan = arbitrate(Do("take", (A, B)), load_policy(name, seed=1), [rule])
    assert names(plan.candidates) == ["arm_b", "arm_a"]
    lower = make_candidate("arm_b", preference=1)
    plan = arbitrate(Do("take", (lower, likelier)), load_policy(name, seed=1), [rule])
    assert names(plan.candidates) == ["arm_c", "arm_b"]
