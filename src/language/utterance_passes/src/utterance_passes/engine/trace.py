"""Records what the rules did, in order: each rule that changed or settled something in the run that decided."""

from dataclasses import dataclass, replace
from typing import FrozenSet, Iterable, List, Tuple

from utterance_passes.trees.tree import DependencyTree, Word


@dataclass(frozen=True)
class TraceLine:
    """One thing that a rule did.

    Attributes:
        rule: name of the pass, the verdict or the step
        positions: positions of the words that the line is about, from 1; empty if it is not about single words
        about: these words, or another subject of the line ("take -> taking(theme=a right)")
        before: the state before the rule, "nmod:poss(lunch)"; empty if there was nothing before
        after: the state after the rule
    """

    rule: str
    positions: Tuple[int, ...]
    about: str
    before: str
    after: str

    @property
    def what(self) -> str:
        """The line without the name of the rule."""
        change = f"{self.before} -> {self.after}" if self.before else self.after
        return f"{self.about}: {change}" if self.about else change

    def __str__(self) -> str:
        return f"{self.rule}: {self.what}"


class Trace:
    """A list of lines, in the order in which they were written."""

    def __init__(self, lines: Iterable[TraceLine] = ()) -> None:
        self._lines: List[TraceLine] = list(lines)

    @property
    def lines(self) -> Tuple[TraceLine, ...]:
        """The lines so far."""
        return tuple(self._lines)

    def add(self, rule: str, about: str = "", before: str = "", after: str = "", positions: Iterable[int] = ()) -> None:
        """Write a line."""
        self._lines.append(TraceLine(rule, tuple(sorted(positions)), about, before, after))

    def extend(self, lines: Iterable[TraceLine]) -> None:
        """Add the lines of another trace."""
        self._lines += lines

    def add_changes(self, rule: str, before: DependencyTree, after: DependencyTree) -> None:
        """Write a line for each word that differs, and for each new mark."""
        self._lines += changes(rule, before, after)

    def __str__(self) -> str:
        return "\n".join(map(str, self._lines))

    @property
    def rules(self) -> FrozenSet[str]:
        """Names of the rules that wrote something."""
        return frozenset(line.rule for line in self._lines)


def moved(lines: Iterable[TraceLine], part: DependencyTree, whole: DependencyTree) -> List[TraceLine]:
    """Return the lines on a part of a sentence, with the positions of its words in the whole sentence.

    Args:
        lines: lines with positions in the part
        part: the tree of the part
        whole: the tree of the sentence; every word of the part begins at the same character in it
    """
    places = {word.start_character: word.index for word in whole.words}
    positions = {word.index: places.get(word.start_character, 0) for word in part.words}
    return [
        replace(line, positions=tuple(sorted(positions[index] for index in line.positions if positions.get(index))))
        for line in lines
    ]


def changes(rule: str, before: DependencyTree, after: DependencyTree) -> List[TraceLine]:
    """Return the changes that a rule made to a sentence, word by word."""
    if before is after:
        return []
    found = []
    for old, new in zip(before.words, after.words):
        if old == new:
            continue
        parts = [(_tag(old), _tag(new)), (old.form, new.form)]
        if (old.head, old.deprel) != (new.head, new.deprel):
            parts.insert(0, (_arc(before, old), _arc(after, new)))
        different = [(one, other) for one, other in parts if one != other]
        if different:
            was, has_become = (" ".join(side) for side in zip(*different))
            found.append(TraceLine(rule, (new.index,), old.form, was, has_become))
    for time in after.times:
        if time not in before.times:
            found.append(TraceLine(rule, tuple(sorted(time)), after.text_of(time), "", "says when"))
    for _, heads in after.clusters[len(before.clusters) :]:
        words = sorted(frozenset().union(*map(after.subtree, heads)))
        found.append(TraceLine(rule, tuple(words), after.text_of(words), "", "a clause of its own"))
    return found


def _arc(tree: DependencyTree, word: Word) -> str:
    if not word.head:
        return word.deprel
    head = tree.governor(word)
    is_alone = sum(1 for other in tree.words if other.said == head.said) == 1
    return f"{word.deprel}({head.form if is_alone else f'{head.form}-{head.index}'})"


def _tag(word: Word) -> str:
    return f"{word.upos}/{word.lemma}"
