"""Divides a text into tokens, and tokens such as "don't" into words."""

import re
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, NamedTuple, Tuple

import numpy as np

from stanford_parser_ros.lean.layers import Linear, Recurrent, floats, log_sigmoid, product, relu, sigmoid
from stanford_parser_ros.lean.vocabulary import UNKNOWN, Vocabulary

if TYPE_CHECKING:
    from stanford_parser_ros.lean.layers import Floats

_BLANK_LINE = re.compile("\n[\\s\u0080-\u009f]*\n")
_SPACE = re.compile("[\\s\u0080-\u009f]")
#: An address is one token, whatever the model says.
_ADDRESS = re.compile(
    r"[\w.!#$%&'*+/=?^`{|}~-]+@[a-z0-9-]+(?:\.[a-z0-9-]+)+|https?://[^\s\"]+\.[^\s\"]{2,}|www\.[^\s\"]+\.[^\s\"]{2,}"
)
#: What stands for a token with more letters than the model takes.
_TOO_LONG = "<UNK>"
_FEATURES = ["space_before", "capitalized", "numeric", "end_of_para", "start_of_para"]


class Token(NamedTuple):
    """A token of the text.

    Attributes:
        text: its letters
        start, end: positions of its first character and after its last one
        is_compound: whether it may hold several words
    """

    text: str
    start: int
    end: int
    is_compound: bool


class Tokenizer:
    """Stanza's tokenizer: an LSTM over the characters that says of each whether a token ends there."""

    def __init__(self, saved: Mapping[str, Any]) -> None:
        """
        Args:
            saved: content of the model file
        Raises:
            ValueError: the model has parts that are not known here
        """
        config, weights = saved["config"], saved["model"]
        if (
            config["feat_funcs"] != _FEATURES
            or config["use_dictionary"]
            or config.get("charlm_forward_file")
            or config["conv_res"] is not None
            or config["rnn_layers"] != 1
            or not (config["hierarchical"] and config["use_mwt"] and config["hier_invtemp"] > 0)
        ):
            raise ValueError("a tokenizer of another form")
        self._numbers: Dict[str, int] = saved["vocab"]["_unit2id"]
        self._first = Recurrent(weights, "rnn")
        inputs = self._first.inputs
        # What each character adds to the gates, and each feature of it.
        self._of_character = product(floats(weights, "embeddings.weight"), inputs[: -len(_FEATURES)]) + self._first.bias
        self._of_feature = np.ascontiguousarray(inputs[-len(_FEATURES) :])
        self._second = Recurrent(weights, "rnn2")
        self._scores = Linear(weights, "tok_clf", "sent_clf", "mwt_clf")
        self._more_scores = Linear(weights, "tok_clf2", "sent_clf2", "mwt_clf2")
        self._longest = int(config["max_seqlen"])
        self._temperature = np.float32(config["hier_invtemp"])

    def tokens(self, text: str) -> List[Token]:
        """Return the tokens of the first paragraph of a text."""
        characters, places = _paragraph(text)
        ends, are_compounds = self._ends(characters)
        for address in _ADDRESS.finditer("".join(characters)):
            ends[address.start() : address.end() - 1] = False
            if not ends[address.end() - 1]:
                ends[address.end() - 1] = True
                are_compounds[address.end() - 1] = False
        tokens, start = [], 0
        for last in np.flatnonzero(ends):
            stop = int(last) + 1
            letters = "".join(characters[start:stop])
            stripped = letters.lstrip()
            if stripped:
                begin = places[start + len(letters) - len(stripped)]
                end = places[last] + 1
                if len(stripped) > self._longest:
                    # Stanza counts the letters of what stands for the token.
                    stripped = _TOO_LONG
                    end = begin + len(_TOO_LONG)
                tokens.append(Token(stripped, begin, end, bool(are_compounds[last])))
            start = stop
        return tokens

    def _ends(self, characters: List[str]) -> Tuple[Any, Any]:
        """Return whether a token ends at each character, and whether it is one of several words."""
        # One more, which stands for what follows the paragraph, as Stanza has it.
        count = len(characters)
        numbers = [self._numbers.get(character, UNKNOWN) for character in characters]
        features = np.zeros((count + 1, len(_FEATURES)), np.float32)
        features[:count, 0] = [character == " " for character in characters]
        features[:count, 1] = [character.isupper() for character in characters]
        features[:count, 2] = [character.isdecimal() for character in characters]
        features[count - 1, 3] = features[0, 4] = 1.0
        gates = self._of_character[[*numbers, 0]] + product(features, self._of_feature)
        rest = np.zeros((2, self._first.size), np.float32)
        outputs, _, _ = self._first(gates, rest, rest)
        scores = self._scores(outputs)
        outputs = outputs * (np.float32(1.0) - sigmoid(-scores[:, :1] * self._temperature))
        outputs, _, _ = self._second.from_rest(outputs)
        scores = scores + self._more_scores(outputs)
        best = _classes(scores).argmax(axis=1)[:count]
        are_compounds = best >= 3
        ends = best > 0
        ends[-1] = True
        return ends, are_compounds


