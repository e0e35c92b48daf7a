"""Learns from answers: keeps what a yes or a no teaches, and gives the lexicon what is kept."""

from typing import Callable, FrozenSet, Iterable, Optional, Tuple

from nearest_meaning.learned import KIND, PLACE, Declined, LearnedUnit, name_in_words, name_of
from nearest_meaning.learned_file import LearnedFile
from roboframenet_ros.sqlite_file import StoreError
from semantic_framer.units.learned_units import text_of_lesson
from semantic_framer.units.lexicon import Lexicon
from semantic_framer.units.lexicon_files import LexiconFiles
from semantic_framer.units.taught_names import TaughtNames
from semantic_framer.values.dialogue import Lesson


class Learning:
    """What the robot has learned. One thread at a time uses it.

    A file that cannot be opened or written teaches nothing; the robot understands the rest.
    """

    def __init__(
        self,
        path: str,
        lexicon: Lexicon,
        files: LexiconFiles,
        *,
        warn: Callable[[str], None],
        now: Callable[[], float],
        tell: Callable[[Tuple[LearnedUnit, ...]], None] = lambda units: None,
    ) -> None:
        """
        Args:
            path: of the file
            lexicon: of the programmers' units, from which those of the known verbs are taken
            files: gives the lexicon what is learned
            warn: told what is wrong with the file
            now: the time, seconds since 1970
            tell: told all that is learned, when it has changed
        """
        self._lexicon, self._files, self._warn, self._now = lexicon, files, warn, now
        self._tell = tell
        self._names = TaughtNames()
        self._file: Optional[LearnedFile] = None
        self._version = -1
        self._told = 0
        self._declined: FrozenSet[Tuple[str, str]] = frozenset()
        try:
            self._file = LearnedFile(path)
        except StoreError as error:
            warn(f"nothing is learned: {error}")
        self.refresh()

    @property
    def declined(self) -> FrozenSet[Tuple[str, str]]:
        """Words that do not mean a frame, each with its name."""
        return self._declined

    @property
    def names(self) -> TaughtNames:
        """Kinds of things, and names of places."""
        return self._names

    def refresh(self) -> None:
        """Give the lexicon what is learned, if another program has changed the file: "rfn forget"."""
        try:
            if self._file is not None and self._file.version() != self._version:
                self._read(self._file)
        except StoreError as error:
            self._warn(str(error))

    def _read(self, file: LearnedFile) -> None:
        self._version = file.version()
        units, self._declined = file.units(), file.declined()
        for problem in file.problems[self._told :]:
            self._warn(problem)
        self._told = len(file.problems)
        self._tell(units)
        # What was taught last counts.
        kinds = {unit.said: unit.verb for unit in units if unit.frame_name == KIND}
        places = {unit.said: unit.verb for unit in units if unit.frame_name == PLACE}
        self._names = TaughtNames(kinds, places, {unit.path: unit.verb for unit in units if unit.unit_text})
        self._files.set_learned({unit.path: unit.unit_text for unit in units if unit.unit_text})

    def take(self, lessons: Iterable[Lesson], who: str) -> None:
        """Keep what the answer to a question teaches.

        Args:
            lessons: what it teaches
            who: id of the person who answered; empty when nobody is known
        """
        for lesson in lessons if self._file is not None else ():
            try:
                assert self._file is not None
                self._keep(self._file, lesson, who)
                self._read(self._file)
            except (StoreError, LookupError) as error:
                self._warn(f'"{lesson.said}" is not learned: {error}')

    def _keep(self, file: LearnedFile, lesson: Lesson, who: str) -> None:
        said, frame, now_s = lesson.said.lower(), lesson.frame_name, self._now()
        is_in_words = bool(lesson.text) or frame in (KIND, PLACE)
        if lesson.is_forgotten or (is_in_words and lesson.is_agreed):
            # What was taught last counts: the person was told what the words meant before. What two persons teach is
            # kept, and it is asked which is meant.
            for unit in file.units():
                is_of_another = bool(unit.text and lesson.text and unit.who and who and unit.who != who)
                if unit.said == said and (lesson.is_forgotten or not is_of_another):
                    file.forget(unit.name)
        if lesson.is_forgotten:
            return
        if not lesson.is_agreed:
            file.decline(Declined(said, frame, who, now_s, lesson.sentence))
        elif lesson.verb:
            text = lesson.text if is_in_words else text_of_lesson(lesson, self._lexicon)
            name = name_of(said, frame)
            if any(unit.name == name and unit.who != who for unit in file.units()):
                name = f"{name}.{name_in_words(who)}"
            file.add(LearnedUnit(name, said, lesson.verb, frame, text, who, now_s, lesson.sentence))

    def close(self) -> None:
        """Close the file."""
        if self._file is not None:
            self._file.close()
