"""What a perceiver believes of the things that it saw: where they are, and how sure it is that they are there.

Sightings of one thing are one object. Each sighting adds to the log-odds that it is there, and each look that should
have shown it and did not takes from them. Images that follow each other quickly show the same, so evidence counts once
in a period.
"""

import math
from dataclasses import dataclass, field, replace
from typing import Dict, List, Mapping, Optional, Sequence, Set, Tuple

from object_perception.camera import View
from object_perception.geometry import Vector, distance_m
from roboframenet_ros.parameters import Parameters, parameter
from world_model.knowledge import Update
from world_model.world_object import Pose, Sort, WorldObject

#: Log-odds go no further: what is sure can be lost again.
_MOST_SURE = math.log(0.98 / 0.02)
#: No single look is more certain than this.
_MOST_OF_ONE = 0.9
#: Before the first sighting: detectors see things that are not there.
_BEFORE = math.log(0.3 / 0.7)
#: A place moves towards a new sighting at least by this part of the way.
_LEAST_GAIN = 0.3


@dataclass(frozen=True)
class BeliefSettings(Parameters):
    """The parameters that all perceivers have, after validation.

    Attributes:
        world_frame: the frame in which things are told
        least_score: a detection with a lower score is no sighting
        merge_m: sightings of one category that are no further apart are of one object, metres; large things, half their
            size
        tell_at: an object is told from this probability on
        forget_at: below this probability it is told to be missing
        missed_score: the probability that a thing is there after a look that should have shown it and did not
        evidence_period_s: evidence counts once in this time, and a look that misses a thing only when no other one has
            shown it for so long, seconds
        forget_after_s: what nobody saw for so long is told to be missing, seconds
        tell_moved_m: an object is told again when it has moved so far, metres
        tell_again_s: an object that stays is told again after this time, seconds

    Raises:
        ParameterError: a value is not allowed
    """

    world_frame: str = parameter("map", may_be_empty=False)
    least_score: float = parameter(0.5, least=0.5, most=1.0)
    merge_m: float = parameter(0.25, least=0.01, most=5.0)
    tell_at: float = parameter(0.8, least=0.5, most=0.97)
    forget_at: float = parameter(0.2, least=0.03, most=0.5)
    missed_score: float = parameter(0.2, least=0.05, most=0.45)
    evidence_period_s: float = parameter(0.5, least=0.0, most=60.0)
    forget_after_s: float = parameter(3600.0, least=1.0, most=10000000.0)
    tell_moved_m: float = parameter(0.05, least=0.001, most=5.0)
    tell_again_s: float = parameter(10.0, least=0.1, most=3600.0)


@dataclass(frozen=True)
class Sighting:
    """One thing that one look showed.

    Attributes:
        about: category, sort, pose and size; its id is empty if the look does not say which thing it is
        score: how sure the detector is, 0 to 1
    """

    about: WorldObject
    score: float


@dataclass
class _Belief:
    """What is believed of one object."""

    about: WorldObject
    odds: float
    sightings: int = 0
    seen_s: float = 0.0
    evidence_s: float = -math.inf
    told: Optional[WorldObject] = None
    #: Whether the world has shown it, so that its absence there means something.
    is_in_world: bool = False

    @property
    def probability(self) -> float:
        return 1.0 / (1.0 + math.exp(-self.odds))


@dataclass
class _Changes:
    told: List[WorldObject] = field(default_factory=list)
    missing: List[str] = field(default_factory=list)
    gone: List[str] = field(default_factory=list)

    def update(self) -> Update:
        return Update(tuple(self.told), missing=tuple(self.missing), gone=tuple(self.gone))


