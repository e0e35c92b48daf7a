#!/usr/bin/env python3
"""Measures framing: with 50 lexical units and frames and with 10,000, alternately in one run on the same parsed
sentences, and sentences of the shipped domains beside their parses; all in processor time."""

import dataclasses
import random
import statistics
import sys
import time
from typing import Dict, List, Mapping, Sequence, Tuple

from nearest_meaning.learned_file import MOST_UNITS
from offline_pipeline.knowledge import load_knowledge, shipped_domains
from semantic_framer.framer import Policy, read
from semantic_framer.units.learned_units import learned_units
from semantic_framer.units.lexicon import Lexicon
from semantic_framer.values.outcome import MEANING_ONLY
from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import LexicalUnit, WordPattern
from stanford_parser_ros.model import Parser, shipped_parser
from utterance_passes.trees.tree import DependencyTree

COUNTS = (50, 10000)
ROUNDS = 40
LIMIT = 1.5
#: Of the median time to frame a sentence to that of its parse: a person waits longer for the parser.
LIMIT_TO_PARSE = 1.0
#: Of the time with as many learned units as there can be to that without any.
LIMIT_LEARNED, LEARNED_ROUNDS = 1.1, 8
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
        clauses=(),
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


def with_learned(units: Sequence[LexicalUnit]) -> Lexicon:
    """Return a lexicon of units and as many as persons can teach: half of them verbs, half of them idioms."""
    texts = ("frame_name: navigating_to_location\nverb: zip\n", "frame_name: waving\nremark: zip\n")
    models = [one for text in texts for one in learned_units(text, "learned/model.yaml")]
    learned: List[LexicalUnit] = []
    for number in range(MOST_UNITS):
        words = f"{made_up_verb(number)} along"
        verb, idiom = models
        is_verb = number % 2 == 0
        learned.append(
            dataclasses.replace(verb, verbs=(words,))
            if is_verb
            else dataclasses.replace(idiom, remarks=(WordPattern(words),), path=f"learned/{number}.yaml")
        )
    return Lexicon.of_units([*units, *learned])


def ratio_of_learned(parser: Parser, domains: Scale, sample: List[str]) -> Tuple[float, float, float]:
    """Return the time of framing with learned units and without, milliseconds, and their ratio, measured in turn."""
    units, frames = domains[0].units, domains[1]
    lexicons = (Lexicon.of_units(units), with_learned(units))
    trees = [parser.parse(sentence, domains[0].verbs) for sentence in sample]
    found: Tuple[List[float], List[float]] = ([], [])
    for number in range(LEARNED_ROUNDS):
        for place in (0, 1) if number % 2 else (1, 0):
            found[place].append(statistics.mean(time_ms(trees, (lexicons[place], frames), Policy())))
    without_ms, with_ms = map(statistics.median, found)
    return with_ms, without_ms, with_ms / without_ms


def time_ms(trees: List[DependencyTree], scale: Scale, policy: Policy = MEANING_ONLY) -> List[float]:
    """Return the processor time of each sentence; a copy of its tree has nothing of what the framer found before."""
    times: List[float] = []
    for tree in map(dataclasses.replace, trees):
        start_s = time.process_time()
        read(tree, *scale, policy=policy)
        times.append(1000.0 * (time.process_time() - start_s))
    return times


def parsed_and_framed_ms(parser: Parser, sentence: str, domains: Scale) -> Tuple[float, float]:
    """Return the processor time of the parse of a sentence and that of its framing, one right behind the other."""
    start_s = time.process_time()
    tree = parser.parse(sentence, domains[0].verbs)
    parse_ms = 1000.0 * (time.process_time() - start_s)
    return parse_ms, time_ms([tree], domains)[0]


def main() -> int:
    """Run the comparison."""
    made, domains, sentences, sample = scales()
    parser = shipped_parser(cache_size=0)
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
    # The first time fills what the framer keeps of a lexicon.
    both_ms = [parsed_and_framed_ms(parser, sentence, domains) for sentence in sample + sample][len(sample) :]
    parse_ms, each_ms = (sorted(times) for times in zip(*both_ms))
    p50_ms, p99_ms = statistics.median(each_ms), each_ms[int(0.99 * len(each_ms))]
    ratio = p50_ms / statistics.median(parse_ms)
    is_quick = ratio <= LIMIT_TO_PARSE
    print(
        f"framing of {len(sample)} examples of the domains: p50 {p50_ms:.2f} ms, p99 {p99_ms:.2f} ms, ratio to "
        f"parsing {ratio:.3f}  (at most {LIMIT_TO_PARSE:g}: {'held' if is_quick else 'MISSED'})"
    )
    with_ms, without_ms, grown = ratio_of_learned(parser, domains, sample)
    is_level = grown <= LIMIT_LEARNED
    print(
        f"framing of the same with {MOST_UNITS} learned units | without: {with_ms:.3f} | {without_ms:.3f} ms per "
        f"command, ratio {grown:.3f}  (at most {LIMIT_LEARNED}: {'held' if is_level else 'MISSED'})"
    )
    return 0 if is_held and is_quick and is_level else 1


if __name__ == "__main__":
    sys.exit(main())
