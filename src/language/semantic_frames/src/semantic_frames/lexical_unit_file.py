"""Lexical unit files: one unit or a list of units, as in 2012, with additions."""

import re
from typing import Dict, FrozenSet, List, Mapping, Optional, Tuple

import yaml

from checked_files.marked_yaml import Reader, did_you_mean, line_of
from checked_files.problem import Problem
from semantic_frames.clause_shape import lowered_phrases, read_shapes
from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import (
    SLOT_KINDS,
    ElementChange,
    ElementRelation,
    Example,
    HeldState,
    LexicalUnit,
    WordPattern,
)
from semantic_frames.relation_reader import RELATION_KEYS, read_relation
from semantic_frames.roles import inherited, with_inherited

UNIT_KEYS = (
    "frame_name",
    "verb",
    "verb_class",
    "question",
    "remark",
    "clause",
    "asks",
    "holds",
    "event",
    "subject",
    "values",
    "frame_element_grammatical_relations",
    "elements",
    "examples",
)
#: The attribute of a relation that each key of an element gives.
_ATTRIBUTES = {
    "relation": "relations",
    "argument": "argument",
    "words": "words",
    "semantic_type": "semantic_types",
    "required": "is_required",
    "wanted": "is_wanted",
    "after_place": "after_place",
}
#: A sense of a verb, as "get.v.01": the verb, and the number of the sense in WordNet.
_SENSE = re.compile(r"^[a-z_]+\.v\.\d\d$")
#: Says that a unit does not fill an element.
_NOTHING = "none"
#: What may stand in the place of verbs.
PATTERN_KEYS = ("question", "remark", "clause", "asks", "holds")
#: Elements of states, of which a condition may be said.
STATE_ELEMENTS = (
    "theme",
    "verb",
    "location",
    "state",
    "owner",
    "possession",
    "goal",
    "time",
    "side",
    "measure",
    "unit",
    "comparison",
    "standard",
)
EXAMPLE_KEYS = ("text", "frame_elements")


def load_lexical_units(text: str, path: str) -> Tuple[LexicalUnit, ...]:
    """Read a lexical unit file.

    Args:
        text: content of the file
        path: where it came from, for problems and for :attr:`LexicalUnit.path`
    Returns:
        its units, at least one
    Raises:
        FileRefused: the file has mistakes; the exception carries all of them
    """
    reader = Reader(path)
    root = reader.compose(text, "a mapping with frame_name and verb, or a list of them")
    if isinstance(root, yaml.SequenceNode):
        units = tuple(_unit(reader, item, f"[{index}]") for index, item in enumerate(root.value))
    else:
        units = (_unit(reader, root, ""),)
    reader.refuse_if_wrong()
    return units


