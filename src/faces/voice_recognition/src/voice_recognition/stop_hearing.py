"""Hears stops by two recognisers: pocketsphinx is quick, and Whisper decides where pocketsphinx is not certain."""

from concurrent import futures
from typing import Callable, Optional

from voice_recognition.spotting import StopSpotter

#: Seconds that a stop which pocketsphinx heard waits for Whisper.
DECIDES_WITHIN_S = 1.5

#: Returns the stop that Whisper hears in a sound, empty for none; None if it cannot tell.
OtherOpinion = Callable[[bytes], Optional[str]]


class StopHearing:
    """Hears whether a short utterance is a stop."""

    def __init__(self, spotter: StopSpotter, by_whisper: Optional[OtherOpinion]) -> None:
        """
        Args:
            spotter: searches by pocketsphinx
            by_whisper: the other opinion; None where there is none
        """
        self._spotter = spotter
        self._by_whisper = by_whisper
        self._beside = futures.ThreadPoolExecutor(1, thread_name_prefix="stop_by_whisper")

    def stop_in(self, pcm: bytes) -> str:
        """Return the stop that an utterance is; empty for none."""
        if self._by_whisper is None:
            return self._spotter.stop_in(pcm)
        other = self._beside.submit(self._by_whisper, pcm)
        found = self._spotter.find_stop(pcm)
        if found.is_certain:
            return found.text
        try:
            decided = other.result(DECIDES_WITHIN_S)
        except Exception:  # boundary: an opinion that fails, or comes too late, must not cost a stop
            decided = None
        return found.text if decided is None else decided

    def close(self) -> None:
        """End its thread, when that has done what it does."""
        self._beside.shutdown(wait=False)
