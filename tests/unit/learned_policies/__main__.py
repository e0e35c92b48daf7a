"""Prints the table: ``PYTHONPATH=tests/unit:$PYTHONPATH python -m learned_policies --seeds 20``."""

import argparse

from .comparison import AFTER_DRIFT, above_oracle, compare, recovery, still_asked, table


def main() -> None:
    """Compare the policies."""
    parser = argparse.ArgumentParser(description=main.__doc__)
    parser.add_argument("--seeds", type=int, default=20, help="how many homes")
    parser.add_argument("--first", type=int, default=0, help="first seed")
    given = parser.parse_args()
    results = compare(range(given.first, given.first + given.seeds))
    print(table(results))
    share, (least, most) = above_oracle(results, "learned")
    print(f"\nmeans of `learned` above those of the oracle: {share:+.1%} (95 %: {least:+.1%} to {most:+.1%})\n")
    print(recovery(results, "learned"))
    print("\nA server that has broken is still asked first, of the commands of its frame:")
    for first, end in AFTER_DRIFT:
        print("{} to {}: {:.1%} ± {:.1%}".format(first + 1, end, *still_asked(results, "learned", first, end)))
    times = sorted(one for result in results["learned"] for one in result.ordering_s)
    p99_ms, longest_ms = 1e3 * times[int(0.99 * len(times))], 1e3 * times[-1]
    print(f"\nordering by `learned`, processor time: p99 {p99_ms:.2f} ms, longest {longest_ms:.2f} ms")


if __name__ == "__main__":
    main()
