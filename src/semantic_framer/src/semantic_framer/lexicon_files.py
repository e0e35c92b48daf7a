"""The files of a lexicon that grows while it is used: added one after the other, and told of in that order."""

import threading
from dataclasses import dataclass
from typing import Callable, ContextManager, Iterable, List, Mapping, Tuple

from semantic_framer.lexicon import Lexicon
from semantic_frames import FileRefused, Problem
from semantic_frames.source_files import read_text, replace_problems


@dataclass(frozen=True)
class LexiconState:
    """What there is after files were added.

    Attributes:
        files: text of each file by its path
        problems: of all files that were refused and not mended since
        refused: the problems of the files that were added last, empty where all were accepted
        accepted: paths of the files that were added last and accepted
    """

    files: Mapping[str, str]
    problems: Tuple[Problem, ...]
    refused: Tuple[Problem, ...]
    accepted: Tuple[str, ...]


class LexiconFiles:
    """Adds files to a lexicon. Threads that add at the same time wait for each other until the state was announced, so
    that what is announced last is what there is.
    """

    def __init__(
        self, lexicon: Lexicon, lock: ContextManager[object], announce: Callable[[LexiconState], None]
    ) -> None:
        """
        Args:
            lexicon: takes the units
            lock: held while the lexicon changes, by those too who read it; never held while announcing
            announce: is told the state after each addition, by one thread at a time; must not add files itself
        """
        self._lexicon = lexicon
        self._lock = lock
        self._announce = announce
        self._adding = threading.Lock()
        self._problems: Tuple[Problem, ...] = ()

    def add(self, paths: Iterable[str]) -> LexiconState:
        """Add files, or replace what they gave before; a wrong one is left out, and the others count."""
        with self._adding:
            refused: List[Problem] = []
            accepted: List[str] = []
            for path in paths:
                problems: Tuple[Problem, ...] = ()
                try:
                    text = read_text(path)
                    with self._lock:
                        self._lexicon.add_file(text, path)
                    accepted.append(path)
                except FileRefused as error:
                    problems = tuple(error.problems)
                    refused += problems
                self._problems = replace_problems(self._problems, path, problems)
            state = LexiconState(
                files=self._lexicon.files, problems=self._problems, refused=tuple(refused), accepted=tuple(accepted)
            )
            self._announce(state)
            return state
