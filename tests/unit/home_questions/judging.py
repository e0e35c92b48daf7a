"""Asks questions about a scene, and judges answers by the scene alone: what must be said, and what would be invented.

Nothing here uses the world model or the framer: the truth comes from the state of the home and from what was seen.
"""

import random
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Callable, Dict, FrozenSet, Iterable, List, Mapping, Optional, Sequence, Tuple

import yaml

from home_questions.states import Scene
from roboframenet_sim.home_state import ROBOT, Entity

TEMPLATES: Mapping[str, Mapping[str, List[str]]] = yaml.safe_load(
    (Path(__file__).parent / "templates.yaml").read_text(encoding="utf-8")
)
_COLOURS = frozenset("red blue green white yellow brown black".split())
_NUMBERS = re.compile(r"\b\d+\b")
_UNKNOWN = re.compile(r"\b(not|no|nothing|nobody)\b")
#: Plural nouns that are counted, each with the categories and names that it stands for.
_COUNTED = {"books": "book", "mugs": "mug", "plates": "plate", "lamps": "lamp", "people": "person"}


@dataclass(frozen=True)
class Question:
    """A question, and what a right answer has.

    Attributes:
        kind: of the templates
        text: as it is asked
        must: of each group of words the answer has at least one
        names: names that the answer may have; every other name of the home would be invented
        colours: colours that the answer may have
        numbers: numbers that the answer may have
        verdict: "yes" or "no" at the beginning; "unknown": the answer must say that it is not known; empty for others
        noun: of what is asked for and not seen: the answer may name other things of this kind, if it says truly where
            each of them is
    """

    kind: str
    text: str
    must: Tuple[FrozenSet[str], ...] = ()
    names: FrozenSet[str] = frozenset()
    colours: FrozenSet[str] = frozenset()
    numbers: FrozenSet[str] = frozenset()
    verdict: str = ""
    noun: str = ""


@dataclass(frozen=True)
class Verdict:
    """Whether an answer is right, and what of it is invented."""

    is_right: bool
    invented: Tuple[str, ...] = ()


def judge(question: Question, answer: Optional[str], scene: Scene) -> Verdict:
    """Judge an answer; None stands for a question that was not understood."""
    if answer is None:
        return Verdict(False)
    said = answer.lower()
    begins = "yes" if said.startswith("yes") else "no" if said.startswith(("no,", "no.")) else ""
    true = _true_of_others(question.noun, said, scene)
    invented = [name for name in _names_in(said, scene) if name not in question.names | true]
    invented += [one for one in _COLOURS & set(re.findall(r"[a-z]+", said)) if one not in question.colours]
    if question.verdict != "unknown":
        invented += [one for one in _NUMBERS.findall(said) if one not in question.numbers]
    if begins and question.verdict in ("yes", "no") and begins != question.verdict:
        invented.append(begins)
    is_known = question.verdict in ("yes", "no")
    is_right = all(any(_has(said, word) for word in group) for group in question.must)
    if question.verdict == "unknown":
        is_right = _UNKNOWN.search(said) is not None
    elif is_known:
        is_right = is_right and (begins == question.verdict)
    return Verdict(is_right and not invented, tuple(invented))


def _true_of_others(noun: str, said: str, scene: Scene) -> FrozenSet[str]:
    """Return the names in what an answer says truly of other things of a kind: each is there, and was seen there.

    "I know of no cloth but the towel" says itself that the towel may be another kind.
    """
    found: FrozenSet[str] = frozenset()
    is_said = f"no {noun} but" in said
    for one in scene.entities("thing", "furniture") if noun else ():
        is_known = one.kind == "furniture" or scene.is_seen(one)
        if not is_known or not (is_said or one.category == noun or one.name.lower().endswith(f" {noun}")):
            continue
        room = scene.plan.entities[scene.room_of(one)]
        where = [room] if one.kind == "furniture" else [room, scene.plan.entities[scene.state.places[one.id].holder]]
        for name, place in ((name, place) for name in words_of(one) for place in words_of(room)):
            if re.search(rf"\b{re.escape(name)},?( which)? (is|are) (?:(?! and )[a-z ])*\b{re.escape(place)}\b", said):
                found |= _all_words([one, *where])
    return found


