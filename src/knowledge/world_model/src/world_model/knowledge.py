"""Changes of what the robot knows: the file of the world says one part, updates say the other.

Updates of this run are newer than those of earlier ones, whatever their stamps: each run may have a clock of its own,
and a simulated one begins at 0. Where something is and in which states it is may have changed since an earlier run; so
both keep the time at which they were learned.
"""

from dataclasses import dataclass, field, replace
from typing import Dict, FrozenSet, Iterable, List, Mapping, Optional, Tuple, Union

from world_model.world_object import FILE, Sort, WorldObject, is_id, mistakes

#: Objects that are stored; a snapshot has fewer.
MOST_STORED = 20000
#: Objects and ids of one update.
MOST_IN_AN_UPDATE = 5000
#: States of which an object has at most one.
OPPOSITES: Tuple[FrozenSet[str], ...] = (
    frozenset(["open", "closed", "ajar"]),
    frozenset(["locked", "unlocked"]),
    frozenset(["on", "off"]),
    frozenset(["full", "empty"]),
    frozenset(["clean", "dirty"]),
    frozenset(["standing", "sitting", "lying", "walking"]),
    frozenset(["awake", "asleep"]),
)
#: A clock that goes back by more than this, seconds, is the clock of another run.
_SET_BACK_S = 1.0
#: What stays where it is from run to run.
_FIXED = frozenset([Sort.PLACE, Sort.DOOR])
_OPPOSITES_OF: Mapping[str, FrozenSet[str]] = {word: words for words in OPPOSITES for word in words}


@dataclass(frozen=True)
class Update:
    """What somebody saw, did or was told: the message ``WorldUpdate``."""

    objects: Tuple[WorldObject, ...] = ()
    replaces: bool = False
    missing: Tuple[str, ...] = ()
    gone: Tuple[str, ...] = ()


@dataclass(frozen=True)
class Learned:
    """What updates said about one object, as it is stored.

    Attributes:
        about: what they said together
        is_whole: whether this is all that is known; otherwise it is laid over what the file says
        is_gone: whether the object of the file no longer exists
        place_s: Unix time at which its place was learned; 0 where the file says it, or nobody
        states_s: the same of its states
    """

    about: WorldObject
    is_whole: bool = False
    is_gone: bool = False
    place_s: float = 0.0
    states_s: float = 0.0

    def of_before(self) -> "Learned":
        """Return it as a later run knows it: older than everything that this one learns."""
        is_fixed = not self.about.is_placed or self.about.sort in _FIXED
        about = replace(
            self.about,
            stamp_s=0.0,
            place_of_before_s=0.0 if is_fixed else self.place_s,
            states_of_before_s=self.states_s if self.about.states else 0.0,
        )
        return replace(self, about=about)


@dataclass(frozen=True)
class Refused:
    """Why a part of an update is refused; ``position`` is None for the whole."""

    position: Optional[int]
    reason: str


@dataclass(frozen=True)
class Change:
    """What an accepted update changes: entries to store, and ids whose entries are no longer needed."""

    learned: Mapping[str, Learned] = field(default_factory=dict)
    forgotten: Tuple[str, ...] = ()

    @property
    def is_empty(self) -> bool:
        """Whether nothing changes."""
        return not self.learned and not self.forgotten


