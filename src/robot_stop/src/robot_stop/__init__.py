"""Stops a robot without asking anybody: zero velocity, cancels, and who does not obey."""
