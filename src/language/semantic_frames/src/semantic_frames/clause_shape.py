"""The grammar of a clause about the robot: its verb, its subject and its object, and what is asked of it."""

from dataclasses import dataclass, field
from typing import Dict, Mapping, Optional, Sequence, Tuple

import yaml

from checked_files.marked_yaml import Reader, did_you_mean, line_of
from semantic_frames.relation_names import is_relation_name

#: What a clause may ask: nothing, whether, or for what its question word stands for.
ASKED = ("nothing", "whether", "what", "who", "why", "how", "how many")
#: When it happens.
ASPECTS = ("present", "running", "done", "ever_done", "planned")
SHAPE_KEYS = ("verb", "noun", "subject", "object", "asks", "aspect", "modal", "negated", "said", "with", "elements")
#: Who is the subject: the robot, the speaker, what was spoken of, what is asked for, somebody who fills an element,
#: nobody in a command.
ROBOT, SPEAKER, IT, ASKED_FOR, ANYBODY, NOBODY = "you", "i", "it", "what", "anybody", "none"
_WHAT, _MANY, _WHETHER = "what", "how many", "whether"


@dataclass(frozen=True)
class ClauseShape:
    """What a clause must be to evoke the frame of its unit; all its other words must be padding.

    Attributes:
        verbs: lemmas, with a particle ("give up"), an infinitive ("plan to do"), or "be" and a predicate ("be busy")
        subjects: "you", "i", "it", "what" for the subject that is asked for, "anybody" for one that fills an element,
            "none" for a command, or phrases as `objects` has them
        objects: the words of a phrase that matter, the head last: "your last command"; none if only what is asked for
            may be an object; with "none" among them, the clause may have no object
        asks: what may be asked, of :data:`ASKED`
        aspects: when it may happen, of :data:`ASPECTS`; none for any time
        modals: what the auxiliary of modality must be, "none" for a clause without one; none if there must not be any
        is_negated: whether it is denied
        said: words, of which one must be said beside it; none if nothing must
        beside: words that may be said beside it, as padding may
        elements: the relations that fill an element, by its name; only a core element must be filled
        line: where it begins, from 1
    """

    verbs: Tuple[str, ...]
    subjects: Tuple[str, ...] = (ROBOT,)
    objects: Tuple[str, ...] = ()
    asks: Tuple[str, ...] = (_WHAT,)
    aspects: Tuple[str, ...] = ()
    modals: Tuple[str, ...] = ()
    is_negated: bool = False
    said: Tuple[str, ...] = ()
    beside: Tuple[str, ...] = ()
    elements: Mapping[str, Tuple[str, ...]] = field(default_factory=dict)
    line: int = 0


def read_shapes(reader: Reader, node: yaml.Node, key: str) -> Tuple[ClauseShape, ...]:
    """Read one shape, or a list of them.

    A shape with "noun" stands for two: "what are *your rules*", and "do you have *any rules*", "which *rules* do you
    follow" with the verbs of the shape beside "have".
    """
    items = reader.sequence(node, key) if isinstance(node, yaml.SequenceNode) else [(key, node)]
    return tuple(shape for item_key, item in items for shape in _shapes(reader, item, item_key))


def _shapes(reader: Reader, node: yaml.Node, key: str) -> Sequence[ClauseShape]:
    entries = reader.mapping(node, key, SHAPE_KEYS)
    verbs, nouns, subjects, objects, asks, aspects, modals, said, beside = (
        lowered_phrases(reader, entries.get(name), f"{key}.{name}")
        for name in ("verb", "noun", "subject", "object", "asks", "aspect", "modal", "said", "with")
    )
    if not verbs and not nouns:
        reader.report("EMPTY", node, key, "neither 'verb' nor 'noun'", "the verbs of the clause, or what it asks for")
    for name, values, known in (("asks", asks, ASKED), ("aspect", aspects, ASPECTS)):
        for value in values:
            if value not in known:
                hint = did_you_mean(value, known)
                reader.report("NOT_A_CHOICE", entries[name], f"{key}.{name}", f"'{value}'", ", ".join(known), hint)
    line = line_of(node)
    if nouns:
        return (
            ClauseShape(("be",), nouns, beside=beside, line=line),
            ClauseShape(
                verbs=("have", *verbs),
                subjects=subjects or (ROBOT,),
                objects=nouns,
                asks=asks or (_WHAT, _MANY, _WHETHER),
                beside=beside,
                line=line,
            ),
        )
    return (
        ClauseShape(
            verbs=verbs,
            subjects=subjects or (ROBOT,),
            objects=objects,
            asks=asks or (_WHAT,),
            aspects=aspects,
            modals=modals,
            is_negated=reader.boolean(entries.get("negated"), f"{key}.negated"),
            said=said,
            beside=beside,
            elements=_elements(reader, entries.get("elements"), f"{key}.elements"),
            line=line,
        ),
    )


def lowered_phrases(reader: Reader, node: Optional[yaml.Node], key: str) -> Tuple[str, ...]:
    """Read phrases as they are compared: in lower case, with one blank between words."""
    return tuple(" ".join(text.lower().split()) for text in reader.texts(node, key))


def _elements(reader: Reader, node: Optional[yaml.Node], key: str) -> Mapping[str, Tuple[str, ...]]:
    found: Dict[str, Tuple[str, ...]] = {}
    for name_node, value in reader.free_mapping(node, key):
        name = reader.graph_name(name_node, key)
        found[name] = reader.texts(value, f"{key}.{name}")
        for relation in found[name]:
            if not is_relation_name(relation):
                expected = "a relation of Stanford Dependencies (dobj, prep_for, ...)"
                reader.report("UNKNOWN_RELATION", value, f"{key}.{name}", f"'{relation}'", expected)
    return found
