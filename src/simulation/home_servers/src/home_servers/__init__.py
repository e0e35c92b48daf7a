"""RFNServers for a robot in a home: each frame becomes a sequence of actions of the home."""
