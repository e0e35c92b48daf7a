"""The last commands as view models."""

from web_console.arcs import ParsedWord
from web_console.history import History
from web_console.views import CandidateView, ClauseView, PlanView, ReplyView, StageView, StepView, TraceLine

PLAN = PlanView("DO", "Ping", candidates=(CandidateView((StepView("pinging", "ping", ()),)),))
DONE = ReplyView("DONE", "DONE", "Done.", "executor", 1.0)


def history(most=50):
    return History(is_own=lambda command_id: command_id.startswith("console"), most=most)


def asked(code="MISSING_ELEMENT", sentence='Whom? For instance: "Alice".'):
    return ReplyView("NEEDS_INFORMATION", code, sentence, "semantic_framer", 0.1)


def test_command_grows_with_its_stages():
    told = history()
    told.heard("console-1", "Ping.", 3.0)
    told.reported("console-1", StageView("stanford_parser_ros", "parsed", 0.08))
    told.parsed("console-1", [ParsedWord(1, "Ping", "VERB", 0, "root")])
    told.understood("console-1", [ClauseView("Ping", ())])
    told.planned("console-1", PLAN)
    view = told.view("console-1")
    assert (view.text, view.is_cancellable, view.reply) == ("Ping.", True, None)
    assert [stage.name for stage in view.stages] == ["stanford_parser_ros"]
    assert view.parse and view.parse_words == "Ping is the root"
    assert view.plan == PLAN


def test_heard_twice_is_one_command():
    told = history()
    told.heard("a", "Ping.", 3.0)
    told.heard("a", "something else", 4.0)
    assert [(view.text, view.stamp_s) for view in told.views()] == [("Ping.", 3.0)]


def test_oldest_commands_are_dropped():
    told = history(most=3)
    for number in range(10):
        told.heard(str(number), "x", number)
    assert [view.id for view in told.views()] == ["7", "8", "9"]


def test_commands_that_came_as_text_cannot_be_cancelled():
    told = history()
    told.heard("text-1", "Ping.", 3.0)
    assert not told.view("text-1").is_cancellable


def test_stage_that_reports_again_keeps_its_trace_and_place():
    told = history()
    told.heard("a", "x", 0.0)
    told.reported("a", StageView("one", "first", 0.1, trace=(TraceLine("r", "a", "e"),)))
    told.reported("a", StageView("two", "second", 0.2))
    told.reported("a", StageView("one", "third", 0.3))
    assert [(stage.name, stage.sentence, len(stage.trace)) for stage in told.view("a").stages] == [
        ("one", "third", 1),
        ("two", "second", 0),
    ]


def test_reply_ends_the_command():
    told = history()
    told.heard("console-1", "Ping.", 0.0)
    told.planned("console-1", PLAN)
    assert told.replied("console-1", DONE) == ("console-1",)
    view = told.view("console-1")
    assert view.reply == DONE and not view.is_cancellable
    assert view.plan.candidates[0].steps[0].state == "done"
    assert told.moved("/Ping/candidate_1", ["1_pinging_by_ping"], "") == ""


def test_machine_belongs_to_the_newest_plan():
    told = history()
    assert told.moved("/Ping", ["candidate_1"], "") == ""
    for name in ("a", "b"):
        told.heard(name, "Ping.", 0.0)
        told.planned(name, PLAN)
    assert told.moved("/Ping", ["candidate_1"], "") == "b"
    assert told.moved("/Ping", ["candidate_1"], "HEARTBEAT") == ""
    assert told.view("b").plan.candidates[0].state == "active"
    assert told.view("a").plan.candidates[0].state == "waiting"


def test_arbitrator_orders_the_candidates():
    told = history()
    assert told.arbitrated([]) == ""
    told.heard("a", "Wave.", 0.0)
    told.planned("a", PlanView("DO", "Wave", candidates=tuple(map(waving_by, ("left", "right", "head")))))
    assert told.arbitrated([[("waving", "head")], [("waving", "right")]]) == "a"
    assert [one.steps[0].server for one in told.view("a").plan.candidates] == ["head", "right", "left"]
    told.moved("/Wave", ["candidate_1"], "")
    assert told.arbitrated([[("waving", "left")]]) == ""


def test_machine_of_the_command_before_lights_nothing():
    told = history()
    told.heard("a", "Ping.", 0.0)
    told.planned("a", PLAN)
    assert told.moved("/Wave at Alice/1 Wave", ["candidate_1"], "") == ""
    assert told.moved("/Ping", ["candidate_1"], "") == "a"


def waving_by(server):
    return CandidateView((StepView("waving", server, ()),))


def test_question_is_open_until_the_next_command():
    told = history()
    told.heard("a", "Wave.", 0.0)
    told.replied("a", asked())
    assert told.view("a").question.answers == ("Alice",)
    assert told.close_questions() == ("a",)
    assert told.view("a").question is None


def test_only_the_newest_question_is_open():
    told = history()
    for name in ("a", "b"):
        told.heard(name, "Wave.", 0.0)
        told.replied(name, asked())
    assert [bool(view.question) for view in told.views()] == [False, True]


def test_very_long_texts_are_cut():
    told = history()
    told.heard("a", "x" * 100_000, 0.0)
    assert len(told.view("a").text) == 1000
