"""Go to a place: an RFNServer in front of move_base."""
