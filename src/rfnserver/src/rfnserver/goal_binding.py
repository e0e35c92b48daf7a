"""Makes a goal of any type out of a filled frame.

A goal's fields are filled from the frame elements of the same name, or as a mapping declares::

    target_pose: goal                                   # the element "goal"
    side: goal.relation                                 # a part of it: "under"
    speed: {element: speed, unit: metre}                # in this unit
    angle: {element: angle, unit_element: angle_unit, unit: degree}
    mode: {element: manner, default: slow}              # words used when the element is empty
    planner: {value: navfn}                             # always these words
    shape: {element: shape, values: {square: 1, triangle: 2}}   # a table of words; others are refused

An extra-thematic element, which every frame inherits, may be mapped too. A table says what the server takes: the
registrar hears of it (:mod:`rfnserver.heeding`).

A mapping that does not fit is refused when the server registers, with the field, and not at the first command.
"""

import dataclasses
import difflib
from dataclasses import dataclass, replace
from typing import Any, Callable, Dict, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

from rfnserver.arguments import ArgumentError
from rfnserver.goal_types import Filling, GoalField
from semantic_frames.extra_thematic import extra_thematic_of_arguments
from semantic_frames.server_profile import spellings
from spoken_quantities import QuantityError, find_unit, parse_measure
from typed_arguments import TypedArgument
from typed_arguments.parts import PARTS
from word_classes import without_determiner, word_class

SOURCE_KEYS = ("element", "unit_element", "unit", "default", "value", "values")

#: The mapping of one field: the name of an element, or :data:`SOURCE_KEYS`.
Declaration = Union[str, Mapping[str, Any]]


class BindingError(ValueError):
    """A goal cannot be made of a frame; the message names the fields."""

    def __init__(self, problems: Sequence[str]) -> None:
        super().__init__("; ".join(problems))
        self.problems: Tuple[str, ...] = tuple(problems)


@dataclass(frozen=True)
class BoundElement:
    """A frame element, as far as a binding needs it."""

    name: str
    is_core: bool


@dataclass(frozen=True)
class FieldSource:
    """Source of the words of one field.

    Attributes:
        field: to be filled
        element: whose argument fills it, empty when ``value`` does
        part: the part of that argument, see :mod:`typed_arguments.parts`; empty for its text or its measure
        unit_element: the element that holds the unit of a number, empty for none
        unit: of the field; empty for metres, radians and seconds
        default: words used when the element has no argument
        value: words that always fill it
        values: by the words of a person, in lower case and without a determiner, the words that fill the field
            instead; empty for no such table
    """

    field: GoalField
    element: str = ""
    part: str = ""
    unit_element: str = ""
    unit: str = ""
    default: str = ""
    value: str = ""
    values: Mapping[str, str] = dataclasses.field(default_factory=dict)


@dataclass(frozen=True)
class GoalPlan:
    """How the goals of one server are made of one frame.

    Attributes:
        sources: of the fields that are filled
        unfilled: paths of the fields that keep their default
        unheeded: elements that fill no field, and are not ignored on purpose
    """

    sources: Tuple[FieldSource, ...]
    unfilled: Tuple[str, ...] = ()
    unheeded: Tuple[str, ...] = ()

    def __str__(self) -> str:
        filled = ", ".join(f"{source.field.path} <- {_spelled(source)}" for source in self.sources)
        text = filled or "no field is filled"
        if self.unheeded:
            text += f"; not heeded: {', '.join(self.unheeded)}"
        return f"{text}; at their default: {', '.join(self.unfilled)}" if self.unfilled else text


def _spelled(source: FieldSource) -> str:
    return ".".join(filter(None, (source.element, source.part))) or repr(source.value)


