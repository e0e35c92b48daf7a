"""A generated set of sentences with amounts. Each says how a base must move, or that it must ask or refuse."""
