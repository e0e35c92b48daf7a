#!/usr/bin/env python3
"""Compares the policies of the arbitrator on simulated servers with contexts and drift, 20 seeds in one run."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "unit"))

from learned_policies.__main__ import main

if __name__ == "__main__":
    main()
