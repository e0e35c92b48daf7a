"""The models without Stanza and torch."""

from pathlib import Path

from stanford_parser_ros.inference import CONSTITUENCY, WARM_UP, ModelError, check_model_folder, processors_of
from stanford_parser_ros.lean.dependencies import DependencyParser
from stanford_parser_ros.lean.tagger import Tagger, Tags, WordVectors
from stanford_parser_ros.lean.words import HINT, Words, load_model, model_files
from utterance_passes.tree import DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit


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
            raise ModelError(f"the lean runtime has no phrase trees, and {model_dir} holds a model of them: {HINT}")
        files = model_files(model_dir, package)
        vectors = WordVectors(load_model(files["pretrain"], dict))
        self._words = Words(files)
        self._tagger: Tagger = load_model(files["pos"], lambda saved: Tagger(saved, vectors))
        self._parser: DependencyParser = load_model(files["depparse"], lambda saved: DependencyParser(saved, vectors))
        self.parse(WARM_UP)

    def parse(self, text: str) -> DependencyTree:
        """See :meth:`stanford_parser_ros.inference.Inference.parse`."""
        forms, spans = self._words.split(text)
        tags = self._tagger.tags(forms)
        lemmas = self._words.lemmas(forms, [tag.upos for tag in tags])
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
