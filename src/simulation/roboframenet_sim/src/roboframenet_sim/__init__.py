"""Simulated robots that offer the topics and actions of the real ones."""
