"""Verbs that mean what known verbs mean."""

import pytest

from semantic_types.verbs import shipped_verbs

KNOWN = frozenset("attach bring check connect fetch find go move put take turn".split())


@pytest.fixture(scope="module")
def like():
    return shipped_verbs().like(KNOWN)


@pytest.mark.parametrize(
    ("verb", "known"), [("veer", "turn"), ("walk", "go"), ("deliver", "fetch"), ("detect", "find"), ("affix", "attach")]
)
def test_a_verb_stands_with_the_known_one_that_it_mostly_means(like, verb, known):
    assert verb in like[known]


@pytest.mark.parametrize("word", ["near", "table", "free", "die", "glass", "pick up", "bring"])
def test_other_words_stand_with_none(like, word):
    assert not any(word in verbs for verbs in like.values())


def test_a_known_verb_that_wordnet_lacks_has_none():
    assert not shipped_verbs().like(["frobnicate"])


def test_the_order_of_the_known_verbs_does_not_matter():
    assert shipped_verbs().like(sorted(KNOWN)) == shipped_verbs().like(sorted(KNOWN, reverse=True))


def test_known_verbs_that_usually_mean_the_same_are_found_both_ways():
    same = shipped_verbs().same(KNOWN)
    assert "move" in same["go"] and "go" in same["move"]
    assert "turn" not in same
