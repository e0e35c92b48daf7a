#!/usr/bin/env python3
"""Compares framing with 50 lexical units and with 10,000, alternately in one run, on the same parsed sentences."""

import dataclasses
import statistics
import sys
import time
from typing import Dict, List, Mapping, Tuple

from offline_pipeline.knowledge import load_knowledge, shipped_domains
from semantic_framer.framer import read
from semantic_framer.lexicon import Lexicon
from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import LexicalUnit
from stanford_parser_ros.model import shipped_parser
from utterance_passes.tree import DependencyTree

COUNTS = (50, 10000)
ROUNDS = 40
LIMIT = 1.5
SYLLABLES = ("ba", "ko", "li", "mu", "ne", "ra", "so", "ti", "vu", "ze")


def made_up_verb(number: int) -> str:
    """Return an invented verb: "bakoli", ..."""
    return "".join(SYLLABLES[int(digit)] for digit in f"{number:05d}")


def lexicons() -> Tuple[Dict[int, Lexicon], Mapping[str, SemanticFrame], List[str]]:
    """Return lexicons by their size, the frames, and sentences for the units that all of them hold.

    The added units have verbs of their own: the lexicon grows, but not the number of meanings of a verb.
    """
    knowledge = load_knowledge([shipped_domains()])
    shipped = list(knowledge.lexicon.units)[: min(COUNTS)]
    sentences = [example.text for unit in shipped for example in unit.examples]
    made: Dict[int, Lexicon] = {}
    for count in COUNTS:
        units: List[LexicalUnit] = list(shipped)
        while len(units) < count:
            model = shipped[len(units) % len(shipped)]
            units.append(dataclasses.replace(model, verbs=(made_up_verb(len(units)),), examples=()))
        made[count] = Lexicon.of_units(units)
    return made, knowledge.frames, sentences


def main() -> int:
    """Run the comparison."""
    made, frames, sentences = lexicons()
    parser = shipped_parser()
    verbs = {count: lexicon.verbs for count, lexicon in made.items()}
    trees: List[DependencyTree] = [parser.parse(sentence, verbs[min(COUNTS)]) for sentence in sentences]
    times_ms: Dict[int, List[float]] = {count: [] for count in COUNTS}
    for number in range(ROUNDS):
        for count in COUNTS if number % 2 else tuple(reversed(COUNTS)):
            start_s = time.perf_counter()
            for tree in trees:
                read(tree, made[count], frames)
            times_ms[count].append(1000.0 * (time.perf_counter() - start_s) / len(trees))
    few, many = (statistics.median(times_ms[count]) for count in COUNTS)
    is_held = many <= LIMIT * few
    print(
        f"framing, median of {ROUNDS} rounds over {len(trees)} sentences: {COUNTS[1]} | {COUNTS[0]} units: "
        f"{many:.3f} | {few:.3f} ms per command, ratio {many / few:.3f}  "
        f"(at most {LIMIT}: {'held' if is_held else 'MISSED'})"
    )
    return 0 if is_held else 1


if __name__ == "__main__":
    sys.exit(main())
