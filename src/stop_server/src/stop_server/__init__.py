"""The short way of Stop: cancels every goal and publishes zero velocity, whatever else is dead."""
