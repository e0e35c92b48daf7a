"""From a lexical unit file of 2012 to a filled element, for each relation of the rule table: real sentences, parsed by
the shipped models; where no sentence of a command has the relation, or the models do not find it, a tree.
"""

from typing import Any, Dict, Tuple

import pytest

from semantic_framer.framer import LeftOverWords, Policy, Understood, read
from semantic_framer.units.lexicon import Lexicon
from semantic_frames import load_frame
from stanford_parser_ros.model import Parser
from stanford_parser_ros.stanford_dependencies import RULES
from utterance_passes.trees.conllu import from_conllu
from utterance_passes.trees.tree import DependencyTree

FRAME = load_frame("name: scene\nframe_elements:\n  - {name: filler, is_core: True}\n", "scene.yaml")
UNIT = """
frame_name: scene
verb: %s
frame_element_grammatical_relations:
  - name: filler
    relation: %s
"""

#: Relation of the file, sentence, verb, argument. A relation below a noun is the second of a chain.
SENTENCES: Tuple[Tuple[str, str, str, str], ...] = (
    ("nsubj", "Could you bring the mug?", "bring", "you"),
    ("dobj", "Bring the mug.", "bring", "mug"),
    ("iobj", "Give Bob the mug.", "give", "Bob"),
    ("tmod", "Move forward three feet.", "move", "feet"),
    ("npadvmod", "Move forward three feet.", "move", "feet"),
    ("ccomp", "Check whether the oven is hot.", "check", "hot"),
    ("xcomp", "Call this room the lab.", "call", "lab"),
    ("acomp", "Paint the door green.", "paint", "green"),
    ("advmod", "Turn left.", "turn", "left"),
    ("prt", "Turn on the light.", "turn", "on"),
    ("aux", "Could you bring the mug?", "bring", "Could"),
    ("discourse", "Please bring the mug.", "bring", "Please"),
    ("vocative", "Bring the mug, Robot.", "bring", "Robot"),
    ("expl", "There is a lamp on the desk.", "be", "There"),
    ("attr", "This is the office.", "be", "office"),
    ("prep_to", "Go to the office.", "go", "office"),
    ("prep_from", "Take the mug from the table.", "take", "table"),
    ("prep_on", "Put the mug on the table.", "put", "table"),
    ("prep_in", "Put the mug in the sink.", "put", "sink"),
    ("prep_into", "Carry the box into the garage.", "carry", "garage"),
    ("prep_with", "Scrub the pot with the brush.", "scrub", "brush"),
    ("prep_for", "Look for the remote.", "look", "remote"),
    ("prep_near", "Stay near the door.", "stay", "door"),
    ("prep_through", "Walk through the door.", "walk", "door"),
    ("prep_out_of", "Take the mug out of the box.", "take", "box"),
    ("prep_next_to", "Put the mug next to the lamp.", "put", "lamp"),
    ("prep_in_front_of", "Stop in front of the fridge.", "stop", "fridge"),
    ("prep", "Go to the office.", "go", "office"),
    ("prepc_by", "Clean the pot by scrubbing it.", "clean", "scrubbing"),
    ("dobj/det", "Bring the mug.", "bring", "the"),
    ("dobj/predet", "Bring all the mugs.", "bring", "all"),
    ("dobj/amod", "Bring the red mug.", "bring", "red"),
    ("dobj/num", "Bring two mugs.", "bring", "two"),
    ("dobj/number", "Bring two mugs.", "bring", "two"),
    ("dobj/nn", "Open the kitchen door.", "open", "kitchen"),
    ("dobj/poss", "Open Roger's door.", "open", "Roger"),
    ("dobj/poss/possessive", "Open Roger's door.", "open", "'s"),
    ("dobj/prep_of", "Open the door of the office.", "open", "office"),
    ("dobj/rcmod", "Bring the mug that stands on the table.", "bring", "stands"),
    ("dobj/vmod", "Bring the mug standing on the table.", "bring", "standing"),
    ("dobj/partmod", "Bring the mug standing on the table.", "bring", "standing"),
    ("dobj/infmod", "Find a way to open the door.", "find", "open"),
    ("dobj/conj_and", "Bring the mug and the plate.", "bring", "plate"),
    ("dobj/conj_or", "Bring the mug or the plate.", "bring", "plate"),
    ("dobj/conj", "Bring the mug and the plate.", "bring", "plate"),
    ("dobj/conj_and/cc", "Bring the mug and the plate.", "bring", "and"),
    ("ccomp/cop", "Check whether the oven is hot.", "check", "is"),
    ("advcl/mark", "Turn left because I say so.", "turn", "because"),
    ("advcl", "Turn left because I say so.", "turn", "say"),
    ("purpcl", "Turn left because I say so.", "turn", "say"),
    ("prepc_because", "Turn left because I say so.", "turn", "say"),
    # The same relations, named alone: in 2012 a unit had no chains.
    ("num", "Turn left 120 degrees.", "turn", "120"),
    ("number", "Turn left 120 degrees.", "turn", "120"),
    ("num", "Bring two mugs.", "bring", "two"),
    ("poss", "Go to Roger's office.", "go", "Roger"),
    ("poss", "Open Roger's door.", "open", "Roger"),
    ("amod", "Bring the red mug.", "bring", "red"),
    ("nn", "Go to the kitchen door.", "go", "kitchen"),
    ("det", "Bring the mug.", "bring", "the"),
    ("predet", "Bring all the mugs.", "bring", "all"),
    ("rcmod", "Bring the mug that stands on the table.", "bring", "stands"),
    ("vmod", "Bring the mug standing on the table.", "bring", "standing"),
    ("partmod", "Bring the mug standing on the table.", "bring", "standing"),
    ("infmod", "Find a way to open the door.", "find", "open"),
    ("ccomp/complm", "Check whether the oven is hot.", "check", "whether"),
    ("ccomp/neg", "Check whether the oven is not hot.", "check", "not"),
    ("ccomp/agent", "Check whether the door was opened by Bob.", "check", "Bob"),
    ("dobj", "Bring the mug and the plate.", "bring", "mug"),
)

