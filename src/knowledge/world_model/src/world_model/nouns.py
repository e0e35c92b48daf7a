"""Which objects a noun may stand for: by their categories, by WordNet, and by the kinds that persons taught."""

from functools import cached_property
from typing import Dict, Iterable, Iterator, List, Mapping, Sequence, Tuple

from semantic_types import shipped_nouns, spoken
from world_model.world_object import Sort, WorldObject


class Nouns:
    """The nouns of some objects."""

    def __init__(self, objects: Sequence[WorldObject], taught_kinds: Sequence[Tuple[str, str]]) -> None:
        """
        Args:
            objects: those that are known
            taught_kinds: nouns that a person taught, each with the noun of which it is a kind
        """
        self._objects, self._taught_kinds = objects, taught_kinds

    @cached_property
    def _by_category(self) -> Mapping[str, Tuple[WorldObject, ...]]:
        found: Dict[str, List[WorldObject]] = {}
        for one in self._objects:
            found.setdefault(category_of(one), []).append(one)
        return {category: tuple(objects) for category, objects in found.items()}

    @cached_property
    def categories_below(self) -> Mapping[object, Tuple[str, ...]]:
        """The categories below each synset of WordNet, and those that end with a word."""
        found: Dict[object, List[str]] = {}
        for category, objects in self._by_category.items():
            is_person = objects[0].sort is Sort.PERSON
            last = category.split()[-1] if category else ""
            above = shipped_nouns().kinds(category, is_person=is_person)
            if not above and last != category:
                above = shipped_nouns().kinds(last, is_person=is_person)
            for key in (last, *above):
                found.setdefault(key, []).append(category)
        return {key: tuple(categories) for key, categories in found.items()}

    def exactly(self, noun: str) -> Tuple[WorldObject, ...]:
        """Return the objects of a category, without those of more special categories."""
        return self._by_category.get(spoken(noun), ())

    def kinds_of(self, noun: str) -> Tuple[WorldObject, ...]:
        """Return the objects that a noun may stand for: those of its category and of more special categories.

        A person may have taught more special ones. A noun of which nothing is known but that it is a kind of another
        stands for things of that other kind.
        """
        said = spoken(noun)
        return self._of_any(self._taught_below(said)) or self._of_any(
            upper for lower, upper in self._taught_kinds if lower == said
        )

    def _taught_below(self, key: str) -> Sequence[str]:
        """Return a noun, and the nouns that are taught to be kinds of it."""
        found = [key]
        for one in found:
            found += [lower for lower, upper in self._taught_kinds if upper == one and lower not in found]
        return found

    def _of_any(self, keys: Iterable[str]) -> Tuple[WorldObject, ...]:
        return tuple({one.id: one for key in keys for one in self._known_kinds_of(key)}.values())

    def _known_kinds_of(self, key: str) -> Iterator[WorldObject]:
        categories = [key, *self.categories_below.get(key, ())]
        for synset in shipped_nouns().synsets(key):
            categories += self.categories_below.get(synset, ())
        for category in dict.fromkeys(categories):
            yield from self._by_category.get(category, ())


def category_of(one: WorldObject) -> str:
    """Return the category of an object as it is compared; persons and robots without one have that of their sort."""
    if one.category:
        return spoken(one.category)
    return one.sort.value if one.sort in (Sort.PERSON, Sort.ROBOT, Sort.DOOR) else ""
