"""Memory: trials and rules together."""

from dataclasses import replace

from experience.known import Subject
from experience.memory import Memory
from experience.rules import RuleKind, is_named, words_of
from experience.trial import Circumstances, Judgement, Outcome, Trial, kinds_of, referents_of
from experience.whereabouts import Sequences, Whereabouts
from typed_arguments import FilledFrame, Measure, TypedArgument

TRIAL = Trial("c1", "Wave.", 0.0, "waving", "/left_arm_waving", "", Circumstances(), 1.0, Outcome.SUCCEEDED)


def test_what_a_person_says_is_about_what_succeeded_in_the_last_command() -> None:
    failed = replace(TRIAL, command_id="c2", server="/arm", outcome=Outcome.FAILED)
    memory = Memory([TRIAL, failed, replace(TRIAL, command_id="c2")])
    judged = memory.judge(Judgement.WRONG)
    assert [trial.command_id for trial in judged] == ["c2"]
    assert [trial.judgement for trial in memory.trials] == [Judgement.NONE, Judgement.NONE, Judgement.WRONG]
    assert memory.experience.expect(Subject("waving", "/left_arm_waving"), Circumstances()).rate < 0.6


def test_rule_that_holds_once_is_dropped_when_it_was_followed() -> None:
    memory = Memory()
    once = memory.teach(RuleKind.FIRST, "the left arm", frame="waving", is_once=True)
    always = memory.teach(RuleKind.NEVER, "right arm")
    assert once is not None and always is not None
    assert memory.hear(replace(TRIAL, server="/right_arm_waving")) == ()
    assert memory.hear(TRIAL) == (once.rule_id,)
    assert memory.rules == (always,)
    memory.take_back([always])
    assert memory.rules == ()


def test_same_rule_is_kept_once() -> None:
    memory = Memory()
    assert memory.teach(RuleKind.NEVER, "arm_a", thing="glass") == memory.teach(RuleKind.NEVER, "arm_a", thing="glass")
    assert len(memory.rules) == 1


def test_servers_are_meant_by_the_words_of_their_names() -> None:
    assert words_of("the left arm") == ("left", "arm")
    assert is_named("the left arm", "/robot/left_arm_waving")
    assert is_named("arm_a", "/arm_a") and not is_named("arm_a", "/arm_b")
    assert is_named("left arm", "/LeftArmServer")
    assert not is_named("", "/arm_a")


def test_rule_is_about_a_thing_by_its_noun() -> None:
    rule = Memory().teach(RuleKind.NEVER, "arm_a", thing="glass")
    assert rule is not None
    glass = TypedArgument(name="theme", text="wine glasses", lemma="glass")
    assert rule.is_about(FilledFrame("grasping", (glass,), "/arm_a"))
    assert not rule.is_about(FilledFrame("grasping", (glass,), "/arm_b"))
    assert not rule.is_about(FilledFrame("grasping", (TypedArgument("theme", "cup", lemma="cup"),), "/arm_a"))


def test_kinds_and_referents_of_arguments() -> None:
    cups = TypedArgument("theme", "red cups", lemma="cup", referents=("cup_1", "cup_2", "cup_3"), referent_count=2)
    far = TypedArgument("distance", "two metres", lemma="metre", measure=Measure("length"))
    person = TypedArgument("recipient", "her", semantic_type="Human")
    assert kinds_of([cups, far, person]) == "recipient=human theme=cup"
    assert referents_of([cups, far, person]) == "theme=cup_1+cup_2"


def test_trial_belongs_to_the_room_where_it_began() -> None:
    where = Whereabouts()
    assert where.at(5.0) == ""
    assert where.hear("hall", 10.0) and not where.hear("hall", 11.0) and where.hear("kitchen", 20.0)
    assert [where.at(time_s) for time_s in (5.0, 15.0, 20.0)] == ["hall", "hall", "kitchen"]


def test_sequence_of_a_candidate_begins_anew_after_a_failure() -> None:
    sequences = Sequences()
    assert sequences.hear("c", 0, "going", "base", succeeded=True) == "going by base"
    assert sequences.hear("c", 0, "taking", "arm", succeeded=False) == "going by base, taking by arm"
    assert sequences.hear("c", 0, "taking", "hand", succeeded=True) == "taking by hand"
