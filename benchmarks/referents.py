#!/usr/bin/env python3
"""Measures how long a phrase takes in a world of 50 and of 5,000 objects, alternately in one run."""

import statistics
import sys
import time
from typing import Dict, List, Tuple

from phrase_meanings.phrases import Phrases
from referring_expressions import Situation, resolve
from stanford_parser_ros.model import shipped_parser
from typed_arguments import TypedArgument
from world_model import Pose, Relation, Sort, WorldObject
from world_model.world import snapshot

COUNTS = (50, 5000)
ROUNDS = 40
#: Of the time for a phrase among the most objects to that among the fewest: it grows as their number does, at most.
LIMIT = COUNTS[1] / COUNTS[0]
CATEGORIES = ("mug", "box", "chair", "coffee table", "lamp", "bottle", "book", "plate", "towel", "apple")
COLOURS = ("red", "blue", "green", "white", "black")
PHRASES = (
    "The red mug.",
    "The box near the lamp on the table.",
    "All chairs in the kitchen.",
    "The biggest container.",
    "The thing on the left.",
    "A blue book on the coffee table.",
    "The smallest red plate in room 3.",
    "My mug.",
    "All red things.",
    "Everything on the table.",
    "The thing near the lamp.",
    "The towel behind the box.",
    "The things in the kitchen that are not red.",
    "The highest white bottle in the kitchen.",
    "The chair next to the door.",
    "The other mug.",
)


def objects_of(count: int) -> Dict[str, WorldObject]:
    """Return objects in twenty rooms, by id."""
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
    return known


def main() -> int:
    """Run the comparison."""
    parser = shipped_parser()
    arguments: Dict[str, TypedArgument] = {}
    for text in PHRASES:
        tree = parser.parse(text, frozenset())
        arguments[text] = Phrases(tree).argument("theme", tree.children(0)[0].index)
    objects = {count: objects_of(count) for count in COUNTS}
    times_ms: Dict[Tuple[int, str], List[float]] = {(count, text): [] for count in COUNTS for text in PHRASES}
    for number in range(ROUNDS):
        for count, known in objects.items():
            # A robot hears of the world anew with each change: nothing is left of earlier phrases.
            situation = Situation(snapshot(str(number), known).prepare())
            for text in PHRASES[number % len(PHRASES) :] + PHRASES[: number % len(PHRASES)]:
                began_s = time.process_time()
                resolve(arguments[text], situation)
                times_ms[count, text].append(1000.0 * (time.process_time() - began_s))
    late = {key: statistics.quantiles(times, n=20)[-1] for key, times in times_ms.items()}
    for count in COUNTS:
        slowest = max(PHRASES, key=lambda text: late[count, text])
        median = statistics.median(statistics.median(times_ms[count, text]) for text in PHRASES)
        of_slowest = statistics.median(times_ms[count, slowest])
        sys.stdout.write(
            f"{count:5} objects: median {median:.2f} ms; slowest phrase {slowest!r}: median {of_slowest:.2f} ms, "
            f"95 of 100 times within {late[count, slowest]:.2f} ms\n"
        )
    few, many = (max(late[count, text] for text in PHRASES) for count in COUNTS)
    is_fast = many <= LIMIT * few
    verdict = "held" if is_fast else "MISSED"
    sys.stdout.write(f"slowest of all, ratio {many / few:.1f}  (at most {LIMIT:g}: {verdict})\n")
    return 0 if is_fast else 1


if __name__ == "__main__":
    sys.exit(main())
