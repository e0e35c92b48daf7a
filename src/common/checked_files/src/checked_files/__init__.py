"""Files that robot programmers write: found, read within bounds, and refused with all their mistakes at once."""

from checked_files.problem import FileRefused, Problem

__all__ = ["FileRefused", "Problem"]
