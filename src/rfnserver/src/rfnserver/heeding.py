"""What a server that makes goals of frames takes into account: said to the registrar, and checked for each frame."""

from dataclasses import replace
from typing import Collection, Container, Dict, Iterable, Mapping, Optional, Tuple

from rfnserver.goal_binding import GoalPlan
from semantic_frames.extra_thematic import extra_thematic_of_arguments
from semantic_frames.server_profile import AS_IN_2012, HeededElement, ServerProfile
from spoken_quantities import find_unit
from typed_arguments import Source, TypedArgument
from typed_arguments.attribute_names import RELATIONS
from word_classes import word_class


def heeded_by(plan: GoalPlan, own: Container[str]) -> Tuple[HeededElement, ...]:
    """Return what follows from a plan: the words of its tables, and the extra-thematic elements that fill fields.

    An element that several tables read is heeded as far as all of them go.

    Args:
        plan: see :func:`rfnserver.goal_binding.plan_goal`
        own: names of the elements of the frame
    """
    names = extra_thematic_of_arguments()
    found: Dict[str, HeededElement] = {}
    for source in plan.sources:
        is_inherited = source.element in names and source.element not in own
        values: Tuple[str, ...] = ()
        relations: Tuple[str, ...] = ()
        if not source.part:
            values = tuple(source.values or (source.field.choices if is_inherited else ()))
        elif source.part == "relation" and all(words in RELATIONS for words in source.values):
            relations = tuple(source.values)
        if not source.element or not (is_inherited or values or relations):
            continue
        name = names[source.element] if is_inherited else source.element
        known = found.get(name, HeededElement(name))
        found[name] = replace(
            known, values=_common(known.values, values), relations=_common(known.relations, relations)
        )
    return tuple(found.values())


def _common(known: Tuple[str, ...], others: Tuple[str, ...]) -> Tuple[str, ...]:
    """Return the words that two tables have in common; an empty table restricts nothing."""
    return tuple(word for word in known if not others or word in others) or others


def listed_elements(profile: ServerProfile) -> Dict[str, Tuple[HeededElement, ...]]:
    """Return the elements of which a server lists all the words that it takes, by the names of arguments.

    Such an element need not fill a field, and a callback need not read it: the list says what it may be.
    """
    names = {thematic: name for name, thematic in extra_thematic_of_arguments().items()}
    listed: Dict[str, Tuple[HeededElement, ...]] = {}
    for heeded in profile.heeds:
        if heeded.values:
            for name in {heeded.name, names.get(heeded.name, heeded.name)}:
                listed[name] = (*listed.get(name, ()), heeded)
    return listed


def unheeded_argument(
    arguments: Iterable[TypedArgument],
    heeded: Collection[str],
    *,
    profile: ServerProfile = AS_IN_2012,
    defaults: Mapping[str, str],
) -> Optional[TypedArgument]:
    """Return the first argument that was said and that would be dropped; None for none.

    Args:
        arguments: of the filled frame
        heeded: elements that fill a field, that a callback has read, or that may be ignored
        profile: what the server states
        defaults: of the frame, by name of the element: nobody has said those
    """
    listed = listed_elements(profile)
    said = [argument for argument in arguments if argument.text and argument.source is Source.SAID]
    # A measure knows its unit, which may also be an element of its own, in the words of the person: "degrees".
    units = {find_unit(one.measure.unit) for one in said if one.name in heeded and one.measure is not None} - {None}
    for argument in said:
        words = argument.text
        if argument.name in heeded or words == defaults.get(argument.name, "") or find_unit(words) in units:
            continue
        if any(one.fits(argument) for one in listed.get(argument.name, ())) or words.lower() in word_class("hearers"):
            continue
        return argument
    return None


def spoken(argument: TypedArgument) -> str:
    """Return an argument for the person who said it: 'the manner "slowly"'."""
    return f'the {argument.name.replace("_", " ")} "{argument.text}"'


def refusal_of(argument: TypedArgument) -> str:
    """Return the sentence that refuses a frame for an argument that would be dropped."""
    return f"I cannot take {spoken(argument)} into account when I do that."
