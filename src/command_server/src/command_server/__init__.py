"""The doors for commands: text and action in, exactly one reply out."""
