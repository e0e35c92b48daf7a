"""Processor time of nodes by the kernel's account, for the benchmarks."""

from xmlrpc.client import ServerProxy

import psutil
import rosgraph


def processor_s(pid: int) -> float:
    """Return the processor time of a process so far, of all its threads, seconds."""
    times = psutil.Process(pid).cpu_times()
    return float(times.user + times.system)


def pid_of(node: str) -> int:
    """Return the process of a node."""
    return int(ServerProxy(rosgraph.Master("/measuring").lookupNode(node)).getPid("/measuring")[2])
