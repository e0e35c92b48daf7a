"""Writes a lexical unit with all of its relations, as a file of 2012 would list them."""

from typing import List, Sequence

from semantic_frames.lexical_unit import ArgumentForm, ElementRelation, LexicalUnit


def written_out(unit: LexicalUnit) -> str:
    """Return a unit as YAML that inherits nothing.

    Args:
        unit: a unit with the relations that it inherits
    """
    lines = [f"- frame_name: {unit.frame_name}", f"  verb: {_list(unit.verbs)}"]
    if unit.relations:
        lines.append("  frame_element_grammatical_relations:")
    for relation in unit.relations:
        lines += _lines(relation)
    return "\n".join(lines)


def _lines(relation: ElementRelation) -> List[str]:
    found = [f"    - name: {relation.name}", f"      relation: {_list(list(map(str, relation.relations)))}"]
    if relation.argument is not ArgumentForm.HEAD:
        found.append(f"      argument: {relation.argument.value}")
    if relation.words:
        found.append(f"      words: {_list(relation.words)}")
    if relation.semantic_types:
        found.append(f"      semantic_type: {_list(relation.semantic_types)}")
    if relation.after_place:
        found.append(f"      after_place: {_list(relation.after_place)}")
    if relation.is_required:
        found.append("      required: True")
    if relation.is_wanted:
        found.append("      wanted: True")
    return found


def _list(texts: Sequence[str]) -> str:
    return texts[0] if len(texts) == 1 else f"[{', '.join(texts)}]"
