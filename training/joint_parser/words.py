"""Writes the tokenizer, the expander of multi-word tokens and the lemmatizer of a Stanza package for ONNX Runtime."""

import json
from pathlib import Path
from typing import Any, Dict, List, Tuple

import torch
from torch import Tensor, nn

from command_models.errors import TrainingError
from stanford_parser_ros.words import word_folder

_END, _UNKNOWN = 3, 1
_FEATURES = ["space_before", "capitalized", "numeric", "end_of_para", "start_of_para"]


class Ends(nn.Module):  # type: ignore[misc]  # torch is not read
    """Says of each character of a text whether a token ends there."""

    def __init__(self, model: Any) -> None:
        super().__init__()
        self._model = model

    def forward(self, numbers: Tensor, features: Tensor) -> Tensor:
        """Return the class of each character: inside, end of a token, of a sentence, of a compound, of both."""
        model = self._model
        hidden, _ = model.rnn(torch.cat([model.embeddings(numbers), features], 1)[None])
        scores = [model.tok_clf(hidden), model.sent_clf(hidden), model.mwt_clf(hidden)]
        hidden = hidden * (1.0 - torch.sigmoid(-scores[0] * model.args["hier_invtemp"]))
        hidden, _ = model.rnn2(hidden)
        layers = (model.tok_clf2, model.sent_clf2, model.mwt_clf2)
        token, sentence, compound = (score + layer(hidden) for score, layer in zip(scores, layers))

        def log(score: Tensor) -> Tensor:
            return -torch.nn.functional.softplus(-score)

        no_sentence, no_compound = log(-sentence), log(-compound)
        classes = [
            log(-token),
            log(token) + no_sentence + no_compound,
            log(token) + log(sentence) + no_compound,
            log(token) + no_sentence + log(compound),
            log(token) + log(sentence) + log(compound),
        ]
        return torch.cat(classes, 2)[0].argmax(1)


class Cuts(nn.Module):  # type: ignore[misc]
    """Says of each character of a token whether a word begins there."""

    def __init__(self, model: Any) -> None:
        super().__init__()
        self._model = model

    def forward(self, numbers: Tensor) -> Tensor:
        """Return whether it does, of each character between the marks of start and end."""
        hidden, _ = self._model.encoder(self._model.embedding(numbers)[None])
        scores = self._model.output_layer(hidden)[0, 1:-1]
        return scores[:, 1] > scores[:, 0]


class Lemma(nn.Module):  # type: ignore[misc]
    """Spells the lemma of a word."""

    def __init__(self, model: Any, most: int) -> None:
        super().__init__()
        self._model = model
        self._most = most

    def forward(self, part_of_speech: Tensor, numbers: Tensor, copies: Tensor) -> Tuple[Tensor, Tensor]:
        """Return what to do (0: spell it, 1: keep the word, 2: lower case), and the letters, if it is spelled.

        Args:
            part_of_speech: one number
            numbers: of the letters, with the marks of start and end
            copies: row i, column j: whether letter i is letter j of the vocabulary, or of the unknown ones behind it
        """
        model = self._model
        inputs = torch.cat([model.pos_embedding(part_of_speech), model.embedding(numbers)])
        outputs, (hidden, cell) = model.encoder(inputs[None])
        # The direction that read the word backwards comes first.
        hidden, cell = (state.flip(0).reshape(1, -1) for state in (hidden, cell))
        edit = model.edit_clf(hidden)[0].argmax()
        lstm, attention = model.decoder.lstm_cell, model.decoder.attention_layer
        spelled = _SPELLED(
            edit == 0,
            self._most,
            (outputs[0], hidden, cell, copies, model.embedding.weight),
            (lstm.weight_ih, lstm.weight_hh, lstm.bias_ih + lstm.bias_hh),
            (attention.linear_in.weight, attention.linear_out.weight),
            (model.dec2vocab.weight, model.dec2vocab.bias, model.copy_gate.weight, model.copy_gate.bias),
        )
        return edit, spelled


def _spelled(
    wanted: Tensor,
    most: int,
    read: Tuple[Tensor, Tensor, Tensor, Tensor, Tensor],
    lstm: Tuple[Tensor, Tensor, Tensor],
    attention: Tuple[Tensor, Tensor],
    letters: Tuple[Tensor, Tensor, Tensor, Tensor],
) -> Tensor:
    """Return the numbers of the letters of a lemma; those above the vocabulary are the unknown ones."""
    outputs, hidden, cell, copies, embedding = read
    found = torch.zeros([0], dtype=torch.int64)
    number = torch.full([1], 2, dtype=torch.int64)
    going = wanted
    step = 0
    while bool(going) and step < most:
        known = torch.where(number >= embedding.shape[0], torch.ones_like(number), number)
        gates = embedding[known] @ lstm[0].t() + hidden @ lstm[1].t() + lstm[2]
        enter, forget, new, leave = gates.chunk(4, 1)
        cell = torch.sigmoid(forget) * cell + torch.sigmoid(enter) * torch.tanh(new)
        hidden = torch.sigmoid(leave) * torch.tanh(cell)
        scores = (outputs @ (hidden @ attention[0].t()).t()).t()
        context = torch.softmax(scores, 1) @ outputs
        output = torch.tanh(torch.cat([context, hidden], 1) @ attention[1].t())
        gate = torch.sigmoid(output @ letters[2].t() + letters[3])
        own = torch.softmax(output @ letters[0].t() + letters[1], 1)
        # A letter that the model has not learned is as likely as the unknown one.
        unknown = own[:, 1:2].expand(1, copies.shape[1] - own.shape[1])
        chances = gate * (torch.softmax(scores[:, 1:], 1) @ copies) + (1.0 - gate) * torch.cat([own, unknown], 1)
        number = chances.argmax(1)
        going = number[0] != 3
        found = torch.cat([found, number])
        step += 1
    return found


