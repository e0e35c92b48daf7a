"""Helpers for tests; no product code imports this package."""

from roboframenet_testing.clock import Clock
from roboframenet_testing.waiting import comes_true, wait_until

__all__ = ["Clock", "comes_true", "wait_until"]
