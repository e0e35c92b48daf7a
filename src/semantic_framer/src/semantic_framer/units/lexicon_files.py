"""Adds files to a lexicon while it is in use: one at a time, and announced in the same order."""

import threading
from dataclasses import dataclass
from typing import Callable, ContextManager, Iterable, List, Mapping, Tuple

from checked_files.source_files import read_text, replace_problems
from semantic_framer.units.lexicon import Lexicon
from semantic_frames import FileRefused, Problem, load_lexical_units

#: Files come from the wire, and none is ever withdrawn.
MOST_FILES = 20_000


@dataclass(frozen=True)
class LexiconState:
    """The state of the lexicon after files were added.

    Attributes:
        files: text of each file by its path
        problems: problems of all refused files that have not been fixed since
        refused: problems of the last addition; empty if all of its files were accepted
        accepted: paths of the accepted files of the last addition
    """

    files: Mapping[str, str]
    problems: Tuple[Problem, ...]
    refused: Tuple[Problem, ...]
    accepted: Tuple[str, ...]


class LexiconFiles:
    """Adds files to a lexicon. Only one thread at a time adds files and announces the state, so the last announcement
    is always the current state.
    """

    def __init__(
        self, lexicon: Lexicon, lock: ContextManager[object], announce: Callable[[LexiconState], None]
    ) -> None:
        """
        Args:
            lexicon: receives the units
            lock: held while the lexicon changes, and never during an announcement; readers must hold it as well
            announce: called with the state after each addition, by one thread at a time; it must not add files itself
        """
        self._lexicon = lexicon
        self._lock = lock
        self._announce = announce
        self._adding = threading.Lock()
        self._problems: Tuple[Problem, ...] = ()

    def add(self, paths: Iterable[str]) -> LexiconState:
        """Add files or replace their earlier units; a wrong file is left out, and the others are added."""
        with self._adding:
            refused: List[Problem] = []
            accepted: List[str] = []
            known = set(self._lexicon.files)
            for path in paths:
                problems: Tuple[Problem, ...] = ()
                try:
                    if path not in known and len(known) >= MOST_FILES:
                        raise FileRefused(
                            [Problem("TOO_MANY", path, 1, "file", f"{MOST_FILES} files already", "fewer")]
                        )
                    text = read_text(path)
                    # Commands need the lock, so the file is understood before.
                    units = load_lexical_units(text, path)
                    with self._lock:
                        self._lexicon.replace_file(path, text, units)
                    accepted.append(path)
                    known.add(path)
                except FileRefused as error:
                    problems = tuple(error.problems)
                    refused += problems
                self._problems = replace_problems(self._problems, path, problems)
            state = LexiconState(
                files=self._lexicon.files, problems=self._problems, refused=tuple(refused), accepted=tuple(accepted)
            )
            self._announce(state)
            return state
