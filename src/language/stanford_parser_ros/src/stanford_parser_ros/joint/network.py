"""The network in ONNX Runtime, and what its scores say: tags, the best tree, and what else each word may hang on."""

from pathlib import Path
from typing import TYPE_CHECKING, Dict, List, Mapping, NamedTuple, Sequence, Tuple

import numpy as np

from stanford_parser_ros.joint.lexicon_hints import masked
from stanford_parser_ros.joint.model_folder import read_joint_folder
from stanford_parser_ros.joint.pieces import Pieces, PieceVocabulary
from stanford_parser_ros.joint.spanning_tree import heads_of_best_tree
from stanford_parser_ros.joint.windows import Window, windows
from stanford_parser_ros.onnx_session import onnx_session
from utterance_passes.trees.tree import Alternative
from utterance_passes.trees.vocabulary import NamedWord

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
#: To a governor that no window holds together with the word.
UNKNOWN_RELATION = "obl"
#: Relation of words that a speaker takes back, in Universal Dependencies.
TAKEN_BACK = "reparandum"
_NEVER = -1e4
#: By how much the score of a governor falls that a word has only as one that is taken back.
_UNLIKELY = 20.0


class Governor(NamedTuple):
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
        governors: of each word, with their probability: the chosen one, then others, likeliest first
    """

    upos: Tuple[str, ...]
    xpos: Tuple[str, ...]
    feats: Tuple[str, ...]
    heads: Tuple[int, ...]
    relations: Tuple[str, ...]
    governors: Tuple[Tuple[Governor, ...], ...]


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
        self._session = onnx_session(files.network, threads=threads)
        self._labels = files.labels
        self._root = files.labels["deprel"].index("root")
        self._unknown = np.zeros(len(files.labels["deprel"]), np.float32)
        self._unknown[files.labels["deprel"].index(UNKNOWN_RELATION)] = 100.0
        # What a speaker takes back is for the framer to decide, which asks where it is not certain.
        self._not_read = [
            number for number, label in enumerate(files.labels["deprel"]) if label in ("root", TAKEN_BACK)
        ]
        self._vocabulary = PieceVocabulary(files.pieces)

    def analyse(self, forms: Sequence[str], named: Sequence[NamedWord] = ()) -> Analysis:
        """Analyse the words of one sentence, however long it is.

        Args:
            forms: its words
            named: words that lexical units name; see :mod:`stanford_parser_ros.joint.lexicon_hints`
        Raises:
            ValueError: there are no words
        """
        if not forms:
            raise ValueError("a sentence without words")
        sizes = [min(LONGEST_WORD, len(self._vocabulary.of_word(form))) for form in forms]
        parts = windows(sizes, MOST_PIECES)
        scores = [self._scores(forms[part.start : part.end]) for part in parts]
        return self._analysis(len(forms), parts, scores, named)

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

    def _analysis(
        self,
        count: int,
        parts: List[Window],
        scores: List[Dict[str, "Floats"]],
        named: Sequence[NamedWord],
    ) -> Analysis:
        square = np.full((count + 1, count + 1), _NEVER)
        places: List[Tuple[int, int]] = []
        tags: Dict[str, List[str]] = {"upos": [], "xpos": [], "feats": []}
        for number, (part, said) in enumerate(zip(parts, scores)):
            rows = slice(part.first - part.start, part.last - part.start)
            arcs = said["arcs"][rows].astype(np.float64)
            own = np.arange(rows.start, rows.stop)
            arcs[own - rows.start, own + 1] = -np.inf  # no word governs itself
            arcs -= _UNLIKELY * self._taken_back(said["relations"][rows])
            arcs -= arcs.max(axis=1, keepdims=True)
            arcs -= np.log(np.exp(arcs).sum(axis=1, keepdims=True))
            square[part.first + 1 : part.last + 1, 0] = arcs[:, 0]
            square[part.first + 1 : part.last + 1, part.start + 1 : part.end + 1] = arcs[:, 1:]
            places += [(number, row) for row in range(rows.start, rows.stop)]
            for kind, found in tags.items():
                found += [self._labels[kind][n] for n in said[kind][rows].argmax(axis=1)]
        np.fill_diagonal(square, -np.inf)
        given = masked(square, named)
        heads = heads_of_best_tree(given.logs)[1:]
        for position, (upos, xpos) in given.tags.items():
            tags["upos"][position - 1], tags["xpos"][position - 1], tags["feats"][position - 1] = upos, xpos, "_"
        governors = self._governors(heads, given.relations, square[1:], parts, places, scores)
        relations = tuple(
            next(one.relation for one in likely if one.head == head) for head, likely in zip(heads, governors)
        )
        return Analysis(
            tuple(tags["upos"]),
            tuple(tags["xpos"]),
            tuple(tags["feats"]),
            tuple(heads),
            relations,
            tuple(governors),
        )

    def _taken_back(self, relations: "Floats") -> "NDArray[np.bool_]":
        """Return for which governors a word would rather be taken back than anything else."""
        best = relations.argmax(axis=2)
        taken: NDArray[np.bool_] = np.isin(best, [n for n in self._not_read if n != self._root])
        return taken

    def _governors(
        self,
        heads: Sequence[int],
        given: Mapping[int, str],
        logs: "NDArray[np.float64]",
        parts: Sequence[Window],
        places: Sequence[Tuple[int, int]],
        scores: Sequence[Dict[str, "Floats"]],
    ) -> List[Tuple[Governor, ...]]:
        """Return the governors of each word: the chosen one, then the others that are likely, the likeliest first.

        Args:
            heads: the chosen one of each word
            given: relations to the chosen ones that are not the network's, by position
            logs: row i, column j: the logarithm of the probability that word j governs word i + 1
            parts: the windows
            places: number of the window in which each word is read, and its row there
            scores: of each window
        """
        likely = logs >= np.log(LEAST_PROBABILITY)
        likely[np.arange(len(heads)), heads] = True
        words, governors = (found.tolist() for found in np.nonzero(likely))
        # A governor that is in no window with the word is there because a tree needs some; its relation is not known.
        rows = []
        for word, head in zip(words, governors):
            number, row = places[word]
            column = head - parts[number].start
            known = scores[number]["relations"]
            rows.append(known[row, column] if 0 < column < known.shape[1] else self._unknown)
        labels = np.array(rows, np.float64)
        labels[:, self._not_read] = -np.inf
        best = labels.argmax(axis=1)
        for row, (word, head) in enumerate(zip(words, governors)):
            if head == heads[word] and word + 1 in given:
                best[row] = self._labels["deprel"].index(given[word + 1])
        shares = np.exp(labels - labels[np.arange(len(best)), best][:, None]).sum(axis=1)
        is_root = np.array(governors) == 0
        best[is_root], shares[is_root] = self._root, 1.0
        chances = np.exp(logs[words, governors]) / shares
        found: List[List[Governor]] = [[] for _ in heads]
        for word, head, label, chance in zip(words, governors, best.tolist(), chances.tolist()):
            if chance >= LEAST_PROBABILITY or head == heads[word]:
                found[word].append(Governor(head, self._labels["deprel"][label], chance))
        return [
            tuple(sorted(each, key=lambda one: (one.head != head, -one.probability))[:MOST_ALTERNATIVES])
            for head, each in zip(heads, found)
        ]


def alternatives_of(found: Analysis) -> Tuple[Alternative, ...]:
    """Return what else each word may hang on, as a tree has it."""
    return tuple(
        Alternative(word, *one) for word, governors in enumerate(found.governors, start=1) for one in governors[1:]
    )


def pool(pieces: Pieces) -> "Floats":
    """Return the share of each piece in the root, which is the start, and in each word: the mean of its pieces."""
    shares = np.zeros((len(pieces.first) + 1, len(pieces.numbers)), np.float32)
    shares[0, 0] = 1.0
    ends = [*pieces.first[1:], len(pieces.numbers) - 1]
    for row, (start, end) in enumerate(zip(pieces.first, ends), 1):
        shares[row, start:end] = 1.0 / (end - start)
    return shares
