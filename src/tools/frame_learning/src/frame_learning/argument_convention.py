"""Says how a corpus writes arguments: task, trigger text, type and text of each.

A corpus may mark less or more than the words of an argument: the noun without what describes it, a second argument for
the place inside a phrase ("the cup on the table"), a room twice. The file of the corpus says so; nothing is learned.
"""

from dataclasses import dataclass, field
from typing import Dict, FrozenSet, Mapping, NamedTuple, Optional, Sequence, Tuple

import yaml

from checked_files.marked_yaml import Reader
from frame_learning.annotated_commands import AnnotatedCommand

#: Stands for every task.
ALL = "all"
_NONE = "-"


class Argument(NamedTuple):
    """An argument as it is compared; all texts are in lower case."""

    task: str
    trigger: str
    type: str
    text: str


@dataclass(frozen=True)
class AlsoCalled:
    """Arguments that the corpus annotates a second time, with another type.

    Attributes:
        name: the other type
        types: types of the arguments
        tasks: their tasks; empty for all
        semantic_types: one of these is a likely type of the head
        not_texts: and the text is none of these
        relations: relations of the phrase; empty for all
        first_words: the text begins with one of these words, and only this word is annotated; empty for the whole text
    """

    name: str
    types: FrozenSet[str]
    tasks: FrozenSet[str] = frozenset()
    semantic_types: Tuple[str, ...] = ()
    not_texts: FrozenSet[str] = frozenset()
    relations: FrozenSet[str] = frozenset()
    first_words: FrozenSet[str] = frozenset()


@dataclass(frozen=True)
class ArgumentConvention:
    """How a corpus writes arguments.

    Attributes:
        trigger_particles: particles directly behind a verb that belong to its trigger text
        whole_texts: types whose text keeps the article
        inner_places: by task, the type of the place inside an argument of a type ("-": none)
        inner_phrases: by task, the type of other phrases inside an argument, by their relation ("with")
        second: the type of a further argument of a type, in the order of the text
        sides: nouns that are no places by themselves ("on the right")
        performer: type of the hearer as a subject ("can you ..."); empty if it is not annotated
        described: by task, the type whose pronoun ("this is a red bowl") is annotated as the phrase of another type;
            the properties of this phrase remain arguments of the other type
        verb_fills: by task, a type that the verb itself fills if no other words do ("mute the phone")
        also: arguments with two types
        joined: our frames whose arguments belong to the task of the frame before, if that is one of the listed frames
    """

    trigger_particles: FrozenSet[str] = frozenset()
    whole_texts: FrozenSet[str] = frozenset()
    inner_places: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    inner_phrases: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    second: Mapping[str, str] = field(default_factory=dict)
    sides: FrozenSet[str] = frozenset()
    performer: str = ""
    described: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    verb_fills: Mapping[str, str] = field(default_factory=dict)
    also: Tuple[AlsoCalled, ...] = ()
    joined: Mapping[str, FrozenSet[str]] = field(default_factory=dict)

    def inner_place(self, task: str, type_name: str) -> Optional[str]:
        """Return the type of a place inside an argument; None if the corpus does not annotate it."""
        return _of_task(self.inner_places, task, type_name)

    def inner_phrase(self, task: str, relation: str) -> Optional[str]:
        """Return the type of another phrase inside an argument; None if the corpus does not annotate it."""
        return _of_task(self.inner_phrases, task, relation)


def _of_task(names: Mapping[str, Mapping[str, str]], task: str, key: str) -> Optional[str]:
    found = names.get(task, {}).get(key) or names.get(ALL, {}).get(key)
    return None if found == _NONE else found


def annotated_arguments(command: AnnotatedCommand) -> Tuple[Argument, ...]:
    """Return the annotated arguments of a command."""

    def text(positions: Sequence[int]) -> str:
        return " ".join(command.tokens[position - 1] for position in positions).lower()

    return tuple(
        Argument(frame.name, text(sorted(frame.lexical_unit)), element.name, text(sorted(element.tokens)))
        for frame in command.frames
        for element in frame.elements
    )


def read_convention(reader: Reader, node: Optional[yaml.Node], key: str) -> Optional[ArgumentConvention]:
    """Read the section of a mapping file; mistakes are reported to the reader."""
    if node is None:
        return None
    entries = reader.mapping(node, key, list(ArgumentConvention.__dataclass_fields__))

    def texts(name: str) -> FrozenSet[str]:
        return frozenset(reader.texts(entries.get(name), f"{key}.{name}"))

    def names(name: str) -> Dict[str, str]:
        return _names(reader, entries.get(name), f"{key}.{name}")

    def by_task(name: str) -> Dict[str, Dict[str, str]]:
        pairs = reader.free_mapping(entries.get(name), f"{key}.{name}")
        return {str(task.value): _names(reader, each, f"{key}.{name}.{task.value}") for task, each in pairs}

    return ArgumentConvention(
        trigger_particles=texts("trigger_particles"),
        whole_texts=texts("whole_texts"),
        inner_places=by_task("inner_places"),
        inner_phrases=by_task("inner_phrases"),
        second=names("second"),
        sides=texts("sides"),
        performer=reader.text(entries.get("performer"), f"{key}.performer"),
        described=by_task("described"),
        verb_fills=names("verb_fills"),
        also=tuple(_also(reader, item, place) for place, item in reader.sequence(entries.get("also"), f"{key}.also")),
        joined={
            str(name.value): frozenset(reader.texts(value, f"{key}.joined.{name.value}"))
            for name, value in reader.free_mapping(entries.get("joined"), f"{key}.joined")
        },
    )


def _names(reader: Reader, node: Optional[yaml.Node], key: str) -> Dict[str, str]:
    pairs = reader.free_mapping(node, key)
    return {str(name.value): reader.name(value, f"{key}.{name.value}") for name, value in pairs}


def _also(reader: Reader, node: yaml.Node, key: str) -> AlsoCalled:
    entries = reader.mapping(node, key, list(AlsoCalled.__dataclass_fields__), required=("name", "types"))

    def texts(name: str) -> Tuple[str, ...]:
        return reader.texts(entries.get(name), f"{key}.{name}")

    return AlsoCalled(
        name=reader.name(entries.get("name"), f"{key}.name"),
        types=frozenset(texts("types")),
        tasks=frozenset(texts("tasks")),
        semantic_types=texts("semantic_types"),
        not_texts=frozenset(texts("not_texts")),
        relations=frozenset(texts("relations")),
        first_words=frozenset(texts("first_words")),
    )
