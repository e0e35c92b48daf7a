"""What the robot knows of a home: its map, what it has perceived, and what it was told."""

import math
import threading
from dataclasses import dataclass, replace
from typing import Dict, Iterable, List, Optional, Set, Tuple

from referring_expressions.describing import is_plural_noun
from typed_arguments import TypedArgument
from word_classes import without_determiner, word_class

#: Nouns for any thing and for any person.
THINGS = frozenset("thing things object objects item items everything".split())
PERSONS = frozenset(
    "person people persons visitor visitors guest guests everybody everyone somebody someone anybody anyone".split()
)
#: Kinds of modifiers that tell things of one name apart.
_TELLING = ("adjective", "compound", "superlative")


@dataclass(frozen=True)
class Known:
    """What is known of an object.

    Attributes:
        id: stable
        sort: room, door, furniture, thing, person
        names: the usual name first
        category: of things and furniture
        attributes: colour, size
        relation: of its place: on, in, under, held, ...; empty when the place is unknown
        holder: id of what it is on, in, ...
        room: where it is; empty when unknown
        states: open, closed, on, off, dirty, ...
        stamp_s: when it was seen or told
    """

    id: str
    sort: str
    names: Tuple[str, ...]
    category: str = ""
    attributes: Tuple[str, ...] = ()
    relation: str = ""
    holder: str = ""
    room: str = ""
    states: Tuple[str, ...] = ()
    x_m: float = 0.0
    y_m: float = 0.0
    stamp_s: float = 0.0

    @property
    def name(self) -> str:
        """The usual name."""
        return self.names[0]

    def is_a(self, word: str) -> bool:
        """Whether it is of a category, or has that name."""
        return word == self.category or word in self.names

    @property
    def the_name(self) -> str:
        """The name in a sentence."""
        return self.name if self.sort == "person" else f"the {self.name}"

    @property
    def is_plural(self) -> bool:
        """Whether its name is a plural, though it is one thing: "keys"."""
        return self.sort != "person" and is_plural_noun(self.name)

    @property
    def the_name_is(self) -> str:
        """The name in a sentence, and the verb: "the mug is", "the keys are"."""
        return f"{self.the_name} {'are' if self.is_plural else 'is'}"

    @property
    def it_is(self) -> str:
        """The pronoun and the verb."""
        return "they are" if self.is_plural else "it is"


