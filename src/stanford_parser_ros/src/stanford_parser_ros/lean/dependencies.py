"""Finds the head of each word, and its relation to it."""

from typing import TYPE_CHECKING, Any, List, Mapping, Sequence, Tuple

import numpy as np

from stanford_parser_ros.lean.layers import (
    Highway,
    Kept,
    Linear,
    WordCharacters,
    floats,
    log_sigmoid,
    log_softmax,
    product,
    relu,
)
from stanford_parser_ros.lean.spanning_tree import heads_of_best_tree
from stanford_parser_ros.lean.tagger import MOST_KEPT, Tags, WordVectors
from stanford_parser_ros.lean.vocabulary import ROOT, Vocabulary, simple_punctuation

if TYPE_CHECKING:
    from stanford_parser_ros.lean.layers import Floats, Weights

#: Units that every vocabulary begins with; no relation is one of them.
_PREFIX = 4


class Pairs:
    """Scores of pairs of words; there may be several at once."""

    def __init__(self, weights: "Weights", *names: str) -> None:
        """
        Args:
            weights: tensors of the model
            names: of the scorers, each with one score
        """
        self._words = Linear(weights, *(f"{name}.W1" for name in names), *(f"{name}.W2" for name in names))
        self._weights = np.stack([floats(weights, f"{name}.scorer.W_bilin.weight")[:, :, 0] for name in names])
        self._biases = np.stack([floats(weights, f"{name}.scorer.W_bilin.bias") for name in names])
        self._count = len(names)

    def __call__(self, words: "Floats") -> "Floats":
        """Return, for each scorer, row i, column j: the score of word j as the head of word i."""
        length = len(words)
        hidden = relu(self._words(words)).reshape(length, 2, self._count, -1).transpose(1, 2, 0, 3)
        ones = np.ones((*hidden.shape[:-1], 1), np.float32)
        dependents, heads = np.concatenate([hidden, ones], axis=-1)
        scores: Floats = np.einsum("snj,smj->snm", np.einsum("sni,sij->snj", dependents, self._weights), heads)
        return scores + self._biases[:, :, None]


class Relations:
    """The relation of a word to its head."""

    def __init__(self, weights: "Weights", name: str) -> None:
        """
        Args:
            weights: tensors of the model
            name: of the scorer
        """
        self._dependents = Linear(weights, f"{name}.W1")
        self._heads = Linear(weights, f"{name}.W2")
        weight = floats(weights, f"{name}.scorer.W_bilin.weight")
        self._shape = weight.shape[1:]
        self._weight = weight.reshape(weight.shape[0], -1)
        self._bias = floats(weights, f"{name}.scorer.W_bilin.bias")

    def __call__(self, words: "Floats", heads: List[int]) -> "Any":
        """Return the number of the relation of each word but the root to its head."""
        dependents = _with_one(relu(self._dependents(words[1:])))
        governors = _with_one(relu(self._heads(words)))[heads[1:]]
        matrices = product(dependents, self._weight).reshape(len(dependents), *self._shape)
        return (np.einsum("nj,njo->no", governors, matrices) + self._bias).argmax(axis=1)


def _with_one(values: "Floats") -> "Floats":
    return np.concatenate([values, np.ones((len(values), 1), np.float32)], axis=1)


