"""Compares the answers to the commands of a corpus with those that are given with their maps."""

from dataclasses import dataclass
from typing import Dict, Iterable, List, Sequence, Tuple

from frame_learning.annotated_commands import AnnotatedCommand
from frame_learning.metrics import Answer, are_attached_alike, is_exact

Pairs = Sequence[Tuple[AnnotatedCommand, Answer]]


@dataclass(frozen=True)
class Attachments:
    """What maps change.

    Attributes:
        wrong: commands with a wrong attachment without maps, each with whether it is right with them
        lost: commands that are right without maps and not with them
        changed: what the maps change, for people
    """

    wrong: Tuple[Tuple[str, bool], ...]
    lost: Tuple[str, ...]
    changed: Tuple[str, ...]

    def to_json(self) -> Dict[str, object]:
        """Return the object that ``rfn score --json`` writes."""
        return {"wrong": dict(self.wrong), "lost": list(self.lost)}

    def __str__(self) -> str:
        mended = sum(is_right for _, is_right in self.wrong)
        names = ", ".join(f"{name}{' (right with its map)' if is_right else ''}" for name, is_right in self.wrong)
        counts = f"{len(self.wrong)} wrong without maps, {mended} of these right with them"
        return "\n".join(
            [
                f"attachments: {counts}; {len(self.lost)} commands lost",
                f"wrong without maps: {names or 'none'}",
                f"lost: {', '.join(self.lost) or 'none'}",
                "",
                "changed by maps:",
                *self.changed,
            ]
        )


def attachments(plain: Pairs, in_maps: Pairs) -> Attachments:
    """Compare answers without and with maps; both in the order of the corpus."""
    wrong: List[Tuple[str, bool]] = []
    lost: List[str] = []
    changed: List[str] = []
    for (command, before), (_, after) in zip(plain, in_maps):
        if not are_attached_alike(command, before):
            wrong.append((command.name, are_attached_alike(command, after)))
        if is_exact(command, before) and not is_exact(command, after):
            lost.append(command.name)
        if before.frames != after.frames:
            changed.append(compared(command, after).rstrip())
    return Attachments(tuple(wrong), tuple(lost), tuple(changed))


def compared(command: AnnotatedCommand, given: Answer) -> str:
    """Return a command with its annotation and the answer, in lines for a person."""
    lines = [f"{command.name}: {command.text}\n"]
    for sign, frames in (("wanted", command.frames), ("got", given.frames)):
        for frame in frames:
            elements = ", ".join(
                f"{element.name}={_words(command, element.tokens)} ({_words(command, [element.head or 0])})"
                for element in sorted(frame.elements, key=lambda element: element.name)
            )
            lines.append(f"  {sign:<6} {frame.name}[{_words(command, frame.lexical_unit)}] {elements}\n")
    if not given.is_answered:
        lines.append("  not answered\n")
    return "".join(lines)


def _words(command: AnnotatedCommand, positions: Iterable[int]) -> str:
    return " ".join(command.tokens[position - 1] for position in sorted(positions) if position)
