"""Sentences in CoNLL-U: reading, writing, and checks that a sentence is a tree."""

from dataclasses import dataclass
from pathlib import Path
from typing import Dict, Iterable, Iterator, List, Tuple

from .errors import TrainingError

COLUMNS = 10


@dataclass(frozen=True)
class Word:
    """One syntactic word of a sentence.

    ``head`` is the 1-based place of the governor in the sentence, 0 for the root.
    """

    form: str
    lemma: str
    upos: str
    xpos: str
    feats: str
    head: int
    deprel: str
    misc: str = "_"


@dataclass(frozen=True)
class Span:
    """A multi-word token: the words ``first`` to ``last`` (1-based) are written together as ``form``."""

    first: int
    last: int
    form: str
    misc: str = "_"


@dataclass(frozen=True)
class Sentence:
    """Words of one sentence with its multi-word tokens and its comments (without ``#``)."""

    words: Tuple[Word, ...]
    spans: Tuple[Span, ...] = ()
    comments: Tuple[str, ...] = ()

    def comment(self, key: str) -> str:
        """Return the value of the comment ``key = value``; empty if there is none."""
        for line in self.comments:
            name, found, value = line.partition("=")
            if found and name.strip() == key:
                return value.strip()
        return ""

    def text(self) -> str:
        """The running text of the sentence, from the forms and SpaceAfter."""
        pieces: List[str] = []
        covered = 0
        starts: Dict[int, Span] = {span.first: span for span in self.spans}
        for place, word in enumerate(self.words, 1):
            if place <= covered:
                continue
            span = starts.get(place)
            form, misc = (span.form, span.misc) if span else (word.form, word.misc)
            covered = span.last if span else place
            pieces.append(form if "SpaceAfter=No" in misc else form + " ")
        return "".join(pieces).strip()


def problems(sentence: Sentence) -> List[str]:
    """Return what is wrong with the tree of a sentence; an empty list for a tree.

    Checked: one root, heads in range, no word its own ancestor, `root` exactly where the head is 0,
    multi-word tokens in order and inside the sentence.
    """
    found: List[str] = []
    count = len(sentence.words)
    roots = [place for place, word in enumerate(sentence.words, 1) if word.head == 0]
    if len(roots) != 1:
        found.append(f"expected one root, found {len(roots)}")
    for place, word in enumerate(sentence.words, 1):
        if not 0 <= word.head <= count:
            found.append(f"word {place}: head {word.head} is outside 0..{count}")
        if (word.head == 0) != (word.deprel == "root"):
            found.append(f"word {place}: head {word.head} does not fit relation {word.deprel}")
        if not word.form or " " in word.form or not word.upos or not word.xpos:
            found.append(f"word {place}: empty or spaced column")
    if found:
        return found
    for place in range(1, count + 1):
        seen = set()
        at = place
        while at:
            if at in seen:
                found.append(f"word {place}: its governors run in a circle")
                break
            seen.add(at)
            at = sentence.words[at - 1].head
    end = 0
    for span in sentence.spans:
        if not end < span.first < span.last <= count:
            found.append(f"token {span.first}-{span.last} is out of order or out of range")
        end = span.last
    return found


def render(sentence: Sentence) -> str:
    """Return a sentence as CoNLL-U, with the blank line that ends it."""
    lines = ["# " + comment for comment in sentence.comments]
    starts = {span.first: span for span in sentence.spans}
    for place, word in enumerate(sentence.words, 1):
        span = starts.get(place)
        if span:
            lines.append("\t".join([f"{span.first}-{span.last}", span.form] + ["_"] * 7 + [span.misc]))
        lines.append(
            "\t".join(
                [
                    str(place),
                    word.form,
                    word.lemma,
                    word.upos,
                    word.xpos,
                    word.feats or "_",
                    str(word.head),
                    word.deprel,
                    "_",
                    word.misc,
                ]
            )
        )
    return "\n".join(lines) + "\n\n"


def write(path: Path, sentences: Iterable[Sentence]) -> int:
    """Write sentences to a CoNLL-U file; return their number."""
    count = 0
    with path.open("w", encoding="utf-8") as stream:
        for sentence in sentences:
            stream.write(render(sentence))
            count += 1
    return count


def read(path: Path) -> Iterator[Sentence]:
    """Read the sentences of a CoNLL-U file; leave out empty nodes (``8.1``).

    Raises TrainingError with file and line when a row has not ten columns or no number.
    """
    if not path.is_file():
        raise TrainingError(f"{path}: no such file; expected a CoNLL-U treebank there")
    words: List[Word] = []
    spans: List[Span] = []
    comments: List[str] = []
    with path.open(encoding="utf-8") as stream:
        for number, raw in enumerate(stream, 1):
            line = raw.rstrip("\n")
            if line.startswith("#"):
                comments.append(line[1:].strip())
                continue
            if not line:
                if words:
                    yield Sentence(tuple(words), tuple(spans), tuple(comments))
                words, spans, comments = [], [], []
                continue
            cells = line.split("\t")
            if len(cells) != COLUMNS:
                raise TrainingError(
                    f"{path}, line {number}: expected {COLUMNS} columns, found {len(cells)}; is this CoNLL-U?"
                )
            if "." in cells[0]:
                continue
            try:
                if "-" in cells[0]:
                    first, last = cells[0].split("-")
                    spans.append(Span(int(first), int(last), cells[1], cells[9]))
                    continue
                words.append(Word(cells[1], cells[2], cells[3], cells[4], cells[5], int(cells[6]), cells[7], cells[9]))
            except ValueError:
                raise TrainingError(f"{path}, line {number}: expected numbers in columns 1 and 7") from None
    if words:
        yield Sentence(tuple(words), tuple(spans), tuple(comments))
