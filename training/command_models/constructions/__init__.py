"""Constructions of English over all verbs that the robot knows: the moods, the clauses, the phrases.

A construction is taught, or it is for scoring alone: then no training sentence has it (``scored``).
"""
