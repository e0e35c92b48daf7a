"""The joint model as a runtime: words and lemmas, tags and dependencies, all in ONNX Runtime."""

from pathlib import Path
from typing import Optional, Sequence, Tuple

from stanford_parser_ros.inference import JOINT, WARM_UP, check_is_folder
from stanford_parser_ros.joint.network import JointNetwork, alternatives_of
from stanford_parser_ros.words.words import FOLDER, Words
from utterance_passes.trees.tree import DependencyTree, Word
from utterance_passes.trees.vocabulary import NamedWord


class JointInference:
    """The answers of the joint model. Tags do not change its trees: it finds both at once."""

    def __init__(
        self, *, model_dir: Path, package: str = "default", joint_dir: Optional[Path] = None, threads: int = 1
    ) -> None:
        """
        Args:
            model_dir: folder with ``joint`` and ``words`` in it
            package: name of the Stanza package of which the words have to be; ``default`` is any
            joint_dir: folder of the joint model; by default ``joint`` in that folder
            threads: of ONNX Runtime
        Raises:
            ModelError: the models are missing or others than were packed, or ONNX Runtime is not installed
        """
        check_is_folder(model_dir)
        self._words = Words(model_dir / FOLDER, package=package)
        self._network = JointNetwork(joint_dir or model_dir / JOINT, threads=threads)
        self.parse(WARM_UP)

    def parse(self, text: str) -> DependencyTree:
        """See :meth:`stanford_parser_ros.inference.Inference.parse`."""
        forms, spans = self._words.split(text)
        return self._tree(text, forms, spans)

    def _tree(
        self, text: str, forms: Sequence[str], spans: Sequence[Tuple[int, int]], named: Sequence[NamedWord] = ()
    ) -> DependencyTree:
        found = self._network.analyse(forms, named)
        lemmas = self._words.lemmas(forms, found.upos)
        words = tuple(
            Word(
                index=number + 1,
                form=form,
                lemma=form if lemmas[number] == "_" else lemmas[number],
                upos=found.upos[number],
                xpos="" if found.xpos[number] == "_" else found.xpos[number],
                feats="" if found.feats[number] == "_" else found.feats[number],
                head=found.heads[number],
                deprel=found.relations[number],
                start_character=spans[number][0],
                end_character=spans[number][1],
            )
            for number, form in enumerate(forms)
        )
        return DependencyTree(text=text, words=words, alternatives=alternatives_of(found))

    def with_named_words(self, tree: DependencyTree, named: Sequence[NamedWord]) -> DependencyTree:
        """See :meth:`stanford_parser_ros.inference.Inference.with_named_words`."""
        spans = [(word.start_character, word.end_character) for word in tree.words]
        return self._tree(tree.text, [word.form for word in tree.words], spans, named)


def described(tree: DependencyTree, least: float = 0.05) -> Tuple[str, ...]:
    """Return a line for each word that may hang elsewhere: "stove: obl of put; or nmod of left, 17%".

    Args:
        tree: of a text
        least: probability of a governor that is told
    """
    lines = []
    for word in tree.words:
        told = [one for one in tree.alternatives if one.word == word.index and one.probability >= least]
        if told:
            others = ", ".join(f"{_hanging(tree, one.head, one.deprel)}, {one.probability:.0%}" for one in told)
            lines.append(f"{word.form}: {_hanging(tree, word.head, word.deprel)}; or {others}")
    return tuple(lines)


def _hanging(tree: DependencyTree, head: int, relation: str) -> str:
    return f"{relation} of {tree.word(head).form}" if head else relation
