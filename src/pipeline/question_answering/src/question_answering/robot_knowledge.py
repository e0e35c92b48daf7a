"""What the robot knows of itself: its abilities, what it does, and what was said to it."""

import enum
from dataclasses import dataclass, field, replace
from datetime import datetime
from pathlib import Path
from typing import Dict, FrozenSet, List, Mapping, Sequence, Tuple

from question_answering.deed_log import PlannedNode, TriedClause
from referring_expressions import Situation
from roboframenet_ros.spoken_text import with_capital
from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import LexicalUnit
from world_model import World


class Outcome(enum.Enum):
    """How a command ended, as the message ``Reply`` has it; the values are its constants."""

    DONE = 0
    FAILED = 1
    REFUSED = 2
    ASKED = 3
    SUPERSEDED = 4


@dataclass(frozen=True)
class Deed:
    """A command that has ended.

    Attributes:
        text: as it was said
        outcome: how it ended
        sentence: of its reply
        is_stop: whether it was a cry, which stops the robot
    """

    text: str
    outcome: Outcome
    sentence: str = ""
    is_stop: bool = False


@dataclass(frozen=True)
class RobotKnowledge:
    """What answers need to know.

    Attributes:
        world: what the robot knows of things, persons and places
        name: of the robot
        abilities: sentences that it can carry out now, of different domains first
        ability_count: number of frames that it can carry out now
        doing: the command that runs; empty for none
        last_words: what was said before; empty for nothing
        last_reply: what the robot replied last; empty for nothing
        now: local time
        deeds: the commands that have ended, without questions, the last one last
        next_steps: what comes after what runs, in the words of the person
        speaker: id of the person who speaks; empty when unknown
        tried: the clauses that were tried in this run, the last one last
        running: the clauses that are carried out now
        planned: the clauses that come later
        frames: by name
        served: names of the frames that can be carried out now
    """

    world: World = field(default_factory=World)
    name: str = "Robo"
    abilities: Tuple[str, ...] = ()
    ability_count: int = 0
    doing: str = ""
    last_words: str = ""
    last_reply: str = ""
    now: datetime = datetime.min
    deeds: Tuple[Deed, ...] = ()
    next_steps: Tuple[str, ...] = ()
    speaker: str = ""
    tried: Tuple[TriedClause, ...] = ()
    running: Tuple[PlannedNode, ...] = ()
    planned: Tuple[PlannedNode, ...] = ()
    frames: Mapping[str, SemanticFrame] = field(default_factory=dict)
    served: FrozenSet[str] = frozenset()

    @property
    def of_this_run(self) -> "RobotKnowledge":
        """The same without what earlier runs knew of places and states."""
        world = self.world.of_this_run
        return self if world is self.world else replace(self, world=world)

    @property
    def situation(self) -> Situation:
        """What phrases refer to."""
        return Situation(self.world, speaker=self.speaker)


def steps_behind(children: Sequence[str], active: Sequence[str]) -> Tuple[str, ...]:
    """Return what comes behind the active states of a sequence: "say hello" for its child "2 say hello".

    Args:
        children: labels of the states of a machine, each with its number; others are no steps
        active: labels of its active states
    """
    numbers = {label: int(label.split(" ", 1)[0]) for label in children if label.split(" ", 1)[0].isdigit()}
    running = [numbers[label] for label in active if label in numbers]
    if not running:
        return ()
    behind = sorted((number, label) for label, number in numbers.items() if number > max(running))
    return tuple(label.split(" ", 1)[1] for _, label in behind if " " in label)


def served_frames(frames: Mapping[str, SemanticFrame], served: FrozenSet[str]) -> FrozenSet[str]:
    """Return the frames that can be carried out now: by a server of their own, or by those of a sequence of others.

    Args:
        frames: by name
        served: frames with a server that is alive
    """
    found = {name for name in served if name in frames}
    is_growing = True
    while is_growing:
        new = {
            frame.name
            for frame in frames.values()
            if frame.name not in found
            and any(sequence and all(child.name in found for child in sequence) for sequence in frame.children)
        }
        found |= new
        is_growing = bool(new)
    return frozenset(found)


def examples_of(
    frames: Mapping[str, SemanticFrame], units: Sequence[LexicalUnit], served: FrozenSet[str]
) -> Tuple[str, ...]:
    """Return an example sentence for each frame that acts and can be carried out: one of each domain, then others.

    Args:
        frames: by name
        units: with their examples
        served: frames that can be carried out
    """
    of_domain: Dict[str, List[str]] = {}
    seen = set()
    for unit in units:
        frame = frames.get(unit.frame_name)
        if frame is None or frame.is_question or frame.name not in served or frame.name in seen or not unit.examples:
            continue
        seen.add(frame.name)
        domain = Path(frame.path).parents[1].name if len(Path(frame.path).parents) > 1 else ""
        text = unit.examples[0].text
        of_domain.setdefault(domain, []).append(with_capital(text))
    found: List[str] = []
    while any(of_domain.values()):
        found += [examples.pop(0) for examples in of_domain.values() if examples]
    return tuple(found)
