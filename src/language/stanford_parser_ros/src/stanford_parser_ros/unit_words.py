"""What the parser learns from lexical units: their verbs, their spellings, and how they use the words beside them."""

from typing import Dict, Iterable, Mapping, NamedTuple, Optional, Tuple

from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import LexicalUnit
from semantic_frames.roles import with_inherited
from stanford_parser_ros.joint.lexicon_hints import hints_of
from stanford_parser_ros.model import KnownWords
from utterance_passes.wording.typos import spellings_of

_Units = Tuple[LexicalUnit, ...]
_Frames = Tuple[Optional[SemanticFrame], ...]


class _Learned(NamedTuple):
    units: _Units
    frames: _Frames
    words: KnownWords


class UnitWords:
    """The words of files of lexical units.

    A file is learned again only when its units or their frames are others: a thousand files that are added one by one
    are learned a thousand times, not half a million times.
    """

    def __init__(self) -> None:
        self._learned: Dict[int, _Learned] = {}

    def of(self, files: Iterable[_Units], frames: Mapping[str, SemanticFrame]) -> KnownWords:
        """Return the words of files of units, without names.

        Args:
            files: the units of each; files that are not among them are forgotten
            frames: by name; a unit of another frame inherits nothing yet
        """
        learned: Dict[int, _Learned] = {}
        for units in files:
            own = tuple(frames.get(unit.frame_name) for unit in units)
            known = self._learned.get(id(units))
            if known is None or known.units is not units or any(a is not b for a, b in zip(known.frames, own)):
                known = _Learned(units, own, _words_of(units, own))
            learned[id(units)] = known
        self._learned = learned
        words = [one.words for one in learned.values()]
        return KnownWords(
            verbs=frozenset().union(*(one.verbs for one in words)),
            spellings=frozenset().union(*(one.spellings for one in words)),
            hints=frozenset().union(*(one.hints for one in words)),
        )


def _words_of(units: _Units, frames: _Frames) -> KnownWords:
    whole = [with_inherited(unit, frame) for unit, frame in zip(units, frames)]
    # The base form precedes the particle: "pick" of "pick up".
    verbs = frozenset(verb.split()[0] for unit in whole for verb in unit.verbs)
    return KnownWords(verbs, spellings_of(whole), hints=hints_of(whole))
