"""Answers small talk: thanks, greetings, compliments, apologies, "yes" without a question. The words are in
``small_talk.yaml``.
"""

from dataclasses import dataclass
from functools import cached_property, lru_cache
from pathlib import Path
from typing import List, Optional, Pattern, Tuple

from checked_files.marked_yaml import Reader
from checked_files.source_files import read_text
from semantic_framer.values.outcome import TALK, Refusal
from utterance_passes.asides.objections import plain
from utterance_passes.trees.formula_file import Formula, any_of, is_filler
from utterance_passes.trees.tree import DependencyTree
from word_classes import read_pattern

#: Next to this module in the source, devel and install space.
SMALL_TALK_FILE = Path(__file__).resolve().parent / "small_talk.yaml"


@dataclass(frozen=True)
class SmallTalk:
    """A kind of small talk.

    Attributes:
        name: the name in the trace
        reply: what the robot answers
        formulas: what people say
    """

    name: str
    reply: str
    formulas: Tuple[Formula, ...]

    @cached_property
    def _pattern(self) -> Pattern[str]:
        return any_of(self.formulas)

    def has(self, said: str) -> bool:
        """Whether some words, in lower case, are of this kind."""
        return self._pattern.fullmatch(said) is not None


def load_small_talk(text: str, path: str) -> Tuple[SmallTalk, ...]:
    """Read a file of small talk.

    Args:
        text: content of the file
        path: path of the file, for problems
    Returns:
        the kinds, in the order of the file
    Raises:
        FileRefused: lists every mistake in the file
    """
    reader = Reader(path)
    kinds = []
    for name_node, node in reader.free_mapping(reader.compose(text, "a mapping of small talk"), ""):
        name = reader.name(name_node, "")
        entries = reader.mapping(node, name, ("reply", "patterns"), required=("reply", "patterns"))
        formulas: List[Formula] = []
        for key, item in reader.sequence(entries["patterns"], f"{name}.patterns") if "patterns" in entries else ():
            parts = reader.mapping(item, key, ("pattern", "example"), required=("pattern", "example"))
            if len(parts) == 2:
                pattern = read_pattern(reader, parts["pattern"], f"{key}.pattern")
                formulas.append(Formula(pattern, reader.name(parts["example"], f"{key}.example")))
        kinds.append(SmallTalk(name, reader.name(entries.get("reply"), f"{name}.reply"), tuple(formulas)))
    reader.refuse_if_wrong()
    return tuple(kinds)


@lru_cache(maxsize=None)
def shipped_small_talk() -> Tuple[SmallTalk, ...]:
    """Return the kinds of ``small_talk.yaml``, read once.

    Raises:
        FileRefused: the file is wrong
    """
    return load_small_talk(read_text(str(SMALL_TALK_FILE)), str(SMALL_TALK_FILE))


def small_talk_of(tree: DependencyTree) -> Optional[SmallTalk]:
    """Return the kind of an utterance that is small talk from end to end; None for another utterance."""
    parts: List[List[str]] = [[]]
    for word in tree.words:
        if word.upos == "PUNCT":
            parts.append([])
        elif not is_filler(word.form):
            parts[-1].append(plain(word))
    said = [" ".join(part) for part in parts if part]
    found = [_kind_of(part) for part in said]
    if None not in found:
        return next((kind for kind in shipped_small_talk() if kind in found), None)
    return _kind_of(" ".join(said)) if len(said) > 1 else None


def _kind_of(said: str) -> Optional[SmallTalk]:
    return next((kind for kind in shipped_small_talk() if kind.has(said)), None)


def answer_small_talk(kind: SmallTalk) -> Refusal:
    """Return the answer to small talk: nothing is done."""
    return Refusal(TALK, kind.reply)
