"""Arguments in the convention of a corpus, on made-up sentences."""

import pytest

from checked_files import FileRefused
from frame_learning.annotated_commands import AnnotatedElement, AnnotatedFrame, command_of
from frame_learning.argument_convention import Argument, annotated_arguments
from frame_learning.corpora import CORPORA
from frame_learning.corpus_answers import answer
from frame_learning.corpus_mapping import load_mapping
from frame_learning.metrics import Answer, score
from frame_learning.score_command import table, to_json
from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.pipeline import Pipeline

#: A sentence of each convention, and its arguments as tagE would annotate them: trigger, type, text.
SENTENCES = {
    # Nouns with their adjectives, without what describes them; the place of a thing is its source.
    "pick up the green lid on the round table": "pick up Theme green lid; pick up Source round table",
    "pick the lid up": "pick Theme lid",
    # A room is the area, too; a second goal has another name.
    "go to the shelf in the kitchen": "go Goal shelf; go coGoal kitchen; go Area kitchen",
    "walk across the room to the shelf": "walk Goal room; walk coGoal shelf",
    "go to the foot of the stairs": "go Goal stairs",
    "bring the jar to the sofa on the left": "bring Theme jar; bring Goal sofa",
    # What can be closed contains what is put into it; a pronoun is what it stands for.
    "take my jar and put it in the fridge": "take Theme my jar; put Theme my jar; put Goal fridge; "
    "put Containing_object fridge",
    "put the jar on top of the shelf to the right of the radio": "put Theme jar; put Goal shelf; put coGoal radio",
    "turn to your left": "turn Manner your left; turn Agent your",
    "turn left to face the shelf": "turn Manner left; turn Goal shelf",
    "can you find the jar": "find Agent you; find Theme jar",
    "follow the man with the blue hat": "follow Cotheme man; follow Category blue hat",
    "this is a small green jar": "is Theme small green jar; is Category small green",
    "start the dishwasher": "start Device dishwasher; start Operational_state start",
}


@pytest.fixture(scope="module")
def pipeline():
    knowledge = load_knowledge([shipped_domains()])
    pretend_servers(knowledge.graph)
    return Pipeline(knowledge)


@pytest.mark.parametrize(("text", "wanted"), SENTENCES.items(), ids=list(SENTENCES))
def test_arguments_as_tage_writes_them(pipeline, text, wanted):
    given = answer(pipeline, CORPORA["tage"].mapping(), command_of("1", text, text.split(), ()))
    assert {f"{item.trigger} {item.type} {item.text}" for item in given.arguments or ()} == set(wanted.split("; "))


def test_a_corpus_without_a_convention_has_no_such_figure(pipeline):
    command = command_of("1", "take the lid", ["take", "the", "lid"], ())
    given = answer(pipeline, CORPORA["huric"].mapping(), command)
    assert given.arguments is None
    assert score([(command, given)]).arguments is None


def test_micro_f1_counts_task_trigger_type_and_text():
    taking = AnnotatedFrame("Picking", (1,), (AnnotatedElement("Theme", frozenset([3]), 3),))
    command = command_of("1", "Take the Lid", ["Take", "the", "Lid"], (taking,))
    right = Argument("Picking", "take", "Theme", "lid")
    assert annotated_arguments(command) == (right,)
    for given, expected in [
        ((right,), 100.0),
        ((right, right._replace(type="Goal")), 200.0 / 3),
        ((right._replace(task="Placing"),), 0.0),
        ((right._replace(trigger="the"),), 0.0),
        ((right._replace(text="the lid"),), 0.0),
        ((), 0.0),
    ]:
        found = score([(command, Answer((), True, 1.0, given))])
        assert found.arguments is not None
        assert found.arguments.f1 == pytest.approx(expected)
        assert to_json(found)["arguments"]["micro_f1"] == pytest.approx(expected, abs=0.01)
        assert f"micro-F1 {expected:.1f}" in table([("now", found)])


@pytest.mark.parametrize(
    "line", ["second: [Goal]", "also: [{name: Area}]", "inner: {}", "joined: {facing: {}}", "second: {Goal: }"]
)
def test_a_wrong_convention_is_refused(tmp_path, line):
    path = tmp_path / "x.yaml"
    path.write_text(f"arguments:\n  {line}\n", encoding="utf-8")
    with pytest.raises(FileRefused, match="arguments"):
        load_mapping(str(path))
