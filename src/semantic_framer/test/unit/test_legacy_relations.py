"""A lexical unit of 2012 is filled by every relation of the rule table, under each of its Stanford names."""

from typing import Tuple

import pytest

from semantic_framer.framer import LeftOverWords, Policy, Understood, read
from semantic_framer.units.lexicon import Lexicon
from semantic_frames import load_frame
from stanford_parser_ros.stanford_dependencies import RULES
from utterance_passes.trees.conllu import from_conllu

FRAME = load_frame("name: scene\nframe_elements:\n  - {name: filler, is_core: True}\n", "frame.yaml")
UNIT = (
    "frame_name: scene\nverb: act\n"
    "frame_element_grammatical_relations:\n  - {name: filler, relation: %s, words: [thing]}\n"
)
#: Relations between two clauses, or of the root itself, fill nothing.
NO_ARGUMENTS = {
    "root",
    "punct",
    "conj",
    "parataxis",
    "list",
    "cop",
    "case",
    "mark",
    "cc",
    "cc:preconj",
    "ccomp",
    "xcomp",
    "fixed",
    "discourse",
    "vocative",
    "reparandum",
    "goeswith",
    "expl",
}
NAMES = [(relation, name) for relation, names in RULES.items() if relation not in NO_ARGUMENTS for name in names]


def fill(rows: str, relation: str) -> str:
    """Return what fills the element when a unit asks for a relation."""
    lexicon = Lexicon()
    lexicon.add_file(UNIT % relation, "unit.yaml")
    outcome, _ = read(from_conllu(rows), lexicon, {"scene": FRAME})
    assert isinstance(outcome, Understood), outcome
    value = outcome.clauses[0][0].argument("filler")
    return value.text if value else ""


@pytest.mark.parametrize("relation, name", NAMES)
def test_legacy_name_fills_the_element(relation: str, name: str) -> None:
    assert fill(f"1 Act act VERB VB _ 0 root _ _\n2 thing thing NOUN NN _ 1 {relation} _ _", name) == "thing"


@pytest.mark.parametrize("name", ["prep_to", "prep", "obl:to", "obl"])
def test_prepositional_phrase_fills_the_element(name: str) -> None:
    rows = "1 Act act VERB VB _ 0 root _ _\n2 to to ADP IN _ 3 case _ _\n3 thing thing NOUN NN _ 1 obl _ _"
    assert fill(rows, name) == "thing"


@pytest.mark.parametrize(
    "chain, deprel", [("dobj/poss", "nmod:poss"), ("dobj/num", "nummod"), ("obj/amod", "amod"), ("dobj/nn", "compound")]
)
def test_chain_of_relations_fills_the_element(chain: str, deprel: str) -> None:
    rows: Tuple[str, ...] = (
        "1 Act act VERB VB _ 0 root _ _",
        f"2 thing thing NOUN NN _ 3 {deprel} _ _",
        "3 door door NOUN NN _ 1 obj _ _",
    )
    lexicon = Lexicon()
    lexicon.add_file(UNIT % chain, "unit.yaml")
    outcome, _ = read(
        from_conllu("\n".join(rows)), lexicon, {"scene": FRAME}, policy=Policy(left_over_words=LeftOverWords.IGNORE)
    )
    assert isinstance(outcome, Understood) and outcome.clauses[0][0].argument("filler").text == "thing"
