"""What fills the slots of a command: the rooms, furniture, things and persons of a home file, by their usual names."""

import random
from dataclasses import dataclass
from typing import Any, Dict, FrozenSet, List, Mapping, Sequence, Tuple

#: What a hand holds, kg; the robot of the home lifts no more.
MOST_KG = 2.5
#: Plurals of the home's categories, as people say them.
PLURALS: Mapping[str, str] = {
    "fruit": "fruits",
    "vegetable": "vegetables",
    "drink": "drinks",
    "toy": "toys",
    "book": "books",
    "cup": "cups",
}
#: Marks a category, which may be called like a thing.
KIND = "kind:"
#: Who is a woman and who is a man, for pronouns; a name says it to everybody.
GENDERS: Mapping[str, str] = {"Anna": "female", "Alice": "female", "Bob": "male"}
_PLACES_OF_PEOPLE = ("table", "sofa", "counter", "bed", "desk", "shelf", "sink", "wardrobe", "machine", "tub")


@dataclass(frozen=True)
class Value:
    """What fills a slot.

    Attributes:
        text: as it is said
        ident: id of the home, or a category
        gender: of a person
    """

    text: str
    ident: str
    gender: str = ""


class HomeSlots:
    """The values of slots.

    Args:
        home: content of the home file
        speaker: id of the person who speaks: not a third person
        sayings: what may be told: "the time"
    """

    def __init__(self, home: Mapping[str, Any], *, speaker: str, sayings: Sequence[str]) -> None:
        self.home = home
        self.speaker = speaker
        self._values: Dict[str, List[Value]] = {
            "name": [
                Value(one["names"][0], ident, GENDERS.get(one["names"][0], ""))
                for ident, one in home["persons"].items()
                if ident != speaker
            ],
            "room": [Value(one["names"][0], ident) for ident, one in home["rooms"].items()],
            "beacon": [
                Value(one["names"][0], ident)
                for ident, one in home["furniture"].items()
                if one.get("category") in _PLACES_OF_PEOPLE and "flat" not in one["traits"]
            ],
            "placement": [
                Value(one["names"][0], ident) for ident, one in home["furniture"].items() if "surface" in one["traits"]
            ],
            "object": [Value(one["names"][0], ident) for ident, one in self._handy().items()],
            "whattosay": [Value(one, f'"{one}"') for one in sayings],
            "category": [Value(plural, f"{KIND}{category}") for category, plural in PLURALS.items()],
            "object?": [Value(category, f"{KIND}{category}") for category in PLURALS],
            "question": [Value("question", "question")],
        }

    def _handy(self) -> Dict[str, Mapping[str, Any]]:
        """Return the things that a hand takes, and that nothing else is called like."""
        things = {ident: one for ident, one in self.home["things"].items() if one["mass_kg"] <= MOST_KG}
        names = [name for one in self.home["things"].values() for name in one["names"]]
        furniture = {name for one in self.home["furniture"].values() for name in one["names"]}
        return {
            ident: one
            for ident, one in things.items()
            if names.count(one["names"][0]) == 1
            and one["names"][0] not in furniture
            and "attached_to" not in one
            # Soup stays in its pot.
            and one.get("in") not in things
        }

    def choose(self, kind: str, chance: random.Random, taken: FrozenSet[str]) -> Value:
        """Draw a value that is not taken yet.

        Raises:
            LookupError: there is none
        """
        values = [one for one in self._values.get(kind, []) if one.ident not in taken]
        if not values:
            raise LookupError(kind)
        return chance.choice(values)

    def of_category(self, category: str) -> Tuple[str, ...]:
        """Return the ids of the things of a category; of an id, itself; nothing for what the home has not."""
        things = self.home["things"]
        kind = category[len(KIND) :] if category.startswith(KIND) else ""
        return tuple(ident for ident, one in things.items() if ident == category or one["category"] == kind)

    def room_of(self, place: str) -> str:
        """Return the room of furniture, of a thing as the file has it, or the room itself."""
        if place in self.home["rooms"]:
            return place
        if place in self.home["furniture"]:
            return str(self.home["furniture"][place]["room"])
        thing = self.home["things"][place]
        return self.room_of(str(thing.get("on") or thing.get("in") or thing.get("under") or thing.get("beside")))

    def is_place(self, ident: str) -> bool:
        """Whether an id is that of a room or of furniture."""
        return ident in self.home["rooms"] or ident in self.home["furniture"]

    def is_surface(self, place: str) -> bool:
        """Whether things can be put on it; a room has a floor."""
        return place in self.home["rooms"] or "surface" in self.home["furniture"][place]["traits"]

    def surfaces_in(self, room: str) -> List[str]:
        """Return the tables and the like of a room."""
        return [
            ident
            for ident, one in self.home["furniture"].items()
            if one["room"] == room and "surface" in one["traits"] and "flat" not in one["traits"]
        ]
