"""Dependency trees as CoNLL-U text."""

from typing import List

from utterance_passes.tree import DependencyTree, Word


def from_conllu(text: str) -> DependencyTree:
    """Read one sentence.

    Args:
        text: lines of ten columns divided by tabs (or by blanks, for tests written by hand); comments, ranges ("1-2")
            and empty nodes are skipped
    Returns:
        the tree; its text is the words joined by blanks unless a comment ``# text = `` gives it
    Raises:
        ValueError: a line with too few columns, or a head that is no number
    """
    words: List[Word] = []
    sentence = ""
    for number, line in enumerate(text.splitlines(), start=1):
        line = line.strip()
        if line.startswith("# text = "):
            sentence = line[len("# text = ") :]
        if not line or line.startswith("#"):
            continue
        columns = line.split("\t") if "\t" in line else line.split()
        if len(columns) < 8:
            raise ValueError(f"line {number}: expected at least 8 columns, found {len(columns)}")
        if not columns[0].isdigit():
            continue
        words.append(
            Word(
                index=int(columns[0]),
                form=columns[1],
                lemma=columns[2],
                upos=columns[3],
                xpos=columns[4],
                feats="" if columns[5] == "_" else columns[5],
                head=int(columns[6]),
                deprel=columns[7],
            )
        )
    return DependencyTree(text=sentence or " ".join(word.form for word in words), words=tuple(words))


def to_conllu(tree: DependencyTree) -> str:
    """Write one sentence, with its text as a comment."""
    lines = [f"# text = {tree.text}"]
    for word in tree.words:
        lines.append(
            "\t".join(
                [
                    str(word.index),
                    word.form,
                    word.lemma,
                    word.upos,
                    word.xpos,
                    word.feats or "_",
                    str(word.head),
                    word.deprel,
                    "_",
                    "_",
                ]
            )
        )
    return "\n".join(lines) + "\n"


def from_short(text: str) -> DependencyTree:
    """Read a sentence from one line, as the examples of the passes have it.

    Args:
        text: words divided by blanks, each ``form|part of speech|head|relation``; a dictionary form that is not the
            form in lower case, and a Penn tag, may follow: ``left|VERB|0|root|leave|VBD``
    """
    words = []
    for index, item in enumerate(text.split(), start=1):
        form, upos, head, deprel, lemma, xpos, *_ = item.split("|") + ["", ""]
        words.append(Word(index, form, lemma or form.lower(), upos, xpos, "", int(head), deprel))
    return DependencyTree(text=" ".join(word.form for word in words), words=tuple(words))