class Beliefs:
    """The objects of one perceiver. Not thread-safe."""

    def __init__(self, settings: BeliefSettings, source: str) -> None:
        """
        Args:
            settings: when sightings are one object, when it is told and when forgotten
            source: name of the node; ids of things that nobody else named begin with it
        """
        self._settings = settings
        self._source = source
        self._beliefs: Dict[str, _Belief] = {}
        self._world: Mapping[str, WorldObject] = {}
        #: Own things whose place nobody knows, with their category; the last one last.
        self._missed: Dict[str, str] = {}
        #: Those of them that the world may still show at their old place, as it has not heard of it.
        self._just_missed: Set[str] = set()
        self._used: Set[str] = set()

    def know(self, objects: Sequence[WorldObject]) -> Update:
        """Take what the world knows, as others may have named, moved or removed things. Returns what to tell it."""
        changes = _Changes()
        self._world = {one.id: one for one in objects}
        self._used.update(self._world)
        for name, belief in list(self._beliefs.items()):
            known = self._world.get(name)
            if known is None:
                if belief.is_in_world:
                    del self._beliefs[name]
                continue
            belief.is_in_world = True
            if known.source != self._source and known.stamp_s > belief.seen_s:
                self._follow(name, belief, known)
        for one in objects:
            if self._is_own(one.id) and one.id not in self._beliefs:
                self._remember(one)
        for name in list(self._beliefs):
            twin = self._twin_of(name)
            if twin is not None:
                belief = self._beliefs.pop(name)
                about = replace(belief.about, id=twin.id)
                self._beliefs[twin.id] = replace(belief, about=about, told=twin, is_in_world=True)
                changes.gone.append(name)
        return changes.update()

    def _follow(self, name: str, belief: _Belief, known: WorldObject) -> None:
        """Believe where another source says that a thing is, or that it is carried."""
        if known.pose is None or known.pose.frame_id != self._settings.world_frame:
            del self._beliefs[name]
        else:
            belief.about = replace(belief.about, pose=known.pose)
            belief.told = known

    def _is_own(self, name: str) -> bool:
        return name.startswith(f"{self._source}/")

    def _remember(self, one: WorldObject) -> None:
        """Take up what this perceiver told before, also before it was started again."""
        if not one.is_placed:
            self._just_missed.discard(one.id)
            self._missed.setdefault(one.id, one.category)
        elif one.id not in self._just_missed:
            self._missed.pop(one.id, None)
            if one.pose is not None and one.pose.frame_id == self._settings.world_frame:
                odds = _logit(self._settings.tell_at)
                self._beliefs[one.id] = _Belief(one, odds, 1, one.stamp_s, told=one, is_in_world=True)

    def _twin_of(self, name: str) -> Optional[WorldObject]:
        """Return what another perceiver named at the same time, for one that was named here; the first id stays."""
        belief = self._beliefs[name]
        if not self._is_own(name) or belief.told is None or not belief.is_in_world:
            return None
        near = self._known_near(belief.about)
        return near if near is not None and near.id < name else None

    def see(self, sightings: Sequence[Sighting], view: View, now_s: float) -> Update:
        """Take one look.

        Args:
            sightings: all that it showed, in the frame of the world
            view: what else it could have shown
            now_s: when it was, ROS time
        Returns:
            what to tell the world
        """
        seen = [one for one in sightings if one.score >= self._settings.least_score and one.about.pose is not None]
        found: Set[str] = set()
        for sighting, name in self._assigned(seen):
            self._merge(name, sighting, now_s)
            found.add(name)
        for name, belief in self._beliefs.items():
            # A detector misses a thing now and then: no evidence between two sightings.
            is_overdue = now_s - belief.seen_s >= self._settings.evidence_period_s
            if name not in found and is_overdue and view.shows(_middle(belief.about)):
                self._weigh(belief, self._settings.missed_score, now_s)
        return self._changes(now_s)

    def pass_time(self, now_s: float) -> Update:
        """Forget what nobody saw for long. Returns what to tell the world."""
        return self._changes(now_s)

    def _assigned(self, sightings: Sequence[Sighting]) -> List[Tuple[Sighting, str]]:
        """Return the id of the object of each sighting: the nearest pairs first, and one object for each sighting."""
        found = [(one, one.about.id) for one in sightings if one.about.id]
        left = [one for one in sightings if not one.about.id]
        pairs = sorted(
            (distance, index, name)
            for index, one in enumerate(left)
            for name, belief in self._beliefs.items()
            for distance in [self._distance(one.about, belief.about)]
            if distance is not None
        )
        taken_sightings: Set[int] = set()
        taken = {name for _, name in found}
        for _, index, name in pairs:
            if index not in taken_sightings and name not in taken:
                taken_sightings.add(index)
                taken.add(name)
                found.append((left[index], name))
        for index, one in enumerate(left):
            if index not in taken_sightings:
                found.append((one, self._name_of_new(one.about)))
        return found

    def _distance(self, seen: WorldObject, known: WorldObject) -> Optional[float]:
        """Return how far two things are from each other; None if they are not the same."""
        if seen.category != known.category:
            return None
        distance = distance_m(_position(seen), _position(known))
        return distance if distance <= self._reach(known) else None

    def _reach(self, one: WorldObject) -> float:
        return max(self._settings.merge_m, max(one.size_m[:2]) / 2.0)

    def _known_near(self, about: WorldObject) -> Optional[WorldObject]:
        """Return what others told of a thing there; its height may be that of the table below it."""
        near = [
            (one.pose.distance_m(about.pose), one)
            for one in self._world.values()
            if one.category == about.category and one.id not in self._beliefs and one.pose and about.pose
        ]
        reached = [(distance, one.id, one) for distance, one in near if distance <= self._reach(one)]
        return min(reached)[2] if reached else None

    def _name_of_new(self, about: WorldObject) -> str:
        """Return the id of a thing that is believed for the first time, and begin the belief."""
        known = self._known_near(about)
        missed = [name for name, category in self._missed.items() if category == about.category]
        if known is not None:
            name = known.id
        elif missed:
            # What is missed there has been moved here: nobody can tell it from another one.
            name = missed[-1]
            del self._missed[name]
            self._just_missed.discard(name)
        else:
            name = self._new_name(about.category)
        self._beliefs[name] = _Belief(replace(about, id=name), _BEFORE, told=known, is_in_world=known is not None)
        return name

    def _new_name(self, category: str) -> str:
        stem = f"{self._source}/{'_'.join(category.split()) or 'thing'}"
        number = 1
        while f"{stem}_{number}" in self._used:
            number += 1
        self._used.add(f"{stem}_{number}")
        return f"{stem}_{number}"

    def _merge(self, name: str, sighting: Sighting, now_s: float) -> None:
        """Believe a sighting of an object."""
        belief = self._beliefs.setdefault(name, _Belief(sighting.about, _BEFORE))
        before, after = _position(belief.about), _position(sighting.about)
        belief.sightings += 1
        is_moved = distance_m(before, after) > self._reach(belief.about)
        gain = 1.0 if is_moved else max(1.0 / belief.sightings, _LEAST_GAIN)
        x, y, z = (old + gain * (new - old) for old, new in zip(before, after))
        turn = sighting.about.pose.orientation if sighting.about.pose else (0.0, 0.0, 0.0, 1.0)
        size = sighting.about.size_m if any(sighting.about.size_m) else belief.about.size_m
        belief.about = replace(
            sighting.about, id=name, size_m=size, pose=Pose(self._settings.world_frame, x, y, z, turn)
        )
        belief.seen_s = max(belief.seen_s, now_s)
        self._weigh(belief, sighting.score, now_s)

    def _weigh(self, belief: _Belief, probability: float, now_s: float) -> None:
        """Count evidence, unless the last one is too young to be another one."""
        if now_s < belief.evidence_s:
            belief.evidence_s = -math.inf  # the clock was set back
        if now_s - belief.evidence_s < self._settings.evidence_period_s:
            return
        belief.evidence_s = now_s
        odds = belief.odds + _logit(min(probability, _MOST_OF_ONE))
        belief.odds = max(-_MOST_SURE, min(_MOST_SURE, odds))

    def _changes(self, now_s: float) -> Update:
        changes = _Changes()
        for name, belief in list(self._beliefs.items()):
            is_old = belief.seen_s > 0.0 and now_s - belief.seen_s > self._settings.forget_after_s
            if is_old or belief.probability < self._settings.forget_at:
                del self._beliefs[name]
                self._forget(name, belief, changes)
            elif belief.probability >= self._settings.tell_at and self._is_new(belief, now_s):
                belief.told = replace(belief.about, source=self._source, stamp_s=belief.seen_s)
                changes.told.append(belief.told)
        return changes.update()

    def _forget(self, name: str, belief: _Belief, changes: _Changes) -> None:
        """Tell that a thing is missing, if it was told; its name is for it when it is seen elsewhere."""
        if belief.told is not None:
            changes.missing.append(name)
            self._just_missed.add(name)
        if self._is_own(name):
            if belief.told is not None or name in self._world:
                self._missed[name] = belief.about.category
            else:
                self._used.discard(name)

    def _is_new(self, belief: _Belief, now_s: float) -> bool:
        if belief.sightings == 0 or belief.seen_s == 0.0:
            return False
        if belief.told is None or belief.told.pose is None or belief.told.source != self._source:
            return True
        moved = distance_m(_position(belief.told), _position(belief.about)) >= self._settings.tell_moved_m
        return moved or belief.seen_s - belief.told.stamp_s >= self._settings.tell_again_s


def sighting_of(category: str, score: float, pose: Pose, size_m: Vector = (0.0, 0.0, 0.0)) -> Sighting:
    """Return a sighting of a thing of a category, or of a person."""
    sort = Sort.PERSON if category == "person" else Sort.THING
    return Sighting(WorldObject("", sort, category=category, size_m=size_m, pose=pose), score)


def _logit(probability: float) -> float:
    return math.log(probability / (1.0 - probability))


def _position(one: WorldObject) -> Vector:
    return (one.pose.x_m, one.pose.y_m, one.pose.z_m) if one.pose else (math.nan,) * 3


def _middle(one: WorldObject) -> Vector:
    x, y, z = _position(one)
    return (x, y, z + one.size_m[2] / 2.0)
