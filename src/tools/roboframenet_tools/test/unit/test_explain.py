"""Explaining sentences, offline."""

import json

import pytest
from roboframenet_msgs.msg import Command, StageEvent

from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.pipeline import Pipeline, to_json
from roboframenet_tools import explain
from roboframenet_tools.cli import main
from roboframenet_tools.drawing import draw_arcs, svg_arcs
from roboframenet_tools.explain import describe
from roboframenet_tools.passes import effects_of
from roboframenet_tools.ros_graph import describe_event
from semantic_framer.rules import RULES
from utterance_passes.table import PASSES
from utterance_passes.trees.tree import DependencyTree, Word

TREE = DependencyTree(
    "Take it", (Word(1, "Take", "take", "VERB", "VB", "", 0, "root"), Word(2, "it", "it", "PRON", "PRP", "", 1, "obj"))
)


@pytest.fixture(scope="module")
def pipeline():
    knowledge = load_knowledge([shipped_domains()])
    pretend_servers(knowledge.graph)
    return Pipeline(knowledge, is_traced=True)


def test_json_of_a_command(pipeline):
    result = to_json(pipeline.understand("Turn left 120 degrees."))
    assert list(result) == ["text", "tokens", "frames", "left_over", "reply"]
    frame = result["frames"][0]
    assert (frame["name"], frame["verb_token"]) == ("turning", 1)
    direction = next(element for element in frame["frame_elements"] if element["name"] == "direction")
    typed = direction.pop("typed")
    assert direction == {"name": "direction", "argument": "left", "tokens": [2], "head_token": 2}
    assert (typed["name"], typed["text"], typed["direction"]) == ("direction", "left", "left")
    assert result["left_over"] == []
    assert result["reply"]["outcome"] == "DONE"


def test_names_that_the_robot_knows(tmp_path, capsys):
    names = tmp_path / "names.yaml"
    names.write_text("names: {butler: Device}\n")
    assert main(["explain", "take the butler to the hall"]) == 0
    assert "guiding(cotheme=the butler" in capsys.readouterr().out
    assert main(["explain", "--names", str(names), "take the butler to the hall"]) == 0
    assert "bringing(theme=the butler" in capsys.readouterr().out


def test_what_the_robot_knows_attaches_places(tmp_path, capsys):
    world = tmp_path / "home.yaml"
    world.write_text("things:\n  table_1: {x: 4, y: 0}\n  lamp_1: {x: 0, y: 0}\n  box_1: {x: 1, y: 0, near: lamp_1}\n")
    said = "Take the box near the lamp on the table."
    assert main(["explain", said]) == 0
    assert "taking(theme=the box near the lamp on the table)" in capsys.readouterr().out
    assert main(["explain", "--world", str(world), said]) == 1
    shown = capsys.readouterr().out
    assert "attached_by_world" in shown
    assert "bringing(theme=the box near the lamp, goal=the table)" in shown
    assert "I know of no box near the lamp on the table." in shown
    assert main(["explain", "--world", str(tmp_path / "none.yaml"), said]) == 2


def test_what_is_said_on_the_way_is_no_step(pipeline):
    understanding = pipeline.understand("Bring me the towel that is in the bathroom.")
    frames = to_json(understanding)["frames"]
    assert [(frame["name"], frame["is_description"]) for frame in frames] == [
        ("bringing", False),
        ("being_located", True),
    ]
    steps = [step for candidates in understanding.candidates for candidate in candidates for step in candidate.frames]
    assert "being_located" not in [step.name for step in steps]
    assert "description: being_located(theme=that, location=the bathroom)" in describe(understanding)
    assert to_json(pipeline.understand("Don't bring me the towel that is in the bathroom."))["frames"] == []


def test_each_clause_has_its_own_candidates(pipeline):
    understanding = pipeline.understand("Take the mug, then go to the kitchen.")
    assert [[step.name for step in candidates[0].frames] for candidates in understanding.candidates] == [
        ["taking"],
        ["navigating_to_location"],
    ]
    explanation = describe(understanding)
    assert 'clause 1, "Take the mug"\nwould run: taking(theme=the mug) on taking\notherwise: grasping' in explanation
    assert 'clause 2, "go to the kitchen"\nwould run: navigating_to_location(goal=the kitchen)' in explanation


def test_negated_command_reaches_no_frame(pipeline):
    result = to_json(pipeline.understand("Don't say hello."))
    assert result["frames"] == []
    assert result["reply"]["code"] == "NEGATED"


def test_relations_have_the_names_that_units_use(pipeline):
    assert "prep_to(go, kitchen)" in describe(pipeline.understand("Take the mug, then go to the kitchen."))


def test_missing_relation_is_named(pipeline):
    understanding = pipeline.understand("Bring.")
    assert understanding.reply.code == "MISSING_ELEMENT"
    assert "no dobj" in describe(understanding)