class DependencyParser:
    """Stanza's graph-based dependency parser."""

    def __init__(self, saved: Mapping[str, Any], vectors: WordVectors) -> None:
        """
        Args:
            saved: content of the model file
            vectors: those that it was trained with
        Raises:
            ValueError: the model has parts that are not known here
        """
        config, weights, vocabularies = saved["config"], saved["model"], saved["vocab"]
        if (
            saved.get("model_type", "graph") != "graph"
            or config.get("charlm")
            or config.get("bert_model")
            or config.get("use_arc_embedding")
            or config.get("reversed")
            or config.get("resolve_head_constraints", True)
            or config.get("use_ufeats", True)
            or config["rec_dropout"] > 0
            or config["char_num_layers"] != 1
            or not (config.get("use_upos", True) and config.get("use_xpos", True))
            or not (config["char"] and config["pretrain"] and config["word_emb_dim"] and config["tag_emb_dim"])
            or not (config["linearization"] and config["distance"])
            or vocabularies["_key2class"]["xpos"] != "WordVocab"
        ):
            raise ValueError("a parser of another form")
        self._vectors = vectors
        self._words = Vocabulary(vocabularies["word"])
        self._characters = Vocabulary(vocabularies["char"])
        self._lemmas = Vocabulary(vocabularies["lemma"])
        self._upos = Vocabulary(vocabularies["upos"])
        self._xpos = Vocabulary(vocabularies["xpos"])
        self._relations = Vocabulary(vocabularies["deprel"])
        self._transform = Linear(weights, "trans_pretrained")
        # These two are large and sparsely read: they stay in the precision of the file.
        self._word_embedding = weights["word_emb.weight"]
        self._lemma_embedding = weights["lemma_emb.weight"]
        self._upos_embedding = floats(weights, "upos_emb.weight")
        self._xpos_embedding = floats(weights, "xpos_emb.weight")
        self._spelling = WordCharacters(weights, "charmodel", "trans_char")
        self._lstm = Highway(weights, "parserlstm", config["num_layers"])
        self._arcs = Pairs(weights, "unlabeled", "linearization", "distance")
        self._labels = Relations(weights, "deprel")
        self._kept: Kept[Tuple[str, str, str, str]] = Kept(MOST_KEPT)
        root = self._rows(vectors.root(), [ROOT], [ROOT], ([ROOT], [ROOT]), [[ROOT]])
        self._root = self._lstm.entering(root)

    def arcs(self, forms: Sequence[str], lemmas: Sequence[str], tags: Sequence[Tags]) -> List[Tuple[int, str]]:
        """Return head and relation of each word.

        Args:
            forms: the words of a sentence
            lemmas: of each; "_" is none
            tags: of each
        """
        forms = [simple_punctuation(form) for form in forms]
        keys = [(form, lemma, tag.upos, tag.xpos) for form, lemma, tag in zip(forms, lemmas, tags)]
        entering = self._kept.rows(keys, lambda places: self._lstm.entering(self._inputs([keys[n] for n in places])))
        words = self._lstm(np.concatenate([self._root, entering]))
        heads = heads_of_best_tree(self._scores(words))
        return [
            (head, self._relations.unit(int(label) + _PREFIX))
            for head, label in zip(heads[1:], self._labels(words, heads))
        ]

    def _inputs(self, words: Sequence[Tuple[str, str, str, str]]) -> "Floats":
        """Return the inputs of words: form, lemma and tags of each."""
        forms, lemmas, upos, xpos = zip(*words)
        return self._rows(
            self._vectors.rows(forms),
            self._words.numbers(forms),
            self._lemmas.numbers(lemmas),
            (self._upos.numbers(upos), self._xpos.numbers(xpos)),
            [self._characters.numbers(form) for form in forms],
        )

    def _rows(
        self,
        vectors: "Floats",
        words: List[int],
        lemmas: List[int],
        tags: Tuple[List[int], List[int]],
        characters: List[List[int]],
    ) -> "Floats":
        return np.concatenate(
            [
                self._transform(vectors),
                np.asarray(self._word_embedding[words], dtype=np.float32),
                np.asarray(self._lemma_embedding[lemmas], dtype=np.float32),
                self._upos_embedding[tags[0]] + self._xpos_embedding[tags[1]],
                self._spelling(characters),
            ],
            axis=1,
        )

    def _scores(self, words: "Floats") -> "Floats":
        """Return the logarithm of the probability that word j is the head of word i, in row i, column j."""
        arcs, order, distance = self._arcs(words)
        places = np.arange(len(words), dtype=np.float32)
        offsets = places[None, :] - places[:, None]
        arcs = arcs + log_sigmoid(order * np.sign(offsets))
        expected = np.float32(1.0) + np.logaddexp(np.float32(0.0), distance)
        arcs -= np.log((np.abs(offsets) - expected) ** 2 / np.float32(2.0) + np.float32(1.0))
        np.fill_diagonal(arcs, -np.inf)
        return log_softmax(arcs)