def _unit(reader: Reader, node: yaml.Node, key: str) -> LexicalUnit:
    prefix = f"{key}." if key else ""
    has_patterns = any(pattern in _keys(node) for pattern in PATTERN_KEYS)
    has_event = "event" in _keys(node)
    is_bare = has_patterns or has_event
    entries = reader.mapping(node, key, UNIT_KEYS, required=("frame_name",) if is_bare else ("frame_name", "verb"))
    events = lowered_phrases(reader, entries.get("event"), f"{prefix}event")
    verbs = lowered_phrases(reader, entries.get("verb"), f"{prefix}verb")
    listed, changed = entries.get("frame_element_grammatical_relations"), entries.get("elements")
    if changed is not None and (listed is not None or has_patterns):
        beside = "frame_element_grammatical_relations" if listed is not None else "patterns of words"
        reader.report(
            "INHERITS_NOTHING",
            changed,
            f"{prefix}elements",
            f"'elements' beside {beside}",
            "only one of them: 'elements' says what is special about a verb that inherits the usual relations",
        )
    listed_class = _arguments(reader, entries.get("verb_class"), f"{prefix}verb_class")
    class_verbs = {verb.lower(): sense for verb, sense in listed_class.items()}
    for verb, sense in class_verbs.items():
        if not _SENSE.match(sense) or sense.rsplit(".", 2)[0].replace("_", " ") not in verbs or verb in verbs:
            expected = "for each other verb, a sense of one of the verbs, such as get.v.01"
            reader.report("NOT_A_SENSE", entries["verb_class"], f"{prefix}verb_class.{verb}", f"'{sense}'", expected)
    inherits = bool(verbs or events) and listed is None and not has_patterns
    if "verb" in entries and not any(verbs):
        reader.report("EMPTY", entries["verb"], f"{prefix}verb", "no verb", "a verb or a list of verbs")
    return LexicalUnit(
        frame_name=reader.graph_name(entries.get("frame_name"), f"{prefix}frame_name"),
        verbs=(*verbs, *class_verbs),
        class_verbs=class_verbs,
        relations=tuple(
            _relation(reader, item, item_key)
            for item_key, item in reader.sequence(listed, f"{prefix}frame_element_grammatical_relations")
        ),
        changes=_changes(reader, changed, f"{prefix}elements") if inherits else None,
        examples=_examples(reader, entries.get("examples"), f"{prefix}examples"),
        questions=_patterns(reader, entries.get("question"), f"{prefix}question"),
        remarks=_patterns(reader, entries.get("remark"), f"{prefix}remark"),
        clauses=read_shapes(reader, entries["clause"], f"{prefix}clause") if "clause" in entries else (),
        asks=reader.texts(entries.get("asks"), f"{prefix}asks"),
        holds=_holds(reader, entries.get("holds"), f"{prefix}holds"),
        events=events,
        subjects=lowered_phrases(reader, entries.get("subject"), f"{prefix}subject"),
        values=_arguments(reader, entries.get("values"), f"{prefix}values"),
        path=reader.path,
        line=line_of(node),
    )


def _keys(node: yaml.Node) -> FrozenSet[str]:
    return frozenset(str(key.value) for key, _ in node.value) if isinstance(node, yaml.MappingNode) else frozenset()


def _holds(reader: Reader, node: Optional[yaml.Node], key: str) -> Tuple[HeldState, ...]:
    """Read the names of states, or one state with what its elements fill and which words they may be."""
    if not isinstance(node, yaml.MappingNode):
        return tuple(HeldState(name) for name in reader.texts(node, key))
    entries = reader.mapping(node, key, ("frame", *STATE_ELEMENTS), required=("frame",))
    elements: List[Tuple[str, str]] = []
    words: List[Tuple[str, Tuple[str, ...]]] = []
    for name, value in entries.items():
        if name == "frame":
            continue
        inner = f"{key}.{name}"
        if isinstance(value, yaml.SequenceNode):
            words.append((name, lowered_phrases(reader, value, inner)))
        elif isinstance(value, yaml.MappingNode):
            both = reader.mapping(value, inner, ("element", "words"), required=("element", "words"))
            elements.append((name, reader.graph_name(both.get("element"), f"{inner}.element")))
            words.append((name, lowered_phrases(reader, both.get("words"), f"{inner}.words")))
        else:
            elements.append((name, reader.graph_name(value, inner)))
    return (HeldState(reader.graph_name(entries.get("frame"), f"{key}.frame"), tuple(elements), tuple(words)),)


def _patterns(reader: Reader, node: Optional[yaml.Node], key: str) -> Tuple[WordPattern, ...]:
    """Read patterns such as "where (is|are) <theme>"."""
    items = reader.sequence(node, key) if isinstance(node, yaml.SequenceNode) else [(key, node)] if node else []
    found = []
    for item_key, item in items:
        text = " ".join(reader.name(item, item_key).lower().split())
        pattern = WordPattern(text, line_of(item))
        try:
            pattern.compile(dict.fromkeys(SLOT_KINDS, ".+?"))
        except (re.error, KeyError) as error:
            kinds = ", ".join(f"<element:{kind}>" for kind in SLOT_KINDS if kind)
            expected = f"words, (a|b), (a )?, <element>, {kinds}"
            reader.report("NOT_A_PATTERN", item, item_key, f"'{text}' ({error})", expected)
            continue
        found.append(pattern)
    if node is not None and not items:
        reader.report("EMPTY", node, key, "no pattern", "a pattern, or a list of patterns")
    return tuple(found)


