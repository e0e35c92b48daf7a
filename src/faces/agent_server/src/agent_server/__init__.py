"""Offers the frames of the robot as tools to agents, by the Model Context Protocol."""
