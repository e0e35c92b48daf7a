"""What the nodes of RoboFrameNet share."""
