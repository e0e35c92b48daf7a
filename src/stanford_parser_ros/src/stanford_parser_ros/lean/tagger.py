"""Tags words: part of speech, Penn Treebank tag, features."""

from typing import TYPE_CHECKING, Any, List, Mapping, NamedTuple, Sequence

import numpy as np

from stanford_parser_ros.lean.layers import Highway, Kept, Linear, WordCharacters, floats, product, relu
from stanford_parser_ros.lean.vocabulary import EMPTY, Vocabulary, pretrained_key, simple_punctuation

if TYPE_CHECKING:
    from stanford_parser_ros.lean.layers import Floats, Weights


#: Words of which the results are kept, 10 kB each: those of some hundred different commands.
MOST_KEPT = 1024


class Tags(NamedTuple):
    """The tags of a word; "_" is none."""

    upos: str
    xpos: str
    feats: str


class WordVectors:
    """The word vectors that the tagger and the parser share."""

    def __init__(self, saved: Mapping[str, Any]) -> None:
        """
        Args:
            saved: content of the file
        """
        self._vocabulary = Vocabulary(saved["vocab"])
        self._vectors = saved["emb"]

    def rows(self, forms: Sequence[str]) -> "Floats":
        """Return the vector of each word."""
        rows = self._vectors[self._vocabulary.numbers(map(pretrained_key, forms))]
        return np.asarray(rows, dtype=np.float32)

    def root(self) -> "Floats":
        """Return the row that stands for the root."""
        return np.asarray(self._vectors[3:4], dtype=np.float32)


class Biaffine:
    """Scores of several classifiers of one word and one tag, as one matrix."""

    def __init__(self, weights: "Weights", names: Sequence[str]) -> None:
        """
        Args:
            weights: tensors of the model
            names: of the classifiers
        """
        tensors = [floats(weights, f"{name}.W_bilin.weight") for name in names]
        self.ends = np.cumsum([len(tensor) for tensor in tensors])
        whole = np.concatenate(tensors)
        outputs, self._size, parents = whole.shape
        # word, then outputs by tag
        self._weight = np.ascontiguousarray(whole.transpose(2, 1, 0)).reshape(parents, self._size * outputs)
        self._bias = np.concatenate([floats(weights, f"{name}.W_bilin.bias") for name in names])

    def by_parent(self, parents: "Floats") -> "Floats":
        """Return a matrix for each parent: of it alone, so it is computed once for all words."""
        whole = np.concatenate([parents, np.ones((len(parents), 1), np.float32)], axis=1)
        matrices: Floats = product(whole, self._weight).reshape(len(parents), self._size, len(self._bias))
        return matrices

    def scores(self, words: "Floats", matrices: "Floats", parents: "Any") -> "Floats":
        """Return the scores of each word.

        Args:
            words: a row for each
            matrices: of all parents, from :meth:`by_parent`
            parents: number of the parent of each word
        """
        result: Floats = np.einsum("ni,nio->no", words, matrices[parents, :-1])
        result += matrices[parents, -1]
        result += self._bias
        return result


class Tagger:
    """Stanza's tagger."""

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
            config.get("charlm")
            or config.get("bert_model")
            or config.get("char_bidirectional")
            or config.get("extra_tag_columns")
            or config.get("tag_column_parents")
            or config.get("share_hid")
            or config["rec_dropout"] > 0
            or config["char_num_layers"] != 1
            or not (config["char"] and config["pretrain"] and config["word_emb_dim"])
            or vocabularies["_key2class"]["xpos"] != "WordVocab"
        ):
            raise ValueError("a tagger of another form")
        self._vectors = vectors
        self._words = Vocabulary(vocabularies["word"])
        self._characters = Vocabulary(vocabularies["char"])
        self._upos = Vocabulary(vocabularies["upos"])
        self._xpos = Vocabulary(vocabularies["xpos"])
        self._feats: Mapping[str, List[str]] = vocabularies["feats"]["_id2unit"]
        self._word_embedding = weights["word_emb.weight"]
        self._transform = Linear(weights, "trans_pretrained")
        self._spelling = WordCharacters(weights, "charmodel", "trans_char")
        self._kept: Kept[str] = Kept(MOST_KEPT)
        self._lstm = Highway(weights, "taggerlstm", config["num_layers"])
        self._hidden = Linear(weights, "upos_hid", "tag_hid.xpos", "tag_hid.feats")
        sizes = [weights[f"{name}.bias"].shape[0] for name in ("upos_hid", "tag_hid.xpos")]
        self._splits = np.cumsum(sizes)
        self._upos_scores = Linear(weights, "upos_clf")
        # Only a few parts of speech exist, so what a classifier makes of each of them is computed once.
        parents = floats(weights, "upos_emb.weight")
        self._xpos_scores = Biaffine(weights, ["tag_clf.xpos"])
        self._xpos_matrices = self._xpos_scores.by_parent(parents)
        self._feats_scores = Biaffine(weights, [f"tag_clf.feats.{number}" for number in range(len(self._feats))])
        self._feats_matrices = self._feats_scores.by_parent(parents)

    def tags(self, forms: Sequence[str]) -> List[Tags]:
        """Return the tags of the words of a sentence."""
        forms = [simple_punctuation(form) for form in forms]
        outputs = self._lstm(self._kept.rows(forms, lambda places: self._entering([forms[place] for place in places])))
        for_upos, for_xpos, for_feats = np.split(relu(self._hidden(outputs)), self._splits, axis=1)
        upos = self._upos_scores(for_upos).argmax(axis=1)
        xpos = self._xpos_scores.scores(for_xpos, self._xpos_matrices, upos).argmax(axis=1)
        feats = self._feats_scores.scores(for_feats, self._feats_matrices, upos)
        starts = [0, *self._feats_scores.ends[:-1]]
        values = np.stack([feats[:, a:b].argmax(axis=1) for a, b in zip(starts, self._feats_scores.ends)], axis=1)
        return [
            Tags(self._upos.unit(u), self._xpos.unit(x), self._features(row)) for u, x, row in zip(upos, xpos, values)
        ]

    def _entering(self, forms: Sequence[str]) -> "Floats":
        """Return what the network makes of words alone."""
        return self._lstm.entering(
            np.concatenate(
                [
                    np.asarray(self._word_embedding[self._words.numbers(forms)], dtype=np.float32),
                    self._transform(self._vectors.rows(forms)),
                    self._spelling([self._characters.numbers(form) for form in forms]),
                ],
                axis=1,
            )
        )

    def _features(self, numbers: "Any") -> str:
        parts = [f"{name}={units[n]}" for (name, units), n in zip(self._feats.items(), numbers) if n != EMPTY]
        return "|".join(parts) or "_"
