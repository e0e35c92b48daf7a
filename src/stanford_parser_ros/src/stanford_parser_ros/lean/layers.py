"""The layers of the models, for one sequence at a time."""

from typing import TYPE_CHECKING, Callable, Dict, Generic, List, Mapping, Sequence, Tuple, TypeVar

import numpy as np

if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Floats = NDArray[np.float32]
    Weights = Mapping[str, NDArray[Any]]

Key = TypeVar("Key")


def floats(weights: "Weights", name: str) -> "Floats":
    """Return a tensor in single precision, in which Stanza computes whatever the precision of the file."""
    return np.ascontiguousarray(weights[name], dtype=np.float32)


def product(rows: "Floats", matrix: "Floats") -> "Floats":
    """Return rows @ matrix.

    The loops of numpy itself: on few rows they are several times as fast as those of a plain BLAS, which is what some
    distributions link numpy with, and they start no threads.
    """
    result: Floats = np.einsum("ij,jk->ik", rows, matrix)
    return result


def sigmoid(values: "Floats") -> "Floats":
    """Return 1 / (1 + exp(-x)), without overflow."""
    result: Floats = np.tanh(values * np.float32(0.5)) * np.float32(0.5) + np.float32(0.5)
    return result


def log_sigmoid(values: "Floats") -> "Floats":
    """Return log(sigmoid(x))."""
    result: Floats = -np.logaddexp(np.float32(0.0), -values)
    return result


def log_softmax(values: "Floats") -> "Floats":
    """Return the logarithm of softmax over the last axis."""
    shifted = values - values.max(axis=-1, keepdims=True)
    result: Floats = shifted - np.log(np.exp(shifted).sum(axis=-1, keepdims=True))
    return result


def relu(values: "Floats") -> "Floats":
    """Return max(x, 0)."""
    result: Floats = np.maximum(values, np.float32(0.0))
    return result


class Linear:
    """x W + b; of several layers with the same inputs, one matrix: their outputs lie side by side."""

    def __init__(self, weights: "Weights", *names: str) -> None:
        """
        Args:
            weights: tensors of the model
            names: of the layers; a layer without bias has no tensor ``name.bias``
        """
        matrices = [floats(weights, f"{name}.weight").T for name in names]
        self.weight = np.ascontiguousarray(np.concatenate(matrices, axis=1))
        self.bias = np.concatenate(
            [
                floats(weights, f"{name}.bias") if f"{name}.bias" in weights else np.zeros(matrix.shape[1], np.float32)
                for name, matrix in zip(names, matrices)
            ]
        )

    def __call__(self, values: "Floats") -> "Floats":
        """Return the outputs for each row."""
        result = product(values, self.weight)
        result += self.bias
        return result


class Recurrent:
    """One layer of an LSTM, in one direction or in both at once.

    The gates lie in the order of torch: input, forget, cell, output. sigmoid(x) is 0.5 tanh(0.5 x) + 0.5, so with
    halved weights one tanh does for all four gates.
    """

    def __init__(self, weights: "Weights", name: str, *, layer: int = 0) -> None:
        """
        Args:
            weights: tensors of the model
            name: of the LSTM
            layer: of it
        """
        names = [f"_l{layer}"]
        if f"{name}.weight_ih_l{layer}_reverse" in weights:
            names.append(f"_l{layer}_reverse")
        self.directions = len(names)
        self.size = weights[f"{name}.weight_hh{names[0]}"].shape[1]
        is_cell = np.zeros(4 * self.size, bool)
        is_cell[2 * self.size : 3 * self.size] = True
        half = np.where(is_cell, np.float32(1.0), np.float32(0.5))
        self._gain = half
        self._offset = np.where(is_cell, np.float32(0.0), np.float32(0.5))
        #: Inputs to gates, both directions side by side.
        self.inputs = np.ascontiguousarray(
            np.concatenate([floats(weights, f"{name}.weight_ih{each}").T * half for each in names], axis=1)
        )
        self.bias = np.concatenate(
            [(floats(weights, f"{name}.bias_ih{e}") + floats(weights, f"{name}.bias_hh{e}")) * half for e in names]
        )
        self._hidden = np.ascontiguousarray(
            np.stack([floats(weights, f"{name}.weight_hh{each}").T * half for each in names])
        )

    def gates(self, values: "Floats") -> "Floats":
        """Return what the inputs add to the gates of each step."""
        result = product(values, self.inputs)
        result += self.bias
        return result

    def __call__(self, gates: "Floats", hidden: "Floats", cell: "Floats") -> Tuple["Floats", "Floats", "Floats"]:
        """Run over a sequence.

        Args:
            gates: of each step, from :meth:`gates`
            hidden, cell: the first states, one row for each direction
        Returns:
            outputs of each step with the directions side by side, and the last states, one row for each direction
        """
        length, size, directions = len(gates), self.size, self.directions
        steps = gates.reshape(length, directions, 4 * size)
        if directions == 2:
            steps = np.stack([steps[:, 0], steps[::-1, 1]], axis=1)
        outputs = np.empty((length, directions, size), np.float32)
        gain, offset, weight = self._gain, self._offset, self._hidden
        state = hidden.reshape(directions, size)
        cell = cell.reshape(directions, size)
        for step in range(length):
            values = np.einsum("dj,djk->dk", state, weight)
            values += steps[step]
            np.tanh(values, out=values)
            values *= gain
            values += offset
            cell = values[:, size : 2 * size] * cell
            cell += values[:, :size] * values[:, 2 * size : 3 * size]
            out = outputs[step]
            np.tanh(cell, out=out)
            out *= values[:, 3 * size :]
            state = out
        last = outputs[-1].copy() if length else hidden
        if directions == 2:
            outputs[:, 1] = outputs[::-1, 1].copy()
        return outputs.reshape(length, directions * size), last, cell

    def from_rest(self, values: "Floats") -> Tuple["Floats", "Floats", "Floats"]:
        """Run over a sequence of inputs from states that are zero."""
        rest = np.zeros((self.directions, self.size), np.float32)
        return self(self.gates(values), rest, rest)


