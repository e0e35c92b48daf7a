"""Finds out what a server, or a sequence of frames, would not heed of what was said."""

from typing import FrozenSet, List, Sequence, Tuple

from frame_registrar.filling import spoken_name
from roboframenet_ros.spoken_text import join_with_or
from semantic_frames.frame import ElementMapping, RelatedFrame, SemanticFrame, ValueCondition
from semantic_frames.server_profile import Purpose, ServerProfile
from typed_arguments import FilledFrame, Source, TypedArgument
from word_classes import word_class


def unheeded_arguments(profile: ServerProfile, filled: FilledFrame, frame: SemanticFrame) -> Tuple[TypedArgument, ...]:
    """Return the arguments that were said and that a server does not heed.

    A server that watches has to heed all arguments: the words of a condition may stand for one that nobody said, as
    "the battery is low" does for the level.

    Args:
        profile: what the server stated
        filled: the frame with its arguments
        frame: its file
    """
    if not profile.heeds and not profile.unheeded:
        # As in 2012: everything that the frame declares, and nothing else.
        return tuple(argument for argument in filled.arguments if frame.element(argument.name) is None)
    is_condition = profile.purpose is Purpose.WATCHES
    asked = _said(filled, frame, is_all=is_condition)
    return tuple(argument for argument in asked if not profile.heeds_argument(argument, frame))


def lost_arguments(
    sequence: Sequence[RelatedFrame], filled: FilledFrame, frame: SemanticFrame
) -> Tuple[TypedArgument, ...]:
    """Return the arguments that were said and that no member of a sequence of children gets."""
    taken = {
        relation.parent_name
        for child in sequence
        for relation in child.frame_element_relations
        if isinstance(relation, (ElementMapping, ValueCondition))
    }
    core = {element.name for element in frame.frame_elements if element.is_core}
    return tuple(
        argument
        for argument in _said(filled, frame)
        if argument.name not in taken | core and frame.element(argument.name) is not None and argument.measure is None
    )


def _said(filled: FilledFrame, frame: SemanticFrame, *, is_all: bool = False) -> List[TypedArgument]:
    """Return the arguments that were said, or all, without the robot itself, and units, which measures include."""
    units = {element.unit_element for element in frame.frame_elements}
    hearers: FrozenSet[str] = word_class("hearers")
    return [
        argument
        for argument in filled.arguments
        if (is_all or argument.source is Source.SAID)
        and argument.name not in units
        and argument.text.lower() not in hearers
    ]


def sentence_about(argument: TypedArgument, frame: SemanticFrame, profiles: Sequence[ServerProfile]) -> str:
    """Say that no server heeds an argument, and what they heed of its element.

    Args:
        argument: the argument
        frame: the frame that is to be carried out
        profiles: of its servers
    """
    said = argument.words or f"{argument.relation.replace('_', ' ')} {argument.text}".strip()
    if frame.element(argument.name) is None:
        return f'I can do that, but not "{said}".'
    stated = [heeded for profile in profiles for heeded in profile.heeded(argument.name, frame)]
    relations = tuple(dict.fromkeys(relation.replace("_", " ") for one in stated for relation in one.relations))
    values = tuple(dict.fromkeys(value for one in stated for value in one.values))
    allowed = f"{join_with_or(relations)} something" if relations else join_with_or(values) if values else ""
    only = f", only {allowed}" if allowed else ""
    return f'The {spoken_name(argument.name)} cannot be "{said}"{only}.'
