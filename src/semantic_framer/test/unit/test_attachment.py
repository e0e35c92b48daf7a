"""Which words belong to which element, on parses written by hand: no model needed."""

from typing import Dict, Tuple

import pytest

from semantic_framer.filling.descriptions import descriptions
from semantic_framer.framer import LeftOverWords, Policy, Refusal, Understood, read
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.lexicon import Lexicon
from semantic_framer.values.sentence import Sentence
from semantic_frames import load_frame
from utterance_passes.engine.running import run_tree_passes
from utterance_passes.phrases.clauses import find_clauses
from utterance_passes.table import PARSE_CORRECTING_PASSES
from utterance_passes.trees.conllu import from_conllu
from utterance_passes.trees.vocabulary import Verbs

FRAMES = {
    frame.name: frame
    for frame in (
        load_frame(text, "frame.yaml")
        for text in (
            "name: taking\nframe_elements:\n  - {name: theme, is_core: True}\n  - {name: source, is_core: False}\n",
            "name: saying\nframe_elements:\n  - {name: message, is_core: True, framenet: Message}\n",
            "name: bringing\nframe_elements:\n  - {name: theme, is_core: True}\n  - {name: goal, is_core: False}\n",
            (
                "name: being_located\nframe_elements:\n  - {name: theme, is_core: True}\n"
                "  - {name: location, is_core: True}\n"
            ),
            "name: releasing\nframe_elements:\n  - {name: theme, is_core: True}\n",
        )
    )
}
UNITS = """
- frame_name: taking
  verb: [take, lift]
  frame_element_grammatical_relations:
    - {name: theme, relation: dobj, argument: phrase}
    - {name: source, relation: prep_from, argument: phrase}
- frame_name: taking
  verb: [remove]
  frame_element_grammatical_relations:
    - {name: theme, relation: dobj, argument: phrase}
    - {name: source, relation: [prep_from, prep_on], argument: phrase}
- frame_name: bringing
  verb: take
  frame_element_grammatical_relations:
    - {name: theme, relation: dobj, argument: phrase, required: True}
    - {name: goal, relation: [prep_on, prep_near], argument: phrase, required: True, after_place: [on]}
- frame_name: being_located
  verb: [be, stand]
  frame_element_grammatical_relations:
    - {name: theme, relation: nsubj, argument: phrase, required: True}
    - {name: location, relation: prep_on, argument: phrase, required: True}
- frame_name: saying
  verb: say
  frame_element_grammatical_relations:
    - {name: message, relation: dobj, argument: phrase}
- frame_name: releasing
  verb: let go of
  frame_element_grammatical_relations:
    - {name: theme, relation: prep_of, argument: phrase}
"""
ROWS = (
    "1 {verb} {verb} VERB VB _ 0 root _ _\n2 the the DET DT _ 3 det _ _\n3 mug mug NOUN NN _ 1 obj _ _"
    "\n4 {preposition} {preposition} ADP IN _ 6 case _ _\n5 the the DET DT _ 6 det _ _"
    "\n6 table table NOUN NN _ 1 obl _ _"
)


def lexicon() -> Lexicon:
    made = Lexicon()
    made.add_file(UNITS, "units.yaml")
    return made


def filled(rows: str) -> Dict[str, str]:
    outcome, _ = read(from_conllu(rows), lexicon(), FRAMES, policy=Policy())
    assert isinstance(outcome, Understood), outcome
    return {value.name: value.text for value in outcome.clauses[0][0].arguments}


@pytest.mark.parametrize(
    "verb, preposition, arguments",
    [
        ("take", "on", {"theme": "the mug on the table"}),
        ("take", "from", {"theme": "the mug", "source": "the table"}),
        ("remove", "on", {"theme": "the mug", "source": "the table"}),
    ],
)
def test_phrase_of_place_that_fills_nothing_belongs_to_the_noun_before_it(
    verb: str, preposition: str, arguments: Dict[str, str]
) -> None:
    assert filled(ROWS.format(verb=verb, preposition=preposition)) == arguments


@pytest.mark.parametrize("verb, preposition", [("take", "with"), ("take", "to"), ("say", "on")])
def test_other_phrases_that_fill_nothing_are_left_over(verb: str, preposition: str) -> None:
    strict = Policy(left_over_words=LeftOverWords.STRICT)
    outcome, _ = read(from_conllu(ROWS.format(verb=verb, preposition=preposition)), lexicon(), FRAMES, policy=strict)
    assert isinstance(outcome, Refusal) and outcome.code == "LEFT_OVER_WORDS"


@pytest.mark.parametrize(
    "first, second",
    [
        # The verb is what the second unit is about, wherever it stands in the first.
        (("fetch", "[fetch, take]", ""), ("take", "[take, fetch]", "")),
        # Neither is about it: fewer elements stay empty.
        (("bring", "[bring, take]", "{name: source, relation: prep_from}"), ("lift", "[lift, take]", "")),
        # Neither, and as many stay empty: it is listed earlier.
        (("bring", "[bring, carry, take]", ""), ("lift", "[lift, take, carry]", "")),
    ],
)
@pytest.mark.parametrize("is_swapped", [False, True])
def test_unit_that_the_verb_names_comes_first(
    first: Tuple[str, str, str], second: Tuple[str, str, str], is_swapped: bool
) -> None:
    made = Lexicon()
    for name, verbs, relation in (second, first) if is_swapped else (first, second):
        relations = "[{name: theme, relation: dobj}" + (f", {relation}]" if relation else "]")
        made.add_file(
            f"{{frame_name: {name}, verb: {verbs}, frame_element_grammatical_relations: {relations}}}", f"{name}.yaml"
        )
    frames = {
        name: load_frame(
            f"name: {name}\nframe_elements:\n  - {{name: theme, is_core: True}}\n"
            "  - {name: source, is_core: False}\n",
            "frame.yaml",
        )
        for name, _, _ in (first, second)
    }
    rows = "1 take take VERB VB _ 0 root _ _\n2 boxes box NOUN NNS _ 1 obj _ _"
    outcome, _ = read(from_conllu(rows), made, frames)
    assert isinstance(outcome, Understood)
    assert [reading.unit.frame_name for reading in outcome.clauses[0]] == [second[0], first[0]]


