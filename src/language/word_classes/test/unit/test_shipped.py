"""The word classes that ship: found by name, read once, and what is asked of them."""

import subprocess
import sys

import pytest

from word_classes import UnknownWordClass, without_determiner, word_class, word_classes, word_list


def test_the_file_is_read_once() -> None:
    assert word_classes() is word_classes()


def test_a_class_is_asked_for_by_name() -> None:
    assert {"not", "never", "nothing"} <= word_class("negations")


def test_order_counts_for_who_asks_for_it() -> None:
    assert word_list("ordinals")[:3] == ("first", "second", "third")


def test_a_misspelt_name_says_where_and_what_is_near() -> None:
    with pytest.raises(UnknownWordClass, match=r"words\.yaml: no class 'negation'.*did you mean 'negations'"):
        word_class("negation")


def test_each_class_says_what_it_is_for_in_one_sentence() -> None:
    assert all(one.purpose.endswith(".") and one.purpose[0].isupper() for one in word_classes().values())


@pytest.mark.parametrize(
    "said, name",
    [
        ("the office", "office"),
        (" The  Office ", "Office"),
        ("office", "office"),
        ("the", "the"),
        ("", ""),
        ("theatre hall", "theatre hall"),
        ("my office", "my office"),
        ("some juice", "juice"),
    ],
)
def test_a_determiner_is_no_part_of_a_name(said: str, name: str) -> None:
    assert without_determiner(said) == name


def test_possessives_are_left_out_where_asked() -> None:
    assert without_determiner("my friend", word_class("determiners_and_possessives")) == "friend"


@pytest.mark.parametrize("module", ["rfnserver.places", "rfnserver.goal_binding", "command_server.stop_words"])
def test_what_stops_the_robot_reads_no_file_of_words(module: str) -> None:
    code = (
        f"import sys, {module}\n"
        "shipped = sys.modules.get('word_classes.shipped')\n"
        "sys.exit(shipped is not None and shipped.word_classes.cache_info().currsize)"
    )
    assert subprocess.run([sys.executable, "-c", code], timeout=60, check=False).returncode == 0
