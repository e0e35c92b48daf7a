"""Runs plans; a newer plan preempts what runs, follows it, or runs beside it."""
