"""Keeps the graph of semantic frames and their servers, and finds candidates for clauses."""