def test_the_run_that_decided_is_shown(pipeline):
    text = describe(pipeline.understand("Tell her lunch is ready, then take a right."))
    assert "quotations" in text and "her: nmod:poss(lunch) -> iobj(Tell)" in text
    assert "side_is_no_thing" in text
    # The arcs are those of the tree that was read.
    assert "flat:quoted" in text


@pytest.mark.parametrize("words", [["--without", "nonsense", "Go."], [], ["Go.", "--batch", "file"]])
def test_wrong_usage(words, capsys):
    assert main(["explain", *words]) == 2
    assert "rfn explain:" in capsys.readouterr().err


def test_without_a_pass(capsys):
    assert main(["explain", "--without", "places_of_devices", "turn the lights off in the bedroom"]) == 1
    assert "left over: " in capsys.readouterr().out


def test_passes_are_listed_in_their_order(capsys):
    assert main(["passes"]) == 0
    names = [line.split()[0] for line in capsys.readouterr().out.splitlines()]
    assert names == [one.name for one in PASSES]
    assert main(["passes", "--all"]) == 0
    listed = [line.split()[0] for line in capsys.readouterr().out.splitlines()]
    assert listed == ["words_of_units", *names, *RULES]


@pytest.mark.parametrize(
    "rule, said",
    [("deed_is_no_thing", "Take the lift."), ("reattached", "Drop me off at the station.")],
)
def test_a_rule_of_the_framer_can_be_switched_off(pipeline, rule, said):
    lacking = Pipeline(pipeline.knowledge, pipeline.parser, without=frozenset([rule]), is_traced=True)
    with_it, without_it = pipeline.understand(said), lacking.understand(said)
    assert rule in {line.rule for line in with_it.trace} - {line.rule for line in without_it.trace}
    assert with_it.reply != without_it.reply


def test_a_list_of_sentences_is_a_corpus(tmp_path, capsys):
    said = tmp_path / "said.tsv"
    said.write_text("somewhere\tTake the lift.\n\nTurn left.\nTurn left.\n", encoding="utf-8")
    assert main(["passes", "--corpus", "sentences", str(said), "--show", "deed_is_no_thing"]) == 0
    printed = capsys.readouterr().out
    assert printed.startswith("2 sentences") and '"Take the lift."' in printed
    assert main(["passes", "--corpus", "sentences", str(tmp_path / "none")]) == 2
    assert "no list of sentences" in capsys.readouterr().err


def test_the_effect_of_a_pass_is_counted(pipeline):
    said = ["Turn the lights off in the bedroom.", "Tell her lunch is ready.", "Turn left."]
    effects = {effect.name: effect for effect in effects_of(pipeline, said, [one.name for one in PASSES])}
    assert len(effects) == len(PASSES)
    assert effects["places_of_devices"].changed == ("Turn the lights off in the bedroom.",)
    assert [text for text, _, _ in effects["quotations"].read_otherwise] == ["Tell her lunch is ready."]
    assert effects["dashes"].changed == ()


def test_an_event_of_a_stage_is_shown_with_its_trace():
    event = StageEvent(command=Command(text="Go."), stage="semantic_framer", sentence="going()", trace="one: a\ntwo: b")
    assert describe_event(event) == '"Go." semantic_framer: going()\n  one: a\n  two: b'


@pytest.mark.parametrize(
    "line", ["", "   ", "?!", "\x00", "\t", "😀", "a" * 300, "(calibrate)", "<no speech>", "\u2028go\ufffd"]
)
def test_no_line_raises(pipeline, line):
    json.dumps(to_json(pipeline.understand(line)))


def test_a_batch_has_a_line_for_each_line(tmp_path):
    file = tmp_path / "lines"
    file.write_bytes(b"one\r\n\n\xff\nlast")
    assert explain._lines(str(file)) == ["one", "", "\ufffd", "last"]


def test_arcs_point_at_the_dependent():
    lines = draw_arcs(TREE).splitlines()
    assert "obj" in lines[0]
    assert lines[1].index("▼") > lines[1].index("●")
    assert svg_arcs(TREE).count('class="arc ') == 1


def test_the_command_behind_a_stop_is_explained(pipeline):
    text = describe(pipeline.understand("stop and go to the office"))
    stopped, _, behind = text.partition("when the robot has stopped:")
    assert "reply: done [DONE] Stopped." in stopped
    assert "would run: navigating_to_location(goal=the office)" in behind


def test_the_behaviour_of_2012_is_explained(capsys):
    assert main(["explain", "--behaviour", "2012", "Go to Roger's office."]) == 0
    assert "would run: navigating_to_location(goal=office)" in capsys.readouterr().out


def test_live_has_the_behaviour_of_the_graph(capsys):
    assert main(["explain", "--live", "--behaviour", "2012", "Go to the office."]) == 2
    assert "omit --behaviour" in capsys.readouterr().err


def test_what_was_said_before(capsys):
    assert main(["explain", "--after", "Move forward two metres.", "ten feet"]) == 0
    shown = capsys.readouterr().out
    assert "fragment" in shown
    assert "moving(direction=forward, distance=10, distance_unit=feet)" in shown