def test_two_phrases_of_place_one_behind_the_other() -> None:
    rows = ROWS.format(verb="take", preposition="on") + (
        "\n7 in in ADP IN _ 9 case _ _\n8 the the DET DT _ 9 det _ _\n9 hall hall NOUN NN _ 1 obl _ _"
    )
    assert filled(rows) == {"theme": "the mug on the table in the hall"}


@pytest.mark.parametrize("head, relation", [(1, "obl"), (6, "nmod")])
@pytest.mark.parametrize(
    "first, second, arguments",
    [
        ("on", "on", {"theme": "the mug on the table", "goal": "the shelf"}),
        ("on", "near", {"theme": "the mug on the table", "goal": "the shelf"}),
        ("near", "on", {"theme": "the mug near the table on the shelf"}),
    ],
)
def test_second_place_is_where_it_shall_be(
    head: int, relation: str, first: str, second: str, arguments: Dict[str, str]
) -> None:
    rows = ROWS.format(verb="take", preposition=first) + (
        f"\n7 {second} {second} ADP IN _ 9 case _ _\n8 the the DET DT _ 9 det _ _"
        f"\n9 shelf shelf NOUN NN _ {head} {relation} _ _"
    )
    assert filled(rows) == arguments


def described(relative: str) -> Tuple[Dict[str, str], ...]:
    """Arguments of what is said of the mug in "take the mug that RELATIVE"."""
    rows = (
        "1 take take VERB VB _ 0 root _ _\n2 the the DET DT _ 3 det _ _\n3 mug mug NOUN NN _ 1 obj _ _\n"
        "4 that that PRON WDT _ {predicate} nsubj _ _\n" + relative
    )
    predicate = next(line.split()[0] for line in relative.splitlines() if "acl:relcl" in line)
    sentence = Sentence(from_conllu(rows.format(predicate=predicate)))
    found = descriptions(sentence, find_clauses(sentence.tree), FramedLexicon(lexicon(), FRAMES))
    return tuple({value.name: value.text for value in reading.arguments} for reading in found)


def test_relative_clause_says_where_a_thing_is() -> None:
    place = "5 is be AUX VBZ _ 8 cop _ _\n6 on on ADP IN _ 8 case _ _\n7 the the DET DT _ 8 det _ _"
    assert described(place + "\n8 table table NOUN NN _ 3 acl:relcl _ _") == (
        {"theme": "that", "location": "the table"},
    )


def test_relative_clause_with_the_verb_of_a_command_asks_for_nothing() -> None:
    assert described("5 takes take VERB VBZ _ 3 acl:relcl _ _\n6 milk milk NOUN NN _ 5 obj _ _") == ()


def test_relative_clause_that_is_not_wholly_understood_says_nothing() -> None:
    place = "5 stands stand VERB VBZ _ 3 acl:relcl _ _\n6 on on ADP IN _ 7 case _ _\n7 fire fire NOUN NN _ 5 obl _ _"
    assert described(place) == ({"theme": "that", "location": "fire"},)
    assert described(place + "\n8 since since ADP IN _ 9 case _ _\n9 Monday Monday PROPN NNP _ 5 obl _ _") == ()


def test_place_belongs_to_the_last_of_a_list() -> None:
    rows = (
        "1 take take VERB VB _ 0 root _ _\n2 cups cup NOUN NNS _ 1 obj _ _\n3 and and CCONJ CC _ 4 cc _ _"
        "\n4 plates plate NOUN NNS _ 2 conj _ _\n5 on on ADP IN _ 6 case _ _\n6 shelves shelf NOUN NNS _ 1 obl _ _"
    )
    outcome, _ = read(from_conllu(rows), lexicon(), FRAMES)
    assert isinstance(outcome, Understood)
    assert outcome.clauses[0][0].arguments[0].members[1].text == "plates on shelves"


LET_GO = (
    "1 let let VERB VB _ 0 root _ _\n2 go go VERB VB _ 1 xcomp _ _\n3 of of ADP IN _ 5 case _ _"
    "\n4 the the DET DT _ 5 det _ _\n5 rope rope NOUN NN _ 2 obl _ _"
)


def test_verb_of_several_words_is_one_verb_where_the_lexicon_has_it() -> None:
    assert filled(LET_GO) == {"theme": "the rope"}
    assert [clause.lemma for clause in find_clauses(from_conllu(LET_GO))] == ["go"]


def test_modal_with_a_subject_is_no_noun() -> None:
    rows = (
        "1 lift lift VERB VB _ 0 root _ _\n2 mugs mug NOUN NNS _ 1 obj _ _\n3 can can AUX MD _ 1 parataxis _ _"
        "\n4 you you PRON PRP _ 3 nsubj _ _"
    )
    tree = run_tree_passes(from_conllu(rows), Verbs(), PARSE_CORRECTING_PASSES)
    assert {word.upos for word in tree.words} == {"VERB", "NOUN", "AUX", "PRON"}
