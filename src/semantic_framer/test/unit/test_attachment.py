"""Phrases that hang on the verb, and tell which thing is meant."""

from semantic_framer.attachment import joined_phrases, words_before, words_before_amount
from semantic_framer.sentence import Sentence
from stanford_parser_ros.conllu import from_conllu


def sentence(*rows: str) -> Sentence:
    """Make a sentence from rows "form upos head deprel"."""
    lines = []
    for index, row in enumerate(rows, start=1):
        form, upos, head, deprel = row.split()
        lines.append("\t".join([str(index), form, form, upos, "_", "_", head, deprel, "_", "_"]))
    return Sentence(from_conllu("\n".join(lines) + "\n\n"))


CLOSE_THE_DOOR_ON_THE_RIGHT = (
    "close VERB 0 root",
    "the DET 3 det",
    "door NOUN 1 obj",
    "on ADP 6 case",
    "the DET 6 det",
    "right NOUN 1 obl",
)


def test_a_place_behind_a_thing_tells_which_one():
    joined = joined_phrases(
        sentence(*CLOSE_THE_DOOR_ON_THE_RIGHT), 1, {"portal": (3, frozenset([2, 3]))}, frozenset([4, 5, 6])
    )
    assert joined == {"portal": frozenset([4, 5, 6])}


def test_a_place_that_an_element_took_stays_there():
    joined = joined_phrases(sentence(*CLOSE_THE_DOOR_ON_THE_RIGHT), 1, {"portal": (3, frozenset([2, 3]))}, frozenset())
    assert joined == {}


def test_with_goes_to_a_thing_and_not_to_a_place():
    to_the_kitchen = sentence(
        "go VERB 0 root", "to ADP 3 case", "kitchen NOUN 1 obl", "with ADP 5 case", "Bob PROPN 1 obl"
    )
    assert joined_phrases(to_the_kitchen, 1, {"goal": (3, frozenset([2, 3]))}, frozenset([4, 5])) == {}


def test_a_pronoun_needs_no_telling():
    put_it = sentence("put VERB 0 root", "it PRON 1 obj", "on ADP 4 case", "tables NOUN 1 obl")
    assert joined_phrases(put_it, 1, {"theme": (2, frozenset([2]))}, frozenset([3, 4])) == {}


def test_an_adverb_makes_a_preposition_more_precise():
    close_to = sentence("go VERB 0 root", "close ADV 1 advmod", "to ADP 4 case", "doors NOUN 1 obl")
    assert words_before(close_to, 1, 3, frozenset([2])) == frozenset([2])
    assert words_before(close_to, 1, 3, frozenset()) == frozenset()


def test_words_in_front_of_a_number_belong_to_it():
    by_almost = sentence(
        "turn VERB 0 root", "by ADP 5 case", "almost ADV 4 advmod", "90 NUM 5 nummod", "degrees NOUN 1 obl"
    )
    assert words_before_amount(by_almost, 4) == frozenset([2, 3])
