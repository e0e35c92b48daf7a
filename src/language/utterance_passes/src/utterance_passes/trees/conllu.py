"""Reads and writes dependency trees as CoNLL-U text."""

import re
from dataclasses import replace
from typing import List, Tuple

from utterance_passes.trees.tree import Alternative, DependencyTree, Word

#: The place of a word in the text: its first character, and one past its last.
_PLACE = re.compile(r"start_char=(\d+)\|end_char=(\d+)")
#: Another governor of the word, its probability, and the relation to it.
_ALTERNATIVE = re.compile(r"alternative=(\d+):(\d\.\d+):([^|\s]+)")


def from_conllu(text: str) -> DependencyTree:
    """Read one sentence.

    Args:
        text: lines of ten columns separated by tabs (or by blanks, in tests written by hand); comments, ranges ("1-2")
            and empty nodes are skipped
    Returns:
        the tree. A comment ``# text = `` gives its text; without one, the text is the words joined by blanks. The last
        column gives the positions of characters (``start_char=0|end_char=4``); a word without them comes next in the
        text. It also gives what else the word may hang on (``alternative=3:0.21:obl``: governor, probability, relation)
    Raises:
        ValueError: a line has too few columns, or a head is not a number
    """
    words: List[Word] = []
    places: List[str] = []
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
                xpos="" if columns[4] == "_" else columns[4],
                feats="" if columns[5] == "_" else columns[5],
                head=int(columns[6]),
                deprel=columns[7],
            )
        )
        places.append(columns[9] if len(columns) > 9 else "_")
    text = sentence or " ".join(word.form for word in words)
    at = 0
    alternatives: List[Alternative] = []
    for number, (word, place) in enumerate(zip(words, places)):
        for head, probability, relation in _ALTERNATIVE.findall(place):
            alternatives.append(Alternative(word.index, int(head), relation, float(probability)))
        given = _PLACE.search(place)
        start, end = map(int, given.groups()) if given else _next_place(text, word.form, at)
        words[number] = replace(word, start_character=start, end_character=end)
        at = max(at, end)
    return DependencyTree(text=text, words=tuple(words), alternatives=tuple(alternatives))


def _next_place(text: str, form: str, at: int) -> Tuple[int, int]:
    """Return the place of a word if it comes next in the text, after blanks; an empty place if another word does."""
    start = len(text) - len(text[at:].lstrip())
    return start, start + len(form) if text.startswith(form, start) else start


def to_conllu(tree: DependencyTree) -> str:
    """Write one sentence, with its text as a comment; write the place of a word only if the text does not show it.

    What else a word may hang on is written as well.
    """
    lines = [f"# text = {tree.text}"]
    at = 0
    for word in tree.words:
        start, end = word.start_character, word.end_character
        is_told = (start, end) == _next_place(tree.text, word.form, at)
        at = max(at, end)
        last = [] if is_told else [f"start_char={start}|end_char={end}"]
        last += [
            f"alternative={one.head}:{one.probability:.2f}:{one.deprel}"
            for one in tree.alternatives
            if one.word == word.index
        ]
        lines.append(
            "\t".join(
                [
                    str(word.index),
                    word.form,
                    word.lemma,
                    word.upos,
                    word.xpos or "_",
                    word.feats or "_",
                    str(word.head),
                    word.deprel,
                    "_",
                    "|".join(last) or "_",
                ]
            )
        )
    return "\n".join(lines) + "\n"


def from_short(text: str) -> DependencyTree:
    """Read a sentence from one line, in the format of the examples of the passes.

    Args:
        text: words separated by blanks, each ``form|part of speech|head|relation``; a dictionary form and a Penn tag
            may follow: ``left|VERB|0|root|leave|VBD``; the default dictionary form is the form in lower case
    """
    words = []
    for index, item in enumerate(text.split(), start=1):
        form, upos, head, deprel, lemma, xpos, *_ = item.split("|") + ["", ""]
        words.append(Word(index, form, lemma or form.lower(), upos, xpos, "", int(head), deprel))
    return DependencyTree(text=" ".join(word.form for word in words), words=tuple(words))
