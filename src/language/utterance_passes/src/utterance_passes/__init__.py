"""Turns the text of an utterance into the tree that the semantic framer reads: one ordered table holds every rule."""
