"""The searches begin before an utterance has surely ended."""

from typing import List

import pytest

from voice_recognition.agreement import Heard, Verdict
from voice_recognition.early_hearing import EarlyHearing
from voice_recognition.endpointing import Utterance

SO_FAR = Utterance(b"so far", 1.0, 2.0)
WHOLE = Utterance(b"so far, and quiet", 1.0, 2.0)


@pytest.mark.parametrize(
    "utterance, how, heard",
    [
        (WHOLE, "a command", [b"so far"]),
        (Utterance(b"and more", 1.0, 2.6), "a command", [b"so far", b"and more"]),
        (Utterance(b"later", 3.0, 4.0), "a command", [b"so far", b"later"]),
        (WHOLE, "an answer", [b"so far", b"so far, and quiet"]),
    ],
)
def test_what_was_heard_early_counts_for_the_same_words_and_purpose(
    utterance: Utterance, how: str, heard: List[bytes]
) -> None:
    sounds: List[bytes] = []

    def hear(pcm: bytes) -> Heard:
        sounds.append(pcm)
        return Heard(Verdict.AGAIN, by_grammar=(pcm.decode(),))

    early: EarlyHearing[str, Heard] = EarlyHearing()
    early.listen(SO_FAR, "a command", hear)
    assert early.heard(utterance, how, hear).by_grammar == (heard[-1].decode(),)
    assert sounds == heard
    early.heard(utterance, how, hear)
    assert len(sounds) == len(heard) + 1
