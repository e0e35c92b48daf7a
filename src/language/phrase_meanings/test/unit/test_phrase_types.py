"""The semantic types of phrases: compounds, names, pronouns, measures and lists."""

from typing import Sequence

import pytest

from phrase_meanings.phrase_types import PhraseTypes
from semantic_types import WordTypes, shipped_types
from semantic_types.likelihood import Fit
from utterance_passes.trees.tree import DependencyTree, Word


def phrase(*words: str) -> DependencyTree:
    """Make a phrase; each word is "form lemma upos xpos head deprel"."""
    made = []
    for index, text in enumerate(words, start=1):
        form, lemma, upos, xpos, head, deprel = text.split()
        made.append(Word(index, form, lemma, upos, xpos, "", int(head), deprel))
    return DependencyTree(" ".join(word.form for word in made), tuple(made))


CUP_OF_COFFEE = phrase(
    "a a DET DT 2 det", "cup cup NOUN NN 0 obj", "of of ADP IN 4 case", "coffee coffee NOUN NN 2 nmod"
)
COFFEE_CUP = phrase("the the DET DT 3 det", "coffee coffee NOUN NN 3 compound", "cup cup NOUN NN 0 obj")
LIVING_ROOM = phrase("the the DET DT 3 det", "living living ADJ JJ 3 amod", "room room NOUN NN 0 obl")
LIGHT_SWITCH = phrase("the the DET DT 3 det", "light light NOUN NN 3 compound", "switch switch NOUN NN 0 obj")
COLD_WATER = phrase("cold cold ADJ JJ 2 amod", "water water NOUN NN 0 obj")
PIECE_OF_BREAD = phrase(
    "a a DET DT 2 det", "piece piece NOUN NN 0 obj", "of of ADP IN 4 case", "bread bread NOUN NN 2 nmod"
)
MUG_AND_ANNA = phrase(
    "the the DET DT 2 det", "mug mug NOUN NN 0 obj", "and and CCONJ CC 4 cc", "Anna Anna PROPN NNP 2 conj"
)

MRS_MILLER = phrase("Lead lead VERB VB 0 root", "Mrs. Mrs. PROPN NNP 1 obj", "Miller Miller PROPN NNP 2 flat")
DR_CHEN = phrase("Lead lead VERB VB 0 root", "Dr. Dr. PROPN NNP 3 nmod:desc", "Chen Chen PROPN NNP 1 obj")
DOCTOR = phrase("take take VERB VB 0 root", "the the DET DT 3 det", "doctor doctor NOUN NN 1 obj")


@pytest.mark.parametrize(
    ("tree", "head", "accepted", "kind"),
    [
        (MRS_MILLER, 2, (), "Human"),
        (DR_CHEN, 3, (), "Human"),
        (DOCTOR, 3, (), "Human"),
        (phrase("a a DET DT 2 det", "bit bit NOUN NN 0 obl"), 2, (), "Quantity"),
        (phrase("the the DET DT 2 det", "bit bit NOUN NN 0 obj"), 2, ("Physical_object",), "Physical_object"),
        (COFFEE_CUP, 3, (), "Container"),
        (LIVING_ROOM, 3, (), "Room"),
        (LIGHT_SWITCH, 3, (), "Control"),
        (COLD_WATER, 2, (), "Fluid"),
        (CUP_OF_COFFEE, 2, (), "Food"),
        (CUP_OF_COFFEE, 2, ("Container",), "Container"),
        (PIECE_OF_BREAD, 2, (), "Food"),
        (phrase("Anna Anna PROPN NNP 0 obj"), 1, (), "Human"),
        (phrase("Ben Ben PROPN NNP 0 obj"), 1, (), "Human"),
        (phrase("Paris Paris PROPN NNP 0 obl"), 1, (), "Location"),
        (phrase("Jordan Jordan PROPN NNP 0 obj"), 1, ("Human",), "Human"),
        (phrase("Michael Michael PROPN NNP 0 obj"), 1, (), "Human"),
        (phrase("Coke Coke PROPN NNP 0 obj"), 1, (), "Food"),
        (phrase("the the DET DT 2 det", "TV tv PROPN NNP 0 obj"), 2, (), "Device"),
        (phrase("Anna Anna PROPN NNP 0 obj", "Smith Smith PROPN NNP 1 flat"), 1, (), "Human"),
        (phrase("me I PRON PRP 0 obj"), 1, (), "Human"),
        (phrase("them they PRON PRP 0 obj"), 1, ("Human",), "Human"),
        (phrase("it it PRON PRP 0 obj"), 1, (), ""),
        (phrase("the the DET DT 3 det", "red red ADJ JJ 3 amod", "one one NOUN NN 0 obj"), 3, (), ""),
        (phrase("your you PRON PRP$ 2 nmod:poss", "hand hand NOUN NN 0 obj"), 2, (), "Body_part"),
        (phrase("frobnicator frobnicator NOUN NN 0 obj"), 1, (), ""),
        (phrase("3ft 3ft PROPN NNP 0 obj"), 1, (), ""),
    ],
)
def test_the_type_of_a_phrase(tree: DependencyTree, head: int, accepted: Sequence[str], kind: str) -> None:
    assert PhraseTypes(tree, shipped_types()).of(head).likeliest(tuple(accepted)) == kind


def test_of_a_list_the_item_that_fits_worst_counts() -> None:
    types = PhraseTypes(MUG_AND_ANNA, shipped_types())
    assert types.fit(2, ["Physical_object"]) is Fit.WRONG
    assert types.fit(2, ["Physical_object", "Sentient"]) is Fit.LIKELY


@pytest.mark.parametrize(
    ("tree", "head", "name"),
    [
        (COFFEE_CUP, 3, "coffee cup"),
        (phrase("Bill Bill PROPN NNP 0 obj"), 1, "bill"),
        (
            phrase("the the DET DT 3 det", "coffee coffee NOUN NN 3 compound", "corner corner NOUN NN 0 obl"),
            3,
            "corner",
        ),
        (phrase("Anna Anna PROPN NNP 0 obj", "Smith Smith PROPN NNP 1 flat"), 1, "anna smith"),
    ],
)
def test_a_name_that_the_robot_knows_counts_before_the_dictionary(tree: DependencyTree, head: int, name: str) -> None:
    assert PhraseTypes(tree, WordTypes(names={name: ("Vehicle",)})).likeliest(head) == "Vehicle"
