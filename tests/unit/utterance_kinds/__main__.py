"""Measures the generated set: ``PYTHONPATH=tests/unit:$PYTHONPATH python -m utterance_kinds --set tune``."""

import argparse
import json
from pathlib import Path

from .judging import Judge, table_by_kind, table_by_template
from .utterances import SEED, SETS, generate, sample


def main() -> None:
    """Print how often utterances acted, by kind and by template."""
    parser = argparse.ArgumentParser(prog="utterance_kinds", description=__doc__)
    parser.add_argument("--set", choices=SETS, default="tune", help="templates to tune on, or those put aside")
    parser.add_argument("--seed", type=int, default=SEED, help="of the choice of clauses")
    parser.add_argument("--sample", type=int, metavar="COUNT", help="only so many utterances")
    parser.add_argument("--failures", type=Path, metavar="FILE", help="write what is wrong there, as JSON")
    parser.add_argument(
        "--open-frozen",
        action="store_true",
        help="show templates and failures of the frozen set too; not for whoever writes the rules",
    )
    arguments = parser.parse_args()
    utterances = generate(arguments.set, seed=arguments.seed)
    if arguments.sample is not None:
        utterances = sample(utterances, arguments.sample, seed=arguments.seed)
    verdicts = list(Judge().verdicts(utterances))
    may_show = arguments.set == "tune" or arguments.open_frozen
    if may_show:
        print("\n".join(table_by_template(verdicts)) + "\n")
    print("\n".join(table_by_kind(verdicts)))
    print(f"{len(utterances)} utterances, {len(utterances) - len(verdicts)} whose plain command does nothing left out")
    if arguments.failures is not None:
        if not may_show:
            parser.error("the failures of the frozen set are shown with --open-frozen only")
        failures = [verdict.to_json() for verdict in verdicts if not verdict.is_right]
        arguments.failures.write_text(json.dumps(failures, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
