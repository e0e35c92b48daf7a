#!/usr/bin/env python3
"""Measures how long a phrase takes in a world of 50 and of 5,000 objects, alternately in one run."""

import statistics
import sys
import time
from typing import Dict, List

from phrase_meanings.phrases import Phrases
from referring_expressions import Situation, resolve
from stanford_parser_ros.model import shipped_parser
from typed_arguments import TypedArgument
from world_model import Pose, Relation, Sort, World, WorldObject
from world_model.world import snapshot

COUNTS = (50, 5000)
ROUNDS = 40
LIMIT_MS = 5.0
CATEGORIES = ("mug", "box", "chair", "coffee table", "lamp", "bottle", "book", "plate", "towel", "apple")
COLOURS = ("red", "blue", "green", "white", "black")
PHRASES = (
    "The red mug.",
    "The box near the lamp on the table.",
    "All chairs in the kitchen.",
    "The biggest container.",
    "The thing on the left.",
)


def world_of(count: int) -> World:
    """Return a world of some objects in twenty rooms."""
    known: Dict[str, WorldObject] = {
        f"room_{number}": WorldObject(f"room_{number}", Sort.PLACE, "kitchen" if not number else f"room {number}")
        for number in range(20)
    }
    for number in range(count - len(known)):
        category = CATEGORIES[number % len(CATEGORIES)]
        name = f"{category.replace(' ', '_')}_{number}"
        place = (
            Relation("in", f"room_{number % 20}")
            if category in CATEGORIES[3:4]
            else Relation("on", f"coffee_table_{3 + 10 * (number % 3)}")
        )
        known[name] = WorldObject(
            name,
            category=category,
            attributes=(COLOURS[number % 7 % 5],),
            size_m=(0.1, 0.1, 0.1 + number / 10000.0),
            pose=Pose("map", number % 70, number // 70),
            relations=(place,),
        )
    known["robot"] = WorldObject("robot", Sort.ROBOT, pose=Pose("map", 0.0, 0.0))
    return snapshot("1", known).prepare()


def main() -> int:
    """Run the comparison."""
    parser = shipped_parser()
    arguments: List[TypedArgument] = []
    for text in PHRASES:
        tree = parser.parse(text, frozenset())
        arguments.append(Phrases(tree).argument("theme", tree.children(0)[0].index))
    situations = {count: Situation(world_of(count)) for count in COUNTS}
    times_ms: Dict[int, List[float]] = {count: [] for count in COUNTS}
    for _ in range(ROUNDS):
        for count, situation in situations.items():
            for argument in arguments:
                began_s = time.process_time()
                resolve(argument, situation)
                times_ms[count].append(1000.0 * (time.process_time() - began_s))
    for count in COUNTS:
        median, most = statistics.median(times_ms[count]), sorted(times_ms[count])[-len(PHRASES)]
        sys.stdout.write(f"{count:5} objects: median {median:.2f} ms, slowest {most:.2f} ms for a phrase\n")
    is_fast = statistics.quantiles(times_ms[COUNTS[1]], n=20)[-1] <= LIMIT_MS
    sys.stdout.write(f"at most {LIMIT_MS:g} ms with {COUNTS[1]} objects: {'yes' if is_fast else 'NO'}\n")
    return 0 if is_fast else 1


if __name__ == "__main__":
    sys.exit(main())
