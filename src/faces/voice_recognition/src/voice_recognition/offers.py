"""Finds the frame of words that were heard, and the question that offers it."""

from dataclasses import dataclass
from typing import Dict, Iterator, List, Mapping, Optional, Sequence, Tuple

from voice_recognition.spoken_language import Filler, SpokenLanguage, Template, Words
from voice_recognition.voice_words import voice_words


@dataclass(frozen=True)
class Offer:
    """A frame that the robot offers to carry out.

    Attributes:
        frame: its name
        elements: names and arguments, sorted by name
        text: the command in writing, for the pipeline: "turn left 120 degrees"
        deed: the frame in the words of the robot, "turn left 120 degrees"; empty when it has no words for it
        is_question: whether the robot answers, and does nothing else
    """

    frame: str
    elements: Tuple[Tuple[str, str], ...]
    text: str
    deed: str = ""
    is_question: bool = False

    @property
    def question(self) -> str:
        """Asks for a yes."""
        return f"Shall I {self.deed}?" if self.deed else f'I heard "{self.text}". Is that right?'

    def means_the_same(self, other: "Offer") -> bool:
        """Whether two offers are of one frame with the same arguments; case is ignored."""
        return self.frame == other.frame and _lower(self.elements) == _lower(other.elements)


def _lower(elements: Tuple[Tuple[str, str], ...]) -> Tuple[Tuple[str, str], ...]:
    return tuple((name, value.lower()) for name, value in elements)


class OfferFinder:
    """Reads words by the templates of a language."""

    def __init__(self, language: SpokenLanguage) -> None:
        self._language = language
        self._by_first: Dict[str, List[Template]] = {}
        for template in language.templates:
            first = template.parts[0]
            self._by_first.setdefault(first if isinstance(first, str) else "", []).append(template)
        self._ways: Dict[str, Dict[str, List[Tuple[Words, Filler]]]] = {}
        for name, fillers in language.classes.items():
            by_first = self._ways.setdefault(name, {})
            for filler in fillers:
                for way in filler.ways:
                    by_first.setdefault(way[0], []).append((way, filler))

    def find(self, words: Sequence[str]) -> Optional[Offer]:
        """Return the offer for some words; None when the robot cannot read them.

        Templates without slots count first: they are examples, word by word.
        """
        said = without_politeness(tuple(words))
        if not said:
            return None
        best: Optional[Tuple[int, Template, Tuple[Filler, ...]]] = None
        for template in self._by_first.get(said[0], []) + self._by_first.get("", []):
            count = len(template.slots)
            if best is not None and best[0] <= count:
                continue
            fillers = next(self._match(template, 0, said, 0), None)
            if fillers is not None:
                best = (count, template, fillers)
        return self._offer(best[1], best[2]) if best is not None else None

    def _match(self, template: Template, part_at: int, words: Words, at: int) -> Iterator[Tuple[Filler, ...]]:
        if part_at == len(template.parts):
            if at == len(words):
                yield ()
            return
        if at >= len(words):
            return
        part = template.parts[part_at]
        if isinstance(part, str):
            if words[at] == part:
                yield from self._match(template, part_at + 1, words, at + 1)
            return
        for way, filler in self._ways[part.filled_from].get(words[at], ()):
            if words[at : at + len(way)] == way:
                for rest in self._match(template, part_at + 1, words, at + len(way)):
                    yield (filler, *rest)

    def _offer(self, template: Template, fillers: Tuple[Filler, ...]) -> Offer:
        elements = {**dict(self._language.defaults.get(template.frame, ())), **dict(template.fixed)}
        written: Dict[Tuple[str, ...], str] = {}
        for slot, filler in zip(template.slots, fillers):
            elements.update(zip(slot.elements, filler.values))
            written[slot.elements] = filler.text
        deed = self._deed(template, written, elements)
        return Offer(template.frame, tuple(sorted(elements.items())), _write(template, written), deed)

    def _deed(self, said: Template, written: Mapping[Tuple[str, ...], str], elements: Mapping[str, str]) -> str:
        """Return the frame in the words of the first example that has the same elements."""
        for template in self._language.templates:
            if (
                template.frame == said.frame
                and template.begins_with_verb
                and template.elements == said.elements
                and {slot.elements for slot in template.slots} == set(written)
                and dict(template.fixed) == dict(said.fixed)
            ):
                return of_other_person(_write(template, written))
        return ""


def _write(template: Template, written: Mapping[Tuple[str, ...], str]) -> str:
    return " ".join(part if isinstance(part, str) else written[part.elements] for part in template.parts)


def of_other_person(text: str) -> str:
    """Return a command as the robot says it: "follow me" is "follow you"."""
    other = voice_words().other_person
    return " ".join(other.get(word.lower(), word) for word in text.split())


def without_politeness(words: Words) -> Words:
    """Return words without "please" and the like around them."""
    known = voice_words()
    for phrase in sorted(known.polite_before, key=len, reverse=True):
        if words[: len(phrase)] == phrase and len(words) > len(phrase):
            return without_politeness(words[len(phrase) :])
    for phrase in known.polite_after:
        if words[-len(phrase) :] == phrase and len(words) > len(phrase):
            return without_politeness(words[: -len(phrase)])
    return words
