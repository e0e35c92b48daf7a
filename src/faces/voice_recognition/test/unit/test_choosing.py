"""What the robot knows chooses among the sentences that may have been said."""

from typing import Tuple

import pytest

from voice_recognition.agreement import Verdict
from voice_recognition.choosing import Candidate, choose
from voice_recognition.command_reading import Meaning, Sense
from voice_recognition.offers import Offer
from voice_recognition.whisper_model import Sentence


def candidate(
    text: str,
    log_probability: float,
    sense: Sense = Sense.COMMAND,
    *,
    unknown: Tuple[str, ...] = (),
    is_heard: bool = True,
    frame: str = "",
) -> Candidate:
    """A sentence; each command is a frame of its own, unless it is named."""
    words = text.split()
    offer = Offer(frame or words[0], (("all", " ".join(words[1:])),), text, text) if sense > Sense.NONE else None
    meaning = Meaning(sense, None if sense is Sense.STOP else offer, unknown)
    return Candidate(Sentence(text, log_probability, len(words)), meaning, is_heard)


def texts(heard) -> Tuple[str, ...]:
    return tuple(offer.text for offer in heard.offers)


def test_one_clear_command_is_sure() -> None:
    heard = choose([candidate("turn left", -0.4), candidate("turn lift", -2.0, Sense.REFUSED)])
    assert heard.verdict is Verdict.SURE and texts(heard) == ("turn left",)


def test_a_name_that_the_robot_knows_wins_over_one_that_it_does_not() -> None:
    god = candidate("follow God", -0.9, unknown=("god",))
    heard = choose([god, candidate("follow Bob", -7.8, is_heard=False)])
    assert texts(heard)[0] == "follow Bob"
    assert heard.verdict is not Verdict.SURE
    assert texts(choose([god])) == ("follow God",)


def test_what_nobody_heard_is_never_sure() -> None:
    heard = choose([candidate("follow Bob", -0.2, is_heard=False)])
    assert heard.verdict is Verdict.LIKELY


def test_two_commands_that_sound_alike_are_a_choice() -> None:
    heard = choose([candidate("take the pen", -2.0), candidate("take the pan", -2.3)])
    assert heard.verdict is Verdict.CHOICE and set(texts(heard)) == {"take the pen", "take the pan"}


def test_spellings_of_one_command_are_one_command() -> None:
    heard = choose([candidate("turn left", -0.5, frame="t"), candidate("turn left", -0.6, frame="t")])
    assert heard.verdict is Verdict.SURE and len(heard.offers) == 1


def test_unlikely_words_are_nothing() -> None:
    assert choose([candidate("turn left", -9.0)]).verdict is Verdict.NOTHING
    assert choose([]).verdict is Verdict.NOTHING


@pytest.mark.parametrize(
    ("sense", "verdict"), [(Sense.NONE, Verdict.NOTHING), (Sense.REFUSED, Verdict.AGAIN), (Sense.ASKED, Verdict.LIKELY)]
)
def test_what_the_robot_makes_nothing_of_is_not_offered(sense: Sense, verdict: Verdict) -> None:
    heard = choose([candidate("turn left", -1.4, sense)])
    assert heard.verdict is verdict and bool(heard.offers) == (sense is Sense.ASKED)


@pytest.mark.parametrize("sense", [Sense.NONE, Sense.REFUSED])
def test_what_it_would_refuse_is_asked_about_where_it_is_clear_that_it_was_said(sense: Sense) -> None:
    heard = choose([candidate("switch it on", -0.4, sense)])
    assert heard.verdict is Verdict.LIKELY
    assert [offer.question for offer in heard.offers] == ['I heard "switch it on". Is that right?']
    assert not choose([candidate("switch it on", -0.4, sense, is_heard=False)]).offers


def test_a_stop_is_a_stop() -> None:
    heard = choose([candidate("stop", -0.5, Sense.STOP), candidate("step", -3.0, Sense.NONE)])
    assert heard.is_stop and not heard.offers and not heard.is_emergency
    assert choose([candidate("emergency stop", -0.5, Sense.STOP)]).is_emergency
    heard = choose([candidate("stop", -9.0, Sense.STOP), candidate("step back", -0.5)])
    assert not heard.is_stop and texts(heard) == ("step back",)
