"""Judges commands in the home: ``python -m home_referee GRAMMARS --count 200``, with ``tests/unit`` on the path."""

import argparse

from roboframenet_sim.home_state import Faults

from .annotated import slots_of
from .commands import draw
from .direct_run import DirectRun
from .judging import Verdict, judge, table

#: Who speaks to the robot.
SPEAKER = "alice"


def main() -> None:
    """Print the verdicts."""
    parser = argparse.ArgumentParser(prog="home_referee", description=__doc__)
    parser.add_argument("folder", help="grammars with logical forms, in any depth")
    parser.add_argument("--count", type=int, default=200, metavar="N", help="number of commands")
    parser.add_argument("--seed", type=int, default=11, metavar="N", help="of the commands, the persons and the faults")
    parser.add_argument("--slip", type=float, default=0.0, metavar="P", help="probability that a thing slips")
    parser.add_argument("--blocked-door", type=float, default=0.0, metavar="P", help="probability of a blocked door")
    parser.add_argument("--only", default="", metavar="WORDS", help="only commands with these words")
    parser.add_argument("--left-out", action="store_true", help="list what the home has nothing for")
    arguments = parser.parse_args()
    slots = slots_of(arguments.folder, speaker=SPEAKER)
    commands, left_out = draw(arguments.folder, slots, count=arguments.count, seed=arguments.seed)
    runs = DirectRun(speaker=SPEAKER, seed=arguments.seed, faults=Faults(arguments.slip, arguments.blocked_door))
    judged = []
    for command in commands:
        if arguments.only.lower() in command.text.lower():
            judged.append(judge(runs.run(command), slots))
            last = judged[-1]
            if last.verdict is not Verdict.RIGHT:
                print(
                    f"{last.verdict.value}: {command.text}: {last.run.outcome}: {' | '.join(last.reasons)}", flush=True
                )
    print(table(judged, only=()))
    if arguments.left_out:
        print("\n".join(["not in this home:", *left_out]))


if __name__ == "__main__":
    main()
