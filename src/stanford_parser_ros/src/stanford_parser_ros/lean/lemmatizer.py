"""Finds the dictionary form of words."""

import gzip
import json
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Tuple

import numpy as np

from stanford_parser_ros.lean.layers import Linear, Recurrent, floats, log_sigmoid, log_softmax, relu
from stanford_parser_ros.lean.vocabulary import UNKNOWN, Vocabulary

if TYPE_CHECKING:
    from stanford_parser_ros.lean.layers import Floats

#: The form in which the dictionary of the model is saved.
_DICTIONARY_VERSION = 3
_START, _END = 2, 3
#: What the edit classifier says: spell it, leave it as it is, in lower case.
_SPELL, _KEEP, _LOWER = 0, 1, 2


class Lemmatizer:
    """Stanza's lemmatizer: a dictionary, and for other words a network that spells."""

    #: Words that are kept.
    MOST_KEPT = 4096

    def __init__(self, saved: Mapping[str, Any]) -> None:
        """
        Args:
            saved: content of the model file
        Raises:
            ValueError: the model has parts that are not known here
        """
        config, weights = saved["config"], saved["model"]
        if (
            saved.get("dicts_version") != _DICTIONARY_VERSION
            or saved.get("contextual")
            or config["dict_only"]
            or config["caseless"]
            or config["beam_size"] != 1
            or config["attn_type"] != "soft"
            or config["num_layers"] != 1
            or config.get("charlm")
            or not (config["ensemble_dict"] and config["edit"] and config["pos"] and config["copy"])
        ):
            raise ValueError("a lemmatizer of another form")
        self._dictionary: Mapping[str, Mapping[str, str]] = json.loads(gzip.decompress(saved["dicts"]))
        self._characters = Vocabulary(saved["vocab"]["char"])
        self._upos = Vocabulary(saved["vocab"]["pos"])
        self._most_letters: int = config["max_dec_len"]
        self._embedding = floats(weights, "embedding.weight")
        self._upos_embedding = floats(weights, "pos_embedding.weight")
        self._encoder = Recurrent(weights, "encoder")
        self._edit = (Linear(weights, "edit_clf.0"), Linear(weights, "edit_clf.2"))
        self._decoder = Recurrent(_as_layer(weights), "decoder")
        self._attention_in = Linear(weights, "decoder.attention_layer.linear_in")
        self._attention_out = Linear(weights, "decoder.attention_layer.linear_out")
        self._letters = Linear(weights, "dec2vocab")
        self._copy = Linear(weights, "copy_gate")
        self._kept: Dict[Tuple[str, str], str] = {}

    def lemma(self, form: str, upos: str) -> str:
        """Return the dictionary form of a word."""
        key = (form, upos)
        lemma = self._kept.get(key)
        if lemma is None:
            if len(self._kept) >= self.MOST_KEPT:
                self._kept.clear()
            known = self._known(form, upos)
            lemma = self._kept[key] = self._predicted(form, upos) if known is None else known
        return lemma

    def _known(self, form: str, upos: str) -> Optional[str]:
        """Return the lemma that the dictionary has for a word of this part of speech, or for the word."""
        known = self._dictionary.get(upos, {}).get(form)
        return self._dictionary.get("*", {}).get(form) if known is None else known

    def _predicted(self, form: str, upos: str) -> str:
        numbers = self._characters.numbers(["<SOS>", *form, "<EOS>"])
        inputs = np.concatenate([self._upos_embedding[[self._upos.number(upos)]], self._embedding[numbers]])
        outputs, hidden, cell = self._encoder.from_rest(inputs)
        # The direction that read the word backwards comes first.
        hidden, cell = hidden[::-1].reshape(1, -1), cell[::-1].reshape(1, -1)
        edit = int(self._edit[1](relu(self._edit[0](hidden))).argmax())
        if edit == _KEEP:
            return form
        if edit == _LOWER:
            return form.lower()
        return self._spelled(["", *form, ""], numbers, outputs, hidden, cell) or form

    def _spelled(
        self, letters: List[str], numbers: List[int], outputs: "Floats", hidden: "Floats", cell: "Floats"
    ) -> str:
        """Spell a lemma letter by letter; empty if the network does not know how.

        Args:
            letters: of the word, between its marks
            numbers: of each
            outputs: of the encoder: of the part of speech, then of each letter
            hidden, cell: the first states of the decoder
        """
        # A letter that the model has not learned gets a number of its own here, so that it can be copied.
        unknown = sorted({x for x, n in zip(letters, numbers) if n == UNKNOWN and not self._characters.knows(x)})
        size = len(self._characters)
        sources = [size + unknown.index(x) if x in unknown else n for x, n in zip(letters, numbers)]
        result: List[str] = []
        number = _START
        while len(result) < self._most_letters:
            embedded = self._embedding[[UNKNOWN if number >= size else number]]
            state, hidden, cell = self._decoder(self._decoder.gates(embedded), hidden, cell)
            attention = log_softmax(np.einsum("ij,j->i", outputs, self._attention_in(state)[0]))
            context = np.einsum("i,ij->j", np.exp(attention), outputs)
            output = np.tanh(self._attention_out(np.concatenate([context, state[0]])[None]))
            scores = log_softmax(self._letters(output))[0]
            scores = np.concatenate([scores, np.full(len(unknown), scores[UNKNOWN])])
            gate = self._copy(output)[0]
            copied = np.full(len(scores), -1e12)
            np.logaddexp.at(copied, sources, log_sigmoid(gate) + log_softmax(attention[1:]))
            number = int(np.logaddexp(copied, scores + log_sigmoid(-gate)).argmax())
            if number == _END:
                break
            result.append(unknown[number - size] if number >= size else self._characters.unit(number))
        spelled = "".join(result)
        return "" if "<UNK>" in spelled else spelled


def _as_layer(weights: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return the decoder's cell under the names of a layer."""
    parts = ("weight_ih", "weight_hh", "bias_ih", "bias_hh")
    return {f"decoder.{part}_l0": weights[f"decoder.lstm_cell.{part}"] for part in parts}
