"""Frame files: one semantic frame each, as in 2012, with additions."""

import math
from dataclasses import replace
from typing import Callable, Dict, FrozenSet, List, Optional, Tuple

import yaml

from checked_files.marked_yaml import Reader, describe, did_you_mean, line_of
from semantic_frames.frame import (
    ConstantArgument,
    ElementMapping,
    FrameElement,
    FrameElementRelation,
    ListPolicy,
    Quantity,
    RelatedFrame,
    Result,
    SemanticFrame,
    UnknownPolicy,
    ValueCondition,
)
from semantic_frames.roles import filler_of
from semantic_frames.semantic_type import read_semantic_types
from spoken_quantities import QuantityError, parse_measure, parse_number
from typed_arguments.attribute_names import QUANTIFIERS, RELATIONS

FRAME_KEYS = (
    "name",
    "description",
    "frame_elements",
    "children",
    "framenet",
    "on_list",
    "on_unknown",
    "confirm",
    "is_question",
    "is_condition",
    "results_in",
)
ELEMENT_KEYS = (
    "name",
    "is_core",
    "default",
    "quantity",
    "unit_element",
    "minimum",
    "maximum",
    "values",
    "relations",
    "counts",
    "quantifiers",
    "question",
    "answer",
    "framenet",
    "semantic_type",
    "confirm",
)
RESULT_KEYS = ("frame", "theme", "state", "location", "goal", "owner", "possession")
CHILD_KEYS = ("name", "frame_element_relations")
RELATION_KEYS = ("parent_name", "parent_value", "child_name", "child_value", "relation")


def load_frame(text: str, path: str) -> SemanticFrame:
    """Read a frame file.

    Args:
        text: content of the file
        path: where it came from, for problems and for :attr:`SemanticFrame.path`
    Returns:
        the frame, consistent in itself; whether its children exist is not checked here
    Raises:
        FileRefused: the file has mistakes; the exception carries all of them
    """
    reader = Reader(path)
    root = reader.compose(text, "a mapping with name")
    entries = reader.mapping(root, "", FRAME_KEYS, required=("name",))
    elements = _elements(reader, entries.get("frame_elements"), has_framenet="framenet" in entries)
    is_question = reader.boolean(entries.get("is_question"), "is_question")
    is_condition = reader.boolean(entries.get("is_condition"), "is_condition")
    has_fillers = "framenet" in entries and not (is_question or is_condition)
    frame = SemanticFrame(
        name=reader.graph_name(entries.get("name"), "name"),
        description=reader.text(entries.get("description"), "description"),
        frame_elements=tuple(map(_with_filler, elements)) if has_fillers else elements,
        children=_children(reader, entries.get("children"), elements),
        framenet=reader.text(entries.get("framenet"), "framenet"),
        on_list=ListPolicy(
            reader.choice(
                entries.get("on_list"), "on_list", [policy.value for policy in ListPolicy], ListPolicy.REPEAT.value
            )
        ),
        on_unknown=UnknownPolicy(
            reader.choice(
                entries.get("on_unknown"), "on_unknown", [one.value for one in UnknownPolicy], UnknownPolicy.ACT.value
            )
        ),
        is_confirmed=reader.boolean(entries.get("confirm"), "confirm"),
        is_question=is_question,
        is_condition=is_condition,
        results_in=_result(reader, entries.get("results_in"), elements),
        path=path,
        line=line_of(root),
    )
    reader.refuse_if_wrong()
    return frame


def _result(reader: Reader, node: Optional[yaml.Node], elements: Tuple[FrameElement, ...]) -> Optional[Result]:
    """Read what a frame results in: ``{frame: condition_of_state, theme: container_portal, state: closed}``.

    Whether that frame exists is not checked here.
    """
    if node is None:
        return None
    said = {
        key: reader.text(value, f"results_in.{key}")
        for key, value in reader.mapping(node, "results_in", RESULT_KEYS, required=("frame",)).items()
    }
    frame = said.pop("frame", "")
    if not said:
        reader.report("MISSING_KEY", node, "results_in", "no element of that frame", "at least one element")
    return Result(frame, tuple(said.items()), frozenset(element.name for element in elements))