#: Relation of the file, tree, argument: relations that no parse of a command is certain to have.
TREES: Tuple[Tuple[str, str, str], ...] = (
    # "The office, the big room" may be a list, and "closed" an adjective.
    (
        "prep_to/appos",
        (
            "1 act act VERB VB _ 0 root _ _\n2 to to ADP IN _ 3 case _ _\n3 office office NOUN NN _ 1 obl _ _"
            "\n4 room room NOUN NN _ 3 appos _ _"
        ),
        "room",
    ),
    (
        "appos",
        (
            "1 act act VERB VB _ 0 root _ _\n2 to to ADP IN _ 3 case _ _\n3 office office NOUN NN _ 1 obl _ _"
            "\n4 room room NOUN NN _ 3 appos _ _"
        ),
        "room",
    ),
    (
        "abbrev",
        (
            "1 act act VERB VB _ 0 root _ _\n2 to to ADP IN _ 3 case _ _\n3 office office NOUN NN _ 1 obl _ _"
            "\n4 room room NOUN NN _ 3 appos _ _"
        ),
        "room",
    ),
    (
        "ccomp/nsubjpass",
        (
            "1 act act VERB VB _ 0 root _ _\n2 doors door NOUN NNS _ 4 nsubj:pass _ _"
            "\n3 are be AUX VBP _ 4 aux:pass _ _\n4 closed close VERB VBN _ 1 ccomp _ _"
        ),
        "doors",
    ),
    (
        "ccomp/auxpass",
        (
            "1 act act VERB VB _ 0 root _ _\n2 doors door NOUN NNS _ 4 nsubj:pass _ _"
            "\n3 are be AUX VBP _ 4 aux:pass _ _\n4 closed close VERB VBN _ 1 ccomp _ _"
        ),
        "are",
    ),
    # "Act both mugs and plates": the models find a determiner.
    (
        "dobj/preconj",
        "1 Act act VERB VB _ 0 root _ _\n2 both both CCONJ CC _ 3 cc:preconj _ _\n3 mugs mug NOUN NNS _ 1 obj _ _",
        "both",
    ),
    # Subjects of a verb that are clauses: no command begins with one.
    ("csubj", "1 Turning turn VERB VBG _ 2 csubj _ _\n2 act act VERB VB _ 0 root _ _", "Turning"),
    ("csubjpass", "1 Turning turn VERB VBG _ 2 csubj:pass _ _\n2 act act VERB VB _ 0 root _ _", "Turning"),
    # The models hang "because of" and the like as one preposition with two words.
    (
        "prep_because_of",
        (
            "1 Act act VERB VB _ 0 root _ _\n2 because because ADP IN _ 4 case _ _\n3 of of ADP IN _ 2 fixed _ _"
            "\n4 rain rain NOUN NN _ 1 obl _ _"
        ),
        "rain",
    ),
    # Relations of speech that did not come out right.
    ("dep", "1 Act act VERB VB _ 0 root _ _\n2 thing thing NOUN NN _ 1 dep _ _", "thing"),
    ("dep", "1 Act act VERB VB _ 0 root _ _\n2 thing thing NOUN NN _ 1 dislocated _ _", "thing"),
    ("dep", "1 Act act VERB VB _ 0 root _ _\n2 thing thing NOUN NN _ 1 orphan _ _", "thing"),
)
#: Names that fill no element, and why.
UNFILLED: Dict[str, str] = {
    "root": "the verb itself",
    "punct": "no word",
    "mwe": "a part of a word",
    "goeswith": "a part of a word",
    "parataxis": "a clause of its own",
}


