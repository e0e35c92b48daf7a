"""Runs one plan at a time and preempts the one before."""
