"""Hears spoken commands: microphone or file, grammar of what the robot can do, confirmation of the frame."""
