"""Draws clauses from the examples of the shipped units: ``python -m utterance_kinds.examples``.

The output was checked and corrected by hand (objects, and three clauses that the parser misread) and stored in
``clauses.tsv``, so that the set stays the same when units and parser change.
"""

import re
from typing import Dict, Iterator, Optional, Tuple

from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.pipeline import Parameters, Pipeline, Understanding
from semantic_framer.values.outcome import MEANING_ONLY

from .utterances import Clause

_POLITENESS = re.compile(r"^(robot, )?(please )?(?P<clause>.*?)( please)?[.!]?$", re.IGNORECASE)
#: Relations of a second clause: a question made of "check whether it is hot" would be two questions in one.
_SECOND_CLAUSE = frozenset(["ccomp", "advcl", "parataxis", "acl:relcl", "csubj", "xcomp"])
#: "High five!" alone is an exclamation, not a clause.
_CRIES = frozenset(["high five", "low five"])
#: Objects that do not occur in the passive: "a left was taken", "you were faced".
_NO_PASSIVE = frozenset(
    "me it us her him five 5 left right turn u-turn 180 look way hug hand arm hello goodbye picture photo".split()
)


def clauses_of_examples(pipeline: Pipeline) -> Iterator[Clause]:
    """Return the examples of all units that are plain imperatives of one clause and act unchanged."""
    seen: Dict[str, None] = {}
    verbs = frozenset(verb.split()[0] for verb in pipeline.knowledge.lexicon.verbs)
    for unit in pipeline.knowledge.lexicon.units:
        for example in unit.examples:
            match = _POLITENESS.match(example.text)
            if match is None:
                continue
            clause = match.group("clause")
            clause = clause[:1].lower() + clause[1:]
            if clause in seen or clause.split()[0] not in verbs or clause in _CRIES:
                continue
            seen[clause] = None
            understood = pipeline.understand_safely(clause)
            if _is_plain_imperative(understood):
                yield Clause(unit.frame_name, clause, _object(understood))


def _is_plain_imperative(understood: Understanding) -> bool:
    if understood.reply.outcome != "DONE" or understood.tree is None or len(understood.readings) != 1:
        return False
    words = understood.tree.words
    subjects = [word for word in words if word.deprel.startswith("nsubj")]
    verb_first = words[0].head == 0 or understood.readings[0].verb_positions[0] == 1
    return verb_first and not subjects and not any(word.deprel in _SECOND_CLAUSE for word in words)


def _object(understood: Understanding) -> str:
    """Return the object of the verb, as written, if the clause has a passive; otherwise an empty string."""
    assert understood.tree is not None
    tree = understood.tree
    objects = [word for word in tree.children(1) if word.deprel == "obj"]
    if len(objects) != 1 or objects[0].form.lower() in _NO_PASSIVE:
        return ""
    if any(word.deprel == "iobj" for word in tree.children(1)):
        return ""
    span = _span(tuple(word.index for word in tree.subtree(objects[0].index)))
    if span is None:
        return ""
    return tree.text[tree.word(span[0]).start_character : tree.word(span[1]).end_character]


def _span(positions: Tuple[int, ...]) -> Optional[Tuple[int, int]]:
    whole = positions == tuple(range(positions[0], positions[-1] + 1))
    return (positions[0], positions[-1]) if whole else None


def main() -> None:
    """Print the clauses as tab-separated values."""
    knowledge = load_knowledge([shipped_domains()])
    pretend_servers(knowledge.graph)
    print("frame\tclause\tobject")
    for clause in clauses_of_examples(Pipeline(knowledge, parameters=Parameters(policy=MEANING_ONLY))):
        print(f"{clause.frame_name}\t{clause.text}\t{clause.object}")


if __name__ == "__main__":
    main()
