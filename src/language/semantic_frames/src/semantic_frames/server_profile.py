"""Profiles of action servers: what a server states about itself when it registers for a frame."""

import enum
import json
import math
from dataclasses import dataclass, replace
from typing import FrozenSet, Iterable, List, Optional, Sequence, Tuple

from checked_files.marked_yaml import NAME_EXPECTED, did_you_mean, is_name
from semantic_frames.extra_thematic import extra_thematic_names, extra_thematic_of_arguments
from semantic_frames.frame import SemanticFrame
from semantic_frames.semantic_type import SEMANTIC_TYPES, with_parents
from typed_arguments import TypedArgument
from typed_arguments.attribute_names import RELATIONS

#: The only type of goals that the executor sends.
ACTION_TYPE = "roboframenet_msgs/FilledSemanticFrameAction"
#: In the place of resources: the goals of the server occupy none.
NOTHING = "nothing"
#: Entries of each list of a profile; profiles come from the wire.
MOST_ENTRIES = 200


class Purpose(enum.IntEnum):
    """What goals of a server do; the numbers are those of the message ``ServerProfile``."""

    ACTS = 0
    WATCHES = 1


@dataclass(frozen=True)
class HeededElement:
    """Arguments of one element that a server heeds; an empty list restricts nothing.

    Attributes:
        name: of an extra-thematic element ("Manner") or of an element of the frame ("goal")
        relations: "on", "in"
        values: lemmas of the head ("slow", "quick"), or whole phrases without an article ("half speed")
        semantic_types: "Container"; a type below it is heeded too
        most: things at a time; 0 for any number
    """

    name: str
    relations: Tuple[str, ...] = ()
    values: Tuple[str, ...] = ()
    semantic_types: Tuple[str, ...] = ()
    most: int = 0

    def fits(self, argument: TypedArgument) -> bool:
        """Whether it heeds everything that was said in an argument."""
        if self.most and (len(argument.members) or argument.count or 1) > self.most:
            return False
        if argument.members:
            return all(self.fits(_as_member(member, argument)) for member in argument.members)
        if self.relations and argument.relation and argument.relation not in self.relations:
            return False
        # "A slow pace" is listed as "slow pace".
        phrase = argument.text.partition(" ")[2] if argument.quantifier else ""
        said = spellings(argument.text, phrase, argument.head, argument.lemma)
        if self.values and said.isdisjoint(value.lower() for value in self.values):
            return False
        kind = argument.semantic_type
        if not self.semantic_types or kind not in SEMANTIC_TYPES:
            return True
        return not with_parents(kind).isdisjoint(self.semantic_types)


def _as_member(member: TypedArgument, of: TypedArgument) -> TypedArgument:
    """Return a member with the relation that was said once for the whole list."""
    if member.relation or not of.relation:
        return member
    return replace(member, relation=of.relation)


def spellings(*words: str) -> FrozenSet[str]:
    """Return the forms in which a server may list words: "quickly" and "quick", in lower case."""
    said = frozenset(word.lower() for word in words if word)
    return said.union(*(_adjectives(word) for word in said))


def _adjectives(adverb: str) -> Tuple[str, ...]:
    """Return the adjectives that an adverb may come from: "quick", "gentle", "steady"."""
    if not adverb.endswith("ly"):
        return ()
    stem = adverb[:-2]
    return (stem, stem + "le", stem[:-1] + "y") if stem.endswith("i") else (stem, stem + "le")


@dataclass(frozen=True)
class ServerSetting:
    """A setting of another node that a server needs; the value is a JSON scalar."""

    node: str
    name: str
    value: str


@dataclass(frozen=True)
class ServerProfile:
    """Properties of an action server. The default values are those of a server that registered as in 2012.

    Attributes:
        purpose: whether it acts or watches a condition
        action_type: type of its action; empty for :data:`ACTION_TYPE`
        robot: name of its robot; empty for the robot of its namespace
        heeds: the extra-thematic elements that it heeds, and elements of the frame of which it heeds less than the
            frame declares; "Manner" stands for an element "manner" of the frame too
        unheeded: elements of the frame that it does not heed at all
        occupies: resources that its goals occupy ("base", "arms"), or :data:`NOTHING`; empty for all of them when it
            acts, and for none when it watches
        settings: settings of other nodes that a goal needs
        longest_goal_s: a goal that takes longer has failed; 0 for the limit of the executor
        longest_silence_s: a condition that is silent for longer is dead; 0 for the limit of the executor
    """

    purpose: Purpose = Purpose.ACTS
    action_type: str = ""
    robot: str = ""
    heeds: Tuple[HeededElement, ...] = ()
    unheeded: Tuple[str, ...] = ()
    occupies: Tuple[str, ...] = ()
    settings: Tuple[ServerSetting, ...] = ()
    longest_goal_s: float = 0.0
    longest_silence_s: float = 0.0

    def heeded(self, name: str, frame: Optional[SemanticFrame]) -> Tuple[HeededElement, ...]:
        """Return what the server heeds of the arguments of an element.

        Args:
            name: of the arguments: that of an element of the frame, or of an extra-thematic element in lower case
            frame: the frame; None if no file describes it
        Returns:
            alternatives, one of which must fit; empty if the server heeds nothing of the element
        """
        if name in self.unheeded:
            return ()
        names = (name, extra_thematic_of_arguments().get(name))
        stated = tuple(heeded for heeded in self.heeds if heeded.name in names)
        is_inherited = names[1] is not None and (frame is None or frame.element(name) is None)
        return stated if stated or is_inherited else (HeededElement(name),)

    def heeds_argument(self, argument: TypedArgument, frame: Optional[SemanticFrame]) -> bool:
        """Whether the server heeds all of an argument; see :meth:`heeded`."""
        return any(heeded.fits(argument) for heeded in self.heeded(argument.name, frame))


