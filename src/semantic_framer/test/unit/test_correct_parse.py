"""What the parser hangs as no command has it hangs where it belongs."""

from typing import Any, Dict

import pytest

from semantic_framer.framer import Refusal, Understood
from utterance_passes.engine.running import run_tree_passes
from utterance_passes.table import PARSE_CORRECTING_PASSES
from utterance_passes.trees.conllu import from_conllu
from utterance_passes.trees.vocabulary import Verbs


@pytest.mark.parametrize(
    "rows, index, head, deprel",
    [
        # "go up to Bob"
        (
            (
                "1 go go VERB VB _ 0 root _ _\n2 up up ADP RP _ 1 compound:prt _ _\n3 to to ADP IN _ 4 case _ _"
                "\n4 Bob Bob PROPN NNP _ 1 obl _ _"
            ),
            2,
            1,
            "advmod",
        ),
        # "turn lights off in rooms"
        (
            (
                "1 turn turn VERB VB _ 0 root _ _\n2 lights light NOUN NNS _ 1 obj _ _\n3 off off ADP RP _ 1 "
                "compound:prt _ _\n4 in in ADP IN _ 5 case _ _\n5 rooms room NOUN NNS _ 1 obl _ _"
            ),
            5,
            2,
            "nmod",
        ),
    ],
)
def test_word_is_rehung(rows: str, index: int, head: int, deprel: str) -> None:
    word = run_tree_passes(from_conllu(rows), Verbs(), PARSE_CORRECTING_PASSES).word(index)
    assert (word.head, word.deprel) == (head, deprel)


@pytest.mark.parametrize(
    "text, arguments",
    [
        ("go up to the desk", {"goal": "the desk"}),
        ("go down to the kitchen", {"goal": "the kitchen"}),
        ("head over to the lab", {"goal": "the lab"}),
        ("take the keys off the hook", {"theme": "the keys", "source": "the hook"}),
        ("pick your socks up off the floor", {"theme": "your socks", "source": "the floor"}),
        ("pick up the box", {"theme": "the box"}),
        ("turn the lights off in the bedroom", {"device": "the lights in the bedroom", "operational_state": "off"}),
        ("put the box down on the table", {"theme": "the box", "goal": "the table"}),
        ("fry two eggs in the small pan", {"food": "two eggs", "container": "the small pan"}),
        ("boil three large eggs for 5 minutes", {"food": "three large eggs", "duration": "5 minutes"}),
        ("switch off everything in the kitchen", {"device": "everything in the kitchen", "operational_state": "off"}),
        ("put everything in the box", {"theme": "everything", "goal": "the box"}),
        (
            "turn a quarter turn to the right",
            {"direction": "right", "angle": "0.25", "angle_unit": "turn"},
        ),
        ("hold on a second", {"duration": "1 second"}),
    ],
)
def test_sentences_of_this_kind_are_understood(understand: Any, text: str, arguments: Dict[str, str]) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Understood), outcome
    ((reading, *_),) = outcome.clauses
    assert {value.name: value.text for value in reading.arguments if value.positions} == arguments


def test_degree_that_nothing_takes_is_left_over(understand: Any) -> None:
    outcome, _ = understand("turn up the heating a little sideways")
    assert isinstance(outcome, Refusal) and outcome.code == "LEFT_OVER_WORDS"