def _elements(reader: Reader, node: Optional[yaml.Node], *, has_framenet: bool) -> Tuple[FrameElement, ...]:
    """Read the elements; in a frame of FrameNet each has FrameNet's name, unless it says another one."""
    elements: List[FrameElement] = []
    unit_nodes: List[Tuple[str, yaml.Node, FrameElement]] = []
    for key, item in reader.sequence(node, "frame_elements"):
        entries = reader.mapping(item, key, ELEMENT_KEYS, required=("name",))
        quantity_name = reader.choice(
            entries.get("quantity"), f"{key}.quantity", [quantity.value for quantity in Quantity], ""
        )
        quantity = Quantity(quantity_name) if quantity_name else None
        name = reader.graph_name(entries.get("name"), f"{key}.name")
        element = FrameElement(
            name=name,
            is_core=reader.boolean(entries.get("is_core"), f"{key}.is_core"),
            default=reader.text(entries.get("default"), f"{key}.default"),
            quantity=quantity,
            unit_element=reader.text(entries.get("unit_element"), f"{key}.unit_element"),
            minimum=_limit(reader, entries, key, "minimum", quantity),
            maximum=_limit(reader, entries, key, "maximum", quantity),
            values=reader.texts(entries.get("values"), f"{key}.values"),
            relations=_names(reader, entries.get("relations"), f"{key}.relations", RELATIONS),
            counts=_counts(reader, entries.get("counts"), f"{key}.counts"),
            quantifiers=_names(reader, entries.get("quantifiers"), f"{key}.quantifiers", QUANTIFIERS),
            question=reader.text(entries.get("question"), f"{key}.question"),
            answer=reader.text(entries.get("answer"), f"{key}.answer"),
            framenet=reader.text(entries.get("framenet"), f"{key}.framenet", name.capitalize() if has_framenet else ""),
            semantic_types=read_semantic_types(reader, entries.get("semantic_type"), f"{key}.semantic_type"),
            confirmed_values=tuple(
                value.lower() for value in reader.texts(entries.get("confirm"), f"{key}.confirm") if value
            ),
        )
        if element.name in [other.name for other in elements]:
            reader.report("DUPLICATE_ELEMENT", item, f"{key}.name", f"a second '{element.name}'", "names that differ")
        if (
            element.default
            and element.values
            and element.default.lower() not in [value.lower() for value in element.values]
        ):
            reader.report(
                "UNKNOWN_VALUE",
                entries["default"],
                f"{key}.default",
                f"'{element.default}'",
                f"one of {', '.join(element.values)}",
            )
        if element.minimum is not None and element.maximum is not None and element.minimum > element.maximum:
            reader.report(
                "LIMITS",
                entries["minimum"],
                f"{key}.minimum",
                f"{element.minimum:g}",
                f"not more than the maximum {element.maximum:g}",
            )
        if element.semantic_types and element.quantity is not None:
            reader.report(
                "TYPED_QUANTITY",
                entries["semantic_type"],
                f"{key}.semantic_type",
                ", ".join(element.semantic_types),
                "a semantic type only without the key 'quantity'",
            )
        if element.unit_element:
            unit_nodes.append((f"{key}.unit_element", entries["unit_element"], element))
        elements.append(element)
    names = [element.name for element in elements]
    for key, unit_node, element in unit_nodes:
        if element.unit_element not in names or element.unit_element == element.name:
            reader.report(
                "UNKNOWN_ELEMENT",
                unit_node,
                key,
                f"'{element.unit_element}'",
                f"another element: {', '.join(names)}",
                did_you_mean(element.unit_element, names),
            )
    return tuple(elements)


def _with_filler(element: FrameElement) -> FrameElement:
    """Return an element with the types of its role, if the frame says nothing of what may fill it."""
    if element.semantic_types or element.values or element.quantity is not None:
        return element
    return replace(element, semantic_types=filler_of(element.framenet))


def _names(reader: Reader, node: Optional[yaml.Node], key: str, known: FrozenSet[str]) -> Tuple[str, ...]:
    """Read names of relations or quantifiers; unknown ones are reported."""
    names = reader.texts(node, key)
    for name in names:
        if node is not None and name not in known:
            expected = f"one of {', '.join(sorted(known))}"
            reader.report("UNKNOWN_VALUE", node, key, f"'{name}'", expected, did_you_mean(name, known))
    return names


