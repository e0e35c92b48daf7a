"""What people say of deeds and servers, and what the robot answers."""

from dataclasses import replace
from typing import Dict, Optional

import pytest

from experience.known import Subject
from experience.memory import Memory
from experience.rules import RuleKind
from experience.teaching import TEACHING, Answer, Asked
from experience.trial import Circumstances, Judgement, Outcome, Trial
from typed_arguments import TypedArgument

SERVERS = {"waving": frozenset(["/left_arm_waving", "/right_arm_waving"]), "grasping": frozenset(["/arm_a", "/arm_b"])}
WAVED = Trial("c1", "Wave at Anna.", 1.0, "waving", "/right_arm_waving", "", Circumstances(), 2.0, Outcome.SUCCEEDED)


def said(name: str, memory: Memory, reasons: Optional[Dict[str, str]] = None, **elements: str) -> Answer:
    arguments = {key: TypedArgument(name=key, text=text, lemma=text.rstrip("s")) for key, text in elements.items()}
    return TEACHING[name](Asked(memory, arguments, SERVERS, reasons or {}, "what was said", 5.0))


def test_praise_and_criticism_name_what_they_count() -> None:
    memory = Memory([WAVED])
    answer = said("criticizing_a_deed", memory)
    assert answer.sentence == 'I am sorry. I remember that right_arm_waving did "Wave at Anna" wrong.'
    assert answer.judged == ("c1", Judgement.WRONG)
    assert memory.experience.expect(Subject("waving", WAVED.server), Circumstances()).rate < 0.5
    assert said("praising_a_deed", memory).sentence.startswith("Thank you. I remember")
    assert memory.experience.expect(Subject("waving", WAVED.server), Circumstances()).rate > 0.5


@pytest.mark.parametrize("name", ["praising_a_deed", "criticizing_a_deed"])
def test_nothing_to_judge_is_said(name: str) -> None:
    assert "remember nothing" in said(name, Memory()).sentence
    failed = Memory([replace(WAVED, outcome=Outcome.FAILED, reason="aborted")])
    assert said(name, failed) == Answer('"Wave at Anna" did not work anyway.')


def test_next_time_is_about_what_was_done_last() -> None:
    answer = said("preferring_a_server", Memory([WAVED]), server="the left arm", frequency="once")
    assert answer.sentence == "All right: next time first left arm for waving."
    (rule,) = answer.kept
    assert (rule.kind, rule.frame, rule.is_once) == (RuleKind.FIRST, "waving", True)


def test_never_for_a_thing_or_a_frame() -> None:
    memory = Memory()
    (thing,) = said("avoiding_a_server", memory, server="arm_a", purpose="cups").kept
    assert (thing.server, thing.frame, thing.thing) == ("arm_a", "", "cup")
    (frame,) = said("avoiding_a_server", memory, server="arm_a", purpose="grasping").kept
    assert (frame.frame, frame.thing) == ("grasping", "")
    assert said("question_of_rules", memory).sentence == (
        "My rules are: never arm_a for cup; never arm_a for grasping."
    )


def test_rule_is_taken_back_and_the_opposite_one_replaced() -> None:
    memory = Memory()
    never = said("avoiding_a_server", memory, server="arm_a").kept
    assert said("preferring_a_server", memory, server="arm_a", frequency="always").dropped == never
    assert len(said("taking_back_a_rule", memory, server="arm_a").dropped) == 1
    assert memory.rules == ()
    assert said("taking_back_a_rule", memory, server="arm_a").sentence == 'I have no rule about "arm_a".'


def test_last_rule_or_all_are_taken_back() -> None:
    memory = Memory()
    assert said("taking_back_a_rule", memory, server="all").sentence == "I have no rules about my parts."
    for server in ("arm_a", "arm_b", "the left arm"):
        said("avoiding_a_server", memory, server=server)
    assert [rule.server for rule in said("taking_back_a_rule", memory, server="last").dropped] == ["left arm"]
    assert len(said("taking_back_a_rule", memory, server="all").dropped) == 2
    assert memory.rules == ()


def test_unknown_server_makes_no_rule() -> None:
    answer = said("avoiding_a_server", Memory(), server="the third arm")
    assert answer == Answer('I have no server that is called "third arm".')


def test_choice_is_explained_by_what_decided() -> None:
    memory = Memory([WAVED])
    why = "I asked right_arm_waving first: left_arm_waving failed 7 of 9 times in the kitchen."
    assert said("question_of_choice", memory, {"c1": why}, server="right arm").sentence == why
    plain = said("question_of_choice", memory, server="right arm").sentence
    assert plain == "Right_arm_waving succeeded 1 of 1 times. That did not decide: my policy or chance did."
    failed = replace(WAVED, server="/left_arm_waving", outcome=Outcome.FAILED, reason="aborted: it is stuck")
    after = Memory([failed, WAVED])
    assert said("question_of_choice", after, server="right arm").sentence == (
        "Left_arm_waving had failed: it aborted: it is stuck."
    )
    assert said("question_of_choice", memory, server="third arm").sentence == 'I remember no deed of "third arm".'
