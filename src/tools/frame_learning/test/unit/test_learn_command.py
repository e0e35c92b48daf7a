"""Learning lexical units from annotated sentences."""

from pathlib import Path

import pytest

from checked_files import FileRefused
from checked_files.source_files import LEXICAL_UNITS_FOLDER
from frame_learning import learn_command
from frame_learning.annotated_commands import AnnotatedElement, AnnotatedFrame, command_of
from frame_learning.annotated_sentences import read_sentences, sentences_of
from frame_learning.corpora import CORPORA
from offline_pipeline.file_checks import Examples, example_problems, find_problems, load_paths
from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.pipeline import Pipeline
from stanford_parser_ros.model import shipped_parser

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
    assert {value.name: value.text for value in reading.arguments} == arguments


def test_learned_files_are_right_and_their_examples_are_understood(learned):
    knowledge, checked = load_paths([str(learned)])
    assert find_problems(knowledge, checked) == []
    assert example_problems(Examples(knowledge), checked) == []
    assert sum(len(unit.examples) for unit in knowledge.lexicon.units) == 10


def test_nothing_is_overwritten(learned, capsys):
    parser = learn_command.argparse.ArgumentParser()
    learn_command.add_arguments(parser)
    assert learn_command.run(parser.parse_args([str(GARDENING), "--out", str(learned)])) == 1
    assert "exist already" in capsys.readouterr().err


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
    mapping = CORPORA["huric"].mapping()
    annotated = AnnotatedFrame("Motion", (1,), (AnnotatedElement("Goal", frozenset([2, 3]), 3),))
    unknown = AnnotatedFrame("Sleeping", (1,))
    command = command_of("7", "go to town", "go to town".split(), (annotated, unknown))
    sentences, unexplained = sentences_of([command], mapping, knowledge.frames, knowledge.lexicon.units)
    assert [(sentence.frame_name, dict(sentence.elements)) for sentence in sentences] == [
        ("navigating_to_location", {"goal": ((3, 5), (6, 10))})
    ]
    assert len(unexplained) == 1 and "Sleeping" in unexplained[0]


def test_an_element_with_values_takes_no_other_words():
    knowledge = load_knowledge([shipped_domains()])
    mapping = CORPORA["huric"].mapping()
    commands = []
    for words in ("move forward", "move to your left"):
        tokens = words.split()
        direction = AnnotatedElement("Direction", frozenset(range(2, len(tokens) + 1)), len(tokens))
        commands.append(command_of(words, words, tokens, (AnnotatedFrame("Motion", (1,), (direction,)),)))
    sentences, _ = sentences_of(commands, mapping, knowledge.frames, knowledge.lexicon.units)
    assert [sentence.frame_name for sentence in sentences] == ["moving", "navigating_to_location"]


def taught(sentences, frames, tmp_path):
    """Pipeline with the units that sentences teach, and with the given frames alone."""
    folder = tmp_path / "frames"
    folder.mkdir()
    for name, text in frames.items():
        (folder / f"{name}.yaml").write_text(text, encoding="utf-8")
    known = load_knowledge([str(tmp_path)])
    (tmp_path / "sentences.yaml").write_text(sentences, encoding="utf-8")
    parser = shipped_parser()
    files, _ = learn_command.lexicon_files(read_sentences(str(tmp_path / "sentences.yaml")), parser, known)
    units = {path: text for path, text in files.items() if path.startswith(LEXICAL_UNITS_FOLDER)}
    learned = learn_command.learned_knowledge(known.frames, {}, units)
    pretend_servers(learned.graph)
    return Pipeline(learned, parser)


def frame_text(name, core, peripheral):
    elements = [f"  - {{name: {element}, is_core: True}}" for element in core]
    elements += [f"  - {{name: {element.lower()}, is_core: False, framenet: {element}}}" for element in peripheral]
    return f"name: {name}\nframe_elements:\n" + "\n".join(elements) + "\n"


def understood(pipeline, text):
    understanding = pipeline.understand(text)
    assert understanding.reply.code == "DONE", understanding.reply.sentence
    (reading,) = understanding.readings
    return reading.unit.frame_name, {value.name: value.text for value in reading.arguments}


def test_what_is_core_in_no_frame_is_said_in_the_same_way_in_all(tmp_path):
    pipeline = taught(
        "- {text: Go through the main door to the hall., frame_name: going, verb: Go,"
        " frame_elements: {goal: to the hall, path: through the main door}}\n"
        "- {text: Enter the kitchen., frame_name: entering, verb: Enter, frame_elements: {goal: the kitchen}}\n"
        "- {text: Walk to the desk slowly., frame_name: going, verb: Walk,"
        " frame_elements: {goal: to the desk, manner: slowly}}\n",
        {name: frame_text(name, ["goal"], ["Path", "Manner"]) for name in ("going", "entering")},
        tmp_path,
    )
    assert understood(pipeline, "Enter the garage via the gate.") == (
        "entering",
        {"goal": "the garage", "path": "the gate"},
    )
    assert understood(pipeline, "Enter the garage quickly.") == (
        "entering",
        {"goal": "the garage", "manner": "quickly"},
    )


def test_what_is_opened_is_told_apart_by_what_opens(tmp_path):
    pipeline = taught(
        "- {text: Open the jar., frame_name: opening_container, verb: Open, frame_elements: {container: the jar}}\n"
        "- {text: Open the door., frame_name: opening, verb: Open, frame_elements: {portal: the door}}\n",
        {
            "opening": frame_text("opening", ["portal"], []),
            "opening_container": frame_text("opening_container", ["container"], []),
        },
        tmp_path,
    )
    assert understood(pipeline, "Open the window.") == ("opening", {"portal": "the window"})
    assert understood(pipeline, "Open the bottle.") == ("opening_container", {"container": "the bottle"})