def plan_goal(
    fields: Sequence[GoalField],
    elements: Iterable[BoundElement],
    *,
    mapping: Optional[Mapping[str, Declaration]] = None,
    ignored_elements: Iterable[str] = (),
) -> GoalPlan:
    """Decide which element fills which field.

    Args:
        fields: every field of the goal, including those of nested messages
        elements: of the frame
        mapping: by path of a field; the others are filled from the element of their name
        ignored_elements: elements that need not fill a field
    Raises:
        BindingError: a declared field or element does not exist, a field cannot be filled from words, a name fits two
            fields, or a core element fills none, so that words would be ignored
    """
    known = {element.name: element for element in elements}
    problems: List[str] = []
    sources: List[FieldSource] = []
    by_path = {field.path: field for field in fields}
    for path, declaration in (mapping or {}).items():
        source = _declared(path, declaration, by_path, problems)
        if source is None:
            continue
        for name in filter(None, (source.element, source.unit_element)):
            if name not in known and name not in extra_thematic_of_arguments():
                problems.append(f"{path}: the frame has no element '{name}'{_offer(name, known)}")
        sources.append(source)
    used = {name for source in sources for name in (source.element, source.unit_element)}
    taken = {source.field.path for source in sources}
    for name in known:
        if name in used:
            continue
        fitting = [field for field in fields if name in (field.name, field.element) and field.path not in taken]
        exact = (
            [field for field in fitting if field.path == name]
            or [field for field in fitting if "." not in field.path]
            or fitting
        )
        if len(exact) == 1 and exact[0].filling is None:
            # A message around one value, as of std_msgs.
            inner = [field for field in fields if field.path.startswith(f"{exact[0].path}.")]
            exact = inner if len(inner) == 1 else exact
        if len(exact) > 1:
            problems.append(f"the element '{name}' fits {' and '.join(field.path for field in exact)}: map one of them")
        elif exact and exact[0].filling is None:
            problems.append(f"{exact[0].path}: words cannot fill a {exact[0].type_name}")
        elif exact:
            sources.append(FieldSource(field=exact[0], element=name))
            used.add(name)
    ignored = set(ignored_elements)
    problems.extend(f"no element '{name}' to ignore{_offer(name, known)}" for name in ignored if name not in known)
    for element in known.values():
        if element.is_core and element.name not in used | ignored and not _mentions(problems, element.name):
            problems.append(
                f"the core element '{element.name}' fills no field: map one of {_fillable(fields)} to it, list in "
                "'heeds' what it may be, ignore it, or make the goal in a frame_callback"
            )
    if problems:
        raise BindingError(problems)
    filled = [source.field.path for source in sources]
    unfilled = tuple(
        field.path
        for field in fields
        if field.filling is not None and not any(_covers(path, field.path) for path in filled)
    )
    unheeded = tuple(name for name in known if name not in used | ignored)
    return GoalPlan(sources=tuple(sources), unfilled=unfilled, unheeded=unheeded)


def mapped_elements(mapping: Optional[Mapping[str, Declaration]]) -> Tuple[str, ...]:
    """Return the elements that a mapping names."""
    names: List[str] = []
    for declaration in (mapping or {}).values():
        if isinstance(declaration, str):
            names.append(declaration.partition(".")[0])
        elif isinstance(declaration, Mapping):
            said = (str(declaration[key]) for key in ("element", "unit_element") if declaration.get(key))
            names.extend(name.partition(".")[0] for name in said)
    return tuple(names)


def _mentions(problems: Sequence[str], element: str) -> bool:
    return any(f"'{element}'" in problem or problem.startswith(f"{element}:") for problem in problems)


def _fillable(fields: Sequence[GoalField]) -> str:
    return ", ".join(field.path for field in fields if field.filling is not None) or "no field (words can fill none)"


def _covers(path: str, other: str) -> bool:
    return other == path or other.startswith(path + ".") or path.startswith(other + ".")


def _offer(name: str, known: Iterable[str]) -> str:
    alike = difflib.get_close_matches(name, list(known), n=1)
    return f"; did you mean '{alike[0]}'?" if alike else f", only {', '.join(known) or 'none'}"


