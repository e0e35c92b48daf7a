"""Runs one plan at a time; a newer plan preempts the running one."""
