"""Moos when it is told to speak."""
