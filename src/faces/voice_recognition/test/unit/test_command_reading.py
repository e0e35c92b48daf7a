"""What the robot makes of a text that may have been said."""

import pytest

from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.pipeline import Pipeline
from voice_recognition.calling import Calls
from voice_recognition.command_reading import CommandReader, Sense, make_reader
from voice_recognition.live_language import Knowledge
from voice_recognition.live_reader import ReaderMaker
from voice_recognition.offers import OfferFinder
from voice_recognition.spoken_language import SpokenLanguage
from world_model import World
from world_model.world import snapshot
from world_model.world_file import load_world_file

FINDER = OfferFinder(SpokenLanguage((), {}, {}))


@pytest.fixture(scope="module", name="reader")
def _reader() -> CommandReader:
    knowledge = load_knowledge([shipped_domains()])
    pretend_servers(knowledge.graph)
    return make_reader(Pipeline(knowledge), FINDER, World())


def test_a_command_is_offered_in_its_own_words(reader: CommandReader) -> None:
    meaning = reader.read("Turn left 120 degrees.")
    assert meaning.sense is Sense.COMMAND and meaning.unknown == ()
    assert meaning.offer is not None and meaning.offer.frame == "turning"
    assert dict(meaning.offer.elements)["direction"] == "left"
    assert meaning.offer.question == "Shall I turn left 120 degrees?"
    assert reader.read("Bring me the mug.").offer.question == "Shall I bring you the mug?"


def test_a_stop_is_a_stop(reader: CommandReader) -> None:
    for text in ("Stop!", "Stop it.", "Emergency stop."):
        assert reader.read(text).sense is Sense.STOP


def test_the_name_by_which_a_robot_is_called_is_no_part_of_the_command() -> None:
    knowledge = load_knowledge([shipped_domains()])
    pretend_servers(knowledge.graph)
    reader = make_reader(Pipeline(knowledge), FINDER, World(), Calls(["Rosie"]))
    assert reader.read("Rosie, turn left 120 degrees.") == reader.read("Turn left 120 degrees.")
    assert reader.read("Hey Rosie, stop!").sense is Sense.STOP
    several = make_reader(Pipeline(knowledge), FINDER, World(), Calls(["alpha", "beta"]), are_several=True)
    alpha, beta = (several.read(f"{name}, turn left 120 degrees.").offer for name in ("Alpha", "Beta"))
    assert alpha is not None and alpha.text == "Alpha, turn left 120 degrees"
    assert alpha.question == 'I heard "Alpha, turn left 120 degrees". Is that right?'
    assert beta is not None and not alpha.means_the_same(beta) and alpha.frame == beta.frame == "turning"


def test_talk_is_nothing_and_unknown_words_are_named(reader: CommandReader) -> None:
    meaning = reader.read("Follow Alice.")
    assert meaning.sense is Sense.COMMAND and meaning.unknown == ("alice",)
    assert reader.read("Hello.").sense < Sense.ASKED


def test_a_question_moves_nothing(reader: CommandReader) -> None:
    meaning = reader.read("Where is the mug?")
    assert meaning.offer is not None and meaning.offer.is_question


def test_a_person_whom_the_robot_learns_of_is_no_unknown_word(reader: CommandReader) -> None:
    world = snapshot("1", {one.id: one for one in load_world_file("persons:\n  alice: \n", "world.yaml")})
    assert reader.in_world(world, has_new_names=True).read("Follow Alice.").unknown == ()
    assert reader.in_world(world, has_new_names=False).read("Follow Alice.").unknown == ("alice",)


FRAME = "name: juggling\nframe_elements:\n  - name: place\n    semantic_type: Location\n"
UNIT = """
- frame_name: juggling
  verb: [juggle]
  examples:
    - {text: Juggle., frame_elements: {}}
"""


def test_what_can_be_done_changes_with_the_servers() -> None:
    maker = ReaderMaker()
    files = Knowledge(unit_files=(("u.yaml", UNIT),), frame_files=(("f.yaml", FRAME),))
    without = maker.make(files, FINDER, World(), Calls()).known
    assert "juggle" in without and "alice" not in without
    named = Knowledge(files.unit_files, files.frame_files, names=(("Alice", ("Human",)),))
    assert maker.make(named, FINDER, World(), Calls(["Rosie"])).known >= {"alice", "rosie"}