class Memory:
    """The objects that the robot knows. Several threads may use it."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._objects: Dict[str, Known] = {}
        self._told: Dict[str, str] = {}
        self._named: Dict[str, Tuple[str, ...]] = {}
        #: Doors that the robot has opened to get into a room, with the room; it closes them when it leaves.
        self.opened: Dict[str, str] = {}
        #: The id of the person whom the robot has met last, and when.
        self.met: Tuple[str, float] = ("", -math.inf)
        #: Where the robot has met persons last: by id, metres.
        self.met_at: Dict[str, Tuple[float, float]] = {}

    def update(self, objects: Iterable[Known]) -> None:
        """Take in what was perceived; an object with an older stamp than what is known is left out."""
        with self._lock:
            for one in objects:
                before = self._objects.get(one.id)
                if before is None or one.stamp_s >= before.stamp_s:
                    told = self._named.get(one.id, ())
                    self._objects[one.id] = replace(one, names=tuple(dict.fromkeys((*one.names, *told))))

    def begin_anew(self) -> None:
        """The clock began anew: whatever is perceived from now on is newer than what is known."""
        with self._lock:
            self._objects = {name: replace(one, stamp_s=-math.inf) for name, one in self._objects.items()}

    def forget_place(self, ident: str) -> None:
        """A thing is no longer where it was thought to be."""
        with self._lock:
            if ident in self._objects:
                self._objects[ident] = replace(self._objects[ident], relation="", holder="", room="")

    def name(self, ident: str, name: str) -> None:
        """Remember that an object is called by another name, too."""
        with self._lock:
            self._named[ident] = (*self._named.get(ident, ()), name)
            known = self._objects[ident]
            self._objects[ident] = replace(known, names=tuple(dict.fromkeys((*known.names, name))))

    def tell(self, words: str, place: str) -> None:
        """Remember where things of a name are said to be: the id of furniture or a room."""
        with self._lock:
            self._told[words.lower()] = place

    def told_place(self, argument: TypedArgument) -> str:
        """Return where somebody said that such a thing is; empty for nowhere."""
        with self._lock:
            return next((self._told[name] for name in wanted_names(argument) if name in self._told), "")

    def get(self, ident: str) -> Optional[Known]:
        """Return what is known of an id."""
        with self._lock:
            return self._objects.get(ident)

    def all(self, *sorts: str) -> List[Known]:
        """Return all objects of some sorts, of all when none is given."""
        with self._lock:
            return [one for one in self._objects.values() if not sorts or one.sort in sorts]

    def find(self, argument: TypedArgument, *sorts: str, here: Optional[Tuple[float, float]] = None) -> List[Known]:
        """Return the objects that an argument may mean, the likeliest first.

        Args:
            argument: its referents count first, then its words
            sorts: which sorts count; all when none is given
            here: of things that are named alike, the one nearest to this point comes first
        """
        objects = self.all(*sorts)
        by_id = {one.id: one for one in objects}
        referents = [by_id[ident] for ident in argument.referents if ident in by_id]
        if referents and not is_any(argument):
            return referents
        wanted = wanted_names(argument)
        for nouns, sort in ((THINGS, "thing"), (PERSONS, "person")):
            if nouns.intersection(wanted):
                objects = [replace(one, names=(*one.names, *nouns)) if one.sort == sort else one for one in objects]
        scored = [(score, one) for one in objects for score in [_score(wanted, one)] if score < 2 * len(wanted)]
        if not scored:
            return referents
        telling = {m.lemma or m.word for m in argument.modifiers if m.kind in _TELLING}
        telling |= {m.word for m in argument.modifiers if m.kind in _TELLING}
        vocabulary = {word for _, one in scored for word in (*one.attributes, *one.states)} | _COLOURS
        asked = {word.lower() for word in telling} & vocabulary
        fitting = [(s, one) for s, one in scored if asked <= {*one.attributes, *one.states, *_name_words(one)}]
        fitting.sort(key=lambda pair: (pair[0], math.dist(here, (pair[1].x_m, pair[1].y_m)) if here else 0.0))
        found = [by_id[one.id] for _, one in fitting]
        found += [one for one in referents if one not in found]
        places = self.find(argument.possessor, "furniture", "room") if argument.possessor is not None else []
        return [one for one in found if any(_is_part_of(one, place) for place in places)] if places else found


_WHOLE = word_class("determiners_of_all")
_INDEFINITE = word_class("indefinite_articles")
_PRONOUNS = (
    word_class("indefinite_persons") - word_class("words_for_all")
    | word_class("indefinite_persons_asked")
    | word_class("things_asked")
)
_DETERMINERS = word_class("determiners_and_possessives")
_COLOURS = frozenset("red blue green yellow white black brown big small".split())


def _is_part_of(one: Known, place: Known) -> bool:
    """Whether a thing is that of a piece of furniture or a room, "the desk's drawer": by its place, or by its name."""
    if place.id in (one.holder, one.room):
        return True
    names = frozenset(name.lower() for name in one.names)
    return any(
        f"{place_name} {word}" in names
        for place_name in map(str.lower, place.names)
        for word in (one.category, one.name)
    )


def is_any(argument: TypedArgument) -> bool:
    """Whether any thing of a kind will do, "a person", "someone": not only those that were known when it was said."""
    return argument.quantifier in _INDEFINITE or argument.text.lower() in _PRONOUNS


def is_whole(argument: TypedArgument) -> bool:
    """Whether all things of a kind are meant: "every mug", "everybody"."""
    return argument.quantifier in _WHOLE


def _name_words(one: Known) -> Set[str]:
    return {word for name in one.names for word in name.lower().split()}


def wanted_names(argument: TypedArgument) -> List[str]:
    """Return the names that an argument may mean, the most exact first."""
    text = without_determiner(" ".join(argument.text.split()).strip(" .,!?"), _DETERMINERS).lower()
    compounds = " ".join(m.word for m in argument.modifiers if m.kind in ("compound", "name"))
    head, lemma = argument.head.lower(), argument.lemma.lower()
    names = [text]
    if argument.possessor is not None:
        owner = argument.possessor.head or argument.possessor.text
        names.append(f"{head} of the {owner}".lower())
    if compounds and head:
        names += [f"{compounds} {head}".lower(), f"{compounds} {lemma}".lower()]
    names += [name for name in (head, lemma) if name]
    if not head and text:
        # A client of 2012 sends only a text.
        words = text.split()
        names += [" ".join(words[index:]) for index in range(1, len(words))]
        names += [" ".join(words[:index]) for index in range(len(words) - 1, 0, -1)]
    names += [name[:-1] for name in list(names) if name.endswith("s") and len(name) > 3]
    return list(dict.fromkeys(name for name in names if name))


def _score(wanted: List[str], one: Known) -> int:
    """Return how far down the list of wanted names an object is found; more than its length for not at all.

    A name counts more than a category.
    """
    names = [name.lower() for name in one.names]
    for index, name in enumerate(wanted):
        if name in names or name.replace(" ", "_") == one.id:
            return 2 * index
        if name == one.category:
            return 2 * index + 1
    return 2 * len(wanted)
