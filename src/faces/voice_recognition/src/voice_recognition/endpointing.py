"""Finds where somebody speaks: energy above the noise of the room, with hysteresis. Silero helps to find its end."""

from collections import deque
from dataclasses import dataclass
from typing import Callable, Deque, List, Optional, Tuple

import numpy as np

from voice_recognition.recogniser import RATE
from voice_recognition.sound import speech_level_db, to_samples

#: Seconds of a frame.
FRAME_S = 0.02
_BYTES = int(RATE * FRAME_S) * 2
#: Share of the quietest frames that are the noise of the room.
_QUIET_SHARE = 10
#: Frames that begin an utterance: so many loud ones of so many.
_LOUD, _OF = 4, 6
#: From this probability on, somebody speaks; and frames after which what is loud is no voice any more.
_VOICE, _VOICE_LASTS = 0.4, 6
#: Returns the probability that somebody speaks at the end of a stream, of which it takes the next part.
VoiceDetector = Callable[[bytes], float]


@dataclass(frozen=True)
class EndpointSettings:
    """When an utterance begins and ends.

    Attributes:
        begin_db: it begins so many decibels above the noise
        end_db: and has ended below so many
        end_s: seconds of quiet that end it
        pause_s: seconds of quiet after which it may have ended
        before_s: seconds before its beginning that belong to it
        shortest_s: seconds of the shortest utterance
        longest_s: seconds after which it is cut off
        noise_s: seconds of the past from which the noise is estimated
        quietest_db: below full scale; anything below is quiet
    """

    begin_db: float = 6.0
    end_db: float = 4.0
    end_s: float = 0.4
    pause_s: float = 0.2
    before_s: float = 0.5
    shortest_s: float = 0.1
    longest_s: float = 12.0
    noise_s: float = 6.0
    quietest_db: float = -62.0


@dataclass(frozen=True)
class Utterance:
    """A part of the stream in which somebody speaks.

    Attributes:
        pcm: its sound, with a little of the quiet around it
        begin_s, end_s: where speech begins and ends, seconds from the beginning of the stream
        is_cut: whether it was cut off because it was too long
    """

    pcm: bytes
    begin_s: float
    end_s: float
    is_cut: bool = False


class Endpointer:
    """Divides a stream into utterances."""

    def __init__(
        self,
        settings: EndpointSettings = EndpointSettings(),
        noise_db: Optional[float] = None,
        voice: Optional[VoiceDetector] = None,
    ) -> None:
        """
        Args:
            settings: when an utterance begins and ends
            noise_db: the noise of the room, when it is known; otherwise the stream has to begin with it
            voice: tells noise from a voice, so that noise which goes on does not make an utterance longer. A voice that
                it does not know ends by its energy alone
        """
        self._voice = voice
        self._last_voice = -1
        self._settings = settings
        self._rest = b""
        self._frames = 0
        self._levels: Deque[float] = deque(maxlen=max(1, int(settings.noise_s / FRAME_S)))
        if noise_db is not None:
            self._levels.extend([noise_db] * max(1, int(0.5 / FRAME_S)))
        self._before: Deque[bytes] = deque(maxlen=max(_OF, int(settings.before_s / FRAME_S)))
        self._loud: Deque[bool] = deque(maxlen=_OF)
        self._said: List[bytes] = []
        self._begin = self._last_loud = 0
        self._pause: Optional[Utterance] = None

    @property
    def is_speaking(self) -> bool:
        """Whether an utterance has begun and not ended."""
        return bool(self._said)

    @property
    def noise_db(self) -> float:
        """Noise of the room, decibels below full scale."""
        quietest = self._settings.quietest_db - self._settings.begin_db
        if not self._levels:
            return quietest
        return max(float(np.percentile(list(self._levels)[::2], _QUIET_SHARE)), quietest)

    @property
    def time_s(self) -> float:
        """Seconds of the stream so far."""
        return self._frames * FRAME_S

    def feed(self, pcm: bytes) -> Tuple[Utterance, ...]:
        """Take the next part of the stream; return the utterances that end in it."""
        self._rest += pcm
        found: List[Utterance] = []
        whole = len(self._rest) // _BYTES * _BYTES
        for at in range(0, whole, _BYTES):
            utterance = self._take(self._rest[at : at + _BYTES])
            if utterance is not None:
                found.append(utterance)
        self._rest = self._rest[whole:]
        return tuple(found)

    def take_pause(self) -> Optional[Utterance]:
        """Return, once, what was said before a pause that may end the utterance; None when it has ended or goes on.

        When it ends, it has the same ``begin_s`` and ``end_s``.
        """
        pause, self._pause = self._pause, None
        return pause

    def finish(self) -> Tuple[Utterance, ...]:
        """End the stream; return the utterance that had not ended."""
        return tuple(one for one in [self._end(is_cut=False)] if one is not None) if self._said else ()

    def _take(self, frame: bytes) -> Optional[Utterance]:
        settings = self._settings
        self._frames += 1
        level = max(speech_level_db(to_samples(frame)), settings.quietest_db - settings.begin_db)
        self._levels.append(level)
        if self._voice is not None and self._voice(frame) >= _VOICE:
            self._last_voice = self._frames
        noise = self.noise_db
        if not self._said:
            self._before.append(frame)
            self._loud.append(level > noise + settings.begin_db)
            if sum(self._loud) >= _LOUD:
                self._said = list(self._before)
                self._begin, self._last_loud = self._frames - len(self._loud), self._frames
            return None
        self._said.append(frame)
        if level > noise + settings.end_db and not self._is_only_noise():
            self._last_loud, self._pause = self._frames, None
        quiet = self._frames - self._last_loud
        if quiet == round(settings.pause_s / FRAME_S):
            self._pause = self._utterance(is_cut=False)
        if quiet * FRAME_S >= settings.end_s - 1e-9:
            return self._end(is_cut=False)
        if len(self._said) * FRAME_S >= settings.longest_s:
            return self._end(is_cut=True)
        return None

    def _is_only_noise(self) -> bool:
        """Whether a voice that was known in this utterance is heard no more."""
        return self._begin <= self._last_voice < self._frames - _VOICE_LASTS

    def _end(self, *, is_cut: bool) -> Optional[Utterance]:
        found = self._utterance(is_cut=is_cut)
        self._said = []
        self._pause = None
        self._before.clear()
        self._loud.clear()
        return found

    def _utterance(self, *, is_cut: bool) -> Optional[Utterance]:
        begin_s, end_s = self._begin * FRAME_S, self._last_loud * FRAME_S
        if end_s - begin_s < self._settings.shortest_s:
            return None
        return Utterance(b"".join(self._said), begin_s, end_s, is_cut)
