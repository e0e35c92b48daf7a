"""The robot does not hear itself."""

from voice_recognition.endpointing import Utterance
from voice_recognition.own_voice import ON_THE_WAY_S, OwnVoice


def test_what_begins_while_the_robot_speaks_is_its_own() -> None:
    own = OwnVoice()
    own.follow(1.0, is_speaking=False)
    assert not own.is_own(Utterance(b"", 0.5, 1.0))
    for time_s in (2.0, 2.5, 3.0):
        own.follow(time_s, is_speaking=True)
    own.follow(3.5, is_speaking=False)
    # It ends only when the robot has been silent for a while.
    assert own.is_own(Utterance(b"", 2.1, 3.4))
    assert own.is_own(Utterance(b"", 3.0 + ON_THE_WAY_S / 2, 4.0))
    assert not own.is_own(Utterance(b"", 3.0 + ON_THE_WAY_S, 4.0))
