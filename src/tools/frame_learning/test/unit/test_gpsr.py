"""Commands of generator grammars, on made-up grammars."""

import json
from argparse import ArgumentParser

import pytest

from checked_files import FileRefused
from frame_learning import score_command
from frame_learning.annotated_commands import CorpusError
from frame_learning.gpsr_commands import draw_commands
from frame_learning.gpsr_grammar import (
    Choice,
    Reference,
    Sequence,
    Slot,
    Word,
    find_grammars,
    read_expression,
    read_slot,
)
from frame_learning.gpsr_logical_forms import agrees, find_logical_form, read_logical_forms
from frame_learning.gpsr_meaning import load_gpsr_mapping, read_gpsr_mapping
from frame_learning.gpsr_score import Judged, Verdict, by_category, causes, judge
from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.pipeline import Pipeline

GRAMMAR = """\ufeff; grammar name Garden
; import common.txt
$Main = $task | $polite $task
$task = $fetch
$whom = {name 1 meta: {name 1} is (late | "early")}
// a comment
$fetch = $vbget the {object 1} from the {placement} (and | , then) give {pron} to $whom
"""
COMMON = """$vbget = take | pick up
$polite = {void meta: say it twice} please
"""
FORMS = """# forms
$fetch = (give (λ$1:e (is_a $1 {object 1})) {name 1})
"""
MAPPING = """
slot_rules: [vbget]
kinds: {place: [room, placement]}
between: "and | , | then | please"
words_left_out: [the, to, from]
logical_forms: {give: [giving]}
macros: {get: "take | pick up | {vbget}"}
clauses:
- said: "$get [theme|entity the {object}] from the [source {place}]"
  frames: [taking]
- said: "give [theme {pron}] to [recipient {name}]"
  frames: [giving|bringing]
- said: "$get [theme the {object} from the {place}]"
  frames: [taking]
"""


@pytest.fixture
def folder(tmp_path):
    below = tmp_path / "year" / "garden"
    below.mkdir(parents=True)
    (below / "garden_grammar.txt").write_text(GRAMMAR, encoding="utf-8")
    (below / "garden_semantics.txt").write_text(FORMS, encoding="utf-8")
    (below / "common_rules.txt").write_text(COMMON, encoding="utf-8")
    (below / "Names.xml").write_text('<names><name gender="Female">Ida</name></names>', encoding="utf-8")
    (below / "objects.xml").write_text("../things.xml", encoding="utf-8")
    (below.parent / "things.xml").write_text(
        '<?xml version="1.0"?><c><category name="tools"><object name="rake"/></category></c>', encoding="utf-8"
    )
    (below / "locations.xml").write_text(
        '<rooms><room name="shed"><location name="bench" isPlacement="true"/></room></rooms>', encoding="utf-8"
    )
    return tmp_path


@pytest.fixture
def mapping(tmp_path):
    path = tmp_path / "mapping.yaml"
    path.write_text(MAPPING, encoding="utf-8")
    return read_gpsr_mapping(str(path))


def test_expressions_are_read():
    assert read_expression("go (to | $into) the {room 1}") == Sequence(
        (Word("go"), Choice((Word("to"), Reference("into"))), Word("the"), Slot("location", "room", "1"))
    )


@pytest.mark.parametrize("text", ["go (to", "go to)", "the {room", "pay $ 5"])
def test_expressions_that_are_wrong_are_refused(text):
    with pytest.raises(ValueError, match=r"\S"):
        read_expression(text)


def test_slots_are_read():
    assert read_slot("aobject? meta: not {here}") == Slot("object", "alike", "", True)
    assert read_slot("location placement 2") == Slot("location", "placement", "2")
    assert read_slot('object where Category="food" canPour!=true').conditions == (
        ("Category", "=", "food"),
        ("canPour", "!=", "true"),
    )


def test_a_grammar_has_the_rules_that_it_imports(folder):
    (grammar,) = find_grammars(str(folder))
    assert grammar.name == "garden/garden_grammar"
    assert set(grammar.rules) == {"Main", "task", "fetch", "vbget", "polite", "whom"}
    assert grammar.undefined == ()


def test_a_folder_without_grammars_is_refused(tmp_path):
    with pytest.raises(CorpusError, match="Main"):
        find_grammars(str(tmp_path))


def test_a_wrong_rule_is_named(folder):
    (folder / "year" / "garden" / "common_rules.txt").write_text("$vbget = (take\n", encoding="utf-8")
    with pytest.raises(CorpusError, match=r"common_rules\.txt:1"):
        find_grammars(str(folder))


