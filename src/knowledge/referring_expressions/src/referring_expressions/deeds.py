"""Compares a clause with what was carried out: "the door that *you closed*", "did *you close the kitchen door*?"."""

from dataclasses import dataclass, field
from typing import Callable, FrozenSet, Iterable, List, Mapping, Sequence, Tuple

from semantic_frames.frame import SemanticFrame
from typed_arguments import EmbeddedFrame, FilledFrame, TypedArgument
from word_classes import without_determiner, word_class

_ANY = word_class("indefinite_articles")
#: The frame of descriptions that say where something is.
_BEING_LOCATED = "being_located"
#: Referents of an argument that means all of them.
_ALL = -1

#: Returns the ids of what a phrase may refer to.
IdsOf = Callable[[TypedArgument], FrozenSet[str]]


@dataclass(frozen=True)
class DeedsDone:
    """What the robot has done.

    Attributes:
        clauses: for each clause of a command that was carried out, the frames that servers have ended with success,
            the last clause last
        frames: by name
    """

    clauses: Tuple[Tuple[FilledFrame, ...], ...] = ()
    frames: Mapping[str, SemanticFrame] = field(default_factory=dict)

    def done_to(self, description: EmbeddedFrame, ids_of: IdsOf) -> FrozenSet[str]:
        """Return the ids of what a deed was done to, of which a clause tells: of the doors "that you closed".

        What was taken from several things that would all do is not known, and not among them.
        """
        done = [one for one in self.clauses if is_about(one, description, self.frames, ids_of)]
        acted_on = [argument for one in done for argument in filled(one, description.head_element)]
        return frozenset().union(*(_certain(argument, ids_of) for argument in acted_on))


def _certain(argument: TypedArgument, ids_of: IdsOf) -> FrozenSet[str]:
    """Return the ids of the things that an argument of a deed was for certain; none of one among several."""
    ids = frozenset(argument.referents) or ids_of(argument)
    return ids if len(ids) == 1 or argument.referent_count in (_ALL, len(ids)) else frozenset()


def is_deed(description: EmbeddedFrame) -> bool:
    """Whether a description tells what was done: "that you closed"."""
    return description.role == "describes" and description.frame_name not in ("", _BEING_LOCATED)


def filled(done: Sequence[FilledFrame], element: str) -> List[TypedArgument]:
    """Return what filled an element of frames that were carried out."""
    found = [one.find(element) for one in done]
    return [one for one in found if one is not None]


def is_about(
    done: Sequence[FilledFrame], asked: EmbeddedFrame, frames: Mapping[str, SemanticFrame], ids_of: IdsOf
) -> bool:
    """Whether frames that were carried out are the deed of a clause, with all elements that it names.

    Args:
        done: frames of one clause of a command
        asked: the frame of the deed; elements that are asked for, or that no words name, may be anything
        frames: by name
        ids_of: of phrases
    """
    if not is_instance([one.name for one in done], asked.frame_name, frames):
        return False
    named = [one for one in asked.frame_elements if not one.is_asked and one.positions]
    return all(_has(done, asked.frame_name, element, ids_of) for element in named)


def _has(done: Sequence[FilledFrame], frame_name: str, element: TypedArgument, ids_of: IdsOf) -> bool:
    """Whether frames that were carried out have what an element of a deed names."""
    found = filled(done, element.name)
    if not found:
        # A frame of a sequence may call it otherwise.
        found = [argument for one in done if one.name != frame_name for argument in one.arguments]
    return any(_is_same(element, one, ids_of) for one in found)


def _is_same(asked: TypedArgument, found: TypedArgument, ids_of: IdsOf) -> bool:
    if without_determiner(asked.text.lower()) == without_determiner(found.text.lower()):
        return True
    meant = frozenset(asked.referents) or ids_of(asked)
    acted_on = frozenset(found.referents) or ids_of(found)
    if meant and acted_on:
        return bool(meant & acted_on)
    is_any = asked.quantifier in _ANY or (asked.is_plural and not asked.quantifier)
    return is_any and asked.lemma.lower() == found.lemma.lower()


def is_instance(names: Iterable[str], asked: str, frames: Mapping[str, SemanticFrame]) -> bool:
    """Whether frames that were carried out are an instance of another: itself, or one of its sequences.

    Args:
        names: the frames that were carried out
        asked: the frame that is asked about
        frames: by name
    """
    return _is_covered(asked, frozenset(names), frames, frozenset())


def _is_covered(name: str, names: FrozenSet[str], frames: Mapping[str, SemanticFrame], above: FrozenSet[str]) -> bool:
    if name in names:
        return True
    frame = frames.get(name)
    if frame is None or name in above:
        return False
    return any(
        sequence and all(_is_covered(child.name, names, frames, above | {name}) for child in sequence)
        for sequence in frame.children
    )