def _declared(
    path: str, declaration: Declaration, by_path: Mapping[str, GoalField], problems: List[str]
) -> Optional[FieldSource]:
    field = by_path.get(path)
    if field is None:
        problems.append(f"{path}: the goal has no such field{_offer(path, by_path)}")
        return None
    if field.filling is None:
        problems.append(f"{path}: words cannot fill a {field.type_name}")
        return None
    if isinstance(declaration, str):
        return _of_part(FieldSource(field=field, element=declaration), problems)
    if not isinstance(declaration, Mapping):
        problems.append(f"{path}: expected an element or a mapping of {', '.join(SOURCE_KEYS)}, found {declaration!r}")
        return None
    unknown = [str(key) for key in declaration if key not in SOURCE_KEYS]
    if unknown:
        problems.append(f"{path}: unknown key {', '.join(unknown)}, expected {', '.join(SOURCE_KEYS)}")
    texts = {key: str(declaration[key]) for key in SOURCE_KEYS if key in declaration and key != "values"}
    table = declaration.get("values", {})
    if not isinstance(table, Mapping):
        problems.append(f"{path}: expected a table of words and values, found {table!r}")
        return None
    if ("element" in texts) == ("value" in texts):
        problems.append(f"{path}: needs either 'element' or 'value'")
        return None
    values = {_key(str(words)): str(value) for words, value in table.items()}
    source = _of_part(FieldSource(field=field, values=values, **texts), problems)
    if source is None:
        return None
    if source.unit and find_unit(source.unit) is None:
        problems.append(f"{path}: I do not know the unit '{source.unit}'")
        return None
    for words in filter(None, (source.value, _default(source), *values.values())):
        if field.filling is not Filling.PLACE:
            try:
                _value(source, words, locate=_no_place)
            except ArgumentError as error:
                problems.append(f"{path}: {error}")
    return source


def _of_part(source: FieldSource, problems: List[str]) -> Optional[FieldSource]:
    """Split the name of an element from that of a part: "goal.relation"."""
    element, _, part = source.element.partition(".")
    if part and part not in PARTS:
        problems.append(f"{source.field.path}: an argument has no part '{part}'{_offer(part, PARTS)}")
        return None
    return replace(source, element=element, part=part)


def _no_place(words: str) -> Any:
    raise ArgumentError(f"no place {words}")


def goal_values(
    plan: GoalPlan, arguments: Mapping[str, TypedArgument], *, locate: Callable[[str], Any] = _no_place
) -> Dict[str, Any]:
    """Return the values of a goal's fields, by path.

    Args:
        plan: see :func:`plan_goal`
        arguments: of the filled frame, by name of the element
        locate: returns the pose of a place, by its words, as the value
    Raises:
        ArgumentError: words do not fit their field; the message is for the person who said them
    """
    values: Dict[str, Any] = {}
    for source in plan.sources:
        argument = arguments.get(source.element) or TypedArgument()
        unit = arguments.get(source.unit_element) or TypedArgument()
        said = argument.text if not source.part else PARTS[source.part](argument)
        try:
            words = source.value or (_default(source) if said in (None, "") else _looked_up(source, str(said)))
            if not words:
                continue
            if source.part or source.values or not argument.text:
                values[source.field.path] = _value(source, f"{words} {unit.text}".strip(), locate=locate)
            else:
                values[source.field.path] = _argument_value(source, argument, unit.text, locate)
        except ArgumentError as error:
            named = (source.element or source.field.path).replace("_", " ")
            raise ArgumentError(f"I cannot use the {named}: {error}") from error
    return values


def _argument_value(source: FieldSource, argument: TypedArgument, unit: str, locate: Callable[[str], Any]) -> Any:
    """Return the value of a whole argument; its members and its measure need no second reading."""
    field = source.field
    if field.is_list and argument.members:
        members = [_argument_value_of_one(source, member, "", locate) for member in argument.members]
        return _of_length(source, members)
    if field.is_list:
        return _value(source, f"{argument.text} {unit}".strip(), locate=locate)
    return _argument_value_of_one(source, argument, unit, locate)


