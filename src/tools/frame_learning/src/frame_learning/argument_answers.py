"""Writes the arguments of an understanding as a corpus does."""

from dataclasses import dataclass, replace
from typing import Dict, FrozenSet, Iterable, Iterator, List, Set, Tuple

from frame_learning.annotated_commands import AnnotatedCommand, positions_at
from frame_learning.argument_convention import AlsoCalled, Argument, ArgumentConvention
from frame_learning.corpus_mapping import CorpusMapping
from offline_pipeline.knowledge import Knowledge
from offline_pipeline.pipeline import Understanding
from semantic_framer.values.reading import Reading
from semantic_types import Fit, WordTypes
from typed_arguments import TypedArgument
from utterance_passes.trees.tree import DependencyTree
from word_classes import word_class

_HEARERS = word_class("hearers")
_ROOM = ("Room",)


@dataclass(frozen=True)
class _Part:
    """An argument, or a phrase inside it.

    Attributes:
        type: in the corpus
        head: position of the head in the tree
        positions: of all words of the phrase in the tree
        relation: of the phrase
        text: as the corpus writes it
    """

    type: str
    head: int
    positions: FrozenSet[int]
    relation: str = ""
    text: str = ""


def arguments_of(
    understanding: Understanding, command: AnnotatedCommand, mapping: CorpusMapping, knowledge: Knowledge
) -> Tuple[Argument, ...]:
    """Return the arguments of an understanding in the convention of a corpus, each once."""
    tree = understanding.tree_read or understanding.tree
    convention = mapping.arguments
    if tree is None or convention is None:
        return ()
    writer = _Writer(tree, command, mapping, convention, knowledge.types)
    found: Dict[Argument, None] = {}
    readings = understanding.readings + (understanding.descriptions if mapping.has_descriptions else ())
    task = trigger = before = ""
    for reading in readings:
        if not reading.verb_positions:
            continue  # The pattern of a question or a condition; no corpus annotates those.
        frame = knowledge.frames[reading.unit.frame_name]
        if before not in convention.joined.get(frame.name, ()):
            task, trigger = mapping.frame_name(frame), writer.trigger(reading)
        before = frame.name
        named = [(mapping.element_name(frame, value.name), value) for value in reading.arguments]
        values = [(name, value) for name, value in named if name is not None]
        for name, text in writer.written(task, trigger, reading.verb_positions[0], values):
            found[Argument(task, trigger, name, text)] = None
    return tuple(found)


