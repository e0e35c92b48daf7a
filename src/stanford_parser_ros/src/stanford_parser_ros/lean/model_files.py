"""The model files of Stanza, read without torch.

A file is a pickle of dictionaries, lists and tensors. Only the handful of names that such a file needs is ever looked
up, so a file can hold data, and nothing that runs.
"""

import _codecs
import io
import pickle
import zipfile
from collections import OrderedDict
from pathlib import Path
from typing import Any, BinaryIO, Callable, Dict, List, Mapping, NamedTuple, Optional, Tuple

import numpy as np

#: What the older form of the files begins with.
_MAGIC = 0x1950A86A20F9469CFC6C
_ITEM_TYPES = {
    "DoubleStorage": np.dtype("<f8"),
    "FloatStorage": np.dtype("<f4"),
    "HalfStorage": np.dtype("<f2"),
    "LongStorage": np.dtype("<i8"),
    "IntStorage": np.dtype("<i4"),
}


class UnreadableModel(ValueError):
    """The file is no model file, or of a kind that cannot be read here; the message says why."""


class _Tensor(NamedTuple):
    """A view of a storage, as the file describes it: its items are read later."""

    storage: str
    item: "np.dtype[Any]"
    offset: int
    shape: Tuple[int, ...]
    strides: Tuple[int, ...]


def read_model_file(path: Path) -> Dict[str, Any]:
    """Read a model file of Stanza.

    Args:
        path: the file, in either form that torch writes
    Returns:
        what was saved; tensors are arrays of their own precision
    Raises:
        UnreadableModel: the file holds something else than data
        OSError: the file cannot be read
    """
    try:
        content = _read_archive(path) if zipfile.is_zipfile(path) else _read_stream(path)
    except (pickle.UnpicklingError, EOFError, KeyError, IndexError, ValueError, zipfile.BadZipFile) as error:
        raise UnreadableModel(f"{path} cannot be read: {error}") from error
    if not isinstance(content, dict):
        raise UnreadableModel(f"{path} holds no model")
    return content


def _read_archive(path: Path) -> Any:
    with zipfile.ZipFile(path) as archive:
        (main,) = (name for name in archive.namelist() if name.endswith("/data.pkl"))
        folder = main[: -len("data.pkl")] + "data/"
        content = _Reader(io.BytesIO(archive.read(main))).load()
        return _with_arrays(content, lambda key: archive.read(folder + key))


def _read_stream(path: Path) -> Any:
    with path.open("rb") as stream:
        if _Reader(stream).load() != _MAGIC:
            raise UnreadableModel(f"{path} is no model file")
        _Reader(stream).load()  # the version of the form
        _Reader(stream).load()  # the machine
        reader = _Reader(stream)
        content = reader.load()
        storages: Dict[str, bytes] = {}
        for key in _Reader(stream).load():
            count = int.from_bytes(stream.read(8), "little")
            storages[key] = stream.read(count * reader.items[key].itemsize)
        return _with_arrays(content, storages.__getitem__)


class _Reader(pickle.Unpickler):
    """An unpickler that knows a few names only."""

    def __init__(self, stream: BinaryIO) -> None:
        super().__init__(stream)
        self.items: Dict[str, np.dtype[Any]] = {}

    def find_class(self, module: str, name: str) -> Any:
        """Return what a name of the file stands for."""
        if module == "torch" and name in _ITEM_TYPES:
            return _ITEM_TYPES[name]
        known: Mapping[Tuple[str, str], Any] = {
            ("collections", "OrderedDict"): OrderedDict,
            ("torch._utils", "_rebuild_tensor_v2"): _rebuild,
            # The form in which protocol 2 writes bytes.
            ("_codecs", "encode"): _codecs.encode,
        }
        try:
            return known[module, name]
        except KeyError:
            raise UnreadableModel(f"it asks for {module}.{name}") from None

    def persistent_load(self, pid: Any) -> Tuple[str, "np.dtype[Any]"]:
        """Note a storage of the file."""
        kind, item, key = pid[0], pid[1], pid[2]
        if kind != "storage":
            raise UnreadableModel(f"it holds a {kind!r}")
        self.items[key] = item
        return key, item


def _rebuild(
    storage: Tuple[str, "np.dtype[Any]"],
    offset: int,
    shape: Tuple[int, ...],
    strides: Tuple[int, ...],
    *_gradient: object,
) -> _Tensor:
    return _Tensor(storage[0], storage[1], offset, tuple(shape), tuple(strides))


def _with_arrays(content: Any, read: Callable[[str], bytes], done: Optional[Dict[str, Any]] = None) -> Any:
    """Return the content with an array in the place of each tensor."""
    done = {} if done is None else done
    if isinstance(content, _Tensor):
        if content.storage not in done:
            done[content.storage] = np.frombuffer(read(content.storage), content.item)
        items = done[content.storage]
        steps = tuple(step * content.item.itemsize for step in content.strides)
        if content.offset + sum((n - 1) * s for n, s in zip(content.shape, content.strides)) >= max(1, items.size):
            raise UnreadableModel("a tensor is larger than its storage")
        return np.lib.stride_tricks.as_strided(items[content.offset :], content.shape, steps).copy()
    if isinstance(content, dict):
        return {key: _with_arrays(value, read, done) for key, value in content.items()}
    if isinstance(content, list):
        parts: List[Any] = [_with_arrays(value, read, done) for value in content]
        return parts
    return content
