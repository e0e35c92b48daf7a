"""Parts of a typed argument by name, for files that bind them to fields: "goal.relation", "angle.si"."""

from typing import Callable, Mapping, Optional, Union

from typed_arguments.argument import TypedArgument

Part = Union[str, float, int]


def _of_measure(name: str) -> Callable[[TypedArgument], Optional[Part]]:
    def read(argument: TypedArgument) -> Optional[Part]:
        value: Optional[Part] = getattr(argument.measure, name) if argument.measure is not None else None
        return value

    return read


#: How each part is read; None or an empty text when it was not said.
PARTS: Mapping[str, Callable[[TypedArgument], Optional[Part]]] = {
    "text": lambda argument: argument.text,
    "words": lambda argument: argument.words,
    "head": lambda argument: argument.head,
    "lemma": lambda argument: argument.lemma,
    "relation": lambda argument: argument.relation,
    "quantifier": lambda argument: argument.quantifier,
    "count": lambda argument: argument.count,
    "direction": lambda argument: argument.direction,
    "conjunction": lambda argument: argument.conjunction,
    "semantic_type": lambda argument: argument.semantic_type,
    "possessor": lambda argument: argument.possessor.text if argument.possessor else None,
    "complement": lambda argument: argument.complement.text if argument.complement else None,
    "modifiers": lambda argument: " ".join(modifier.lemma or modifier.word for modifier in argument.modifiers),
    "referent": lambda argument: argument.referents[0] if argument.referents else None,
    "source": lambda argument: argument.source.name.lower(),
    "si": lambda argument: argument.si,
    "amount": _of_measure("amount"),
    "unit": _of_measure("unit"),
    "bound": _of_measure("bound"),
    "change": _of_measure("change"),
}
