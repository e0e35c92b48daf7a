"""A generated set of sentences with amounts in them, each with what a base has to do, or that it must ask or refuse."""
