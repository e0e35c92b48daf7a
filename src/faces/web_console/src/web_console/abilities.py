"""What the robot can do now: frames that living servers carry out, with sentences to say."""

import os
from typing import Dict, Iterable, List, Mapping, Set, Tuple

from roboframenet_ros.spoken_text import with_capital
from semantic_frames import FileRefused, load_frame, load_lexical_units
from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import LexicalUnit
from web_console.views import AbilitiesView, AbilityView

#: A file: its path and its text.
File = Tuple[str, str]
#: Living servers by frame.
Servers = Mapping[str, Tuple[str, ...]]

_MOST_EXAMPLES = 6
_MOST_WORDS = 2000
_MOST_LEVELS = 8


class Knowledge:
    """Reads files once: the same text of the same path is not read again. One thread owns it."""

    def __init__(self) -> None:
        self._frames: Dict[File, Tuple[SemanticFrame, ...]] = {}
        self._units: Dict[File, Tuple[LexicalUnit, ...]] = {}

    def view(
        self, frame_files: Iterable[File], unit_files: Iterable[File], servers: Servers, names: Iterable[str]
    ) -> AbilitiesView:
        """Return what the robot can do.

        Args:
            frame_files: of all frames
            unit_files: of all lexical units
            servers: that live, by frame
            names: of places, persons and things, for the words
        """
        frames = {frame.name: frame for file in frame_files for frame in self._frames_of(file)}
        units = [unit for file in unit_files for unit in self._units_of(file)]
        grounded = [frame for frame in frames.values() if is_grounded(frame.name, frames, servers)]
        abilities = []
        for frame in sorted(grounded, key=lambda frame: (_domain(frame.path), frame.name)):
            examples = _examples(unit for unit in units if unit.frame_name == frame.name)
            if examples:
                description = " ".join(frame.description.split())
                abilities.append(
                    AbilityView(
                        frame=frame.name,
                        description=description,
                        domain=_domain(frame.path),
                        servers=servers.get(frame.name, ()),
                        examples=examples,
                    )
                )
        words = _words(abilities, (unit for unit in units if unit.frame_name in {frame.name for frame in grounded}))
        return AbilitiesView(
            abilities=tuple(abilities),
            words=tuple(sorted({*words, *names}))[:_MOST_WORDS],
            frames=len(frames),
            units=len(units),
        )

    def _frames_of(self, file: File) -> Tuple[SemanticFrame, ...]:
        if file not in self._frames:
            try:
                self._frames[file] = (load_frame(file[1], file[0]),)
            except FileRefused:
                # The registrar reports the problem.
                self._frames[file] = ()
        return self._frames[file]

    def _units_of(self, file: File) -> Tuple[LexicalUnit, ...]:
        if file not in self._units:
            try:
                self._units[file] = load_lexical_units(file[1], file[0])
            except FileRefused:
                # The framer reports the problem.
                self._units[file] = ()
        return self._units[file]


def is_grounded(name: str, frames: Mapping[str, SemanticFrame], servers: Servers, *, level: int = 0) -> bool:
    """Whether living servers can carry a frame out: one of its own, or those of one of its sequences of children."""
    if servers.get(name):
        return True
    frame = frames.get(name)
    return (
        frame is not None
        and level < _MOST_LEVELS
        and any(
            all(is_grounded(child.name, frames, servers, level=level + 1) for child in sequence)
            for sequence in frame.children
        )
    )


def _domain(path: str) -> str:
    """Return the folder of a domain: domains/DOMAIN/frames/FILE."""
    return os.path.basename(os.path.dirname(os.path.dirname(path))).replace("_", " ")


def _examples(units: Iterable[LexicalUnit]) -> Tuple[str, ...]:
    """Return examples of a frame, the first of each unit before the second of any."""
    texts = [[with_capital(example.text) for example in unit.examples] for unit in units]
    found: List[str] = []
    for place in range(max(map(len, texts), default=0)):
        found += [one[place] for one in texts if place < len(one)]
    return tuple(dict.fromkeys(found))[:_MOST_EXAMPLES]


def _words(abilities: Iterable[AbilityView], units: Iterable[LexicalUnit]) -> Set[str]:
    words = {verb for unit in units for verb in unit.verbs}
    for ability in abilities:
        for example in ability.examples:
            words.update(word for word in (part.strip('.,;:!?"()') for part in example.lower().split()) if word)
    return words
