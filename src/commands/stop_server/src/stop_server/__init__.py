"""Stops the robot without the pipeline: cancels every goal and publishes zero velocity."""
