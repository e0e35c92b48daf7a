"""Phrases that hang on the verb, and tell which thing is meant."""

from phrase_meanings.head_words import is_side_of_something
from semantic_framer.filling.attachment import is_postmodifier_of, words_before, words_before_amount
from semantic_framer.values.sentence import Sentence
from utterance_passes.trees.conllu import from_conllu


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
FOLLOW_THE_GUY_WITH_A_HAT = (
    "follow VERB 0 root",
    "the DET 3 det",
    "guy NOUN 1 obj",
    "with ADP 6 case",
    "a DET 6 det",
    "hat NOUN 1 obl",
)


def test_a_place_behind_a_thing_is_postmodifier_of_one():
    assert is_postmodifier_of(sentence(*CLOSE_THE_DOOR_ON_THE_RIGHT).tree, 6, 3, is_described=False)


def test_with_describes_only_what_the_verb_is_about():
    follow = sentence(*FOLLOW_THE_GUY_WITH_A_HAT).tree
    assert is_postmodifier_of(follow, 6, 3, is_described=True)
    assert not is_postmodifier_of(follow, 6, 3, is_described=False)


def test_a_direction_is_a_side_where_of_follows():
    to_the_left = ("go VERB 0 root", "to ADP 4 case", "the DET 4 det", "left NOUN 1 obl")
    assert not is_side_of_something(sentence(*to_the_left).tree, 4)
    assert is_side_of_something(sentence(*to_the_left, "of ADP 6 case", "tables NOUN 4 nmod").tree, 4)


def test_an_adverb_makes_a_preposition_more_precise():
    close_to = sentence("go VERB 0 root", "close ADV 1 advmod", "to ADP 4 case", "doors NOUN 1 obl").tree
    assert words_before(close_to, 1, 3, frozenset([2])) == frozenset([2])
    assert words_before(close_to, 1, 3, frozenset()) == frozenset()


def test_words_in_front_of_a_number_belong_to_it():
    by_almost = sentence(
        "turn VERB 0 root", "by ADP 5 case", "almost ADV 4 advmod", "90 NUM 5 nummod", "degrees NOUN 1 obl"
    )
    assert words_before_amount(by_almost, 4) == frozenset([2, 3])
