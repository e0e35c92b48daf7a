"""Reads how an element is filled, in files of lexical units and of roles."""

from typing import Mapping, Tuple

import yaml

from checked_files.marked_yaml import Reader, did_you_mean, is_empty, line_of
from semantic_frames.lexical_unit import ArgumentForm, ElementRelation, RelationPath
from semantic_frames.relation_names import (
    MEASURE,
    PLACE,
    RELATIONS_OF_PLACE,
    STANFORD,
    UNIVERSAL,
    is_relation_name,
)
from semantic_frames.semantic_type import read_semantic_types

RELATION_KEYS = ("name", "relation", "argument", "words", "semantic_type", "required", "wanted", "after_place")


def read_relation(
    reader: Reader, node: yaml.Node, entries: Mapping[str, yaml.Node], key: str, name: str, *, is_of_2012: bool = False
) -> ElementRelation:
    """Read how an element is filled.

    Args:
        reader: collects the problems
        node: the entry, for its line
        entries: values by the names of :data:`RELATION_KEYS`
        key: of the entry, for problems
        name: of the element
        is_of_2012: whether the argument is the head word if the entry does not say so; otherwise it is the phrase,
            or the word that is listed
    """
    relation = entries.get("relation")
    if isinstance(relation, yaml.SequenceNode):
        alternatives = reader.sequence(relation, f"{key}.relation")
    else:
        alternatives = [(f"{key}.relation", relation)] if relation is not None and not is_empty(relation) else []
    paths = [path for item_key, item in alternatives for path in _paths(reader, item, item_key)]
    if relation is not None and not paths:
        reader.report("EMPTY", relation, f"{key}.relation", "no relation", "a relation such as dobj or prep_to")
    words = tuple(word.lower() for word in reader.texts(entries.get("words"), f"{key}.words"))
    types = read_semantic_types(reader, entries.get("semantic_type"), f"{key}.semantic_type")
    usual = ArgumentForm.HEAD if is_of_2012 or (words and not types) else ArgumentForm.PHRASE
    return ElementRelation(
        name=name,
        relations=tuple(paths),
        argument=ArgumentForm(
            reader.choice(
                entries.get("argument"), f"{key}.argument", [form.value for form in ArgumentForm], usual.value
            )
        ),
        words=words,
        is_required=reader.boolean(entries.get("required"), f"{key}.required"),
        is_wanted=reader.boolean(entries.get("wanted"), f"{key}.wanted"),
        after_place=tuple(word.lower() for word in reader.texts(entries.get("after_place"), f"{key}.after_place")),
        line=line_of(node),
        semantic_types=types,
    )


def _paths(reader: Reader, node: yaml.Node, key: str) -> Tuple[RelationPath, ...]:
    """Read a chain of relations; one that ends in "place" stands for as many as there are prepositions of place."""
    steps = tuple(step.strip() for step in reader.text(node, key).split("/"))
    for step in steps:
        if not is_relation_name(step) and isinstance(node, yaml.ScalarNode):
            known = sorted(UNIVERSAL | STANFORD | {MEASURE, PLACE})
            reader.report(
                "UNKNOWN_RELATION",
                node,
                key,
                f"'{step}'",
                "a relation of Universal or Stanford Dependencies (dobj, iobj, prep_to, obl:to, ...), steps of a chain "
                "divided by '/'",
                did_you_mean(step, known),
            )
    if steps[-1] == PLACE:
        return tuple(RelationPath((*steps[:-1], relation)) for relation in RELATIONS_OF_PLACE)
    return (RelationPath(steps),)
