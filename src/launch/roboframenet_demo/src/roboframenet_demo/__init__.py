"""Says sentences to a robot, watches what it does and judges it."""
