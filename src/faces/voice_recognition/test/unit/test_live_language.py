"""What can be said changes with the topics of the robot."""

from voice_recognition.live_language import Knowledge, LanguageMaker
from voice_recognition.offers import OfferFinder

FRAME = "name: juggling\nframe_elements:\n  - name: place\n    semantic_type: Location\n"
UNIT = """
- frame_name: juggling
  verb: [juggle]
  frame_element_grammatical_relations:
    - {name: place, relation: prep_in, argument: phrase}
  examples:
    - {text: Juggle., frame_elements: {}}
    - {text: juggle in the garden, frame_elements: {place: the garden}}
"""


def can_say(maker: LanguageMaker, knowledge: Knowledge, words: str) -> bool:
    return OfferFinder(maker.make(knowledge)).find(tuple(words.split())) is not None


def test_an_ability_and_a_name_come_and_go() -> None:
    maker = LanguageMaker()
    files = Knowledge(unit_files=(("u.yaml", UNIT),), frame_files=(("f.yaml", FRAME),))
    served = Knowledge(files.unit_files, files.frame_files, frozenset(["juggling"]))
    named = Knowledge(
        files.unit_files, files.frame_files, served.served, (("kitchen", ("Room",)), ("", ("Room",)), ("x", ("No",)))
    )
    assert not can_say(maker, files, "juggle")
    assert can_say(maker, served, "juggle")
    assert not can_say(maker, served, "juggle in the kitchen")
    assert can_say(maker, named, "juggle in the kitchen")
    assert not can_say(maker, files, "juggle")


def test_a_file_with_mistakes_is_left_out() -> None:
    wrong = Knowledge((("w.yaml", "- frame_name: [1"),), (("f.yaml", "name: "),), frozenset(["juggling"]))
    assert LanguageMaker().make(wrong).templates == ()
