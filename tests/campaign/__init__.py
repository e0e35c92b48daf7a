"""The reliability campaign: attacks on a running robot, each a number of trials, with a table at the end.

``python -m campaign --form short`` runs it; ``make reliability`` does. A demand (R1 to R18) is a set of trials that are
alike. Each trial draws from a random generator of its own, made from the seed, the demand and its number, so that any
one can be repeated; no trial is ever tried again. What each trial found is appended to a file, and a campaign that was
cut goes on behind the last one.
"""
