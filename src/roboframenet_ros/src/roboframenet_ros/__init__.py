"""What several nodes share: log calls that never wait, a master with a deadline, and noticing a suspension."""
