"""Tells whether somebody speaks, by the voice activity detector Silero, whose model comes with faster-whisper."""

import importlib.util
from pathlib import Path
from typing import Any

import numpy as np

from voice_recognition.sound import to_unit_samples
from voice_recognition.whisper_model import HOW_TO_INSTALL, NoWhisper, checksum

PACKAGE, FILE = "faster_whisper", "assets/silero_vad_v6.onnx"
#: SHA-256 of the model (MIT).
SUM = "4cbf549b8326f60f80f2536d9eefeb450a9abe83365a098031c89719f1be17d2"
#: Samples that it looks at, and of those before them.
PART, BEFORE = 512, 64
_STATE = 128


def detector_file() -> Path:
    """Return the file of the model, which is the one that this project knows.

    Raises:
        NoWhisper: it is not installed, or another one is
    """
    spec = importlib.util.find_spec(PACKAGE)
    if spec is None:
        raise NoWhisper(f"{PACKAGE} is not installed ({HOW_TO_INSTALL})")
    path = Path(next(iter(spec.submodule_search_locations or ("",)))) / FILE
    if checksum(path) != SUM:
        raise NoWhisper(f"{path} is not the model that is known here")
    return path


def load_session() -> Any:
    """Return the loaded model, on one thread.

    Raises:
        NoWhisper: it is not installed, or another model is
    """
    import onnxruntime

    options = onnxruntime.SessionOptions()
    options.inter_op_num_threads = options.intra_op_num_threads = 1
    return onnxruntime.InferenceSession(str(detector_file()), options, providers=["CPUExecutionProvider"])


class SpeechStream:
    """How likely somebody speaks now, in a stream. Not thread-safe."""

    def __init__(self, session: Any) -> None:
        """
        Args:
            session: of :func:`load_session`; it may be shared
        """
        self._session = session
        self._before = np.zeros(BEFORE, np.float32)
        self._rest = np.zeros(0, np.float32)
        self._state = np.zeros((1, 1, _STATE), np.float32), np.zeros((1, 1, _STATE), np.float32)
        self._speech = 0.0

    def feed(self, pcm: bytes) -> float:
        """Take the next sound; return the probability of speech in its last part of 32 ms."""
        self._rest = np.concatenate([self._rest, to_unit_samples(pcm)])
        while len(self._rest) >= PART:
            part, self._rest = self._rest[:PART], self._rest[PART:]
            given = np.concatenate([self._before, part])[None]
            (speech, *state) = self._session.run(None, {"input": given, "h": self._state[0], "c": self._state[1]})
            self._state = state[0], state[1]
            self._before = part[-BEFORE:]
            self._speech = float(np.max(speech))
        return self._speech


class SpeechDetector:
    """Looks at whole sounds."""

    def __init__(self) -> None:
        """
        Raises:
            NoWhisper: it is not installed, or another model is
        """
        self._session = load_session()

    def most_speech(self, pcm: bytes) -> float:
        """Return the highest probability of speech in a part of a sound; parts are 32 ms long."""
        samples = to_unit_samples(pcm)
        count = len(samples) // PART
        if not count:
            return 0.0
        padded = np.concatenate([np.zeros(BEFORE, np.float32), samples[: count * PART]])
        parts = np.stack([padded[at * PART : at * PART + BEFORE + PART] for at in range(count)])
        state = np.zeros((1, 1, _STATE), np.float32)
        (speech, _, _) = self._session.run(None, {"input": parts, "h": state, "c": state})
        return float(np.max(speech))