def _classes(scores: "Floats") -> "Floats":
    """Return the scores of: inside a token, end of a token, of a sentence, of a compound, of both."""
    no, yes = log_sigmoid(-scores), log_sigmoid(scores)
    token, sentence, compound = 0, 1, 2
    return np.stack(
        [
            no[:, token],
            yes[:, token] + no[:, sentence] + no[:, compound],
            yes[:, token] + yes[:, sentence] + no[:, compound],
            yes[:, token] + no[:, sentence] + yes[:, compound],
            yes[:, token] + yes[:, sentence] + yes[:, compound],
        ],
        axis=1,
    )


def _paragraph(text: str) -> Tuple[List[str], List[int]]:
    """Return the characters of the first paragraph, no two spaces in a row, and the place of each in the text."""
    start = 0
    for blank in [*_BLANK_LINE.finditer(text), None]:
        end = blank.start() if blank else len(text)
        end = start + len(text[start:end].rstrip())
        if end > start or blank is None:
            break
        start = blank.end()
    characters: List[str] = []
    places: List[int] = []
    for place in range(start, end):
        character = _SPACE.sub(" ", text[place])
        if character != " " or not characters or characters[-1] != " ":
            characters.append(character)
            places.append(place)
    return characters, places


class Expander:
    """Stanza's expander of multi-word tokens: a dictionary, and for others an LSTM that says where to cut."""

    def __init__(self, saved: Mapping[str, Any]) -> None:
        """
        Args:
            saved: content of the model file
        Raises:
            ValueError: the model has parts that are not known here
        """
        config, weights = saved["config"], saved["model"]
        if config["dict_only"] or not config.get("force_exact_pieces") or not config["ensemble_dict"]:
            raise ValueError("an expander of another form")
        self._dictionary: Mapping[str, str] = saved["dict"]
        self._vocabulary = Vocabulary(saved["vocab"])
        self._embedding = floats(weights, "embedding.weight")
        self._layers = [Recurrent(weights, "encoder", layer=layer) for layer in range(config["num_layers"])]
        self._hidden = Linear(weights, "output_layer.0")
        self._output = Linear(weights, "output_layer.2")

    def words(self, token: str) -> List[str]:
        """Return the words of a token that may hold several; itself if it holds one."""
        words = (self._known(token) or self._cut(token)).split()
        return words if len(words) > 1 else [token]

    def _known(self, token: str) -> str:
        """Return the expansion that the dictionary has for a token, empty if none."""
        expansion = self._dictionary.get(token, "")
        if not expansion and token.isupper():
            expansion = self._dictionary.get(token.lower(), "").upper()
        if not expansion and token[0].isupper() and token[1:].islower():
            expansion = self._dictionary.get(token.lower(), "")
            expansion = expansion[:1].upper() + expansion[1:]
        return expansion

    def _cut(self, token: str) -> str:
        values = self._embedding[self._vocabulary.numbers(["<SOS>", *token, "<EOS>"])]
        for layer in self._layers:
            values, _, _ = layer.from_rest(values)
        scores = self._output(relu(self._hidden(values)))[1:-1]
        return "".join(f" {character}" if cut > keep else character for character, (keep, cut) in zip(token, scores))
