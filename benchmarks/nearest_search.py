#!/usr/bin/env python3
"""Measures the search for the nearest meaning: the first one after start, its time and memory, and then the median with
the shipped units alone and with as many learned units as there can be, alternately in one run; in processor time."""

import statistics
import sys
import time
from pathlib import Path
from typing import Dict, List

from framing_scale import with_learned

from nearest_meaning.likeness import Likeness
from offline_pipeline.knowledge import load_knowledge, shipped_domains
from semantic_framer.framer import Heard, Policy, hear
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.lexicon import Lexicon
from stanford_parser_ros.model import shipped_parser

UNITS, LEARNED = 250, 10_000
#: Of the time with learned units to that without.
LIMIT = 1.5
#: Of the memory that the first search adds, MB.
LIMIT_MB = 120.0
ROUNDS = 5
SENTENCES = (
    "Make your way to the hall.",
    "Have a peek at the shelf.",
    "Mosey over to the kitchen.",
    "Acquire the red ball.",
    "Scamper to the office.",
    "Gyrate left 20 degrees.",
    "Destroy the wall.",
    "Go deep into the cave.",
    "Peep at the bed.",
    "Take a photo of what you see.",
)


def memory_mb() -> float:
    """Return the memory of this process that lies in the machine."""
    lines = Path("/proc/self/status").read_text(encoding="utf-8").splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith("VmRSS")) / 1024.0


def main() -> int:
    """Run the comparison."""
    knowledge = load_knowledge([shipped_domains()])
    acting = [unit for unit in knowledge.lexicon.units if unit.verbs]
    shipped = acting[:UNITS]
    parser = shipped_parser()
    likeness = Likeness()
    known = {
        count: FramedLexicon(lexicon, knowledge.frames, knowledge.types, likeness=likeness)
        for count, lexicon in ((0, Lexicon.of_units(shipped)), (LEARNED, with_learned(shipped)))
    }
    trees = [parser.parse(text, known[0].lexicon.verbs) for text in SENTENCES]

    def searched(count: int, number: int) -> Heard:
        return hear(trees[number], known[count], policy=Policy())

    hear(parser.parse("Go to the kitchen.", known[0].lexicon.verbs), known[0], policy=Policy())
    before_mb, start_s = memory_mb(), time.process_time()
    is_loaded_before = likeness.is_loaded
    searched(0, 0)
    first_ms, first_mb = 1000.0 * (time.process_time() - start_s), memory_mb() - before_mb
    start_s = time.process_time()
    searched(LEARNED, 0)
    first_learned_ms = 1000.0 * (time.process_time() - start_s)
    times_ms: Dict[int, List[float]] = {count: [] for count in known}
    for turn in range(ROUNDS):
        for count in sorted(known, reverse=bool(turn % 2)):
            for number in range(len(trees)):
                start_s = time.process_time()
                searched(count, number)
                times_ms[count].append(1000.0 * (time.process_time() - start_s))
    few, many = (statistics.median(times_ms[count]) for count in sorted(known))
    all_mb = memory_mb() - before_mb
    is_held = many <= LIMIT * few and all_mb <= LIMIT_MB and not is_loaded_before and likeness.is_loaded
    print(
        f"first search: {first_ms:.0f} ms, {first_mb:.0f} MB (encoder loaded before: {is_loaded_before}); "
        f"the first with {LEARNED} learned units: {first_learned_ms:.0f} ms; in all {all_mb:.0f} MB "
        f"(limit {LIMIT_MB:g})"
    )
    print(
        f"search, median: {len(shipped)} units and {LEARNED} learned | none learned: {many:.1f} | {few:.1f} ms, "
        f"ratio {many / few:.2f}  (limit {LIMIT:g}: {'held' if is_held else 'MISSED'})"
    )
    return 0 if is_held else 1


if __name__ == "__main__":
    sys.exit(main())
