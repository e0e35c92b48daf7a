"""Adds files to a lexicon while it is in use: one at a time, and announced in the same order."""

import threading
from dataclasses import dataclass
from typing import Callable, ContextManager, Dict, Iterable, List, Mapping, Tuple

from checked_files.source_files import read_text, replace_problems
from semantic_framer.units.learned_units import learned_units
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
        is_learned: whether what persons have taught was changed, and nothing else
    """

    files: Mapping[str, str]
    problems: Tuple[Problem, ...]
    refused: Tuple[Problem, ...]
    accepted: Tuple[str, ...]
    is_learned: bool = False


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
        self._learned: Dict[str, str] = {}

    def set_learned(self, texts: Mapping[str, str]) -> None:
        """Put the files that persons have taught in the place of the earlier ones; a wrong file is left out.

        Args:
            texts: text of each file by the path under which it is known; no such files lie there
        """
        with self._adding:
            refused: List[Problem] = []
            changed = [path for path, text in texts.items() if self._learned.get(path) != text]
            gone = [path for path in self._learned if path not in texts]
            for path in changed:
                try:
                    units = learned_units(texts[path], path)
                    with self._lock:
                        self._lexicon.replace_file(path, texts[path], units)
                except FileRefused as error:
                    gone.append(path)
                    refused += error.problems
            for path in gone:
                with self._lock:
                    self._lexicon.remove_file(path)
            self._learned = dict(texts)
            if changed or gone:
                self._announce(LexiconState(self._lexicon.files, self._problems, tuple(refused), (), is_learned=True))

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
