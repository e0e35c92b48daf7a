"""Words with one wrong letter."""

from typing import Optional

import pytest

from semantic_frames import load_lexical_units
from utterance_passes.trees.spelling import as_said
from utterance_passes.trees.vocabulary import Verbs
from utterance_passes.wording.typos import spellings_of, typos

KNOWN = Verbs(
    frozenset(["turn", "bring", "take", "move"]),
    spellings=frozenset("from turn bring take move left right kitchen bottle table cable".split()),
    names=frozenset(["kuchen", "zora"]),
)


@pytest.mark.parametrize(
    "said, written",
    [
        ("trun left", "turn left"),  # two changed places count before a letter less: "run"
        ("Brng it", "Bring it"),
        ("turn lefft", "turn left"),
        ("take the bottel", "take the bottle"),
        ("go to the kichen, please", "go to the kitchen, please"),
        ("move two metrs", "move two metres"),
        ("take the zable", None),  # table or cable
        ("take the form", None),  # an English word
        ("go to the kuchen", None),  # a name that the robot knows
        ("go to zoora", "go to zora"),
        ("Rigth", None),  # a name may begin with a capital
        ("take it to Rigth", None),
        ("say kichen", None),
        ('write "kichen"', None),
        ("trn left", None),  # too short
        ("look at marco", None),  # "march" is no word of the lexicon
        ("make a mave", None),  # a verb is no thing
        ("take the ftom", None),  # "from" is no thing
        ("take it ftom me", "take it from me"),
    ],
)
def test_typo(said: str, written: Optional[str]) -> None:
    made = typos.run(as_said(said), KNOWN)
    assert made.text == (written or said)
    assert len(made.origins) == len(made.text) + 1
    assert made.origins[-1] == len(said)


MARCHING = Verbs(frozenset(["turn", "march", "give", "go"]), spellings=frozenset(["turn", "march", "give", "go"]))


@pytest.mark.parametrize(
    "said, written",
    [
        ("look at marco", None),  # no verb stands behind a preposition
        ("give marco the pen", None),  # nor right behind a verb
        ("go marsh", None),  # an English word
        ("go trun left", "go turn left"),  # behind "go", one does
        ("bring me teh mug", "bring me the mug"),  # two changed places in a function word
        ("turn left adn go", "turn left and go"),
        ("Teh mug", None),
        ("Garch", None),  # the answer "Garch" to "Who?": the first letter of a word is seldom wrong
        ("marh on", "march on"),
        ("say teh", None),
        ("gize it", None),  # "give" or "gibe"
        ("gibe it", None),
        ("gice it", "give it"),  # the key beside it was hit
        ("gvie it", "give it"),  # two changed places
        ("giv it", None),
        ("nevr turn left", "never turn left"),  # nobody of that name is told to turn left
        ("please dnt go", "please don't go"),
        ("Nevra, turn left", None),
        ("nevr", None),
    ],
)
def test_a_typo_is_no_name(said: str, written: Optional[str]) -> None:
    assert typos.run(as_said(said), MARCHING).text == (written or said)


def test_the_end_of_a_name_is_no_word() -> None:
    unit = load_lexical_units("{frame_name: greeting, verb: greet, examples: [{text: Greet Alice kindly.}]}", "x.yaml")[
        0
    ]
    assert spellings_of([unit]) == frozenset(["greet", "kindly"])


def test_nothing_is_corrected_without_a_lexicon() -> None:
    assert typos.run(as_said("trun left"), Verbs()).text == "trun left"