def _relation(reader: Reader, node: yaml.Node, key: str) -> ElementRelation:
    entries = reader.mapping(node, key, RELATION_KEYS, required=("name", "relation"))
    name = reader.graph_name(entries.get("name"), f"{key}.name")
    return read_relation(reader, node, entries, key, name, is_of_2012=True)


def _changes(reader: Reader, node: Optional[yaml.Node], key: str) -> Tuple[ElementChange, ...]:
    """Read what a unit says of elements that it otherwise inherits."""
    changes: List[ElementChange] = []
    for name_node, value in reader.free_mapping(node, key):
        name = reader.graph_name(name_node, key)
        if any(change.relation.name == name for change in changes):
            reader.report(
                "DUPLICATE_KEY", name_node, f"{key}.{name}", f"a second '{name}'", "one, with a list of entries"
            )
        is_list = isinstance(value, yaml.SequenceNode) and all(isinstance(one, yaml.MappingNode) for one in value.value)
        items = reader.sequence(value, f"{key}.{name}") if is_list else [(f"{key}.{name}", value)]
        changes += [_change(reader, item, item_key, name) for item_key, item in items]
    return tuple(changes)


def _change(reader: Reader, node: yaml.Node, key: str, name: str) -> ElementChange:
    if isinstance(node, yaml.ScalarNode) and node.value == _NOTHING:
        return ElementChange(ElementRelation(name, (), line=line_of(node)))
    if isinstance(node, yaml.MappingNode):
        entries = reader.mapping(node, key, [known for known in RELATION_KEYS if known != "name"])
    else:
        entries = {"relation": node}
    keys = frozenset(_ATTRIBUTES[key] for key in entries)
    return ElementChange(read_relation(reader, node, entries, key, name), keys)


def _examples(reader: Reader, node: Optional[yaml.Node], key: str) -> Tuple[Example, ...]:
    """Read examples: a list, or a mapping of texts to the arguments of their elements."""
    if not isinstance(node, yaml.MappingNode):
        return tuple(_example(reader, item, item_key) for item_key, item in reader.sequence(node, key))
    found: Dict[str, Example] = {}
    for text_node, value in node.value:
        text = reader.name(text_node, key)
        if text in found:
            reader.report("DUPLICATE_KEY", text_node, key, f"a second '{text}'", "one")
        found[text] = Example(text, _arguments(reader, value, f"{key}.{text}"), line_of(text_node))
    return tuple(found.values())


def _example(reader: Reader, node: yaml.Node, key: str) -> Example:
    entries = reader.mapping(node, key, EXAMPLE_KEYS, required=("text",))
    return Example(
        text=reader.name(entries.get("text"), f"{key}.text"),
        frame_elements=_arguments(reader, entries.get("frame_elements"), f"{key}.frame_elements"),
        line=line_of(node),
    )


def _arguments(reader: Reader, node: Optional[yaml.Node], key: str) -> Mapping[str, str]:
    """Read arguments by the names of their elements."""
    arguments: Dict[str, str] = {}
    if isinstance(node, yaml.MappingNode):
        for name_node, value in node.value:
            name = reader.text(name_node, key)
            if name in arguments:
                reader.report("DUPLICATE_KEY", name_node, f"{key}.{name}", f"a second '{name}'", "one")
            arguments[name] = reader.text(value, f"{key}.{name}")
    elif node is not None:
        reader.report("WRONG_TYPE", node, key, "no mapping", "arguments by element name")
    return arguments


