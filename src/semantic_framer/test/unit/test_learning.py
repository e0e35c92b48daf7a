"""Learning: a yes is kept and given to the lexicon; what another program forgets is taken from it."""

import threading
from pathlib import Path
from typing import Any, List, Mapping, Sequence

import pytest

from nearest_meaning.learned import KIND, PLACE, LearnedUnit, text_with_frame
from nearest_meaning.learned_file import MOST_UNITS, LearnedFile
from semantic_framer.learning import Learning
from semantic_framer.units.lexicon import Lexicon
from semantic_framer.units.lexicon_files import LexiconFiles, LexiconState
from semantic_framer.values.dialogue import Lesson

UNIT = """# Our own.
- frame_name: moving
  verb: [walk]
- frame_name: going
  verb: [go, run]
  elements: {goal: dobj}
"""
LESSON = Lesson("make your way", "go", "going", "Make your way home.")


class Robot:
    """A lexicon with one file, and what is learned beside it."""

    def __init__(self, path: Path) -> None:
        self.lexicon = Lexicon()
        self.lexicon.add_file(UNIT, "own.yaml")
        self.announced: List[LexiconState] = []
        self.warnings: List[str] = []
        files = LexiconFiles(self.lexicon, threading.RLock(), self.announced.append)
        self.frames_told: List[Mapping[str, str]] = []
        self.learning = Learning(
            str(path),
            self.lexicon,
            files,
            warn=self.warnings.append,
            now=lambda: 12.0,
            tell=self.told,
        )

    def told(self, units: Sequence[LearnedUnit]) -> None:
        self.frames_told.append({unit.path: unit.frame_text for unit in units if unit.frame_text})

    def frames_of(self, verb: str) -> List[str]:
        return [unit.frame_name for unit in self.lexicon.units_of(verb)]


def test_a_yes_is_kept_with_who_and_when_and_is_known_after_a_restart(tmp_path: Path) -> None:
    robot = Robot(tmp_path / "l.sqlite")
    robot.learning.take([LESSON], "anna")
    assert robot.frames_of("make your way") == ["going"] and robot.announced[-1].is_learned
    robot.learning.close()
    (unit,) = LearnedFile(str(tmp_path / "l.sqlite")).units()
    assert (unit.name, unit.who, unit.when_s, unit.sentence) == (
        "make_your_way.going",
        "anna",
        12.0,
        "Make your way home.",
    )
    again = Robot(tmp_path / "l.sqlite")
    (known,) = again.lexicon.units_of("make your way")
    assert known.is_learned and known.changes is not None and not again.warnings
    assert not any(one.is_learned for one in again.lexicon.units_of("go"))


def test_words_may_be_taught_by_words_that_were_taught(tmp_path: Path) -> None:
    robot = Robot(tmp_path / "l.sqlite")
    robot.learning.take([LESSON, Lesson("zoom", "make your way", "going", "Zoom home.")], "")
    assert robot.frames_of("zoom") == ["going"] and not robot.warnings
    assert robot.lexicon.units_of("zoom")[0].changes == robot.lexicon.units_of("make your way")[0].changes is not None


def test_what_another_program_forgets_is_no_longer_known(tmp_path: Path) -> None:
    robot = Robot(tmp_path / "l.sqlite")
    robot.learning.take([LESSON], "")
    other = LearnedFile(str(tmp_path / "l.sqlite"))
    robot.learning.refresh()
    assert robot.frames_of("make your way") == ["going"]
    other.forget("make_your_way.going")
    robot.learning.refresh()
    assert robot.frames_of("make your way") == [] and list(robot.lexicon.files) == ["own.yaml"]


def test_a_no_is_kept_and_no_unit_is_learned(tmp_path: Path) -> None:
    robot = Robot(tmp_path / "l.sqlite")
    robot.learning.take([Lesson("zoom", "go", "going", "Zoom home.", is_agreed=False)], "")
    robot.learning.close()
    assert Robot(tmp_path / "l.sqlite").learning.declined == {("zoom", "going")}
    assert robot.frames_of("zoom") == []


def test_a_yes_to_a_whole_sentence_teaches_nothing(tmp_path: Path) -> None:
    robot = Robot(tmp_path / "l.sqlite")
    robot.learning.take([Lesson("go deep home", "", "going", "Go deep home.")], "")
    assert robot.warnings == [] and robot.frames_of("go deep home") == []


def test_a_unit_with_mistakes_is_left_out_and_the_others_are_known(tmp_path: Path) -> None:
    file = LearnedFile(str(tmp_path / "l.sqlite"))
    for name, text in (
        ("a", "verb: [zoom\n"),
        ("b", "frame_name: going\nverb: zip\n"),
        ("c", "frame_name: going\nquestion: what\n"),
    ):
        file.add(LearnedUnit(name, name, "go", "going", text, "", 1.0, "Zoom."))
    robot = Robot(tmp_path / "l.sqlite")
    assert robot.frames_of("zip") == ["going"]
    assert {problem.path for problem in robot.announced[-1].refused} == {"learned/a.yaml", "learned/c.yaml"}


