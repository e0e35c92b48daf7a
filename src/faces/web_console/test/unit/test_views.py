"""Arguments, traces, health, and the board of the newest views."""

import json

from typed_arguments import Measure, Modifier, Source, TypedArgument
from web_console.arguments import argument_view, measure_text, trace_lines
from web_console.board import Board
from web_console.health import MISSING, RUNS, SILENT, STAGES, health_of, nodes_to_ask
from web_console.views import Note, PoseView, StatusView, TraceLine, as_json

ANGLE = Measure("angle", "120 degrees", 120.0, "degree", 2.0943951)


def test_argument_shows_its_attributes():
    argument = TypedArgument(
        "goal",
        "the two red mugs",
        relation="under",
        quantifier="the",
        count=2,
        modifiers=(Modifier("adjective", "red"),),
        semantic_type="Container",
        source=Source.INFERRED,
    )
    view = argument_view(argument)
    assert (view.name, view.text) == ("goal", "the two red mugs")
    assert view.notes == (
        Note("source", "inferred"),
        Note("relation", "under"),
        Note("quantifier", "the"),
        Note("count", "2"),
        Note("modifier", "red"),
        Note("type", "Container"),
    )


def test_plain_argument_has_no_notes():
    assert argument_view(TypedArgument("goal", "the office")).notes == ()


def test_measures_are_shown_in_words_and_si_units():
    assert measure_text(ANGLE) == "120 degrees = 2.094 rad"
    assert measure_text(Measure("length", "a bit", None, "", 0.3, is_assumed=True)) == "a bit = 0.3 m (assumed)"
    assert measure_text(Measure("length", "", 3.0, "foot", 0.9144, bound="at_most")) == "at most 3 foot = 0.9144 m"


def test_trace_is_read():
    assert trace_lines("negated: take: refused. It is: so\nalone\n\nrule: what") == (
        TraceLine("negated", "take", "refused. It is: so"),
        TraceLine("", "", "alone"),
        TraceLine("", "", ""),
        TraceLine("rule", "", "what"),
    )
    assert len(trace_lines("a: b: c\n" * 5000)) == 200


def test_health_names_what_is_missing_and_silent():
    topics = {stage: f"/{topic}" for stage, topic, _ in STAGES}
    publishers = {topic: frozenset({f"/{stage}"}) for stage, topic in topics.items() if stage != "arbitrator"}
    asked = nodes_to_ask(publishers, topics)
    answering = frozenset(node for nodes in asked.values() for node in nodes if node != "/executor")
    states = {node.name: node.state for node in health_of(asked, answering, [("/turning", "turning", False)]).nodes}
    assert states.pop("arbitrator") == MISSING
    assert states.pop("executor") == SILENT
    assert states.pop("turning") == SILENT
    assert set(states.values()) == {RUNS} and len(states) == len(STAGES) - 2


def test_board_tells_only_changes():
    board = Board(most_commands=2)
    assert board.show("status", StatusView("a"))
    assert not board.show("status", StatusView("a"))
    assert [key for key, _ in board.take_changes()] == ["status"]
    assert board.take_changes() == ()
    board.show("status", StatusView("b"))
    board.show("status", StatusView("c"))
    ((_key, message),) = board.take_changes()
    assert json.loads(message) == {"view": "status", "value": {"sentence": "c", "active": []}}


def test_board_keeps_the_last_commands_for_a_late_page():
    board = Board(most_commands=2)
    board.show("pose", PoseView(0.0, 0.0, 0.0, "odom"))
    for number in range(5):
        board.show("command", StatusView(str(number)), which=str(number))
    assert [key for key, _ in board.snapshot()] == ["pose", "command 3", "command 4"]
    assert [key for key, _ in board.take_changes()] == ["pose", "command 3", "command 4"]
    board.show("pose", PoseView(1.0, 0.0, 0.0, "odom"))
    board.forget_changes()
    assert board.take_changes() == ()


def test_markup_stays_text_on_its_way():
    message = as_json("status", StatusView("</script><img src=x onerror=alert(1)>"))
    assert json.loads(message)["value"]["sentence"] == "</script><img src=x onerror=alert(1)>"
