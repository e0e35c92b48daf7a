"""Converts readings to messages."""

from typing import Sequence, Tuple

from roboframenet_msgs.msg import (
    Clause,
    FilledFrameElement,
    FilledLexicalUnit,
    FilledLexicalUnitList,
    FrameElementValue,
    LexicalUnitReading,
)

from semantic_framer.reading import ElementValue, Reading
from utterance_passes.tree import DependencyTree


def to_clauses(clauses: Sequence[Tuple[Reading, ...]], tree: DependencyTree) -> Sequence[Clause]:
    """Return readings as messages."""
    return [
        Clause(
            words=readings[0].clause_text,
            readings=[_reading(reading, tree, preference) for preference, reading in enumerate(readings)],
        )
        for readings in clauses
    ]


def to_filled_units(clauses: Sequence[Tuple[Reading, ...]]) -> FilledLexicalUnitList:
    """Return readings as the message of 2012."""
    return FilledLexicalUnitList(lexical_units=[_unit(reading) for readings in clauses for reading in readings])


def _unit(reading: Reading) -> FilledLexicalUnit:
    return FilledLexicalUnit(
        frame_name=reading.unit.frame_name,
        verb=reading.verb,
        frame_elements=[FilledFrameElement(name=value.name, argument=value.argument) for value in reading.values],
    )


def _reading(reading: Reading, tree: DependencyTree, preference: int) -> LexicalUnitReading:
    count = len(tree.words)
    return LexicalUnitReading(
        lexical_unit=_unit(reading),
        values=[_value(value) for value in reading.values],
        verb_position=reading.verb_positions[0],
        left_over=[tree.word(index).form for index in reading.left_over if index <= count],
        coverage=reading.coverage,
        preference=preference,
        source=reading.unit.path,
    )


def _value(value: ElementValue) -> FrameElementValue:
    return FrameElementValue(
        name=value.name,
        argument=value.argument,
        head=value.head,
        phrase=value.phrase,
        possessor=value.possessor,
        determiner=value.determiner,
        adjectives=list(value.adjectives),
        amount=value.amount,
        unit=value.unit,
        quantity=value.quantity,
        si_amount=value.si_amount,
        conjunction=value.conjunction,
        items=list(value.items),
        positions=list(value.positions),
        head_position=value.head_position,
    )
