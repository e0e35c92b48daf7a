"""The models without Stanza and torch."""

import json
from pathlib import Path
from typing import Any, Callable, Dict, List

from stanford_parser_ros.inference import (
    CONSTITUENCY,
    PROCESSORS,
    WARM_UP,
    ModelError,
    check_model_folder,
    processors_of,
)
from stanford_parser_ros.lean.dependencies import DependencyParser
from stanford_parser_ros.lean.lemmatizer import Lemmatizer
from stanford_parser_ros.lean.model_files import UnreadableModel, read_model_file
from stanford_parser_ros.lean.tagger import Tagger, Tags, WordVectors
from stanford_parser_ros.lean.tokenizer import Expander, Tokenizer
from utterance_passes.tree import DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit

_HINT = "set ~runtime to stanza for it"


class LeanInference:
    """The answers of one Stanza package, computed by the arithmetic of Stanza in numpy.

    It knows the kinds of models that the shipped package holds, and refuses others.
    """

    def __init__(self, *, model_dir: Path, package: str = "default") -> None:
        """
        Args:
            model_dir: folder with ``resources.json`` and ``en/``, as Stanza lays it out
            package: name of a package in that folder
        Raises:
            ModelError: the models are missing, or of another kind
        """
        check_model_folder(model_dir, package)
        if CONSTITUENCY in processors_of(model_dir).split(","):
            raise ModelError(f"the lean runtime has no phrase trees, and {model_dir} holds a model of them: {_HINT}")
        files = _files(model_dir, package)
        vectors = WordVectors(_model(files["pretrain"], dict))
        self._tokenizer: Tokenizer = _model(files["tokenize"], Tokenizer)
        self._expander: Expander = _model(files["mwt"], Expander)
        self._tagger: Tagger = _model(files["pos"], lambda saved: Tagger(saved, vectors))
        self._lemmatizer: Lemmatizer = _model(files["lemma"], Lemmatizer)
        self._parser: DependencyParser = _model(files["depparse"], lambda saved: DependencyParser(saved, vectors))
        self.parse(WARM_UP)

    def parse(self, text: str) -> DependencyTree:
        """See :meth:`stanford_parser_ros.inference.Inference.parse`."""
        forms: List[str] = []
        spans = []
        for token in self._tokenizer.tokens(text):
            words = self._expander.words(token.text) if token.is_compound else [token.text]
            at = token.start
            for form in words:
                start = at if text[at : at + len(form)] == form else token.start
                end = start + len(form) if start == at else token.end
                at = min(end, token.end)
                forms.append(form)
                spans.append((start, end))
        tags = self._tagger.tags(forms)
        lemmas = [self._lemmatizer.lemma(form, tag.upos) or "_" for form, tag in zip(forms, tags)]
        arcs = self._parser.arcs(forms, lemmas, tags)
        return DependencyTree(
            text=text,
            words=tuple(
                Word(
                    index=number,
                    form=form,
                    lemma=form if lemma == "_" else lemma,
                    upos=tag.upos,
                    xpos="" if tag.xpos == "_" else tag.xpos,
                    feats="" if tag.feats == "_" else tag.feats,
                    head=head,
                    deprel=relation,
                    start_character=start,
                    end_character=end,
                )
                for number, (form, lemma, tag, (head, relation), (start, end)) in enumerate(
                    zip(forms, lemmas, tags, arcs, spans), 1
                )
            ),
        )

    def reparse(self, tree: DependencyTree) -> DependencyTree:
        """See :meth:`stanford_parser_ros.inference.Inference.reparse`."""
        arcs = self._parser.arcs(
            [word.form for word in tree.words],
            [word.lemma or "_" for word in tree.words],
            [Tags(word.upos or "_", word.xpos or "_", word.feats or "_") for word in tree.words],
        )
        edit = TreeEdit(tree)
        for word, (head, relation) in zip(tree.words, arcs):
            edit.rehang(word.index, head, relation)
        return edit.tree()


def _files(model_dir: Path, package: str) -> Dict[str, Path]:
    """Return the file of each model of a package, and that of the word vectors.

    Raises:
        ModelError: the folder has no such package
    """
    try:
        english = json.loads((model_dir / "resources.json").read_text(encoding="utf-8"))["en"]
        names = dict(english["packages"][package])
        for processor in ("pos", "depparse"):
            for needed in english[processor][names[processor]].get("dependencies", ()):
                names[needed["model"]] = needed["package"]
        return {kind: model_dir / "en" / kind / f"{names[kind]}.pt" for kind in (*PROCESSORS.split(","), "pretrain")}
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise ModelError(f"{model_dir / 'resources.json'} names no package '{package}' ({error!r}); {_HINT}") from error


def _model(path: Path, make: Callable[[Dict[str, Any]], Any]) -> Any:
    try:
        return make(read_model_file(path))
    except (UnreadableModel, OSError) as error:
        raise ModelError(f"the lean runtime cannot load {path}: {error}; {_HINT}") from error
    except (KeyError, ValueError) as error:
        raise ModelError(f"{path} holds a model that the lean runtime does not know ({error}); {_HINT}") from error
