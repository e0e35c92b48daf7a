"""All rules that can change how a sentence is read, and that can be switched off to see what each of them does."""

from typing import Iterable, Mapping, NamedTuple, Tuple

from semantic_framer.rules import RULES
from stanford_parser_ros.joint import lexicon_hints
from utterance_passes.table import NODES, PASSES

#: The stage of the rules that are no passes.
FRAMER = "framer"


class NamedRule(NamedTuple):
    """Where a rule runs, and what it does."""

    stage: str
    what: str


#: The rule of the units' words, the passes in their order, then the rules of the framer, by their names in the trace.
NAMED_RULES: Mapping[str, NamedRule] = {
    lexicon_hints.RULE: NamedRule("stanford_parser_ros", lexicon_hints.WHAT),
    **{one.name: NamedRule(NODES[one.name], one.what) for one in PASSES},
    **{name: NamedRule(FRAMER, what) for name, what in RULES.items()},
}


def unknown_rules(names: Iterable[str]) -> Tuple[str, ...]:
    """Return the names that no rule has."""
    return tuple(sorted(set(names) - set(NAMED_RULES)))
