"""Answers to questions about measures: "How tall is the fridge?", "Is the sofa bigger than the bed?"."""

from typing import Callable, Dict, Optional, Tuple

from question_answering.robot_knowledge import RobotKnowledge
from question_answering.wording import Arguments, at_location, definite, found_of, name_for, verb_of
from referring_expressions import unknown_of
from referring_expressions.describing import counted_noun
from referring_expressions.measures import Measure, distance_m, measure, measured
from roboframenet_ros.spoken_text import with_capital
from typed_arguments import TypedArgument
from world_model import WorldObject

#: Of what is this much larger than another, one can see it; the map is no more exact.
_LEAST_RATIO = 1.02
_HIGH = "high"


def amount(arguments: Arguments, known: RobotKnowledge) -> str:
    """Say how big, how high or how far away something is."""
    theme, attribute = arguments["theme"], arguments["attribute"].text.lower()
    one, missing = _one(theme, known)
    if one is None:
        return missing
    name = name_for(theme, one)
    verb = verb_of([one], name)
    wanted = measure(attribute)
    said = None
    if wanted is not None and wanted.name == "distance":
        said = _distance(one, arguments, known)
    elif wanted is not None and wanted.name == "height" and one.size_m[2]:
        said = f"{_metres(one.size_m[2])} {_HIGH if attribute == wanted.name else attribute}"
    elif wanted is not None and measured(one, wanted.name, known.world) is not None:
        # Which edge is its length depends on who looks at it.
        said = f"{_number(one.size_m[0])} by {_metres(one.size_m[1])}, and {_metres(one.size_m[2])} {_HIGH}"
    if said is None and wanted is not None and attribute == wanted.name:
        return f"I do not know the {attribute} of {name}."
    if said is None:
        return f"I do not know how {attribute} {name} {verb}."
    return f"{with_capital(name)} {verb} {said}."


def _distance(one: WorldObject, arguments: Arguments, known: RobotKnowledge) -> Optional[str]:
    standard = arguments.get("standard")
    if standard is None or known.situation.here in found_of(standard, known):
        away_m = distance_m(one, known.world.robot)
        return f"{_metres(away_m)} away from me" if away_m is not None else None
    other, _ = _one(standard, known)
    away_m = distance_m(one, other)
    return f"{_metres(away_m)} away from {definite(standard)}" if away_m is not None else None


def comparison(arguments: Arguments, known: RobotKnowledge) -> str:
    """Say whether one thing has more of a measure than another, or which of them has; or of which there are more."""
    theme, attribute = arguments["theme"], arguments["attribute"].text.lower()
    standard = arguments.get("standard", arguments.get("alternative"))
    if standard is None:
        return "I do not know with what to compare it."
    wanted = measure(attribute)
    if wanted is not None and wanted.name == "number":
        return _of_number(arguments, standard, wanted, known)
    (one, missing), (other, also_missing) = _one(theme, known), _one(standard, known)
    if one is None or other is None:
        return missing or also_missing
    name, other_name = name_for(theme, one), name_for(standard, other)
    verb = verb_of([one], name)
    first = measured(one, wanted.name, known.world) if wanted is not None else None
    second = measured(other, wanted.name, known.world) if wanted is not None else None
    is_choice = "alternative" in arguments
    if wanted is None or first is None or second is None:
        return f"I do not know {'which of them' if is_choice else f'whether {name}'} {verb} {attribute}."
    if wanted.is_little:
        first, second = second, first
    is_same = max(first, second) < _LEAST_RATIO * min(first, second)
    if is_choice and not is_same:
        return f"{with_capital(name if first > second else other_name)} {verb} {attribute}."
    if is_same:
        return f"As far as I know, {name} and {other_name} are alike in that."
    if first > second:
        return f"Yes, {name} {verb} {attribute} than {other_name}."
    return f"No, {name} {verb} not {attribute} than {other_name}."


def _of_number(arguments: Arguments, standard: TypedArgument, wanted: Measure, known: RobotKnowledge) -> str:
    """Say whether there are more things of one kind than of another."""
    counts = [
        len(at_location(arguments, found_of(one, known, is_wide=True), known)) for one in (arguments["theme"], standard)
    ]
    verdict = counts[0] < counts[1] if wanted.is_little else counts[0] > counts[1]
    said = [f"{count or 'no'} {counted_noun(one, count)}" for one, count in zip((arguments["theme"], standard), counts)]
    return f"{'Yes' if verdict else 'No'}, I know of {said[0]} and {said[1]}."


def _one(theme: TypedArgument, known: RobotKnowledge) -> Tuple[Optional[WorldObject], str]:
    """Return the thing that a phrase means; None, and what to say, if it means none, or several."""
    found = found_of(theme, known)
    if not found:
        return None, unknown_of(theme)
    if len(found) > 1:
        return None, f"I know of {len(found)} things that {definite(theme)} may be. Please say which one."
    return found[0], ""


def _metres(amount_m: float) -> str:
    return f"{_number(amount_m)} m"


def _number(amount_m: float) -> str:
    return f"{amount_m:.2f}" if amount_m < 1.0 else f"{amount_m:.1f}"


ABOUT_MEASURES: Dict[str, Callable[[Arguments, RobotKnowledge], str]] = {
    "question_of_measure": amount,
    "question_of_comparison": comparison,
}
