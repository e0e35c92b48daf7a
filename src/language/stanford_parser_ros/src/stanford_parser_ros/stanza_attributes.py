"""Attributes that the joint model adds to a sentence of Stanza."""

#: What else its words may hang on, as the joint model says.
ALTERNATIVES = "alternatives"