def check_lexical_unit(unit: LexicalUnit, frames: Mapping[str, SemanticFrame]) -> List[Problem]:
    """Check a unit against the known frames.

    Args:
        unit: the unit
        frames: by name
    Returns:
        problems: an unknown frame, an unknown element in a relation or an example, a core element that nothing can fill
    """
    frame = frames.get(unit.frame_name)
    if frame is None:
        return [
            Problem(
                "UNKNOWN_FRAME",
                unit.path,
                unit.line,
                "frame_name",
                f"'{unit.frame_name}'",
                "the name of a frame",
                did_you_mean(unit.frame_name, frames),
            )
        ]
    names = [element.name for element in frame.frame_elements]
    named = [(relation.line, "frame_element_grammatical_relations", relation.name) for relation in unit.relations]
    named += [(change.relation.line, "elements", change.relation.name) for change in unit.changes or ()]
    named += [(pattern.line, "question", name) for pattern in unit.questions for name in pattern.elements]
    named += [(pattern.line, "remark", name) for pattern in unit.remarks for name in pattern.elements]
    named += [(shape.line, "clause", name) for shape in unit.clauses for name in shape.elements]
    named += [(unit.line, "holds", name) for held in unit.holds for _, name in held.elements or ()]
    named += [(unit.line, "values", name) for name in unit.values]
    named += [(example.line, "examples", name) for example in unit.examples for name in example.frame_elements]
    problems = [
        Problem(
            "UNKNOWN_ELEMENT",
            unit.path,
            line,
            key,
            f"'{name}'",
            f"an element of {frame.name}: {', '.join(names) or 'it has none'}",
            did_you_mean(name, names),
        )
        for line, key, name in named
        if name not in names
    ]
    problems += [
        Problem(
            "NO_USUAL_RELATION",
            unit.path,
            change.relation.line,
            f"elements.{element.name}",
            "no relation",
            f"the key 'relation': the role {element.framenet or 'of the element'} has no usual relations",
        )
        for change in unit.changes or ()
        for element in frame.frame_elements
        if element.name == change.relation.name
        and change.keys
        and not change.relation.relations
        and not inherited(frame, element)
    ]
    filled = {relation.name for relation in with_inherited(unit, frame).relations} | set(unit.values)
    filled |= {name for held in unit.holds for _, name in held.elements or ()}
    ways = [pattern.elements for pattern in unit.questions + unit.remarks]
    ways += [tuple(shape.elements) for shape in unit.clauses]
    if ways:
        filled |= frozenset.intersection(*map(frozenset, ways))
    if (unit.questions or unit.asks or unit.clauses) and not frame.is_question:
        problems.append(
            Problem(
                "NOT_A_QUESTION",
                unit.path,
                unit.line,
                "question" if unit.questions else "asks" if unit.asks else "clause",
                f"the frame {frame.name}, which acts",
                "a frame with 'is_question: True': a question never acts",
            )
        )
    is_condition = bool(unit.holds or unit.events)
    if is_condition and not frame.is_condition:
        problems.append(
            Problem(
                "NOT_A_CONDITION",
                unit.path,
                unit.line,
                "holds" if unit.holds else "event",
                f"the frame {frame.name}, which acts",
                "a frame with 'is_condition: True': a condition is watched, and never carried out",
            )
        )
    if frame.is_condition and not is_condition:
        problems.append(
            Problem(
                "NOT_A_COMMAND",
                unit.path,
                unit.line,
                "verb" if unit.verbs else "question",
                f"the frame {frame.name}, which is a condition",
                "'event' or 'holds' in its place: a condition is watched, and never carried out",
            )
        )
    problems += [
        Problem(
            "CORE_NOT_FILLED",
            unit.path,
            unit.line,
            "frame_element_grammatical_relations",
            f"nothing for '{element.name}'",
            f"a relation for every core element of {frame.name}, or a default in its file",
        )
        for element in frame.frame_elements
        # What a question asks for, it leaves out; a state fills the elements that have the same names.
        if element.is_core and not element.default and element.name not in filled and not unit.asks
        if not any(held.elements is None for held in unit.holds)
    ]
    return problems