class _Writer:
    """Writes the arguments of one command."""

    def __init__(
        self,
        tree: DependencyTree,
        command: AnnotatedCommand,
        mapping: CorpusMapping,
        convention: ArgumentConvention,
        types: WordTypes,
    ) -> None:
        self._tree = tree
        self._command = command
        self._mapping = mapping
        self._convention = convention
        self._types = types
        #: Text of a phrase by the text of its argument, for the pronouns that stand for it.
        self._said: Dict[str, str] = {}

    def trigger(self, reading: Reading) -> str:
        """Return the text that evokes the frame of a reading."""
        words = self._tokens(reading.verb_positions)
        tokens = self._tokens(reading.verb_positions[:1])
        behind = max(tokens, default=0) + 1
        while behind in words and self._command.tokens[behind - 1].lower() in self._convention.trigger_particles:
            tokens, behind = tokens | {behind}, behind + 1
        return self._text(tokens)

    def written(
        self, task: str, trigger: str, verb: int, values: Iterable[Tuple[str, TypedArgument]]
    ) -> Iterator[Tuple[str, str]]:
        """Return type and text of the arguments of a task."""
        convention = self._convention
        parts = self._described(task, self._parts(task, values))
        filled = {part.type for part in parts}
        if convention.performer and convention.performer not in filled:
            subjects = [word for word in self._tree.children(verb) if word.deprel.startswith("nsubj")]
            performers = [word for word in subjects if word.said in _HEARERS]
            yield from ((convention.performer, word.said) for word in performers[:1])
        name = convention.verb_fills.get(task, "")
        if name and name not in filled:
            yield name, trigger
        taken: Set[str] = set()
        for part in parts:
            if part.type in taken and part.type in convention.second:
                part = replace(part, type=convention.second[part.type])
            taken.add(part.type)
            yield part.type, part.text
            for also in convention.also:
                first = part.text.split()[0]
                if part.type in also.types and self._is_also(also, task, part):
                    yield also.name, first if also.first_words else part.text

    def _parts(self, task: str, values: Iterable[Tuple[str, TypedArgument]]) -> List[_Part]:
        """Return the arguments and the phrases inside them in the order of the text."""
        found: List[_Part] = []
        for name, value in values:
            for member in value.members or (value,):
                if not member.positions:
                    continue
                part = self._part(name, member)
                part = replace(part, text=self._referent(member) or self._span(part))
                self._said.setdefault(member.text.lower(), part.text)
                found += [part, *self._inside(task, part, member)]
        real = [part for part in found if part.text and not self._is_side(part)]
        return sorted(real, key=lambda part: min(part.positions))

    def _part(self, name: str, value: TypedArgument) -> _Part:
        """Return the phrase of an argument; the bed is the head of "the foot of the bed"."""
        while value.complement is not None and value.lemma in self._mapping.transparent_nouns:
            value = replace(value.complement, relation=value.relation)
        head = max(value.head_position, min(value.positions))
        return _Part(name, head, frozenset(value.positions), value.relation)

    def _inside(self, task: str, part: _Part, value: TypedArgument) -> Iterator[_Part]:
        """Return the phrases that describe an argument, and those that describe them."""
        convention = self._convention
        while value.complement is not None and value.lemma in self._mapping.transparent_nouns:
            value = value.complement
        inner: List[Tuple[str, TypedArgument]] = []
        for frame in value.frames:
            for element in frame.frame_elements:
                is_place = frame.frame_name == "being_located"
                name = (
                    convention.inner_place(task, part.type) if is_place else convention.inner_phrase(task, element.name)
                )
                inner += [(name, each) for each in element.members or (element,) if name is not None]
        complement = value.complement
        place = convention.inner_place(task, part.type)
        if complement is not None and place is not None and complement.head_position not in self._kept(part):
            inner.append((place, complement))
        for name, each in inner:
            if each.positions:
                found = self._part(name, each)
                found = replace(found, text=self._span(found))
                yield found
                yield from self._inside(task, replace(found, type=part.type), each)

    def _described(self, task: str, parts: List[_Part]) -> List[_Part]:
        """Replace a pronoun by the phrase that says what it is, and this phrase by its properties."""
        for pronoun, description in self._convention.described.get(task, {}).items():
            pronouns = [part for part in parts if part.type == pronoun and self._tree.word(part.head).upos == "PRON"]
            phrases = [part for part in parts if part.type == description]
            if len(pronouns) == 1 and phrases:
                phrase = phrases[0]
                properties = [
                    child.index
                    for child in self._tree.children(phrase.head)
                    if child.deprel == "amod" and child.index in phrase.positions and child.index < phrase.head
                ]
                text = self._text(self._tokens(properties))
                rest = [part for part in parts if part not in (pronouns[0], phrase)]
                parts = [replace(phrase, type=pronoun), *([replace(phrase, text=text)] if text else []), *rest]
        return parts

    def _is_side(self, part: _Part) -> bool:
        is_place = part.type in self._convention.second or part.type in self._convention.second.values()
        return is_place and part.text in self._convention.sides

    def _referent(self, value: TypedArgument) -> str:
        """Return how the phrase that a pronoun stands for was written; empty for other phrases."""
        if self._tree.word(value.head_position).upos != "PRON":
            return ""
        return self._said.get(value.text.lower(), "")

    def _is_also(self, also: AlsoCalled, task: str, part: _Part) -> bool:
        if (also.tasks and task not in also.tasks) or (also.relations and part.relation not in also.relations):
            return False
        if part.text in also.not_texts or (also.first_words and part.text.split()[0] not in also.first_words):
            return False
        return not also.semantic_types or self._is_typed(part.head, also.semantic_types)

    def _is_typed(self, index: int, types: Tuple[str, ...]) -> bool:
        word = self._tree.word(index)
        before = self._tree.words[index - 2].said if index > 1 else ""
        forms = [f"{before} {word.said}", word.said, word.lemma.lower()]
        return self._types.of_noun(forms).fit(types) is Fit.LIKELY

    def _span(self, part: _Part) -> str:
        """Return the text of the words that the corpus marks."""
        tokens = sorted(self._tokens(self._kept(part)))
        left_out = self._mapping.words_left_out
        is_whole = part.type in self._convention.whole_texts
        while len(tokens) > 1 and not is_whole and self._command.tokens[tokens[0] - 1].lower() in left_out:
            tokens.pop(0)
        return self._text(tokens)

    def _kept(self, part: _Part) -> FrozenSet[int]:
        """Return the words of a phrase that belong to its head: those before it, and "of bread" behind it."""
        inside = self._tree.subtree(part.head) & part.positions | {part.head}
        last = part.head
        for child in self._tree.children(part.head):
            prepositions = self._tree.said_prepositions(child.index)
            is_of = child.deprel.startswith("nmod") and prepositions == ["of"] and child.index in inside
            is_name = child.index == last + 1 and child.deprel in ("flat", "nummod") and child.index in inside
            if is_name or (is_of and not self._is_typed(child.index, _ROOM)):
                last = child.index
        return frozenset(index for index in inside if index <= last)

    def _tokens(self, positions: Iterable[int]) -> FrozenSet[int]:
        words = [self._tree.word(position) for position in positions if position > 0]
        return positions_at(self._command, [(word.start_character, word.end_character) for word in words])

    def _text(self, tokens: Iterable[int]) -> str:
        return " ".join(self._command.tokens[token - 1] for token in sorted(tokens)).lower()
