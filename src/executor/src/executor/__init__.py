"""Runs one procedure at a time and preempts the one before."""
