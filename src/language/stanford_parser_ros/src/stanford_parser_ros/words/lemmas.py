"""Finds the dictionary form of words."""

from typing import Any, Dict, Mapping, Optional, Tuple

import numpy as np

from stanford_parser_ros.words.word_folder import UNKNOWN, WordFiles

_END = "<EOS>"
#: What the network says of a word: leave it as it is, in lower case. Otherwise it spells.
_KEEP, _LOWER = 1, 2


class Lemmatizer:
    """Stanza's lemmatizer: a dictionary, and for other words a network that spells."""

    #: Words that are kept.
    MOST_KEPT = 4096

    def __init__(self, files: WordFiles, network: Any) -> None:
        """
        Args:
            files: of the folder of words
            network: session of ONNX Runtime
        """
        self._dictionary: Mapping[str, Mapping[str, str]] = files.lemmas
        self._numbers = files.letters
        self._letters = tuple(files.letters)
        self._parts_of_speech = files.parts_of_speech
        self._network = network
        self._kept: Dict[Tuple[str, str], str] = {}

    def lemma(self, form: str, upos: str) -> str:
        """Return the dictionary form of a word."""
        known = self._known(form, upos)
        if known is not None:
            return known
        key = (form, upos)
        if key not in self._kept:
            if len(self._kept) >= self.MOST_KEPT:
                self._kept.clear()
            self._kept[key] = self._predicted(form, upos)
        return self._kept[key]

    def _known(self, form: str, upos: str) -> Optional[str]:
        """Return the lemma that the dictionary has for a word of this part of speech, or for the word."""
        known = self._dictionary.get(upos, {}).get(form)
        return self._dictionary["*"].get(form) if known is None else known

    def _predicted(self, form: str, upos: str) -> str:
        letters = ["<SOS>", *form, _END]
        # A letter that the network has not learned gets a number of its own, so that it can be copied.
        unknown = sorted({letter for letter in form if letter not in self._numbers})
        size = len(self._letters)
        copies = np.zeros((len(letters), size + len(unknown)), np.float32)
        for row, letter in enumerate(letters):
            copies[row, size + unknown.index(letter) if letter in unknown else self._numbers[letter]] = 1.0
        edit, spelled = self._network.run(
            None,
            {
                "part_of_speech": np.array([self._parts_of_speech.get(upos, UNKNOWN)], np.int64),
                "numbers": np.array([self._numbers.get(letter, UNKNOWN) for letter in letters], np.int64),
                "copies": copies,
            },
        )
        if edit == _KEEP:
            return form
        if edit == _LOWER:
            return form.lower()
        units = (*self._letters, *unknown)
        lemma = "".join(units[number] for number in spelled.tolist()).split(_END, 1)[0]
        return lemma if lemma and "<UNK>" not in lemma else form
