"""What persons taught beside verbs: kinds, "a mug is a cup", names, "this room is the den", and the words of idioms."""

from dataclasses import replace
from types import MappingProxyType
from typing import Mapping, Optional, Tuple

from semantic_types import WordTypes
from world_model import World

#: Types of a place that has a taught name.
_PLACE_TYPES = ("Room", "Location")
_NONE: Mapping[str, str] = MappingProxyType({})


class TaughtNames:
    """Kinds, names, and what idioms mean. One thread at a time uses it.

    Attributes:
        kinds: nouns, each with the noun of which it is a kind
        places: names, each with the id of the place
        meanings: what the words of an idiom mean, as it was said, by the path of its lexical unit file
    """

    def __init__(
        self,
        kinds: Mapping[str, str] = _NONE,
        places: Mapping[str, str] = _NONE,
        meanings: Mapping[str, str] = _NONE,
    ) -> None:
        """
        Args:
            kinds: nouns, each with the noun of which it is a kind
            places: names, each with the id of the place
            meanings: what the words of an idiom mean, by the path of its lexical unit file
        """
        self.kinds, self.places, self.meanings = kinds, places, meanings
        # The world and the types of the time before, each with what was made of it.
        self._world: Optional[Tuple[World, World]] = None
        self._types: Optional[Tuple[WordTypes, WordTypes]] = None

    def world_with(self, world: World) -> World:
        """Return a world in which these kinds and names hold; names of places that it does not have say nothing."""
        if not self.kinds and not self.places:
            return world
        if self._world is None or self._world[0] is not world:
            objects = list(world.objects)
            place_of = {one.id: place for place, one in enumerate(objects)}
            for name, known in self.places.items():
                if known in place_of:
                    named = objects[place_of[known]]
                    objects[place_of[known]] = replace(named, other_names=(*named.other_names, name))
            made = replace(world, objects=tuple(objects), taught_kinds=tuple(self.kinds.items()))
            self._world = (world, made.prepare())
        return self._world[1]

    def types_with(self, types: WordTypes) -> WordTypes:
        """Return the types of words with those that these kinds and names give; what was known counts first."""
        if not self.kinds and not self.places:
            return types
        if self._types is None or self._types[0] is not types:
            names = {**dict.fromkeys(self.places, _PLACE_TYPES), **types.names}
            self._types = (types, replace(types, names=names, kinds=self.kinds))
        return self._types[1]
