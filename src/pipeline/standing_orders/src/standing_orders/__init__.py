"""Keeps what is to be done at a time, or whenever something happens, and sends it when it is due."""
