"""From the text of an utterance to the tree that the semantic framer reads: every rule in one ordered table."""