def _has(said: str, word: str) -> bool:
    return re.search(rf"\b{re.escape(word)}\b", said) is not None


def _names_in(said: str, scene: Scene) -> List[str]:
    """Return the names of the home in an answer, the longest first: "coffee table" is no "table"."""
    found: List[str] = []
    for name in sorted({name for one in scene.plan.entities.values() for name in words_of(one)}, key=len, reverse=True):
        pattern = rf"\b{re.escape(name)}(s|es)?\b"
        if re.search(pattern, said):
            found.append(name)
            said = re.sub(pattern, " ", said)
    return found


def words_of(one: Entity) -> FrozenSet[str]:
    """Return the names of an entity, and its category where it has no name of its own."""
    return frozenset(name.lower() for name in one.names) | (
        frozenset([one.category]) if one.kind == "thing" and one.category else frozenset()
    )


def _all_words(entities: Iterable[Entity]) -> FrozenSet[str]:
    return frozenset().union(*map(words_of, entities))


def _colours(entities: Iterable[Entity]) -> FrozenSet[str]:
    return frozenset(value for one in entities for name, value in one.attributes if name == "color")


def _height(one: Entity) -> float:
    return max(0.1, one.height_m)


def _volume(one: Entity) -> float:
    return (one.x_m[1] - one.x_m[0]) * (one.y_m[1] - one.y_m[0]) * _height(one)


