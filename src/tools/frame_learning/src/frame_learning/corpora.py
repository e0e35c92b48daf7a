"""The public corpora that ``rfn score`` and ``rfn learn`` know. To add one, write a reader and a mapping, and add an
entry here."""

from dataclasses import dataclass
from typing import Callable, Mapping, Tuple

from frame_learning.annotated_commands import AnnotatedCommand
from frame_learning.corpus_mapping import CorpusMapping, load_mapping, shipped_mapping
from frame_learning.huric_corpus import read_huric
from frame_learning.scout_corpus import read_scout
from frame_learning.tage_corpus import read_tage


@dataclass(frozen=True)
class PublishedFigures:
    """Published figures for a corpus, in percent; the figures are those of :class:`.metrics.Score`."""

    name: str
    fp: float
    aic_exact: float
    aic_head: float


@dataclass(frozen=True)
class Corpus:
    """A public corpus.

    Attributes:
        name: name on the command line
        title: description for people
        read: returns the commands of a folder; raises :class:`.CorpusError`
        mapping_file: maps our names to those of the corpus, in ``roboframenet_domains/corpora``; empty for a corpus
            whose commands are not annotated with frames
        published: figures that others reached
    """

    name: str
    title: str
    read: Callable[[str], Tuple[AnnotatedCommand, ...]]
    mapping_file: str = ""
    published: Tuple[PublishedFigures, ...] = ()

    @property
    def is_annotated(self) -> bool:
        """Whether its commands are annotated with frames."""
        return bool(self.mapping_file)

    def mapping(self) -> CorpusMapping:
        """Read the mapping of names.

        Raises:
            FileRefused: the mapping file is wrong
        """
        return load_mapping(shipped_mapping(self.mapping_file))


CORPORA: Mapping[str, Corpus] = {
    corpus.name: corpus
    for corpus in (
        Corpus(
            name="huric",
            title="HuRIC 2.1, the folder with its .hrc files",
            read=read_huric,
            mapping_file="huric.yaml",
            published=(PublishedFigures("GrUT 2022, fine-tuned, 10-fold", fp=92.2, aic_exact=88.4, aic_head=93.3),),
        ),
        Corpus(name="tage", title="tagE, the folder with its CSV files", read=read_tage, mapping_file="tage.yaml"),
        Corpus(name="scout", title="ARL SCOUT, the folder with its transcripts", read=read_scout),
    )
}
