"""High five, low five, pound and hug with the arms of a PR2."""