class Asker:
    """Draws questions about a scene."""

    def __init__(self, scene: Scene, chance: random.Random, share: str) -> None:
        """
        Args:
            scene: the scene
            chance: draws the questions
            share: which phrasings: "tune" or "held"
        """
        self._scene = scene
        self._chance = chance
        self._share = share
        self._things = scene.entities("thing")
        self._seen = [one for one in self._things if scene.is_seen(one)]
        self._persons = [one for one in scene.entities("person") if scene.is_seen(one)]
        self._rooms = scene.entities("room")

    def ask(self, kind: str) -> Question:
        """Return a question of a kind."""
        makers: Dict[str, Callable[[str], Question]] = {
            "place": self._place,
            "place_of_person": self._place_of_person,
            "unseen": self._unseen,
            "contents": self._contents,
            "number": self._number,
            "who": self._who,
            "open": self._open,
            "running": self._running,
            "person_there": self._person_there,
            "thing_there": self._thing_there,
            "colour": self._colour,
            "biggest": self._biggest,
            "ranked": self._ranked,
            "height": self._height,
            "comparison": self._comparison,
            "choice": self._choice,
            "more": self._more,
            "own_place": self._own_place,
        }
        return makers[kind](kind)

    def _text(self, kind: str, **slots: str) -> str:
        return self._chance.choice(TEMPLATES[kind][self._share]).format(**slots)

    def _holder(self, thing: Entity) -> Entity:
        return self._scene.plan.entities[self._scene.state.places[thing.id].holder]

    def _relation(self, thing: Entity) -> str:
        return self._scene.state.places[thing.id].relation

    def _unique(self, things: Sequence[Entity]) -> List[Entity]:
        """Return those that nothing else in the home is called like."""
        entities = self._scene.plan.entities.values()
        return [one for one in things if not any(one.name in words_of(other) for other in entities if other != one)]

    def _place_question(self, kind: str, one: Entity, holders: List[Entity], text: str) -> Question:
        room = self._scene.plan.entities[self._scene.room_of(one)]
        where = [*holders, room]
        names = _all_words([one, *where])
        return Question(kind, text, (_all_words(where),), names, _colours([one]))

    def _place(self, kind: str) -> Question:
        one = self._chance.choice(self._unique(self._seen))
        return self._place_question(kind, one, [self._holder(one)], self._text(kind, thing=one.name))

    def _place_of_person(self, kind: str) -> Question:
        if not self._persons:
            return self._own_place("own_place")
        one = self._chance.choice(self._persons)
        return self._place_question(kind, one, [], self._text(kind, person=one.name))

    def _unseen(self, kind: str) -> Question:
        unseen = self._unique([one for one in self._things if not self._scene.is_seen(one)])
        one = self._chance.choice(unseen)
        text = self._text(kind, thing=one.name)
        return Question(kind, text, names=words_of(one), verdict="unknown", noun=one.name.lower())

    def _contents(self, kind: str) -> Question:
        holders = [one for one in self._scene.entities("furniture") if {"surface", "container"} & one.traits]
        holder = self._chance.choice(self._unique(holders))
        relation = "on" if "surface" in holder.traits else "in"
        things = [one for one in self._seen if self._holder(one) == holder and self._relation(one) == relation]
        text = self._text(kind, relation=relation, holder=holder.name)
        names = _all_words([holder, *things])
        numbers = frozenset(map(str, range(1, len(things) + 1)))
        if not things:
            return Question(kind, text, names=names, verdict="unknown")
        return Question(kind, text, tuple(map(words_of, things)), names, _colours(things), numbers)

    def _number(self, kind: str) -> Question:
        room = self._chance.choice(self._rooms)
        plural = self._chance.choice(sorted(_COUNTED))
        noun = _COUNTED[plural]
        counted = [
            one
            for one in self._scene.plan.entities.values()
            if (noun in one.names or noun == one.category)
            and self._scene.room_of(one) == room.id
            # The map has all furniture.
            and (self._scene.is_seen(one) or one.kind == "furniture")
        ]
        text = self._text(kind, plural=plural, room=room.name)
        names = words_of(room) | {noun}
        if not counted:
            return Question(kind, text, names=names, verdict="unknown")
        return Question(kind, text, (frozenset([str(len(counted))]),), names, numbers=frozenset([str(len(counted))]))

    def _who(self, kind: str) -> Question:
        room = self._chance.choice(self._rooms)
        persons = [one for one in self._persons if self._scene.room_of(one) == room.id]
        text = self._text(kind, room=room.name)
        names = _all_words([room, *persons])
        if not persons:
            return Question(kind, text, names=names, verdict="unknown")
        return Question(kind, text, tuple(map(words_of, persons)), names)

    def _yes_or_no(
        self, kind: str, text: str, one: Entity, is_true: bool, is_known: bool, names: FrozenSet[str]
    ) -> Question:
        verdict = ("yes" if is_true else "no") if is_known else "unknown"
        return Question(kind, text, names=names, colours=_colours([one]), verdict=verdict)

    def _open(self, kind: str) -> Question:
        portals = [
            one
            for one in self._scene.plan.entities.values()
            if "closable" in one.traits and one.kind in ("door", "furniture")
        ]
        one = self._chance.choice(self._unique(portals))
        text = self._text(kind, portal=one.name)
        is_open = self._scene.state.is_(one.id, "is_open")
        names = words_of(one) | _all_words(room for room in self._rooms if room.id in one.rooms)
        if "open or closed" in text:
            if not self._scene.is_seen(one):
                return Question(kind, text, names=names, verdict="unknown")
            return Question(kind, text, (frozenset(["is open" if is_open else "is closed"]),), names)
        is_true = is_open != ("closed" in text)
        return self._yes_or_no(kind, text, one, is_true, self._scene.is_seen(one), names)

    def _running(self, kind: str) -> Question:
        devices = [one for one in self._scene.entities("furniture") if "switch" in one.traits]
        one = self._chance.choice(self._unique(devices))
        text = self._text(kind, device=one.name)
        is_true = self._scene.state.is_(one.id, "is_on") != (" off" in text)
        return self._yes_or_no(kind, text, one, is_true, self._scene.is_seen(one), words_of(one))

    def _person_there(self, kind: str) -> Question:
        one = self._chance.choice(self._scene.entities("person"))
        here = self._scene.plan.entities[self._scene.room_of(one)]
        room = self._chance.choice([here, self._chance.choice(self._rooms)])
        text = self._text(kind, person=one.name, room=room.name)
        is_known = self._scene.is_seen(one)
        names = _all_words([one, room, here] if is_known else [one, room])
        return self._yes_or_no(kind, text, one, room == here, is_known, names)

    def _thing_there(self, kind: str) -> Question:
        one = self._chance.choice(self._unique(self._seen))
        here = self._holder(one)
        others = [other for other in self._unique(self._scene.entities("furniture")) if "surface" in other.traits]
        holder = self._chance.choice([here, self._chance.choice(others)])
        relation = self._relation(one) if holder == here else "on"
        text = self._text(kind, thing=one.name, relation=relation, holder=holder.name)
        room = self._scene.plan.entities[self._scene.room_of(one)]
        return self._yes_or_no(kind, text, one, holder == here, True, _all_words([one, holder, here, room]))

    def _colour(self, kind: str) -> Question:
        one = self._chance.choice(self._unique(self._seen))
        text = self._text(kind, thing=one.name)
        colours = _colours([one])
        if not colours:
            return Question(kind, text, names=words_of(one), verdict="unknown")
        return Question(kind, text, (colours,), words_of(one), colours)

    def _biggest(self, kind: str) -> Question:
        sized: Dict[str, List[Entity]] = {}
        for one in self._scene.entities("furniture"):
            sized.setdefault(one.room, []).append(one)
        room = self._scene.plan.entities[self._chance.choice(sorted(sized))]
        text = self._text(kind, room=room.name)
        most = (min if "smallest" in text else max)(sized[room.id], key=_volume)
        return Question(kind, text, (words_of(most),), _all_words([most, room]), _colours([most]))

    def _ranked(self, kind: str) -> Question:
        rooms = [[one for one in self._scene.entities("furniture") if one.room == room.id] for room in self._rooms]
        furniture = self._chance.choice([found for found in rooms if len(found) > 2])
        room = self._scene.plan.entities[furniture[0].room]
        text = self._text(kind, room=room.name)
        measured = sorted(furniture, key=_height if "tall" in text else _volume, reverse=True)
        second = measured[2 if "third" in text else 1]
        same = [one for one in measured if abs(_height(one) - _height(second)) < 0.01] if "tall" in text else [second]
        return Question(kind, text, (_all_words(same),), _all_words([*same, room]), _colours(same))

    def _height(self, kind: str) -> Question:
        one = self._chance.choice(self._unique(self._scene.entities("furniture")))
        height_m = _height(one)
        said = f"{height_m:.2f}" if height_m < 1.0 else f"{height_m:.1f}"
        numbers = frozenset(_NUMBERS.findall(said))
        return Question(kind, self._text(kind, thing=one.name), (frozenset([said]),), words_of(one), numbers=numbers)

    def _two(self, text: str) -> Tuple[Entity, Entity, bool]:
        """Return two pieces of furniture of a different measure, and whether the first has more of it."""
        measure = _height if re.search("tall|high|low", text) else _volume
        things = self._unique(self._scene.entities("furniture"))
        one = self._chance.choice(things)
        # What differs by a hair is the same to whoever looks.
        others = [other for other in things if not 0.9 < measure(one) / measure(other) < 1.1]
        other = self._chance.choice(others)
        return one, other, (measure(one) > measure(other)) != bool(re.search("small|low", text))

    def _comparison(self, kind: str) -> Question:
        text = self._text(kind, thing="{thing}", other="{other}")
        one, other, is_more = self._two(text)
        text = text.format(thing=one.name, other=other.name)
        return Question(kind, text, names=_all_words([one, other]), verdict="yes" if is_more else "no")

    def _choice(self, kind: str) -> Question:
        text = self._text(kind, thing="{thing}", other="{other}")
        one, other, is_more = self._two(text)
        most = one if is_more else other
        return Question(kind, text.format(thing=one.name, other=other.name), (words_of(most),), words_of(most))

    def _more(self, kind: str) -> Question:
        first, second = self._chance.sample(sorted(_COUNTED), 2)
        room = self._chance.choice(self._rooms)
        text = self._text(kind, plural=first, other=second, room=room.name)
        counts = [
            sum(
                (_COUNTED[plural] in one.names or _COUNTED[plural] == one.category)
                and (self._scene.is_seen(one) or one.kind == "furniture")
                and (room.name not in text or self._scene.room_of(one) == room.id)
                for one in self._scene.plan.entities.values()
            )
            for plural in (first, second)
        ]
        is_more = counts[0] < counts[1] if "fewer" in text else counts[0] > counts[1]
        names = words_of(room) | {_COUNTED[first], _COUNTED[second]}
        numbers = frozenset(map(str, counts))
        return Question(kind, text, names=names, numbers=numbers, verdict="yes" if is_more else "no")

    def _own_place(self, kind: str) -> Question:
        room = self._scene.plan.entities[self._scene.plan.room_at(self._scene.plan.position(self._scene.state, ROBOT))]
        return Question(kind, self._text(kind), (words_of(room),), words_of(room))
