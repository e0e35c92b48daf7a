"""The names that the robot knows, from a file and from another program."""

from semantic_framer.units.known_names import KnownNames
from semantic_types.likelihood import Fit

WORLD = [("Rover", ["Animal"]), ("Anna", ["Device"])]


def test_names_of_the_file_count_before_names_that_are_heard(tmp_path) -> None:
    path = tmp_path / "names.yaml"
    path.write_text("names: {Anna: Human}\n")
    names = KnownNames(str(path))
    assert names.problems == ()
    assert names.hear(WORLD, "/world") == ()
    assert names.types.of_name("anna").names == ("Human",)
    assert names.types.of_name("rover").names == ("Animal",)


def test_the_names_before_are_replaced() -> None:
    names = KnownNames()
    names.hear(WORLD, "/world")
    names.hear([("Rex", ["Animal"])], "/world")
    assert names.types.of_name("rover").fit(["Animal"]) is Fit.UNKNOWN
    assert names.types.of_name("rex").names == ("Animal",)


def test_wrong_names_are_refused_and_the_names_before_stay() -> None:
    names = KnownNames()
    names.hear(WORLD, "/world")
    problems = names.hear([("Rex", ["Animl"])], "/world")
    assert [(problem.code, problem.path) for problem in problems] == [("UNKNOWN_TYPE", "/world")]
    assert names.types.of_name("rover").names == ("Animal",)


def test_a_wrong_file_is_left_out_and_tells_its_problems(tmp_path) -> None:
    path = tmp_path / "names.yaml"
    path.write_text("names:\n  Anna: Human\n  Ben: Humam\n")
    names = KnownNames(str(path))
    assert [(problem.code, problem.line) for problem in names.problems] == [("UNKNOWN_TYPE", 3)]
    assert names.types.of_name("anna").names == ()


def test_a_missing_file_is_a_problem(tmp_path) -> None:
    assert [problem.code for problem in KnownNames(str(tmp_path / "none.yaml")).problems] == ["UNREADABLE"]
