import pytest

from checked_files import FileRefused
from semantic_types import UNTYPED, WordTypes, checked_names, load_name_file
from semantic_types.likelihood import Fit
from semantic_types.name_file import MOST_NAMES


def test_names_count_before_nouns():
    names = load_name_file("names:\n  Bill: Human\n  Coffee  Corner: [Location, Room]\n", "names.yaml")
    types = WordTypes(names=names)
    assert types.of_name("bill").fit(["Human"]) is Fit.LIKELY
    assert types.of_name("coffee corner").names == ("Location", "Room")
    assert types.of_name("cup") == UNTYPED


def test_a_noun_is_looked_up_by_all_of_its_spellings():
    types = WordTypes()
    assert types.of_noun(["scissors", "scissor"]).fit(["Physical_object"]) is Fit.LIKELY
    assert types.of_noun(["frobnicators", "frobnicator"]) == UNTYPED


@pytest.mark.parametrize(
    ("text", "code", "key", "line"),
    [
        ("names:\n  Anna: Humam\n", "UNKNOWN_TYPE", "names.Anna", 2),
        ("names:\n  Anna: [Human, Humam]\n", "UNKNOWN_TYPE", "names.Anna[1]", 2),
        ("names:\n  Anna:\n", "EMPTY", "names.Anna", 2),
        ("names:\n  Anna: Human\n  anna: Human\n", "DUPLICATE_NAME", "names.anna", 3),
        ("name:\n  Anna: Human\n", "UNKNOWN_KEY", "name", 1),
        ("names: [Anna]\n", "WRONG_TYPE", "names", 1),
        (f"names:\n  {'x' * 101}: Human\n", "NAME_LENGTH", f"names.{'x' * 100}", 2),
        ("names:\n  Anna: {kind: Human}\n", "WRONG_TYPE", "names.Anna", 2),
        ("names:\n  a: [" + ", ".join(["Human"] * 9) + "]\n", "TOO_MANY", "names.a", 2),
        ("", "EMPTY", "file", 1),
    ],
)
def test_a_mistake_in_the_file_has_its_line_and_key(text, code, key, line):
    with pytest.raises(FileRefused) as refused:
        load_name_file(text, "names.yaml")
    problem = refused.value.problems[0]
    assert (problem.code, problem.key, problem.line, problem.path) == (code, key, line, "names.yaml")


def test_an_unknown_type_comes_with_the_nearest_one():
    with pytest.raises(FileRefused, match="did you mean 'Human'"):
        load_name_file("names: {Anna: Humam}", "names.yaml")


def test_names_of_another_program_are_checked():
    assert checked_names([("Anna", ["Human"]), ("the  Den", ["Room"])], "world") == {
        "anna": ("Human",),
        "the den": ("Room",),
    }


@pytest.mark.parametrize(
    ("pairs", "code"),
    [
        ([("", ["Human"])], "NAME_LENGTH"),
        ([("x" * 101, ["Human"])], "NAME_LENGTH"),
        ([("Anna", [])], "TYPE_COUNT"),
        ([("Anna", ["Human"] * 9)], "TYPE_COUNT"),
        ([("Anna", ["Humam"])], "UNKNOWN_TYPE"),
        ([(f"thing {number}", ["Device"]) for number in range(MOST_NAMES + 1)], "TOO_MANY"),
    ],
)
def test_wrong_names_of_another_program_are_refused(pairs, code):
    with pytest.raises(FileRefused) as refused:
        checked_names(pairs, "world")
    assert refused.value.problems[0].code == code
