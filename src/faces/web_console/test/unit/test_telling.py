"""How far a command is, in words of persons."""

import pytest

from web_console.history import History
from web_console.telling import help_after, now_of, tasks_of
from web_console.views import PlanView, ReplyView, StageView, TaskView

GO = PlanView("DO", "Go to the kitchen.", state="done")
WAVE = PlanView("DO", "wave at Anna", state="active")
OPEN = PlanView("CONDITION", "the door is open")


def test_plan_is_a_line_of_its_clauses():
    assert tasks_of(PlanView("SEQUENCE", "...", children=(GO, WAVE))) == (
        TaskView("Go to the kitchen", "done"),
        TaskView("wave at Anna", "active"),
    )


@pytest.mark.parametrize(
    ("plan", "notes"),
    [
        (PlanView("IF", "", children=(OPEN, GO, WAVE)), ["if the door is open", "otherwise"]),
        (PlanView("UNTIL", "", children=(OPEN, WAVE)), ["until the door is open"]),
        (PlanView("REPEAT", "", ("3 times",), (WAVE,)), ["3 times"]),
        (PlanView("FALLBACK", "", children=(GO, WAVE)), ["", "or else"]),
        (PlanView("WAIT", "", children=(OPEN,)), [""]),
    ],
)
def test_ways_are_notes(plan, notes):
    assert [task.note for task in tasks_of(plan)] == notes


def test_wait_has_words():
    assert [task.text for task in tasks_of(PlanView("WAIT", "", children=(OPEN,)))] == ["wait until the door is open"]


def test_now_is_what_the_robot_says_or_the_clause_or_the_stage():
    stages = [StageView("semantic_framer", 'evoked by "where (is|are) *"', 0.1)]
    tasks = tasks_of(PlanView("SEQUENCE", "", children=(GO, WAVE)))
    assert now_of(stages, tasks, ["looking for the keys in the bedroom"]) == "Looking for the keys in the bedroom"
    assert now_of(stages, tasks, []) == "Doing “wave at Anna”"
    assert now_of(stages, (), []) == "Working out what it means."
    assert now_of([StageView("another_stage", "x", 0.1)], (), []) == "Working on it."
    assert now_of([], (), []) == ""


def test_history_keeps_what_the_robot_did():
    told = History(is_own=lambda command_id: True)
    told.heard("a", "Wave.", 0.0)
    assert told.doing("waving") == ""
    told.planned("a", WAVE)
    assert [told.doing(words) for words in ("going to Anna", "going to Anna", "", "waving")] == ["a", "", "", "a"]
    assert (told.view("a").did, told.view("a").now) == (("going to Anna", "waving"), "Waving")
    told.replied("a", ReplyView("DONE", "DONE", "Done.", "executor", 1.0))
    assert (told.doing("rolling out"), told.view("a").now) == ("", "")


def test_help_is_for_what_was_not_done():
    assert help_after("FAILED", "ALL_CANDIDATES_FAILED")
    assert help_after("DONE", "NO_SERVER") == ""
    assert help_after("REFUSED", "ANOTHER_CODE") == ""
