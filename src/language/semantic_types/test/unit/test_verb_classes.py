"""Verbs of a class: the same sense and direct ways to do it, never sisters or opposites."""

from semantic_types.verb_classes import HYPONYM, SYNONYM, class_verbs, is_of_class, known_verbs_near
from semantic_types.wordnet import VERB, shipped_wordnet

NET = shipped_wordnet(VERB)


def verbs(*known, owned=()):
    return {one.verb: one for one in class_verbs(NET, known, owned)}


def test_a_verb_of_the_same_sense_and_a_way_to_do_it_are_proposed():
    found = verbs("lift", "get")
    assert (found["elevate"].sense, found["elevate"].reason) == ("lift.v.01", SYNONYM)
    assert (found["obtain"].sense, found["obtain"].reason) == ("get.v.01", HYPONYM)
    assert found["obtain"].gloss == "come into possession of"


def test_what_a_unit_has_is_not_proposed():
    assert "elevate" not in verbs("lift", owned=["elevate"])


def test_sisters_and_opposites_are_not_proposed():
    # Both are ways to move; "lower" is the opposite of "raise".
    assert "lower" not in verbs("raise") and "raise" not in verbs("lower")
    assert not is_of_class(NET, "lower", "raise.v.02") and not is_of_class(NET, "close", "open.v.01")


def test_a_rare_sense_counts_neither_here_nor_there():
    assert "navigate" not in verbs("take")
    assert all(one.verb != "take" for one in class_verbs(NET, ["obtain"]))


def test_a_sense_that_does_not_exist_has_no_class():
    assert is_of_class(NET, "obtain", "get.v.01")
    assert not is_of_class(NET, "obtain", "get.v.99") and not is_of_class(NET, "fly", "get.v.01")


def test_the_known_verbs_of_the_class_of_another_verb_are_found():
    assert known_verbs_near(NET, "stroll", ["walk", "open"]) == {"walk": HYPONYM}
    assert known_verbs_near(NET, "elevate", ["lift", "lower"]) == {"lift": SYNONYM}
    assert known_verbs_near(NET, "xyzzy", ["walk"]) == {}
