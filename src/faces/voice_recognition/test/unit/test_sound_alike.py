"""Words that sound like what was heard."""

import pytest

from voice_recognition.sound_alike import SoundAlikes, difference_of, variants

DICTIONARY = {
    "god": ("G AA D",),
    "bob": ("B AA B",),
    "good": ("G UH D",),
    "mug": ("M AH G",),
    "carry": ("K AE R IY",),
    "car": ("K AA R",),
    "hit": ("HH IH T",),
    "he": ("HH IY",),
    "the": ("DH AH",),
    "follow": ("F AA L OW",),
}


@pytest.fixture(name="alikes")
def _alikes() -> SoundAlikes:
    return SoundAlikes(frozenset("bob good mug carry the follow".split()), ["Bob"], DICTIONARY)


def test_a_name_comes_before_other_words(alikes: SoundAlikes) -> None:
    assert [word for word, _ in alikes.words_like(("god",))] == ["bob", "good"]
    assert alikes.words_like(("follow",)) == ()


def test_two_words_may_have_been_one(alikes: SoundAlikes) -> None:
    assert [word for word, _ in alikes.words_like(("car", "he"))] == ["carry"]


def test_only_words_that_the_robot_does_not_know_are_exchanged(alikes: SoundAlikes) -> None:
    known = frozenset("bob good mug carry the follow".split())
    found = {words for _, words in variants(("follow", "god"), known, alikes)}
    assert found == {("follow", "bob"), ("follow", "good")}
    assert ("carry", "the", "mug") in {words for _, words in variants(("car", "he", "the", "mug"), known, alikes)}
    assert alikes.written(("follow", "bob")) == "follow Bob"


def test_the_difference_is_0_for_the_same_and_1_for_nothing_alike() -> None:
    assert difference_of(["G", "AA"], ["G", "AA"]) == 0.0
    assert difference_of(["G", "AA"], ["M", "S"]) == 1.0
    assert difference_of(["B"], ["P"]) < difference_of(["B"], ["S"])