class Knowledge:
    """What the file says and what was learned, as one mapping of objects by id."""

    def __init__(self, of_file: Iterable[WorldObject] = (), learned: Mapping[str, Learned] = {}) -> None:
        """
        Args:
            of_file: what the file of the world says
            learned: by earlier runs
        """
        self._of_file = {one.id: replace(one, source=FILE, stamp_s=0.0) for one in of_file}
        self._learned: Dict[str, Learned] = dict(learned)
        self._objects: Dict[str, WorldObject] = {}
        self._clock_s = 0.0
        self._begin_run()

    def _begin_run(self) -> None:
        """What is known from now on was learned by earlier runs."""
        self._learned = {name: learned.of_before() for name, learned in self._learned.items()}
        self._clock_s = 0.0
        self._objects = {}
        for name in {**self._of_file, **self._learned}:
            self._lay_over(name)

    @property
    def objects(self) -> Mapping[str, WorldObject]:
        """The objects that exist, by id."""
        return self._objects

    def plan(self, update: Update, now_s: float, unix_s: float = 0.0) -> Union[Change, Tuple[Refused, ...]]:
        """Return what an update changes, or why it is refused as a whole; nothing is changed yet.

        Args:
            update: the update
            now_s: ROS time, for objects without a stamp, or with one of another clock
            unix_s: the time of day, for what a later run tells of it
        """
        refused = self._refused(update)
        if refused:
            return refused
        if 0.0 < now_s < self._clock_s - _SET_BACK_S:
            self._begin_run()
        self._clock_s = max(self._clock_s, now_s)
        changed: Dict[str, Learned] = {}
        for one in update.objects:
            stamped = _of_this_run(one, now_s)
            known = self._known(one.id, changed)
            if known is not None and stamped.stamp_s < known.stamp_s:
                continue
            before = changed.get(one.id) or self._learned.get(one.id)
            changed[one.id] = _learned(stamped, before, unix_s, replaces=update.replaces)
        for name in update.missing:
            known = self._known(name, changed)
            if known is not None:
                about = replace(known.without_place(), stamp_s=max(now_s, known.stamp_s))
                changed[name] = replace(self._times(name, changed), about=about, is_whole=True, place_s=0.0)
        gone = frozenset(update.gone)
        for name in update.gone:
            if name in self._of_file:
                changed[name] = Learned(WorldObject(name, stamp_s=max(now_s, 0.0)), is_gone=True)
            else:
                changed.pop(name, None)
        if gone:
            self._without_relations_to(gone, changed)
        return Change(changed, tuple(name for name in update.gone if name in self._learned and name not in changed))

    def forget(self) -> Change:
        """Return the change that leaves what the file says, and nothing else."""
        return Change(forgotten=tuple(self._learned))

    def apply(self, change: Change) -> None:
        """Make a change that has been stored."""
        for name in change.forgotten:
            self._learned.pop(name, None)
            self._lay_over(name)
        for name, learned in change.learned.items():
            self._learned[name] = learned
            self._lay_over(name)

    def _known(self, name: str, changed: Mapping[str, Learned]) -> Optional[WorldObject]:
        return self._seen(name, changed[name]) if name in changed else self._objects.get(name)

    def _without_relations_to(self, gone: FrozenSet[str], changed: Dict[str, Learned]) -> None:
        """Forget relations to objects that no longer exist."""
        for name in [*self._objects, *changed]:
            known = self._known(name, changed)
            if known is None or name in gone or not any(one.reference in gone for one in known.relations):
                continue
            left = tuple(relation for relation in known.relations if relation.reference not in gone)
            changed[name] = replace(self._times(name, changed), about=replace(known, relations=left), is_whole=True)

    def _times(self, name: str, changed: Mapping[str, Learned]) -> Learned:
        """Return what was learned of an object before, which has the times at which that was."""
        return changed.get(name) or self._learned.get(name) or Learned(WorldObject(name))

    def _refused(self, update: Update) -> Tuple[Refused, ...]:
        count = len(update.objects) + len(update.missing) + len(update.gone)
        if count > MOST_IN_AN_UPDATE:
            return (Refused(None, f"the update is about {count} objects, and may be about {MOST_IN_AN_UPDATE}"),)
        new = sum(1 for one in {one.id for one in update.objects} if one not in self._learned)
        if len(self._learned) + new > MOST_STORED:
            return (Refused(None, f"{MOST_STORED} objects are known, and no more can be stored"),)
        found: List[Refused] = []
        for position, one in enumerate(update.objects):
            reasons = mistakes(one)
            if one.source == FILE:
                reasons += (f'only the file of the world has the source "{FILE}"',)
            if reasons:
                found.append(Refused(position, "; ".join(reasons)))
        for position, name in enumerate((*update.missing, *update.gone), start=len(update.objects)):
            if not is_id(name):
                found.append(Refused(position, f"{name[:100]!r} is no id"))
        return tuple(found)

    def _lay_over(self, name: str) -> None:
        seen = self._seen(name, self._learned.get(name))
        if seen is None:
            self._objects.pop(name, None)
        else:
            self._objects[name] = seen

    def _seen(self, name: str, learned: Optional[Learned]) -> Optional[WorldObject]:
        of_file = self._of_file.get(name)
        if learned is None:
            return of_file
        if learned.is_gone:
            return None
        return learned.about if learned.is_whole or of_file is None else merged(of_file, learned.about)


def _of_this_run(one: WorldObject, now_s: float) -> WorldObject:
    """Return an object of an update with a stamp of the clock of this run; nothing was seen later than now."""
    stamp_s = min(one.stamp_s, now_s) if now_s > 0.0 and one.stamp_s else one.stamp_s or max(now_s, 0.0)
    return replace(one, stamp_s=stamp_s, place_of_before_s=0.0, states_of_before_s=0.0)


def _learned(said: WorldObject, before: Optional[Learned], unix_s: float, *, replaces: bool) -> Learned:
    """Return what is stored of an object after an update said something."""
    place_s, states_s = unix_s if said.is_placed else 0.0, unix_s if said.states else 0.0
    if replaces or (before is not None and before.is_gone):
        return Learned(said, is_whole=True, place_s=place_s, states_s=states_s)
    if before is None:
        return Learned(said, place_s=place_s, states_s=states_s)
    return replace(
        before,
        about=merged(before.about, said),
        place_s=place_s or before.place_s,
        states_s=states_s or before.states_s,
    )


def merged(known: WorldObject, said: WorldObject) -> WorldObject:
    """Return what is known after somebody said more; an empty attribute leaves what is known.

    States of an earlier run are not mixed with what this one says: nobody could say which of them still hold.
    """
    is_placed = said.is_placed
    is_mixed = bool(known.states_of_before_s) and not said.states_of_before_s and bool(said.states)
    states = () if is_mixed else known.states
    words = {relation.relation for relation in said.relations}
    kept = tuple(
        one for one in known.relations if one.relation not in words and not (is_placed and one in known.places)
    )
    opposed = frozenset(word for state in said.states for word in _OPPOSITES_OF.get(state, (state,)))
    return replace(
        said,
        # A perceiver that does not know better says "thing".
        sort=known.sort if said.sort is WorldObject.sort else said.sort,
        name=said.name or known.name,
        other_names=said.other_names or known.other_names,
        category=said.category or known.category,
        attributes=said.attributes or known.attributes,
        size_m=said.size_m if any(said.size_m) else known.size_m,
        pose=said.pose if is_placed else known.pose,
        relations=kept + said.relations,
        states=tuple(state for state in states if state not in opposed) + said.states,
        source=said.source or known.source,
        place_of_before_s=said.place_of_before_s if is_placed else known.place_of_before_s,
        states_of_before_s=said.states_of_before_s if said.states else known.states_of_before_s,
    )
