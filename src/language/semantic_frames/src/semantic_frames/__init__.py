"""Semantic frames and lexical units as values, and the YAML files that robot programmers write."""

from checked_files.problem import FileRefused, Problem
from semantic_frames.frame_file import load_frame
from semantic_frames.lexical_unit_file import check_lexical_unit, load_lexical_units

__all__ = ["FileRefused", "Problem", "check_lexical_unit", "load_frame", "load_lexical_units"]
