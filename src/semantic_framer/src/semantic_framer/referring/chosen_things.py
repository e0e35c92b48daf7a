"""Finds which of several things an answer chooses: "the red one", "in the kitchen"."""

from dataclasses import replace
from typing import Optional, Tuple

from phrase_meanings.arguments import resolved
from referring_expressions import Situation, fitting
from referring_expressions.fitting import at_place
from typed_arguments import TypedArgument
from word_classes import without_determiner, word_class
from world_model import Sort, World

_STANDINS = word_class("noun_standins")
#: Words that are written small inside a sentence.
_SMALL = word_class("determiners_and_possessives") | word_class("place_prepositions")


def chosen(
    argument: TypedArgument, said: TypedArgument, offered: Tuple[str, ...], world: World
) -> Optional[TypedArgument]:
    """Return an argument that an answer completes: "the red one" for "the mug".

    Args:
        argument: the argument that was asked about
        said: the answer
        offered: ids of the things that were offered
        world: what the robot knows
    Returns:
        None if the answer chooses none of them, or more than one
    """
    situation = Situation(world, offered=offered)
    is_place = bool(said.relation) and said.lemma not in _STANDINS
    found = at_place(situation.objects(offered), said, situation) if is_place else fitting(said, situation)
    # "Anna", after "Who are you?"
    owners = {one.id for one in found if one.sort is Sort.PERSON}
    owned = tuple(one for one in situation.objects(offered) if owners & set(one.related("of")))
    found = tuple(one for one in found if one.id in offered) or owned
    if len(found) != 1:
        return None
    noun = without_determiner(argument.text, word_class("determiners_and_possessives"))
    words = said.words.split()
    words[0] = words[0].lower() if words[0].lower() in _SMALL else words[0]
    answer = " ".join(noun if word.lower() in _STANDINS else word for word in words)
    text = f"{argument.text} {answer}" if is_place else argument.text if owned else answer
    return replace(resolved(argument, text), referents=(found[0].id,), referent_count=1, world_version=world.version)


def nearest_of(argument: TypedArgument, offered: Tuple[str, ...], world: World) -> Optional[TypedArgument]:
    """Return an argument that refers to the nearest of the things that were offered: "any of them".

    Args:
        argument: the argument that was asked about
        offered: ids of the things that were offered
        world: what the robot knows
    Returns:
        None if the robot knows none of them any longer
    """
    found = world.nearest_first(Situation(world).objects(offered))
    if not found:
        return None
    meant = resolved(argument, argument.text)
    return replace(meant, referents=(found[0].id,), referent_count=1, world_version=world.version)
