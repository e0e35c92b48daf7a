"""Processor time of nodes by the kernel's account, for the benchmarks."""

import time
from xmlrpc.client import ServerProxy

import rosgraph

#: Of the clocks of a process in Linux, the one that counts what its threads have run.
_RUN = 2


def processor_s(pid: int) -> float:
    """Return the processor time of a process so far, of all its threads, seconds.

    What ``/proc`` tells is rounded to 10 ms; a node that does nothing takes as much in 10 s.
    """
    # The clock of another process, as clock_getcpuclockid(3) makes its number.
    return time.clock_gettime((~pid << 3) | _RUN)


def pid_of(node: str) -> int:
    """Return the process of a node."""
    return int(ServerProxy(rosgraph.Master("/measuring").lookupNode(node)).getPid("/measuring")[2])
