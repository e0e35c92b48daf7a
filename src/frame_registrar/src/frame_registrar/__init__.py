"""Graph of semantic frames: who can carry out what was evoked."""
