"""Finds the frames that a parsed sentence evokes, by lexical units."""