def _argument_value_of_one(
    source: FieldSource, argument: TypedArgument, unit: str, locate: Callable[[str], Any]
) -> Any:
    wanted = find_unit(source.unit) if source.unit else None
    quantity = "duration" if source.field.filling is Filling.DURATION else wanted.quantity if wanted else ""
    measure = argument.measure
    is_number = source.field.filling in (Filling.FLOAT, Filling.DURATION)
    if is_number and measure is not None and measure.si is not None and measure.kind == quantity:
        return measure.si / (wanted.si_factor if wanted else 1.0)
    return _single(source, f"{argument.text} {unit}".strip(), locate=locate)


def _key(words: str) -> str:
    """Return words as the keys of tables have them."""
    return without_determiner(words.lower(), word_class("determiners_and_possessives"))


def _default(source: FieldSource) -> str:
    """Return what fills a field whose element was not said: by its table, or as it stands."""
    return source.values.get(_key(source.default), source.default)


def _looked_up(source: FieldSource, words: str) -> str:
    """Return what the table of a field has for the words of a person; without a table, the words."""
    if not source.values:
        return words
    found = next((source.values[form] for form in sorted(spellings(_key(words))) if form in source.values), None)
    if found is None:
        raise ArgumentError(f'"{words}" is none of {", ".join(source.values)}.')
    return found


def _value(source: FieldSource, words: str, *, locate: Callable[[str], Any]) -> Any:
    if source.field.is_list:
        items = [item.strip() for part in words.split(",") for item in part.split(" and ")]
        return _of_length(source, [_single(source, item, locate=locate) for item in items if item])
    return _single(source, words, locate=locate)


def _of_length(source: FieldSource, values: List[Any]) -> List[Any]:
    """Return the values of an array, if it may have so many."""
    length = source.field.length
    if length is not None and len(values) != length:
        raise ArgumentError(f"it takes {length} values, not {len(values)}.")
    return values


def _single(source: FieldSource, words: str, *, locate: Callable[[str], Any]) -> Any:
    field = source.field
    if field.filling is Filling.PLACE:
        return locate(words)
    if field.filling is Filling.STRING:
        return _constant(field, words, str, words)
    if field.filling is Filling.BOOLEAN:
        return _boolean(words)
    if field.filling is Filling.DURATION:
        return _quantity(source, words, "duration")
    if field.filling is Filling.INTEGER:
        return _integer(source, words)
    return _quantity(source, words, None)


def _integer(source: FieldSource, words: str) -> int:
    named = _constant(source.field, words, int, None)
    if named is not None:
        return int(named)
    number = _quantity(source, words, None)
    least, most = source.field.integer_range
    if number != int(number):
        raise ArgumentError(f'"{words}" is not a whole number.')
    if not least <= number <= most:
        raise ArgumentError(f'"{words}" is not between {least} and {most}.')
    return int(number)


def _constant(field: GoalField, words: str, kind: type, otherwise: Any) -> Any:
    """Return the constant that words name; without one, what stands for it, or an error that names the constants."""
    values = [field.constant(form, kind) for form in (words, *sorted(spellings(_key(words))))]
    found = next((value for value in values if value is not None), None)
    if found is None and otherwise is None and field.choices and not _is_number(words):
        raise ArgumentError(f'"{words}" is none of {", ".join(field.choices)}.')
    return otherwise if found is None else found


def _is_number(words: str) -> bool:
    try:
        parse_measure(words)
    except QuantityError:
        return False
    return True


def _boolean(words: str) -> bool:
    word = words.strip().lower()
    # Read here and not at import: the stop server imports this module, and must not depend on a file.
    is_true = word in word_class("true_words")
    if not is_true and word not in word_class("false_words"):
        raise ArgumentError(f'"{words}" is neither yes nor no.')
    return is_true


def _quantity(source: FieldSource, words: str, quantity: Optional[str]) -> float:
    """Return a number, converted to the unit of the field; a number without a unit is returned as it is."""
    unit = find_unit(source.unit) if source.unit else None
    try:
        if unit is None and quantity is None:
            return parse_measure(words).si_amount
        wanted = quantity if unit is None else unit.quantity
        measure = parse_measure(words, quantity=wanted, default_unit=source.unit or "second")
        return measure.si_amount / (1.0 if unit is None else unit.si_factor)
    except QuantityError as error:
        raise ArgumentError(str(error)) from error
