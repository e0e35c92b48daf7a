"""Hides the versions of pocketsphinx: 5, and the one that Debian and Ubuntu package."""

import os
import tempfile
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any, Mapping, Protocol, Tuple, Union

from voice_recognition.pronunciation import Dictionary, read_dictionary

#: Samples a second of the acoustic model.
RATE = 16_000
#: The share of the model that distributions install.
_SYSTEM_MODEL = Path("/usr/share/pocketsphinx/model")


class NoRecogniser(RuntimeError):
    """Pocketsphinx or its acoustic model is not installed; the message says what to install."""


@dataclass(frozen=True)
class Hypothesis:
    """What a search heard.

    Attributes:
        words: without noises
        score: acoustic and language score in log units of the recogniser; higher is better
        frames: number of frames of 10 ms
    """

    words: Tuple[str, ...]
    score: int = 0
    frames: int = 0


class Recogniser(Protocol):
    """What the voice needs of a speech recogniser."""

    def hear(self, name: str, pcm: bytes) -> Hypothesis:
        """Return what a search hears in a whole utterance of 16 kHz, 16 bit, mono."""


class PocketSphinx:
    """A :class:`Recogniser` by pocketsphinx with the English model. A new language makes a new one."""

    def __init__(
        self,
        dictionary: Dictionary,
        *,
        grammars: Mapping[str, str] = MappingProxyType({}),
        ngrams: Mapping[str, str] = MappingProxyType({}),
        settings: Mapping[str, Union[bool, int, float, str]] = MappingProxyType({}),
    ) -> None:
        """
        Args:
            dictionary: the words of all searches with their sounds; a small one makes it quick
            grammars: JSGF by the name of its search
            ngrams: ARPA by the name of its search
            settings: further parameters of the decoder
        Raises:
            NoRecogniser: it is not installed
        """
        module = _module()
        self._is_new = hasattr(module.Decoder, "add_jsgf_string")
        with tempfile.TemporaryDirectory() as folder:
            words = _written(folder, "words.dict", _dictionary_text(dictionary))
            # pocketsphinx 5 loads its own language model unless it is told of none.
            parameters = {"hmm": str(_model() / "en-us"), "dict": words, **settings}
            if self._is_new:
                config = module.Config(lm=None, loglevel="FATAL", **parameters)
            else:
                config = module.Decoder.default_config()
                for name, value in {"logfn": os.devnull, **parameters}.items():
                    _set(config, f"-{name}", value)
            self._decoder: Any = module.Decoder(config)
            for name, grammar in grammars.items():
                self._call("jsgf_string", name, grammar)
            for name, arpa in ngrams.items():
                self._call("lm_file", name, _written(folder, "words.lm", arpa))

    def _call(self, kind: str, name: str, content: str) -> None:
        getattr(self._decoder, f"{'add' if self._is_new else 'set'}_{kind}")(name, content)

    def _choose(self, name: str) -> None:
        (self._decoder.activate_search if self._is_new else self._decoder.set_search)(name)

    def hear(self, name: str, pcm: bytes) -> Hypothesis:
        """See :class:`Recogniser`."""
        decoder = self._decoder
        self._choose(name)
        decoder.start_utt()
        decoder.process_raw(pcm, False, True)
        decoder.end_utt()
        found = decoder.hyp()
        if found is None:
            return Hypothesis((), 0, decoder.n_frames())
        words = tuple(word for word in found.hypstr.split() if not word.startswith(("<", "[", "+")))
        return Hypothesis(tuple(word.split("(")[0] for word in words), found.best_score, decoder.n_frames())


def _set(config: Any, name: str, value: object) -> None:
    if isinstance(value, bool):
        config.set_boolean(name, value)
    elif isinstance(value, int):
        config.set_int(name, value)
    elif isinstance(value, float):
        config.set_float(name, value)
    else:
        config.set_string(name, str(value))


def _module() -> Any:
    try:
        import pocketsphinx
    except ImportError as error:
        raise NoRecogniser("pocketsphinx is not installed: python3-pocketsphinx, pocketsphinx-en-us") from error
    return pocketsphinx


def _model() -> Path:
    """Return the folder of the English model: that of the distribution, or the one that came with the module."""
    for root in (_SYSTEM_MODEL, Path(_module().get_model_path())):
        folder = root / "en-us"
        if (folder / "en-us" / "mdef").exists() and (folder / "cmudict-en-us.dict").exists():
            return folder
    raise NoRecogniser("the acoustic model of pocketsphinx is not installed: pocketsphinx-en-us")


def model_dictionary() -> Dictionary:
    """Return the dictionary that belongs to the acoustic model.

    Raises:
        NoRecogniser: it is not installed
    """
    return read_dictionary(str(_model() / "cmudict-en-us.dict"))


def _dictionary_text(dictionary: Dictionary) -> str:
    lines = []
    for word, ways in sorted(dictionary.items()):
        lines += [f"{word}({number}) {way}" if number > 1 else f"{word} {way}" for number, way in enumerate(ways, 1)]
    return "\n".join(lines) + "\n"


def _written(folder: str, name: str, text: str) -> str:
    path = Path(folder) / name
    path.write_text(text, encoding="utf-8")
    return str(path)
