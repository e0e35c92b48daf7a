#!/usr/bin/env python3
"""Compares parsing a command, in both runtimes, with a stock Pipeline of Stanza on the same models, in one run.

They are called in turn on the same sentences, so that a machine that is busy is busy for all. Each sentence is parsed
once: the cache of parses does not help. Times of the processor stand beside those of the clock: they do not grow when
other programs run.
"""

import itertools
import statistics
import subprocess
import sys
import time
from typing import Callable, Dict, List, Tuple

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


def timed(call: Callable[[str], object], text: str) -> Tuple[float, float]:
    """Return the milliseconds of one call: of the clock, and of the processor."""
    start, processor = time.perf_counter(), time.process_time()
    call(text)
    return 1000.0 * (time.perf_counter() - start), 1000.0 * (time.process_time() - processor)


def measure(threads: int) -> None:
    """Print one comparison; it runs in a separate process because torch fixes its threads at the start."""
    from stanford_parser_ros.inference import StanzaInference, processors_of, shipped_model_dir
    from stanford_parser_ros.joint.inference import JointInference
    from stanford_parser_ros.model import Parser

    start = time.perf_counter()
    onnx = Parser(JointInference(model_dir=shipped_model_dir(), threads=threads))
    onnx_ready_s = time.perf_counter() - start
    start = time.perf_counter()
    models = StanzaInference(model_dir=shipped_model_dir(), threads=threads)
    parser = Parser(models)
    ready_s = time.perf_counter() - start
    import stanza

    pipeline = stanza.Pipeline(
        "en",
        dir=str(shipped_model_dir()),
        package=None,
        processors=processors_of(shipped_model_dir(), "default", threads=threads),
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
    calls: Dict[str, Callable[[str], object]] = {
        "runtime onnx": onnx.parse,
        "runtime stanza": parser.parse,
        "stanza.Pipeline": pipeline,
    }
    times: Dict[str, List[Tuple[float, float]]] = {name: [] for name in calls}
    names = list(calls)
    for number, text in enumerate(sentences):
        for name in names[number % 3 :] + names[: number % 3]:
            times[name].append(timed(calls[name], text))
    print(
        f"threads {threads}: start to ready onnx {onnx_ready_s:.1f} s; stanza {ready_s:.1f} s, "
        f"{models.load_times.torch_s:.1f} s of it importing torch"
    )
    medians = {}
    for name, pairs in times.items():
        clock, processor = [pair[0] for pair in pairs], [pair[1] for pair in pairs]
        medians[name] = statistics.median(clock)
        print(
            f"  {name:<16} p50 {medians[name]:6.1f} ms   p99 {percentile(clock, 0.99):6.1f} ms   "
            f"processor p50 {statistics.median(processor):6.1f} ms   p99 {percentile(processor, 0.99):6.1f} ms"
        )
    for name in names[:2]:
        print(f"  {name}: ratio of the medians {medians[name] / medians[names[2]]:.2f}")


if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[1] == "--threads":
        measure(int(sys.argv[2]))
    else:
        for count in ("1", "2"):
            subprocess.run([sys.executable, __file__, "--threads", count], check=True, timeout=600)
