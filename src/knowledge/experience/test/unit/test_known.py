"""What is known from trials: it is learned from few, depends on what matters, and is forgotten."""

from dataclasses import replace
from typing import List

import pytest

from experience.belief import CHANGED, aged, mean
from experience.known import MOST_CELLS, MOST_SUBJECTS, Aspect, Experience, Subject, learned_from
from experience.trial import Circumstances, Judgement, Outcome, Trial

KITCHEN, OFFICE = Circumstances(kinds="theme=cup", place="kitchen"), Circumstances(kinds="theme=cup", place="office")
ARM = Subject("grasping", "/arm_a")
TRIAL = Trial("c", "", 0.0, "grasping", "/arm_a", "", KITCHEN, 4.0, Outcome.SUCCEEDED)
FAILED = replace(TRIAL, outcome=Outcome.FAILED)


def rate(trials: List[Trial], about: Circumstances = KITCHEN) -> float:
    return learned_from(trials).expect(ARM, about).rate


def test_of_an_untried_server_little_is_expected_and_little_is_sure() -> None:
    untried = Experience().expect(ARM, KITCHEN)
    assert 0.35 < untried.rate < 0.5
    assert untried.gain(0.8) > 0.01
    assert untried.took_s is None and untried.cell is None


def test_failures_in_one_room_say_less_of_other_rooms() -> None:
    assert rate([FAILED] * 5, KITCHEN) < 0.1
    assert rate([FAILED] * 5, OFFICE) > 1.3 * rate([FAILED] * 5, KITCHEN)


def test_success_elsewhere_shows_that_it_was_the_room() -> None:
    trials = [FAILED] * 5
    before = learned_from(trials).expect(ARM, OFFICE).rate
    after = learned_from([*trials, *[replace(TRIAL, circumstances=OFFICE)] * 5])
    assert after.expect(ARM, OFFICE).rate > 0.75 > before
    assert after.expect(ARM, KITCHEN).rate < 0.35
    # A thing that was never seen fails in the kitchen like the others, and not elsewhere.
    assert after.expect(ARM, Circumstances(kinds="theme=glass", place="kitchen")).rate < 0.4
    assert after.expect(ARM, Circumstances(kinds="theme=glass", place="hall")).rate > 0.6


def test_room_and_kind_that_are_weak_are_told_apart() -> None:
    """It fails in the kitchen, and with glasses everywhere; plates in the office were never tried."""
    trials = []
    for place, kind in (("kitchen", "cup"), ("office", "glass"), ("office", "cup"), ("hall", "cup"), ("hall", "glass")):
        works = place != "kitchen" and kind != "glass"
        about = Circumstances(kinds=f"theme={kind}", place=place)
        trials += [replace(TRIAL if works else FAILED, circumstances=about)] * 6
    assert rate(trials, Circumstances(kinds="theme=plate", place="office")) > 0.7
    assert rate(trials, Circumstances(kinds="theme=glass", place="kitchen")) < 0.2


def test_few_trials_are_enough() -> None:
    assert rate([TRIAL] * 3) > 0.75
    assert rate([FAILED] * 3) < 0.25


def test_three_failures_overturn_twenty_successes() -> None:
    assert rate([TRIAL] * 20) > 0.9
    assert rate([TRIAL] * 20 + [FAILED] * 3) < 0.5


def test_two_successes_show_that_a_server_was_mended() -> None:
    others = [replace(TRIAL, server="/arm_b")] * 300
    assert rate([FAILED] * 10 + others) < 0.4
    assert rate([FAILED] * 10 + others + [TRIAL] * 2) > 0.8


def test_what_was_not_tried_for_long_is_open_again() -> None:
    others = [replace(TRIAL, server="/arm_b")] * 600
    assert rate([FAILED] * 20) < 0.05
    assert 0.3 < rate([FAILED] * 20 + others) < 0.6


def test_server_that_fails_in_one_room_is_known_by_the_room() -> None:
    there = replace(TRIAL, circumstances=OFFICE)
    trials = [FAILED, there] * 8
    assert rate(trials, KITCHEN) < 0.3
    assert rate(trials, OFFICE) > 0.7
    known = learned_from(trials).expect(ARM, KITCHEN)
    assert known.aspect is Aspect.PLACE
    assert known.cell is not None and known.cell.recent == (False,) * 8


def test_server_that_fails_everywhere_is_avoided_in_a_new_room() -> None:
    assert rate([FAILED] * 6 + [replace(FAILED, circumstances=OFFICE)] * 6, Circumstances(place="hall")) < 0.35


def test_person_counts_more_than_the_server() -> None:
    assert rate([replace(TRIAL, judgement=Judgement.WRONG)] * 3) < 0.25
    assert rate([replace(FAILED, judgement=Judgement.RIGHT)] * 3) > 0.75


def test_trial_that_others_ended_says_nothing() -> None:
    assert learned_from([replace(TRIAL, outcome=Outcome.ENDED_BY_OTHERS)] * 5).records == {}


def test_time_is_learned() -> None:
    found = learned_from([TRIAL] * 10 + [replace(TRIAL, took_s=12.0)] * 10).expect(ARM, KITCHEN)
    assert found.took_s is not None and 11.0 < found.took_s < 12.0


def test_what_is_known_is_bounded() -> None:
    known = Experience()
    for number in range(300):
        known.hear(replace(TRIAL, server=f"/s{number}"))
        known.hear(replace(TRIAL, circumstances=Circumstances(place=f"room {number}")))
    assert len(known.records) == MOST_SUBJECTS
    assert Subject("grasping", "/s299") in known.records and Subject("grasping", "/s5") not in known.records
    assert len(known.records[ARM].cells) == MOST_CELLS
    assert (0, "") in known.records[ARM].cells


def test_belief_without_trials_becomes_that_of_a_server_that_has_changed() -> None:
    sharp = (0.0,) * 10 + (1.0,)
    assert mean(aged(sharp, 5, hazard=0.01)) > 0.9
    assert aged(sharp, 10_000, hazard=0.01) == pytest.approx(CHANGED)