def test_words_that_tell_frames_of_one_verb_apart_close_no_other_verb(tmp_path):
    pipeline = taught(
        "- {text: Open the jar., frame_name: opening, verb: Open, frame_elements: {container: the jar}}\n"
        "- {text: Open the box., frame_name: opening, verb: Open, frame_elements: {container: the box}}\n"
        "- {text: Open the water., frame_name: switching, verb: Open, frame_elements: {device: the water}}\n"
        "- {text: Start the radio., frame_name: switching, verb: Start, frame_elements: {device: the radio}}\n",
        {"opening": frame_text("opening", ["container"], []), "switching": frame_text("switching", ["device"], [])},
        tmp_path,
    )
    assert understood(pipeline, "Open the bag.") == ("opening", {"container": "the bag"})
    assert understood(pipeline, "Open the water.") == ("switching", {"device": "the water"})
    assert understood(pipeline, "Start the drill.") == ("switching", {"device": "the drill"})


def test_the_second_of_two_places_may_tell_frames_apart(tmp_path):
    pipeline = taught(
        "- {text: Take the box on the table., frame_name: taking, verb: Take,"
        " frame_elements: {theme: the box on the table}}\n"
        "- {text: Take the box on the table on the couch., frame_name: bringing, verb: Take,"
        " frame_elements: {theme: the box on the table, goal: on the couch}}\n",
        {"taking": frame_text("taking", ["theme"], []), "bringing": frame_text("bringing", ["theme"], ["Goal"])},
        tmp_path,
    )
    assert understood(pipeline, "take the plate on the desk") == ("taking", {"theme": "the plate on the desk"})
    assert understood(pipeline, "take the plate on the desk on the shelf") == (
        "bringing",
        {"theme": "the plate on the desk", "goal": "the shelf"},
    )


def test_what_lacks_the_telling_element_is_a_unit_of_its_own(tmp_path):
    to_places = "".join(
        f"- {{text: Move to the {place}., frame_name: going, verb: Move, frame_elements: {{goal: to the {place}}}}}\n"
        for place in ("hall", "kitchen", "garage", "desk", "office")
    )
    pipeline = taught(
        to_places
        + "- {text: Move to your left., frame_name: going, verb: Move, frame_elements: {direction: to your left}}\n"
        "- {text: Move the box to the desk., frame_name: bringing, verb: Move,"
        " frame_elements: {theme: the box, goal: to the desk}}\n",
        {
            "going": frame_text("going", [], ["Goal", "Direction"]),
            "bringing": frame_text("bringing", ["theme"], ["Goal"]),
        },
        tmp_path,
    )
    assert understood(pipeline, "Move to your right.") == ("going", {"direction": "your right"})
    assert understood(pipeline, "Move to the lab.") == ("going", {"goal": "the lab"})
    assert understood(pipeline, "Move the chair to the lab.") == ("bringing", {"theme": "the chair", "goal": "the lab"})


def test_who_gets_something_is_said_in_the_same_way_in_all_frames(tmp_path):
    pipeline = taught(
        "- {text: Bring me the jar., frame_name: bringing, verb: Bring,"
        " frame_elements: {theme: the jar, beneficiary: me}}\n"
        "- {text: Find the jar., frame_name: finding, verb: Find, frame_elements: {theme: the jar}}\n",
        {name: frame_text(name, ["theme"], ["Beneficiary"]) for name in ("bringing", "finding")},
        tmp_path,
    )
    assert understood(pipeline, "Find me the radio.") == ("finding", {"theme": "the radio", "beneficiary": "me"})


def test_a_way_is_also_said_by_what_is_crossed(tmp_path):
    pipeline = taught(
        "- {text: Go to Bob through the main door., frame_name: going, verb: Go,"
        " frame_elements: {goal: to Bob, path: through the main door}}\n",
        {"going": frame_text("going", ["goal"], ["Path"])},
        tmp_path,
    )
    assert understood(pipeline, "Go to the hall by crossing the garage.") == (
        "going",
        {"goal": "the hall", "path": "crossing the garage"},
    )


def test_the_rarer_of_two_elements_has_the_semantic_type_of_its_frame(tmp_path):
    frame = frame_text("bringing", ["theme"], ["Goal", "Beneficiary"])
    frame = frame.replace("framenet: Beneficiary", "framenet: Beneficiary, semantic_type: Sentient")
    pipeline = taught(
        "- {text: Bring the jar to the kitchen., frame_name: bringing, verb: Bring,"
        " frame_elements: {theme: the jar, goal: to the kitchen}}\n"
        "- {text: Bring the box to the hall., frame_name: bringing, verb: Bring,"
        " frame_elements: {theme: the box, goal: to the hall}}\n"
        "- {text: Bring the box to my mother., frame_name: bringing, verb: Bring,"
        " frame_elements: {theme: the box, beneficiary: to my mother}}\n",
        {"bringing": frame},
        tmp_path,
    )
    assert understood(pipeline, "Bring the box to the nurse.") == (
        "bringing",
        {"theme": "the box", "beneficiary": "the nurse"},
    )
    assert understood(pipeline, "Bring the box to the garage.") == (
        "bringing",
        {"theme": "the box", "goal": "the garage"},
    )
