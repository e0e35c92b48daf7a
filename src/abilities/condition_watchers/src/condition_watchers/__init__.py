"""Servers that watch conditions: the surroundings of the robot, speech, commands, the clock."""
