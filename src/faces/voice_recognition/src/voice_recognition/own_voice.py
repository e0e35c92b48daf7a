"""Which utterances are the robot's own: what begins while it speaks is not said to it."""

from voice_recognition.endpointing import Utterance

#: Seconds after the robot has spoken in which its voice is still on the way through the microphone.
ON_THE_WAY_S = 0.15


class OwnVoice:
    """Follows when the robot speaks, in the time of the stream. Not thread-safe."""

    def __init__(self) -> None:
        self._until_s = -1.0

    def follow(self, time_s: float, *, is_speaking: bool) -> None:
        """Take whether the robot speaks.

        Args:
            time_s: seconds of the stream so far
            is_speaking: whether it speaks now
        """
        if is_speaking:
            self._until_s = time_s + ON_THE_WAY_S

    def is_own(self, utterance: Utterance) -> bool:
        """Whether an utterance began while the robot spoke."""
        return utterance.begin_s < self._until_s