def test_a_damaged_file_is_told_and_learning_goes_on(tmp_path: Path) -> None:
    (tmp_path / "l.sqlite").write_text("no database " * 500)
    robot = Robot(tmp_path / "l.sqlite")
    assert "l.sqlite" in robot.warnings[0]
    robot.learning.take([LESSON], "")
    assert robot.frames_of("make your way") == ["going"]


def test_where_no_file_can_be_nothing_is_learned_and_nothing_fails(tmp_path: Path) -> None:
    (tmp_path / "folder").write_text("a file")
    robot = Robot(tmp_path / "folder" / "l.sqlite")
    robot.learning.take([LESSON], "")
    robot.learning.refresh()
    assert "nothing is learned" in robot.warnings[0] and robot.frames_of("make your way") == []


@pytest.mark.parametrize("lesson", [Lesson("zoom", "fly", "going", "Zoom."), Lesson("zoom", "go", "moving", "Zoom.")])
def test_what_no_file_has_is_not_learned_and_told(tmp_path: Path, lesson: Any) -> None:
    robot = Robot(tmp_path / "l.sqlite")
    robot.learning.take([lesson], "")
    assert "zoom" in robot.warnings[0] and robot.frames_of("zoom") == []


def test_many_learned_units_are_all_known(tmp_path: Path) -> None:
    file = LearnedFile(":memory:")
    assert MOST_UNITS >= 10_000 and file.units() == ()
    robot = Robot(tmp_path / "l.sqlite")
    texts = {f"learned/{n}.yaml": f"frame_name: going\nverb: zip{n} along\n" for n in range(500)}
    robot.learning._files.set_learned(texts)
    assert all(robot.frames_of(f"zip{n} along") == ["going"] for n in range(500))


IDIOM = "frame_name: going\nremark: dismissed\nvalues: {goal: the charger}\n"


def test_what_is_taught_last_in_words_counts_and_all_of_it_is_forgotten_by_its_words(tmp_path: Path) -> None:
    robot = Robot(tmp_path / "l.sqlite")
    other = "frame_name: moving\nremark: dismissed\n"
    robot.learning.take([Lesson("dismissed", "go to the charger", "going", "When ...", text=IDIOM)], "anna")
    robot.learning.take([Lesson("dismissed", "walk", "moving", "When ...", text=other)], "anna")
    (unit,) = LearnedFile(str(tmp_path / "l.sqlite")).units()
    assert (unit.name, unit.verb, unit.who, unit.text) == ("dismissed.moving", "walk", "anna", other)
    robot.learning.take([LESSON, Lesson("dismissed", "", "", "Forget ...", is_forgotten=True)], "bob")
    assert [one.said for one in LearnedFile(str(tmp_path / "l.sqlite")).units()] == ["make your way"]
    assert robot.lexicon.remark_units(["dismissed"]) == []


def test_what_two_persons_teach_is_kept_and_forgotten_together(tmp_path: Path) -> None:
    robot = Robot(tmp_path / "l.sqlite")
    for who, place in (("anna", "the charger"), ("bob", "the hall")):
        text = f"frame_name: going\nremark: dismissed\nvalues: {{goal: {place}}}\n"
        robot.learning.take([Lesson("dismissed", f"go to {place}", "going", "When ...", text=text)], who)
    assert len(robot.lexicon.remark_units(["dismissed"])) == 2
    assert sorted(robot.learning.names.meanings.values()) == ["go to the charger", "go to the hall"]
    robot.learning.take([Lesson("dismissed", "", "", "Forget ...", is_forgotten=True)], "bob")
    assert robot.lexicon.remark_units(["dismissed"]) == []


def test_the_frame_of_a_sequence_is_told_and_taken_back_and_known_after_a_restart(tmp_path: Path) -> None:
    robot = Robot(tmp_path / "l.sqlite")
    text = text_with_frame("frame_name: taught_x\nremark: x\n", "name: taught_x\nchildren: [[{name: going}]]\n")
    robot.learning.take([Lesson("x", "go", "taught_x", "When ...", text=text)], "")
    assert robot.frames_told == [{}, {"learned/x.taught_x.yaml": "name: taught_x\nchildren: [[{name: going}]]\n"}]
    robot.learning.close()
    again = Robot(tmp_path / "l.sqlite")
    assert again.frames_told == robot.frames_told[1:] and not again.warnings
    again.learning.take([Lesson("x", "", "", "Forget ...", is_forgotten=True)], "")
    assert again.frames_told[-1] == {}


def test_kinds_and_names_of_places_are_kept_and_forgotten(tmp_path: Path) -> None:
    robot = Robot(tmp_path / "l.sqlite")
    robot.learning.take([Lesson("mug", "cup", KIND, "A mug ..."), Lesson("den", "room_1", PLACE, "This ...")], "anna")
    robot.learning.take([Lesson("mug", "vessel", KIND, "A mug ...")], "bob")
    assert (robot.learning.names.kinds, robot.learning.names.places) == ({"mug": "vessel"}, {"den": "room_1"})
    assert not robot.warnings and robot.lexicon.units_of("mug") == ()
    robot.learning.take([Lesson("den", "", "", "Forget ...", is_forgotten=True)], "")
    assert robot.learning.names.places == {}
