"""Processor time by the kernel's account, for the benchmarks."""

import psutil


def processor_s(pid: int) -> float:
    """Return the processor time of a process so far, of all its threads, seconds."""
    times = psutil.Process(pid).cpu_times()
    return float(times.user + times.system)
