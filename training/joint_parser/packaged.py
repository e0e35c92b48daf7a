"""The weights of a packaged model, from which a training goes on: what ``export`` wrote, read back by its names."""

import re
from pathlib import Path
from typing import Any, Dict, Iterator, List, Tuple

import numpy as np
from numpy.typing import NDArray

from command_models.errors import TrainingError
from joint_parser.encoder import Arrays
from stanford_parser_ros.inference import ModelError
from stanford_parser_ros.joint.model_folder import JointFiles, read_joint_folder

_OF_LAYER = frozenset("query key value out up down".split())
_MATRIX = re.compile(r"/(\w+?)(?:_(\d+))?/MatMul(_quant)?$")


def read_files(folder: Path) -> JointFiles:
    """Return the labels and pieces of a packaged model, checked by its sums.

    Raises:
        TrainingError: a file is missing or another than was packed
    """
    try:
        return read_joint_folder(folder)
    except ModelError as error:
        raise TrainingError(str(error)) from error


def read_weights(folder: Path) -> Arrays:
    """Return all weights of a packaged model by the names that the network gives them.

    Matrices of 8 bits come back with their rounding, which is far below what a training changes.

    Raises:
        TrainingError: a file is missing or another than was packed
    """
    import onnx
    from onnx import numpy_helper

    graph = onnx.load(str(read_files(folder).network)).graph
    stored = {one.name: numpy_helper.to_array(one) for one in graph.initializer}
    found: Arrays = {
        name[len("_model.") :]: values.astype(np.float32)
        for name, values in stored.items()
        if name.startswith("_model.")
    }
    looked_up = [node.input[0] for node in graph.node if node.op_type == "Gather" and node.input[1] == "numbers"]
    (pieces,) = (name for name in looked_up if stored[name].dtype == np.int8)
    found["pieces.weight"] = stored[pieces].astype(np.float32) * stored["scales"]
    for name, values in _matrices(graph, stored):
        found[f"{name}.weight"] = np.ascontiguousarray(values.T)
    for mix in ("mix_tags", "mix_arcs"):
        found[f"{mix}.weights"] = np.log(_shares(graph, stored, mix))
    return found


def _matrices(graph: Any, stored: Dict[str, Any]) -> Iterator[Tuple[str, "NDArray[np.float32]"]]:
    """Yield the matrices, each under the name of the linear layer that multiplies with it."""
    for node in graph.node:
        named = _MATRIX.match(node.name)
        if named is None or node.op_type not in ("MatMul", "MatMulInteger") or node.input[1] not in stored:
            continue
        name, layer, quantized = named.group(1), named.group(2), named.group(3)
        values = stored[node.input[1]].astype(np.float32)
        if quantized:
            base = node.input[1][: -len("_quantized")]
            values = (values - stored[f"{base}_zero_point"].astype(np.float32)) * stored[f"{base}_scale"]
        yield (f"layers.{layer or 0}.{name}" if name in _OF_LAYER else name), values


def _shares(graph: Any, stored: Dict[str, Any], mix: str) -> "NDArray[np.float32]":
    """Return the shares of the layers: the first stands alone, the others are split from one row."""
    parts: Dict[str, List[NDArray[np.float32]]] = {"Mul": [], "Split": []}
    for node in graph.node:
        if node.name.startswith(f"/{mix}/") and node.op_type in parts:
            parts[node.op_type] += [stored[one].reshape(-1) for one in node.input if one in stored]
    return np.concatenate([*parts["Mul"], *parts["Split"], np.zeros(0, np.float32)])
