"""Prints the table: ``PYTHONPATH=tests/unit:$PYTHONPATH python -m learned_policies --seeds 20``."""

import argparse
from typing import Sequence

from .comparison import AFTER_DRIFT, RECOVERY, above_oracle, compare, extra, interval, recovery, still_asked, table
from .full_store import FULL_STORE, ordering_with_a_full_store

#: Policies that are compared after a drift: the second knows how servers are drawn, the third also when they change.
LEARNERS = ("learned", "ideal", "ideal, told")


def main() -> None:
    """Compare the policies."""
    parser = argparse.ArgumentParser(description=main.__doc__)
    parser.add_argument("--seeds", type=int, default=20, help="how many homes")
    parser.add_argument("--first", type=int, default=0, help="first seed")
    given = parser.parse_args()
    results = compare(range(given.first, given.first + given.seeds))
    print(table(results))
    share, (least, most) = above_oracle(results, "learned")
    print(f"\nmeans of `learned` above those of the oracle: {share:+.1%} (95 %: {least:+.1%} to {most:+.1%})")
    print("\nFailures above the oracle's, in 100 commands:\n")
    print(recovery(results, LEARNERS))
    less = [one - other for one, other in zip(*(extra(results, name, RECOVERY, 2 * RECOVERY) for name in LEARNERS[:2]))]
    print("\n`learned` less `ideal`, {} to {}: {:+.1f} ± {:.1f}".format(RECOVERY + 1, 2 * RECOVERY, *interval(less)))
    print("\nA server that has broken is still asked first, of the commands of its frame:")
    for first, end in AFTER_DRIFT:
        shares = ["`{}` {:.1%} ± {:.1%}".format(name, *still_asked(results, name, first, end)) for name in LEARNERS]
        print(f"{first + 1} to {end}: {', '.join(shares)}")
    times = [one for result in results["learned"] for one in result.ordering_s]
    print(f"\nordering by `learned`, processor time: {_times(times)}")
    print(f"the same with a full store, {FULL_STORE} trials: {_times(ordering_with_a_full_store())}")


def _times(times_s: Sequence[float]) -> str:
    ordered = sorted(times_s)
    return f"p99 {1e3 * ordered[int(0.99 * len(ordered))]:.2f} ms, longest {1e3 * ordered[-1]:.2f} ms"


if __name__ == "__main__":
    main()