def _counts(reader: Reader, node: Optional[yaml.Node], key: str) -> Tuple[int, ...]:
    texts = reader.texts(node, key)
    if node is not None and not all(text.isdecimal() and len(text) < 10 for text in texts):
        reader.report("NOT_A_NUMBER", node, key, f"'{', '.join(texts)}'", "whole numbers of things, such as [1, 2]")
        return ()
    return tuple(int(text) for text in texts)


def _limit(
    reader: Reader, entries: Dict[str, yaml.Node], key: str, name: str, quantity: Optional[Quantity]
) -> Optional[float]:
    node = entries.get(name)
    if node is None:
        return None
    text = reader.text(node, f"{key}.{name}")
    if quantity is None:
        reader.report("NO_QUANTITY", node, f"{key}.{name}", f"'{text}'", "a limit only beside the key 'quantity'")
        return None
    try:
        try:
            value = parse_number(text)
        except QuantityError:
            value = parse_measure(text, quantity=quantity.value).si_amount
    except QuantityError as error:
        reader.report(
            "NOT_A_MEASURE",
            node,
            f"{key}.{name}",
            describe(node),
            f"a {quantity.value}, such as '20 metres'",
            str(error),
        )
        return None
    return value if math.isfinite(value) else None


def _children(
    reader: Reader, node: Optional[yaml.Node], elements: Tuple[FrameElement, ...]
) -> Tuple[Tuple[RelatedFrame, ...], ...]:
    sequences = []
    for key, item in reader.sequence(node, "children"):
        members = reader.sequence(item, key) if isinstance(item, yaml.SequenceNode) else [(key, item)]
        if not members:
            reader.report("EMPTY", item, key, "an empty sequence", "at least one child")
        sequences.append(tuple(_child(reader, member, member_key, elements) for member_key, member in members))
    return tuple(sequences)


def _child(reader: Reader, node: yaml.Node, key: str, elements: Tuple[FrameElement, ...]) -> RelatedFrame:
    entries = reader.mapping(node, key, CHILD_KEYS, required=("name",))
    relations = [
        _relation(reader, item, item_key, [element.name for element in elements])
        for item_key, item in reader.sequence(entries.get("frame_element_relations"), f"{key}.frame_element_relations")
    ]
    return RelatedFrame(
        name=reader.graph_name(entries.get("name"), f"{key}.name"),
        line=line_of(node),
        frame_element_relations=tuple(relation for relation in relations if relation is not None),
    )


def _relation(reader: Reader, node: yaml.Node, key: str, names: List[str]) -> Optional[FrameElementRelation]:
    entries = reader.mapping(node, key, RELATION_KEYS)

    def text(name: str) -> str:
        return reader.name(entries.get(name), f"{key}.{name}")

    makers: Dict[FrozenSet[str], Callable[[], FrameElementRelation]] = {
        frozenset(("parent_name", "child_name")): lambda: ElementMapping(
            text("parent_name"), text("child_name"), reader.text(entries.get("relation"), f"{key}.relation")
        ),
        frozenset(("parent_name", "child_value")): lambda: ValueCondition(
            text("parent_name"), reader.texts(entries["child_value"], f"{key}.child_value")
        ),
        frozenset(("parent_value", "child_name")): lambda: ConstantArgument(text("parent_value"), text("child_name")),
    }
    if not entries:
        return None
    is_mapping = {"parent_name", "child_name"} <= set(entries)
    make = makers.get(frozenset(entries) - ({"relation"} if is_mapping else frozenset()))
    if make is None:
        reader.report(
            "RELATION_FORM",
            node,
            key,
            " and ".join(entries),
            "parent_name and child_name, parent_name and child_value, or parent_value and child_name",
        )
        return None
    parent = entries.get("parent_name")
    if parent is not None and text("parent_name") not in names:
        reader.report(
            "UNKNOWN_ELEMENT",
            parent,
            f"{key}.parent_name",
            describe(parent),
            f"an element of this frame: {', '.join(names) or 'it has none'}",
            did_you_mean(text("parent_name"), names),
        )
    return make()
