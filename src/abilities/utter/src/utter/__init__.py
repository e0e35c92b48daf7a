"""Says a text aloud and on a topic."""
