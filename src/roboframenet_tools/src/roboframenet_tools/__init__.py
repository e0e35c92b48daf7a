"""rfn: what a person asks of the system."""
