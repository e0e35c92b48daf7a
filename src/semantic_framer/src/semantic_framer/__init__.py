"""Lexical units: from the parse of a sentence to the frames that it evokes."""
