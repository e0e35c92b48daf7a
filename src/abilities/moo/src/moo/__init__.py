"""Moos when a person tells the robot to speak."""