def test_commands_know_their_slots(folder):
    for command in draw_commands(str(folder), 20, 4, frozenset(["vbget"])):
        filled = [(piece.kind, piece.text) for piece in command.pieces if piece.kind]
        assert filled[0][0] == "vbget"
        assert filled[1:] == [("object", "rake"), ("placement", "bench"), ("pron", "it"), ("name", "Ida")]
        said = [command.text[start:end].lower() for start, end in command.spans]
        assert said == [piece.text.lower() for piece in command.pieces]
        assert next(piece.referent for piece in command.pieces if piece.kind == "pron") == "rake"
        assert command.task == "fetch"


def test_the_seed_decides(folder):
    first, again = (draw_commands(str(folder), 5, 4, frozenset()) for _ in range(2))
    assert first == again
    assert len({command.text.lower().rstrip(".") for command in first}) == len(first)


def test_a_command_has_all_meanings_that_fit_it(folder, mapping):
    (command, *_) = draw_commands(str(folder), 1, 4, mapping.slot_rules)
    meanings = mapping.meanings(command)
    assert [[frame.names for frame in meaning.frames] for meaning in meanings] == [
        [("taking",), ("giving", "bringing")],
        [("taking",), ("giving", "bringing")],
    ]
    first = meanings[0].frames[0].elements
    assert [(element.names, command.pieces[element.span[0]].text) for element in first] == [
        (("theme", "entity"), "the"),
        (("source",), "bench"),
    ]


def test_logical_forms_are_found_and_compared(folder, mapping):
    (command, *_) = draw_commands(str(folder), 1, 4, frozenset(["vbget"]))
    form = find_logical_form(read_logical_forms(str(folder)), command, mapping)
    assert form is not None
    assert form.predicates(["give", "put"]) == ("give",)
    assert agrees(form, mapping.meanings(command)[0], mapping)


@pytest.mark.parametrize("broken", ["said: go (to", "said: go $nowhere", "heard: go"])
def test_a_wrong_mapping_is_refused(tmp_path, broken):
    path = tmp_path / "mapping.yaml"
    path.write_text(f"between: and\nclauses:\n- {broken}\n  frames: [going]\n", encoding="utf-8")
    with pytest.raises(FileRefused):
        read_gpsr_mapping(str(path))


@pytest.fixture(scope="module")
def pipeline():
    knowledge = load_knowledge([shipped_domains()])
    pretend_servers(knowledge.graph)
    return Pipeline(knowledge)


def test_commands_are_judged(folder, mapping, pipeline):
    (command, *_) = draw_commands(str(folder), 1, 4, mapping.slot_rules)
    judged = judge(pipeline, mapping, command)
    assert (judged.verdict, judged.cause) == (Verdict.RIGHT, "")


@pytest.mark.parametrize(
    ("frames", "element", "cause"),
    [
        ("placing", "theme", "frames: taking, giving for placing, giving|bringing"),
        ("taking", "goal", 'taking: goal lacks "{object}"'),
    ],
)
def test_another_frame_or_element_is_wrong(tmp_path, folder, pipeline, frames, element, cause):
    path = tmp_path / "other.yaml"
    text = MAPPING[: MAPPING.rindex("- said")].replace("[taking]", f"[{frames}]").replace("theme|entity", element)
    path.write_text(text, encoding="utf-8")
    other = read_gpsr_mapping(str(path))
    (command, *_) = draw_commands(str(folder), 1, 4, other.slot_rules)
    judged = judge(pipeline, other, command)
    assert (judged.verdict, judged.cause) == (Verdict.WRONG, cause)


def test_a_command_without_a_meaning_is_reported(tmp_path, folder, pipeline):
    path = tmp_path / "empty.yaml"
    path.write_text("between: and\nclauses: []\n", encoding="utf-8")
    (command, *_) = draw_commands(str(folder), 1, 4, frozenset())
    assert judge(pipeline, read_gpsr_mapping(str(path)), command).verdict is Verdict.UNMAPPED


def test_failures_are_counted_by_category_and_cause(folder):
    commands = draw_commands(str(folder), 2, 4, frozenset())
    judged = [Judged(commands[0], Verdict.RIGHT), *(Judged(item, Verdict.WRONG, "frames") for item in commands)]
    assert by_category(judged)["garden/garden_grammar fetch"] == {Verdict.RIGHT: 1, Verdict.WRONG: len(commands)}
    assert causes(judged, [Verdict.WRONG]) == [(len(commands), Verdict.WRONG, "frames", commands[0].text)]


def test_the_command_line_writes_json(folder, capsys):
    parser = ArgumentParser()
    score_command.add_arguments(parser)
    assert score_command.run(parser.parse_args(["gpsr", str(folder), "--count", "1", "--seed", "4", "--json"])) == 0
    found = json.loads(capsys.readouterr().out)
    assert (found["commands"], found["unmapped"]) == (1, 0)


def test_the_shipped_mapping_is_valid():
    assert "locating" in load_gpsr_mapping().frame_names