def fill(tree: DependencyTree, verb: str, relation: str) -> str:
    """Return what fills the element of a unit that asks for a relation; empty for nothing."""
    lexicon = Lexicon()
    lexicon.add_file(UNIT % (verb, relation), "scene.yaml")
    outcome, _ = read(tree, lexicon, {"scene": FRAME}, policy=Policy(left_over_words=LeftOverWords.IGNORE))
    if not isinstance(outcome, Understood):
        return getattr(outcome, "sentence", "")
    value = outcome.clauses[0][0].argument("filler")
    return value.text if value else ""


@pytest.mark.parametrize("relation, text, verb, argument", SENTENCES)
def test_sentence_fills_the_element(parser: Parser, relation: str, text: str, verb: str, argument: str) -> None:
    assert fill(parser.parse(text, frozenset([verb])), verb, relation) == argument


@pytest.mark.parametrize("relation, rows, argument", TREES)
def test_tree_fills_the_element(relation: str, rows: str, argument: str) -> None:
    assert fill(from_conllu(rows), "act", relation) == argument


def test_every_relation_of_the_rule_table_is_tried() -> None:
    tried = {step for relation, *_ in SENTENCES + TREES for step in relation.split("/")}
    names = {name for of_universal in RULES.values() for name in of_universal}
    assert names - tried - set(UNFILLED) == set()
    assert tried & set(UNFILLED) == set()


def test_unit_of_2012_for_a_measure_is_filled(parser: Parser) -> None:
    frame = load_frame(
        "name: turning\nframe_elements:\n  - {name: direction, is_core: True}\n  - {name: angle, is_core: True}\n"
        "  - {name: angle_unit, is_core: True}\n",
        "turning.yaml",
    )
    lexicon = Lexicon()
    lexicon.add_file(
        "frame_name: turning\nverb: turn\nframe_element_grammatical_relations:\n"
        "  - {name: direction, relation: advmod}\n  - {name: angle, relation: num}\n"
        "  - {name: angle_unit, relation: dobj}\n",
        "turning.yaml",
    )
    outcome, _ = read(parser.parse("Turn left 120 degrees.", frozenset(["turn"])), lexicon, {"turning": frame})
    assert isinstance(outcome, Understood), outcome
    found: Any = {value.name: value.text for value in outcome.clauses[0][0].arguments}
    assert found == {"direction": "left", "angle": "120", "angle_unit": "degrees"}
