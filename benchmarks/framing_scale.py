#!/usr/bin/env python3
"""Measures framing: with 50 lexical units and frames and with 10,000, alternately in one run on the same parsed
sentences, and sentences of the shipped domains beside their parses; all in processor time."""

import dataclasses
import random
import statistics
import sys
import time
from typing import Dict, List, Mapping, Tuple

from offline_pipeline.knowledge import load_knowledge, shipped_domains
from semantic_framer.framer import read
from semantic_framer.units.lexicon import Lexicon
from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import LexicalUnit, WordPattern
from stanford_parser_ros.model import shipped_parser
from utterance_passes.trees.tree import DependencyTree

COUNTS = (50, 10000)
ROUNDS = 40
LIMIT = 1.5
#: Of the median time to frame a sentence to that of its parse.
LIMIT_TO_PARSE = 0.5
SAMPLE, SEED = 200, 11
SYLLABLES = ("ba", "ko", "li", "mu", "ne", "ra", "so", "ti", "vu", "ze")
Scale = Tuple[Lexicon, Mapping[str, SemanticFrame]]


def made_up_verb(number: int) -> str:
    """Return an invented verb: "bakoli", ..."""
    return "".join(SYLLABLES[int(digit)] for digit in f"{number:05d}")


def renamed(model: LexicalUnit, verb: str) -> LexicalUnit:
    """Return a unit like another one, with an invented verb, or with this word in each of its patterns.

    It is asked for nothing, and is no state: there are as many of these as there are meanings of "be".
    """

    def with_verb(patterns: Tuple[WordPattern, ...]) -> Tuple[WordPattern, ...]:
        return tuple(dataclasses.replace(pattern, text=f"{verb} {pattern.text}") for pattern in patterns)

    return dataclasses.replace(
        model,
        frame_name=verb,
        verbs=(verb,) if model.verbs else (),
        questions=with_verb(model.questions),
        remarks=with_verb(model.remarks),
        conditions=with_verb(model.conditions),
        events=(verb,) if model.events else (),
        asks=(),
        holds=(),
        examples=(),
    )


def scales() -> Tuple[Dict[int, Scale], Scale, List[str], List[str]]:
    """Return lexicons and frames by their size, those of the domains, sentences for all sizes, and for the domains.

    The added units have verbs, words in their patterns, and frames of their own: the lexicon grows, but not the number
    of meanings of a verb.
    """
    knowledge = load_knowledge([shipped_domains()])
    units = list(knowledge.lexicon.units)
    shipped = units[: min(COUNTS)]
    made: Dict[int, Scale] = {}
    for count in COUNTS:
        grown: List[LexicalUnit] = list(shipped)
        frames = {unit.frame_name: knowledge.frames[unit.frame_name] for unit in shipped}
        while len(grown) < count:
            model = shipped[len(grown) % len(shipped)]
            verb = made_up_verb(len(grown))
            frames[verb] = dataclasses.replace(frames[model.frame_name], name=verb)
            grown.append(renamed(model, verb))
        made[count] = Lexicon.of_units(grown), frames
    examples = [example.text for unit in units for example in unit.examples]
    sample = random.Random(SEED).sample(examples, SAMPLE)
    return made, (knowledge.lexicon, knowledge.frames), [one.text for unit in shipped for one in unit.examples], sample


def time_ms(trees: List[DependencyTree], scale: Scale) -> List[float]:
    """Return the processor time of each sentence; a copy of its tree has nothing of what the framer found before."""
    times: List[float] = []
    for tree in map(dataclasses.replace, trees):
        start_s = time.process_time()
        read(tree, *scale)
        times.append(1000.0 * (time.process_time() - start_s))
    return times


def main() -> int:
    """Run the comparison."""
    made, domains, sentences, sample = scales()
    parser = shipped_parser()
    trees = [parser.parse(sentence, made[min(COUNTS)][0].verbs) for sentence in sentences]
    times_ms: Dict[int, List[float]] = {count: [] for count in COUNTS}
    for number in range(ROUNDS):
        for count in COUNTS if number % 2 else tuple(reversed(COUNTS)):
            times_ms[count].append(statistics.mean(time_ms(trees, made[count])))
    few, many = (statistics.median(times_ms[count]) for count in COUNTS)
    is_held = many <= LIMIT * few
    print(
        f"framing, median of {ROUNDS} rounds over {len(trees)} sentences: {COUNTS[1]} | {COUNTS[0]} units and frames: "
        f"{many:.3f} | {few:.3f} ms per command, ratio {many / few:.3f}  "
        f"(at most {LIMIT}: {'held' if is_held else 'MISSED'})"
    )
    trees, parse_ms = [], []
    for sentence in sample:
        start_s = time.process_time()
        trees.append(parser.parse(sentence, domains[0].verbs))
        parse_ms.append(1000.0 * (time.process_time() - start_s))
    time_ms(trees, domains)
    each_ms = sorted(time_ms(trees, domains))
    p50_ms, p99_ms = statistics.median(each_ms), each_ms[int(0.99 * len(each_ms))]
    ratio = p50_ms / statistics.median(parse_ms)
    is_quick = ratio <= LIMIT_TO_PARSE
    print(
        f"framing of {len(trees)} examples of the domains: p50 {p50_ms:.2f} ms, p99 {p99_ms:.2f} ms, ratio to "
        f"parsing {ratio:.3f}  (at most {LIMIT_TO_PARSE:g}: {'held' if is_quick else 'MISSED'})"
    )
    return 0 if is_held and is_quick else 1


if __name__ == "__main__":
    sys.exit(main())
