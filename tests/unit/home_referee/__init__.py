"""A referee of commands in the home: it knows from a command's own annotation what must come of it.

It is no part of the pipeline and reads none of its tables: not the frames, not the words, not the world of the robot.
It knows the file of the home, and the logical form that the generators of RoboCup@Home publish with each of their
commands.
"""
