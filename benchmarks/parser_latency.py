#!/usr/bin/env python3
"""Compares parsing a command with Stanza's own Pipeline call on the same models, in one run.

The two are called in turn on the same sentences, so that a machine that is busy is busy for both. Each sentence is
parsed
once: the cache of parses does not help.
"""

import itertools
import statistics
import subprocess
import sys
import time
from typing import Callable, List

PATTERNS = (
    "Turn left {} degrees.",
    "move forward {} feet",
    "Bring me the {} cups from the kitchen.",
    "go to room {}",
    "Put the box number {} on the table.",
    "could you please wait for {} minutes",
)
COUNT = 120


def percentile(values: List[float], share: float) -> float:
    """Return the value below which a share of the values lies."""
    return sorted(values)[min(len(values) - 1, int(share * len(values)))]


def timed(call: Callable[[str], object], text: str) -> float:
    """Return the milliseconds of one call."""
    start = time.perf_counter()
    call(text)
    return 1000.0 * (time.perf_counter() - start)


def measure(threads: int) -> None:
    """Print one comparison; it runs in a separate process because torch fixes its threads at the start."""
    from stanford_parser_ros.inference import PROCESSORS, StanzaInference, shipped_model_dir
    from stanford_parser_ros.model import Parser

    start = time.perf_counter()
    models = StanzaInference(model_dir=shipped_model_dir(), threads=threads)
    parser = Parser(models)
    ready_s = time.perf_counter() - start
    import stanza

    pipeline = stanza.Pipeline(
        "en",
        dir=str(shipped_model_dir()),
        package="default",
        processors=PROCESSORS,
        download_method=None,
        use_gpu=False,
        tokenize_no_ssplit=True,
        logging_level="ERROR",
    )
    pipeline("Turn left 120 degrees.")
    sentences = [
        pattern.format(number)
        for number, pattern in zip(itertools.count(2), itertools.islice(itertools.cycle(PATTERNS), COUNT))
    ]
    ours, stock = [], []
    for number, text in enumerate(sentences):
        pairs = ((ours, parser.parse), (stock, pipeline))
        for times, call in pairs if number % 2 else reversed(pairs):
            times.append(timed(call, text))
    print(f"threads {threads}: start to ready {ready_s:.1f} s, {models.load_times.torch_s:.1f} s of it importing torch")
    for name, times in (("this parser", ours), ("stanza.Pipeline", stock)):
        print(f"  {name:<16} p50 {statistics.median(times):6.1f} ms   p99 {percentile(times, 0.99):6.1f} ms")
    print(f"  ratio of the medians {statistics.median(ours) / statistics.median(stock):.2f}")


if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[1] == "--threads":
        measure(int(sys.argv[2]))
    else:
        for count in ("1", "2"):
            subprocess.run([sys.executable, __file__, "--threads", count], check=True, timeout=600)
