"""Semantic frames and lexical units as values, and the YAML files that robot programmers write."""