#: Its loop ends by what it finds.
_SPELLED = torch.jit.script(_spelled)


def export_words(package: Path, out: Path, *, name: str = "command") -> None:
    """Write the folder of words.

    Args:
        package: folder with ``resources.json`` and ``en/``, as Stanza lays it out
        out: is made
        name: of the package in that folder
    Raises:
        TrainingError: the models are missing, or of a form that is not known here
    """
    models = {kind: _load(package / "en" / kind / f"{name}.pt", kind) for kind in ("tokenize", "mwt", "lemma")}
    out.mkdir(parents=True, exist_ok=True)
    tokenizer, expander, lemmatizer = models["tokenize"], models["mwt"], models["lemma"]
    one, some, features = torch.tensor([1]), torch.tensor([2, 5, 6, 3]), torch.zeros(4, len(_FEATURES))
    size = lemmatizer.args["vocab_size"]
    inputs = {"numbers": some, "features": features}
    _write(Ends(tokenizer.model), inputs, out / word_folder.ENDS, ["classes"], {"numbers": [0], "features": [0]})
    _write(Cuts(expander.model), {"numbers": some}, out / word_folder.CUTS, ["cuts"], {"numbers": [0]})
    inputs = {"part_of_speech": one, "numbers": some, "copies": torch.eye(size + 1)[some]}
    lemma = Lemma(lemmatizer.model, lemmatizer.args["max_dec_len"])
    _write(lemma, inputs, out / word_folder.LEMMA, ["edit", "letters"], {"numbers": [0], "copies": [0, 1]})
    content: Dict[str, Any] = {
        "package": name,
        "longest_token": tokenizer.args["max_seqlen"],
        "text_characters": _units(tokenizer.vocab),
        "token_characters": _units(expander.vocab),
        "expansions": expander.expansion_dict,
        "letters": _units(lemmatizer.vocab["char"]),
        "parts_of_speech": _units(lemmatizer.vocab["pos"]),
        "lemmas": {kind: dict(sorted(lemmas.items())) for kind, lemmas in sorted(lemmatizer.pos_dict.items())},
    }
    text = json.dumps(content, ensure_ascii=False, indent=0)
    (out / word_folder.WORDS).write_text(text + "\n", encoding="utf-8")
    word_folder.write_manifest(out)


def _load(path: Path, kind: str) -> Any:
    """Load a model with Stanza, and check that it is of the form that is written here."""
    if not path.is_file():
        raise TrainingError(f"{path}: no such file; give the folder of a Stanza package, as 'command_models' packs it")
    from stanza.models.lemma.trainer import Trainer as Lemmatizer
    from stanza.models.mwt.trainer import Trainer as Expander
    from stanza.models.tokenization.trainer import Trainer as Tokenizer

    makers = {"tokenize": Tokenizer, "mwt": Expander, "lemma": Lemmatizer}
    trainer = makers[kind](model_file=str(path), device="cpu")
    if not _is_known(kind, trainer):
        raise TrainingError(f"{path}: a model of another form")
    trainer.model.float().eval()
    return trainer


def _is_known(kind: str, trainer: Any) -> bool:
    """Return whether a model has the form that is written here."""
    settings: Dict[str, Any] = trainer.args
    wanted: Tuple[str, ...]
    unwanted: Tuple[str, ...]
    if kind == "tokenize":
        wanted, unwanted = ("hierarchical", "use_mwt"), ("use_dictionary", "charlm_forward_file", "conv_res")
        own = settings["feat_funcs"] == _FEATURES and settings["hier_invtemp"] > 0
    elif kind == "mwt":
        wanted, unwanted = ("force_exact_pieces", "ensemble_dict"), ("dict_only",)
        own = True
    else:
        wanted, unwanted = ("ensemble_dict", "edit", "pos", "copy"), ("dict_only", "caseless", "charlm")
        own = (settings["beam_size"], settings["attn_type"], settings["num_layers"]) == (1, "soft", 1)
        own = own and not trainer.contextual_lemmatizers
    return bool(own and all(map(settings.get, wanted)) and not any(map(settings.get, unwanted)))


def _units(vocabulary: Any) -> List[str]:
    """Return the units in the order of their numbers."""
    units: List[str] = list(vocabulary._id2unit)
    if vocabulary.lower or units.index("<UNK>") != _UNKNOWN or ("<EOS>" in units and units.index("<EOS>") != _END):
        raise TrainingError("a vocabulary of another form")
    return units


def _write(model: Any, inputs: Dict[str, Tensor], path: Path, outputs: List[str], free: Dict[str, List[int]]) -> None:
    """Write a network.

    Args:
        model: with the inputs in this order
        inputs: an example of each
        path: of the file
        outputs: their names
        free: axes of inputs that have any length
    """
    with torch.inference_mode():
        torch.onnx.export(
            model,
            tuple(inputs.values()),
            str(path),
            input_names=list(inputs),
            output_names=outputs,
            dynamic_axes={name: {axis: f"{name}_{axis}" for axis in axes} for name, axes in free.items()},
            opset_version=17,
            dynamo=False,
        )
