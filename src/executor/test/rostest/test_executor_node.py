#!/usr/bin/python3
"""The node with servers that misbehave: one final event for each command, and the right server runs."""

import os
import sys

import rostest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from candidate_cases import CandidateCases
from command_cases import CommandCases
from plan_cases import PlanCases
from progress_cases import ProgressCases
from stop_cases import StopCases


class ExecutorNodeTest(CandidateCases, CommandCases, PlanCases, ProgressCases, StopCases):
    """One launch serves all subjects."""


if __name__ == "__main__":
    rostest.rosrun("executor", "executor_node", ExecutorNodeTest)
