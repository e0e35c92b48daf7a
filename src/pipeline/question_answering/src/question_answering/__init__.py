"""Answers questions about the robot and about what it knows."""
