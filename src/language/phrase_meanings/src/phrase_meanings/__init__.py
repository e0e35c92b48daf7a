"""The meaning of the phrases of a sentence, as typed arguments."""
