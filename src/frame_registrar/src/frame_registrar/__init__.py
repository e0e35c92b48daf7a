"""The graph of semantic frames, and the servers registered for each."""
