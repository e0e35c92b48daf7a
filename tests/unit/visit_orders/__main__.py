"""Prints what is made of each order of visits: `PYTHONPATH=tests/unit:$PYTHONPATH .venv/bin/python -m visit_orders`."""

import sys
from collections import Counter

from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.pipeline import Pipeline
from visit_orders.judging import FIRST, RIGHT, SECOND, judged, rows


def main() -> None:
    """Print what is not right, or all rows whose sentence has the words of the first argument; then the numbers."""
    knowledge = load_knowledge([shipped_domains()])
    pretend_servers(knowledge.graph)
    pipeline = Pipeline(knowledge)
    words = " ".join(sys.argv[1:])
    counts: Counter[str] = Counter()
    for row in (*rows(FIRST), *rows(SECOND)):
        if words not in row.sentence:
            continue
        verdict, why = judged(pipeline, row)
        counts[verdict] += 1
        if words or verdict != RIGHT:
            print(f"{verdict}: {row.sentence} [{row.style}]\n    {row.formula}\n    {why}")
    print(dict(counts))


if __name__ == "__main__":
    main()
