"""The names that the robot knows: those of a file count first, then those that another program sends."""

from typing import Iterable, Sequence, Tuple

from checked_files import FileRefused, Problem
from checked_files.source_files import read_text
from semantic_types import Names, WordTypes, checked_names, load_name_file


class KnownNames:
    """Names of persons, rooms and things, with their types.

    Attributes:
        problems: of the file; it is left out if it has any
        types: the types of all words, with the names; replaced as a whole
    """

    def __init__(self, path: str = "") -> None:
        """
        Args:
            path: a file of names; empty for none
        Raises:
            NoWordNet: the database of nouns is not installed
        """
        self.problems: Tuple[Problem, ...] = ()
        self._of_file: Names = {}
        if path:
            try:
                self._of_file = load_name_file(read_text(path), path)
            except FileRefused as refused:
                self.problems = refused.problems
        self.types = WordTypes(names=self._of_file)

    def hear(self, pairs: Iterable[Tuple[str, Sequence[str]]], source: str) -> Tuple[Problem, ...]:
        """Replace the names that another program sent before.

        Args:
            pairs: names with their types
            source: the program, for problems
        Returns:
            problems of the names; if there are any, the names before stay
        """
        try:
            heard = checked_names(pairs, source)
        except FileRefused as refused:
            return refused.problems
        self.types = WordTypes(self.types.nouns, {**heard, **self._of_file})
        return ()
