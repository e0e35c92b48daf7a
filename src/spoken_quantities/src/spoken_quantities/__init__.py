"""Numbers, lengths, angles and durations in English words, and what they are in SI units."""
