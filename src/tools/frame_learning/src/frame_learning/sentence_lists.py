"""Reads the sentences of a public corpus, or of any list of sentences, without their annotations."""

from pathlib import Path
from typing import Dict, Mapping, Tuple

from frame_learning import gpsr_command
from frame_learning.annotated_commands import CorpusError
from frame_learning.corpora import CORPORA
from frame_learning.gpsr_commands import draw_commands
from frame_learning.gpsr_meaning import load_gpsr_mapping

#: Commands that are drawn from the grammars of GPSR; of each template the first is kept.
_DRAWN = 5000
LIST = "sentences"
#: What each kind of source is, by its name on the command line.
SOURCES: Mapping[str, str] = {
    **{name: corpus.title for name, corpus in CORPORA.items()},
    gpsr_command.NAME: f"{gpsr_command.TITLE}; of each template one command",
    LIST: "a file with a sentence in each line, or in the last column of a table with tabs",
}


def sentences_of(source: str, path: str) -> Tuple[str, ...]:
    """Return the different sentences of a source, in its order.

    Args:
        source: one of :data:`SOURCES`
        path: its folder; the file of a list
    Raises:
        CorpusError: it cannot be read, or has no sentence
        FileRefused: the mapping of the grammars is wrong
    """
    if source == LIST:
        found = _of_list(path)
    elif source == gpsr_command.NAME:
        found = _of_grammars(path)
    else:
        found = tuple(command.text for command in CORPORA[source].read(path))
    return tuple(dict.fromkeys(found))


def _of_list(path: str) -> Tuple[str, ...]:
    try:
        lines = Path(path).read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise CorpusError(f"{path}: no list of sentences: {error}") from error
    found = tuple(filter(None, (line.rpartition("\t")[2].strip() for line in lines)))
    if not found:
        raise CorpusError(f"{path}: no sentences; expected one in each line")
    return found


def _of_grammars(folder: str) -> Tuple[str, ...]:
    """Return a command of each template: what differs only in the words of its slots says nothing more of a rule."""
    of_template: Dict[Tuple[str, ...], str] = {}
    for command in draw_commands(folder, _DRAWN, 0, load_gpsr_mapping().slot_rules):
        template = tuple(piece.kind or piece.text.lower() for piece in command.pieces)
        of_template.setdefault(template, command.text)
    return tuple(of_template.values())
