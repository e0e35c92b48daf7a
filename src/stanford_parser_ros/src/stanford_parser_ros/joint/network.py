"""The network in ONNX Runtime, and what its scores say: tags, the best tree, and what else each word may hang on."""

from pathlib import Path
from typing import TYPE_CHECKING, Dict, List, NamedTuple, Sequence, Tuple

import numpy as np

from stanford_parser_ros.inference import ModelError
from stanford_parser_ros.joint.model_folder import read_joint_folder
from stanford_parser_ros.joint.pieces import Pieces, PieceVocabulary
from stanford_parser_ros.joint.windows import Window, windows
from stanford_parser_ros.lean.spanning_tree import heads_of_best_tree

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float32]

#: Pieces that the encoder has places for, without those of start and end.
MOST_PIECES = 254
#: Pieces that are read of one word: of a longer one, a part of an address, its beginning says enough.
LONGEST_WORD = 16
#: What is less likely is no alternative.
LEAST_PROBABILITY = 0.02
MOST_ALTERNATIVES = 5
_NEVER = -1e4


class Alternative(NamedTuple):
    """A governor of a word.

    Attributes:
        head: its position, from 1; 0 is the root
        relation: the likeliest to it
        probability: that the word hangs there, by this relation
    """

    head: int
    relation: str
    probability: float


class Analysis(NamedTuple):
    """What the network says of the words of a sentence.

    Attributes:
        upos, xpos, feats: tags of each word; "_" is none
        heads: governor of each word, from 1; 0 for the root
        relations: to the governor
        alternatives: governors of each word with their probability, the likeliest first; the chosen one is among them
    """

    upos: Tuple[str, ...]
    xpos: Tuple[str, ...]
    feats: Tuple[str, ...]
    heads: Tuple[int, ...]
    relations: Tuple[str, ...]
    alternatives: Tuple[Tuple[Alternative, ...], ...]


class JointNetwork:
    """The network; one thread uses it at a time."""

    def __init__(self, folder: Path, *, threads: int = 1) -> None:
        """
        Args:
            folder: of the joint model
            threads: of ONNX Runtime
        Raises:
            ModelError: a file is missing or another than was packed, or ONNX Runtime is not installed
        """
        files = read_joint_folder(folder)
        try:
            import onnxruntime
        except ImportError as error:
            raise ModelError(
                f"ONNX Runtime is not installed ({error}): run 'make setup' in RoboFrameNet's clone, or set "
                "~runtime to stanza"
            ) from error
        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = threads
        options.inter_op_num_threads = 1
        # An arena would keep the memory of the longest text.
        options.enable_cpu_mem_arena = False
        options.log_severity_level = 3
        try:
            self._session = onnxruntime.InferenceSession(files.network, options, providers=["CPUExecutionProvider"])
        except Exception as error:  # boundary: ONNX Runtime raises many kinds of errors for a file that it cannot read
            raise ModelError(f"ONNX Runtime cannot load {folder}: {type(error).__name__}: {error}") from error
        self._labels = files.labels
        self._root = files.labels["deprel"].index("root")
        self._vocabulary = PieceVocabulary(files.pieces)

    def analyse(self, forms: Sequence[str]) -> Analysis:
        """Analyse the words of one sentence, however long it is.

        Raises:
            ValueError: there are no words
        """
        if not forms:
            raise ValueError("a sentence without words")
        sizes = [min(LONGEST_WORD, len(self._vocabulary.of_word(form))) for form in forms]
        parts = windows(sizes, MOST_PIECES)
        scores = [self._scores(forms[part.start : part.end]) for part in parts]
        return self._analysis(len(forms), parts, scores)

    def _scores(self, forms: Sequence[str]) -> Dict[str, "Floats"]:
        pieces = self._vocabulary.of_sentence(forms, LONGEST_WORD)
        outputs = self._session.run(
            None,
            {
                "numbers": np.asarray(pieces.numbers, np.int64),
                "shapes": np.asarray(pieces.shapes, np.int64),
                "pool": pool(pieces),
            },
        )
        return dict(zip(("upos", "xpos", "feats", "arcs", "relations"), outputs))

    def _analysis(self, count: int, parts: List[Window], scores: List[Dict[str, "Floats"]]) -> Analysis:
        square = np.full((count + 1, count + 1), _NEVER)
        places: List[Tuple[int, int]] = []
        tags: Dict[str, List[str]] = {"upos": [], "xpos": [], "feats": []}
        for number, (part, said) in enumerate(zip(parts, scores)):
            rows = slice(part.first - part.start, part.last - part.start)
            arcs = said["arcs"][rows].astype(np.float64)
            own = np.arange(rows.start, rows.stop)
            arcs[own - rows.start, own + 1] = -np.inf  # no word governs itself
            arcs -= arcs.max(axis=1, keepdims=True)
            arcs -= np.log(np.exp(arcs).sum(axis=1, keepdims=True))
            square[part.first + 1 : part.last + 1, 0] = arcs[:, 0]
            square[part.first + 1 : part.last + 1, part.start + 1 : part.end + 1] = arcs[:, 1:]
            places += [(number, row) for row in range(rows.start, rows.stop)]
            for kind, found in tags.items():
                found += [self._labels[kind][n] for n in said[kind][rows].argmax(axis=1)]
        np.fill_diagonal(square, -np.inf)
        heads = heads_of_best_tree(square)[1:]
        alternatives = []
        relations = []
        for word, head in enumerate(heads):
            number, row = places[word]
            labelled = scores[number]["relations"][row]
            chosen, others = self._governors(head, square[word + 1], labelled, parts[number].start)
            relations.append(chosen.relation)
            alternatives.append(others)
        return Analysis(
            tuple(tags["upos"]),
            tuple(tags["xpos"]),
            tuple(tags["feats"]),
            tuple(heads),
            tuple(relations),
            tuple(alternatives),
        )

    def _governors(
        self, head: int, logs: "NDArray[np.float64]", relations: "Floats", start: int
    ) -> Tuple[Alternative, Tuple[Alternative, ...]]:
        """Return the chosen governor of a word, and all that are likely."""
        likely = [n for n in np.flatnonzero(logs >= np.log(LEAST_PROBABILITY)).tolist() if n != head]
        found = [self._governor(n, float(np.exp(logs[n])), relations, start) for n in (head, *likely)]
        kept = [found[0], *(one for one in found[1:] if one.probability >= LEAST_PROBABILITY)]
        return found[0], tuple(sorted(kept, key=lambda one: -one.probability)[:MOST_ALTERNATIVES])

    def _governor(self, head: int, probability: float, relations: "Floats", start: int) -> Alternative:
        if head == 0:
            return Alternative(0, "root", probability)
        column = head - start
        if not 0 < column < len(relations):
            # A tree needs some governor; this one is in no window with the word.
            return Alternative(head, "parataxis", 0.0)
        scores = relations[column].astype(np.float64)
        scores[self._root] = -np.inf
        shares = np.exp(scores - scores.max())
        best = int(shares.argmax())
        return Alternative(head, self._labels["deprel"][best], probability * float(shares[best] / shares.sum()))


def pool(pieces: Pieces) -> "Floats":
    """Return the share of each piece in the root, which is the start, and in each word: the mean of its pieces."""
    shares = np.zeros((len(pieces.first) + 1, len(pieces.numbers)), np.float32)
    shares[0, 0] = 1.0
    ends = [*pieces.first[1:], len(pieces.numbers) - 1]
    for row, (start, end) in enumerate(zip(pieces.first, ends), 1):
        shares[row, start:end] = 1.0 / (end - start)
    return shares