#: The profile of a server that states nothing, as all did in 2012.
AS_IN_2012 = ServerProfile()


def profile_problems(profile: ServerProfile, frame: Optional[SemanticFrame]) -> Tuple[str, ...]:
    """Return what is wrong with a profile, in sentences without a full stop.

    Args:
        profile: of a server that registers
        frame: the frame; None while no file describes it
    """
    problems: List[str] = []
    if profile.action_type not in ("", ACTION_TYPE):
        problems.append(f"action_type: goals are of the type {ACTION_TYPE}, found '{profile.action_type}'")
    for key, entries in (("heeds", profile.heeds), ("unheeded", profile.unheeded), ("occupies", profile.occupies)):
        if len(entries) > MOST_ENTRIES:
            problems.append(f"{key}: {len(entries)} entries, expected at most {MOST_ENTRIES}")
    if problems:
        return tuple(problems)
    for heeded in profile.heeds:
        problems += _heeded_problems(heeded, frame)
    for name in profile.unheeded:
        problems += _unheeded_problems(name, profile, frame)
    for resource in (*profile.occupies, profile.robot):
        if not is_name(resource):
            problems.append(f"expected {NAME_EXPECTED}, found {resource[:40]!r}")
    if NOTHING in profile.occupies and len(profile.occupies) > 1:
        problems.append(f"occupies: '{NOTHING}' stands alone, found {', '.join(profile.occupies)}")
    if "" in profile.occupies:
        problems.append("occupies: the name of a resource is empty")
    for setting in profile.settings:
        if not setting.node or not setting.name or not is_json_scalar(setting.value):
            problems.append(
                f"settings: expected a node, a name and a JSON scalar, found '{setting.node}', '{setting.name}', "
                f"'{setting.value}'"
            )
    for key, seconds in (("longest_goal", profile.longest_goal_s), ("longest_silence", profile.longest_silence_s)):
        if not 0.0 <= seconds < math.inf:
            problems.append(f"{key}: expected seconds, 0 or more, found {seconds:g}")
    return tuple(problems)


def _heeded_problems(heeded: HeededElement, frame: Optional[SemanticFrame]) -> Iterable[str]:
    key = f"heeds '{heeded.name}'"
    element = frame.element(heeded.name) if frame is not None else None
    is_extra = heeded.name in extra_thematic_names()
    if not heeded.name or not is_name(heeded.name):
        yield f"heeds: expected {NAME_EXPECTED}, found {heeded.name[:40]!r}"
    elif element is None and not is_extra and frame is not None:
        names = [known.name for known in frame.frame_elements]
        hint = did_you_mean(heeded.name, [*names, *sorted(extra_thematic_names())])
        yield _with_hint(
            f"{key}: the frame {frame.name} has no such element, only {', '.join(names) or 'none'}, and it is no "
            f"extra-thematic element: {', '.join(sorted(extra_thematic_names()))}",
            hint,
        )
    known_relations = tuple(element.relations) if element is not None and element.relations else sorted(RELATIONS)
    yield from unknown_names(f"{key}: relation", heeded.relations, known_relations)
    yield from unknown_names(f"{key}: semantic type", heeded.semantic_types, sorted(SEMANTIC_TYPES))
    if element is not None and element.values:
        yield from unknown_names(f"{key}: value", heeded.values, element.values)
    if "" in heeded.values:
        yield f"{key}: a value is empty"
    if heeded.most < 0:
        yield f"{key}: most: expected 0 or more things, found {heeded.most}"


def _unheeded_problems(name: str, profile: ServerProfile, frame: Optional[SemanticFrame]) -> Iterable[str]:
    key = f"unheeded '{name}'"
    if any(heeded.name == name for heeded in profile.heeds):
        yield f"{key}: the server also states that it heeds it"
    element = frame.element(name) if frame is not None else None
    if frame is not None and element is None:
        names = [known.name for known in frame.frame_elements]
        yield _with_hint(f"{key}: the frame {frame.name} has no such element", did_you_mean(name, names))
    elif element is not None and element.is_core and not element.default:
        yield f"{key}: the frame cannot be carried out without its core element"


def unknown_names(what: str, said: Iterable[str], known: Sequence[str]) -> Iterable[str]:
    """Return a problem for each name that is not among the known ones."""
    for one in said:
        if one not in known:
            yield _with_hint(f"{what} '{one}' is unknown, expected one of {', '.join(known)}", did_you_mean(one, known))


def _with_hint(problem: str, hint: str) -> str:
    return f"{problem}; {hint}" if hint else problem


def is_json_scalar(text: str) -> bool:
    """Whether a text is a number, a text in quotes, true, false or null in JSON."""
    try:
        return not isinstance(json.loads(text), (dict, list))
    except ValueError:
        return False
