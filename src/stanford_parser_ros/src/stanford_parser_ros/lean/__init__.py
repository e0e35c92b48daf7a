"""Stanza's models without Stanza: the same files and the same arithmetic, in numpy, one short sentence at a time."""
