"""Moves the positions of an argument to another sentence, or removes them."""

from dataclasses import replace
from typing import Callable, Tuple

from typed_arguments.argument import EmbeddedFrame, TypedArgument

Move = Callable[[int], int]


def with_moved_positions(argument: TypedArgument, move: Move) -> TypedArgument:
    """Return an argument, with all its parts, whose words have other positions.

    Args:
        argument: the argument
        move: returns the new position of a word, from 1, in the same order; 0 if the sentence does not have the word
    """
    possessor, complement = argument.possessor, argument.complement
    return replace(
        argument,
        positions=_moved(argument.positions, move),
        head_position=move(argument.head_position) if argument.head_position else 0,
        modifiers=tuple(replace(one, position=move(one.position) if one.position else 0) for one in argument.modifiers),
        possessor=None if possessor is None else with_moved_positions(possessor, move),
        complement=None if complement is None else with_moved_positions(complement, move),
        members=tuple(with_moved_positions(one, move) for one in argument.members),
        exceptions=tuple(with_moved_positions(one, move) for one in argument.exceptions),
        frames=tuple(_with_moved_positions(one, move) for one in argument.frames),
    )


def without_any_position(argument: TypedArgument) -> TypedArgument:
    """Return an argument without positions, for a sentence that does not have its words."""
    return with_moved_positions(argument, lambda position: 0)


def _with_moved_positions(frame: EmbeddedFrame, move: Move) -> EmbeddedFrame:
    return replace(
        frame,
        positions=_moved(frame.positions, move),
        frame_elements=tuple(with_moved_positions(one, move) for one in frame.frame_elements),
    )


def _moved(positions: Tuple[int, ...], move: Move) -> Tuple[int, ...]:
    return tuple(position for position in map(move, positions) if position)
