"""Remembers where the robot is under a name: This is the office."""
