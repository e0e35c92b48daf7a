#!/usr/bin/python3
"""The node: whatever the stages do, one reply to each command."""

import os
import sys

import rostest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from call_cases import CallCases
from goal_cases import GoalCases
from reply_cases import ReplyCases
from stop_cases import StopCases
from withdrawal_cases import WithdrawalCases


class CommandServerNodeTest(CallCases, GoalCases, ReplyCases, StopCases, WithdrawalCases):
    """One launch serves all subjects."""


if __name__ == "__main__":
    rostest.rosrun("command_server", "command_server_node", CommandServerNodeTest)
