"""Two searches agree, or the robot asks."""

import pytest

from offline_pipeline.knowledge import load_knowledge, shipped_domains
from voice_recognition.agreement import Verdict, answer_of, compare, compare_answers, share_of_equal_words
from voice_recognition.ears import answers
from voice_recognition.offers import OfferFinder
from voice_recognition.spoken_language import make_language


@pytest.fixture(scope="module", name="finder")
def _finder() -> OfferFinder:
    knowledge = load_knowledge([shipped_domains()])
    frames = frozenset(["turning", "following", "stopping"])
    return OfferFinder(make_language(knowledge.frames, knowledge.lexicon.units, frames, {}, knowledge.types))


@pytest.mark.parametrize(
    "one, other, verdict, texts",
    [
        ("turn left ninety degrees", "turn left ninety degrees", Verdict.SURE, ["turn left 90 degrees"]),
        ("make a left", "turn left", Verdict.SURE, ["make a left"]),
        (
            "turn left ninety degrees",
            "turn left twenty degrees",
            Verdict.CHOICE,
            ["turn left 90 degrees", "turn left 20 degrees"],
        ),
        ("turn left ninety degrees", "turn left ninety the cheese", Verdict.LIKELY, ["turn left 90 degrees"]),
        ("turn left ninety degrees", "what a lovely weather", Verdict.AGAIN, []),
        ("stop", "shop", Verdict.AGAIN, []),
        ("", "what a lovely weather", Verdict.NOTHING, []),
    ],
)
def test_what_both_searches_heard_is_compared(finder: OfferFinder, one, other, verdict, texts) -> None:
    heard = compare(tuple(one.split()), tuple(other.split()), finder)
    assert heard.verdict is verdict
    assert [offer.text for offer in heard.offers] == texts


def test_a_stop_needs_both_searches(finder: OfferFinder) -> None:
    assert compare(("stop",), ("stop", "now"), finder).is_stop
    assert not compare(("stop",), ("shop",), finder).is_stop
    emergency = ("emergency", "stop")
    assert compare(emergency, emergency, finder).is_emergency
    assert not compare(emergency, ("stop",), finder).is_emergency


@pytest.mark.parametrize(
    "one, other, answer",
    [
        ("yes", "yeah", "yes"),
        ("yes", "the", ""),
        ("yes", "no", ""),
        ("no thanks", "no", "no"),
        ("the second one", "the second", "second"),
        ("yes please", "yes", "yes"),
    ],
)
def test_an_answer_needs_both_searches(one: str, other: str, answer: str) -> None:
    assert compare_answers(tuple(one.split()), tuple(other.split()), answers()).answer == answer


def test_answers_differ() -> None:
    ways = [way for phrases in answers().values() for way in phrases]
    assert len(ways) == len(set(ways))
    assert all(answer_of(way, answers()) for way in ways)


def test_equal_words_are_counted() -> None:
    assert share_of_equal_words(("turn", "left"), ("turn", "left")) == 1.0
    assert share_of_equal_words(("turn", "left"), ("turn",)) == 0.5
    assert share_of_equal_words(("turn",), ()) == 0.0
