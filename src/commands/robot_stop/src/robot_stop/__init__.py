"""Stops a robot by itself: publishes zero velocity, cancels goals, and names the nodes that do not obey."""
