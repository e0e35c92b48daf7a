"""Learning lexical units from annotated sentences."""

from pathlib import Path

import pytest

from roboframenet_tools import learn as learn_command
from roboframenet_tools.annotated_sentences import read_sentences, sentences_of
from roboframenet_tools.check import Examples, example_problems, find_problems, load_paths
from roboframenet_tools.corpus import AnnotatedElement, AnnotatedFrame, command_of
from roboframenet_tools.corpus_mapping import load_mapping, shipped_mapping
from roboframenet_tools.understanding import Pipeline, load_knowledge, pretend_servers, shipped_domains
from semantic_frames import FileRefused

GARDENING = Path(__file__).resolve().parent / "gardening.yaml"
#: Sentences that the ten of the file do not contain: other things, other prepositions, other verbs of a frame together
#: with elements that it was not seen with, politeness.
OTHERS = [
    ("water the tulips", "watering", {"plant": "the tulips"}),
    ("Please sprinkle the young trees.", "watering", {"plant": "the young trees"}),
    ("Could you water the herbs near the window?", "watering", {"plant": "the herbs", "place": "the window"}),
    ("Sprinkle the lawn with the old can.", "watering", {"plant": "the lawn", "instrument": "the old can"}),
    ("plant the beans next to the wall", "planting", {"plant": "the beans", "goal": "the wall"}),
    ("Sow the radishes in the second row.", "planting", {"plant": "the radishes", "goal": "the second row"}),
    ("prune the pear tree", "pruning", {"plant": "the pear tree"}),
    ("Trim the bushes with the shears.", "pruning", {"plant": "the bushes", "instrument": "the shears"}),
    ("Dig up the carrots.", "harvesting", {"plant": "the carrots"}),
    ("dig up the weeds out of the path", "harvesting", {"plant": "the weeds", "source": "the path"}),
]


@pytest.fixture(scope="module")
def learned(tmp_path_factory):
    folder = tmp_path_factory.mktemp("gardening")
    parser = learn_command.argparse.ArgumentParser()
    learn_command.add_arguments(parser)
    assert learn_command.run(parser.parse_args([str(GARDENING), "--out", str(folder)])) == 0
    return folder


@pytest.fixture(scope="module")
def pipeline(learned):
    knowledge = load_knowledge([shipped_domains(), str(learned)])
    pretend_servers(knowledge.graph)
    return Pipeline(knowledge)


def test_the_sentences_are_of_a_domain_that_nobody_has_coded():
    sentences = read_sentences(str(GARDENING))
    assert len(sentences) == 10
    assert {sentence.frame_name for sentence in sentences} & set(load_knowledge([shipped_domains()]).frames) == set()
    assert {text.lower().rstrip(".") for text, _, _ in OTHERS} & {
        sentence.text.lower().rstrip(".") for sentence in sentences
    } == set()


@pytest.mark.parametrize("text, frame_name, arguments", OTHERS)
def test_ten_sentences_teach_ten_others(pipeline, text, frame_name, arguments):
    understanding = pipeline.understand(text)
    assert understanding.reply.code == "DONE", understanding.reply.sentence
    (reading,) = understanding.readings
    assert reading.unit.frame_name == frame_name
    assert {value.name: value.argument for value in reading.values} == arguments


def test_learned_files_are_right_and_their_examples_are_understood(learned):
    knowledge, checked = load_paths([str(learned)])
    assert find_problems(knowledge, checked) == []
    assert example_problems(Examples(knowledge), checked) == []
    assert sum(len(unit.examples) for unit in knowledge.lexicon.units) == 10


def test_nothing_is_overwritten(learned, capsys):
    parser = learn_command.argparse.ArgumentParser()
    learn_command.add_arguments(parser)
    assert learn_command.run(parser.parse_args([str(GARDENING), "--out", str(learned)])) == 1
    assert "there already" in capsys.readouterr().err


def test_words_that_are_not_in_the_sentence_are_named(tmp_path):
    path = tmp_path / "wrong.yaml"
    path.write_text(
        "- text: Water the roses.\n  frame_name: watering\n  verb: Plant\n  frame_elements: {plant: the tulips}\n",
        encoding="utf-8",
    )
    with pytest.raises(FileRefused) as refused:
        read_sentences(str(path))
    assert [problem.code for problem in refused.value.problems] == ["NOT_IN_TEXT", "NOT_IN_TEXT"]


def test_a_verb_in_two_parts_is_found(tmp_path):
    path = tmp_path / "x.yaml"
    path.write_text("- {text: Dig it up., frame_name: harvesting, verb: Dig up}\n", encoding="utf-8")
    (sentence,) = read_sentences(str(path))
    assert sentence.verb == ((0, 3), (7, 9))


def test_a_corpus_names_our_frame_by_its_elements_and_verb():
    knowledge = load_knowledge([shipped_domains()])
    mapping = load_mapping(shipped_mapping("huric"))
    annotated = AnnotatedFrame("Motion", (1,), (AnnotatedElement("Goal", frozenset([2, 3]), 3),))
    unknown = AnnotatedFrame("Sleeping", (1,))
    command = command_of("7", "go to town", "go to town".split(), (annotated, unknown))
    sentences, unexplained = sentences_of([command], mapping, knowledge.frames, knowledge.lexicon.units)
    assert [(sentence.frame_name, dict(sentence.elements)) for sentence in sentences] == [
        ("navigating_to_location", {"goal": ((3, 5), (6, 10))})
    ]
    assert len(unexplained) == 1 and "Sleeping" in unexplained[0]
