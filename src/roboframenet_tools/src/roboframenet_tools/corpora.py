"""The sentences of the corpora that are read by path."""

from typing import Callable, Dict, Sequence, Tuple

from roboframenet_tools.huric_corpus import read_huric
from roboframenet_tools.scout_corpus import read_scout, without_remarks
from roboframenet_tools.tage_corpus import read_tage

#: Reads a folder into sentences.
SENTENCES: Dict[str, Callable[[str], Sequence[str]]] = {
    "huric": lambda folder: [command.text for command in read_huric(folder)],
    "tage": lambda folder: [command.text for command in read_tage(folder)],
    "scout": lambda folder: sorted({without_remarks(line) for line in read_scout(folder)}),
}


def sentences(corpus: str, folder: str) -> Tuple[str, ...]:
    """Return the sentences of a corpus.

    Raises:
        CorpusError: the folder does not hold it
    """
    return tuple(SENTENCES[corpus](folder))