class Highway:
    """Layers of an LSTM in both directions, each with a gated way around it."""

    def __init__(self, weights: "Weights", name: str, layers: int) -> None:
        """
        Args:
            weights: tensors of the model
            name: of the layers; the first states are ``name_h_init`` and ``name_c_init``
            layers: number of them
        """
        self._layers = [Recurrent(weights, f"{name}.lstm.{layer}.lstm") for layer in range(layers)]
        #: Of each layer: inputs to gates, gate of the way around it, and the way around it, as one matrix.
        self._inputs: List[Tuple[Floats, Floats]] = []
        for number, layer in enumerate(self._layers):
            around = Linear(weights, f"{name}.gate.{number}", f"{name}.highway.{number}")
            matrix = np.ascontiguousarray(np.concatenate([layer.inputs, around.weight], axis=1))
            self._inputs.append((matrix, np.concatenate([layer.bias, around.bias])))
        self._hidden = floats(weights, f"{name}_h_init")[:, 0]
        self._cell = floats(weights, f"{name}_c_init")[:, 0]

    def entering(self, values: "Floats") -> "Floats":
        """Return what the first layer computes of each step alone; the same inputs give the same."""
        return self._entering(0, values)

    def _entering(self, number: int, values: "Floats") -> "Floats":
        matrix, bias = self._inputs[number]
        result = product(values, matrix)
        result += bias
        return result

    def __call__(self, entering: "Floats") -> "Floats":
        """Return the outputs of the last layer.

        Args:
            entering: of each step, from :meth:`entering`
        """
        for number, layer in enumerate(self._layers):
            if number:
                entering = self._entering(number, entering)
            rows = slice(2 * number, 2 * number + 2)
            width = layer.inputs.shape[1]
            size = (entering.shape[1] - width) // 2
            outputs, _, _ = layer(entering[:, :width], self._hidden[rows], self._cell[rows])
            outputs += sigmoid(entering[:, width : width + size]) * np.tanh(entering[:, width + size :])
            entering = outputs
        return entering


class Kept(Generic[Key]):
    """Rows that are computed once; all are forgotten when there are too many."""

    def __init__(self, most: int) -> None:
        """
        Args:
            most: number of rows
        """
        self._most = most
        self._rows: Dict[Key, Floats] = {}

    def rows(self, keys: Sequence[Key], compute: Callable[[List[int]], "Floats"]) -> "Floats":
        """Return a row for each key.

        Args:
            keys: what a row depends on
            compute: returns the rows of the keys at these places
        """
        if len(self._rows) + len(keys) > self._most:
            self._rows.clear()
        missing = {key: place for place, key in enumerate(keys) if key not in self._rows}
        if missing:
            self._rows.update(zip(missing, compute(list(missing.values()))))
        return np.stack([self._rows[key] for key in keys])


class WordCharacters:
    """What the characters of a word say about it: an LSTM over them, and a weight for each. The same for each place."""

    def __init__(self, weights: "Weights", name: str, transform: str) -> None:
        """
        Args:
            weights: tensors of the model
            name: of the character model
            transform: name of the layer behind it
        """
        self._embedding = floats(weights, f"{name}.char_emb.weight")
        self._lstm = Recurrent(weights, f"{name}.charlstm.lstm")
        self._hidden = floats(weights, f"{name}.charlstm_h_init")[:, 0]
        self._cell = floats(weights, f"{name}.charlstm_c_init")[:, 0]
        self._attention = floats(weights, f"{name}.char_attn.weight")[0]
        self._transform = Linear(weights, transform)

    def __call__(self, words: Sequence[List[int]]) -> "Floats":
        """Return a row for each word.

        Args:
            words: numbers of their characters in the vocabulary
        """
        rows = []
        for characters in words:
            outputs, _, _ = self._lstm(self._lstm.gates(self._embedding[characters]), self._hidden, self._cell)
            weights = sigmoid(np.einsum("ij,j->i", outputs, self._attention))
            rows.append(np.einsum("i,ij->j", weights, outputs))
        return self._transform(np.stack(rows))
