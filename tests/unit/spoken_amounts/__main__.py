"""Measures the generated set: ``PYTHONPATH=tests/unit:$PYTHONPATH python -m spoken_amounts --count 1000``."""

import argparse

from .judging import Judge, table
from .phrases import SEED, generate


def main() -> None:
    """Print how many amounts are understood, asked about, refused or wrong."""
    parser = argparse.ArgumentParser(prog="spoken_amounts", description=__doc__)
    parser.add_argument("--count", type=int, default=10000, help="so many sentences")
    parser.add_argument("--seed", type=int, default=SEED)
    parser.add_argument("--policy", choices=("strict", "ignore"), default="strict", help="for words that are left over")
    parser.add_argument("--show", nargs="*", default=["wrong"], help="outcomes of which each sentence is shown")
    arguments = parser.parse_args()
    judge = Judge()
    verdicts = list(judge.verdicts(generate(arguments.count, arguments.seed), arguments.policy))
    for verdict in verdicts:
        is_plain = verdict.phrase.motions is not None and verdict.phrase.is_within_limits
        if verdict.outcome in arguments.show and (is_plain or verdict.outcome == "wrong"):
            print(
                f"{verdict.outcome}: {verdict.phrase.text!r} {verdict.phrase.motions} -> {verdict.done} {verdict.said}"
            )
    print("\n".join(table(verdicts)))


if __name__ == "__main__":
    main()
