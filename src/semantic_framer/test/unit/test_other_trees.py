"""Another tree is read where what was understood shows that the parser's is wrong, or says less."""

from dataclasses import replace
from typing import Callable, Dict, FrozenSet, List

import pytest

from semantic_framer.asking.other_trees import RULE
from semantic_framer.asking.tree_doubts import DOUBTS
from semantic_framer.framer import hear
from semantic_framer.rules import RULES
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.lexicon import Lexicon
from semantic_framer.values.outcome import MEANING_ONLY, Refusal, Understood
from semantic_frames.frame import SemanticFrame
from stanford_parser_ros.model import Parser
from utterance_passes.engine.trace import Trace

Said = Callable[..., List[str]]

#: What each sentence means, and the sign that the parser's tree is wrong.
MENDED = [
    ("Bring the cup to me and the fork.", "unlike_items", ["bringing(theme=the cup and the fork, beneficiary=me)"]),
    ("Look for the remote and wave.", "unlike_items", ["locating(sought_entity=the remote)", "waving()"]),
    ("Bring Anna Bob's cup.", "unmarked_possessor", ["bringing(theme=Bob's cup, beneficiary=Anna)"]),
    ("Give Uncle Bob Anna's cup.", "unmarked_possessor", ["giving(theme=Anna's cup, recipient=Uncle Bob)"]),
    (
        "Take the box I gave you to the kitchen.",
        "phrase_of_no_unit",
        ["bringing(theme=the box I gave you, goal=the kitchen)"],
    ),
    (
        "Bring the book I put on the shelf to Anna.",
        "phrase_of_no_unit",
        ["bringing(theme=the book I put on the shelf, beneficiary=Anna)"],
    ),
    (
        "See if the mail has arrived and bring it to me.",
        "unlike_verbs",
        ["inspecting(ground=the mail, desired_state=has arrived)", "bringing(theme=the mail, beneficiary=me)"],
    ),
    (
        "Ask Anna to sit down and bring her a coffee.",
        "addressee_again",
        ["requesting(addressee=Anna, message=sit down)", "bringing(theme=a coffee, beneficiary=Anna)"],
    ),
    (
        "Tell the guests who want to go home that the bus is here.",
        "description_as_message",
        ["telling(message=the bus is here, addressee=the guests who want to go home)"],
    ),
    (
        "Follow the person pointing to the left from the sofa to the kitchen.",
        "way_at_its_start",
        ["following(cotheme=the person pointing to the left, goal=the kitchen, source=the sofa)"],
    ),
]
#: What no tree makes sense of, and why.
REFUSED = [
    ("Ask Bob where he wants to go and take him there.", "addressee_again"),
    ("Tell the man who wants to leave to wait.", "description_as_message"),
    ("Take what you found to the kitchen.", "phrase_of_no_unit"),
    ("Go to the kitchen and high five.", "deed_in_list"),
    ("Bring me up to three apples.", "most_as_goal"),
]


@pytest.fixture(scope="module")
def known(lexicon: Lexicon, frames: Dict[str, SemanticFrame]) -> FramedLexicon:
    return FramedLexicon(lexicon, frames)


@pytest.fixture(scope="module")
def said(parser: Parser, known: FramedLexicon) -> Said:
    """What a text means, or the code of the reply."""
    verbs = frozenset(verb.split()[0] for verb in known.lexicon.verbs)

    def call(text: str, without: FrozenSet[str] = frozenset(), least: float = 0.0) -> List[str]:
        tree = parser.parse(text, verbs)
        tree = replace(tree, alternatives=tuple(one for one in tree.alternatives if one.probability >= least))
        outcome = hear(tree, known, policy=MEANING_ONLY, without=without).outcome
        if isinstance(outcome, Understood):
            return [str(readings[0]) for readings in outcome.clauses]
        return [outcome.code]

    return call


@pytest.mark.parametrize(("text", "doubt", "meant"), MENDED)
def test_a_tree_that_shows_a_doubt_gives_way_to_one_without(
    said: Said, text: str, doubt: str, meant: List[str]
) -> None:
    assert said(text) == meant
    assert said(text, frozenset([RULE])) != meant
    assert said(text, frozenset([doubt])) != meant


def test_each_doubt_has_a_sentence_and_a_reason() -> None:
    assert {doubt for _, doubt, *_ in (*MENDED, *REFUSED)} == set(DOUBTS)
    assert RULES[RULE]
    assert all(RULES[name] == doubt.reason for name, doubt in DOUBTS.items())


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("slide the book across the table", ["sliding(theme=the book, path=the table)"]),
        ("Bring Anna orange juice.", ["bringing(theme=orange juice, beneficiary=Anna)"]),
        (
            "Ask the woman sitting on the sofa for her name.",
            ["asking(addressee=the woman sitting on the sofa, message=her name)"],
        ),
    ],
)
def test_a_tree_that_says_more_is_taken_if_it_is_likely(said: Said, text: str, meant: List[str]) -> None:
    found = said(text)
    assert found == meant
    assert said(text, least=1.0) != found


def test_a_verb_has_one_object_so_that_one_of_two_is_a_part_of_the_other(said: Said) -> None:
    text = "set the living room lights to red"
    found = said(text)
    assert found == ["switching_device(device=the living room lights, operational_state=red)"]
    assert said(text, frozenset([RULE])) == ["LEFT_OVER_WORDS"]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        # What has an article of its own is no part of the next word.
        ("take the red cup barefoot", "LEFT_OVER_WORDS"),
        # To hide the words in a thing is no way to understand them.
        ("Grab the cup with the tongs.", "LEFT_OVER_WORDS"),
        ("go to the office frobnicatingly", "LEFT_OVER_WORDS"),
        ("Open and close the door twice.", "MISSING_ELEMENT"),
    ],
)
def test_no_words_are_hidden(said: Said, text: str, code: str) -> None:
    assert said(text) == [code]


@pytest.mark.parametrize(("text", "doubt"), REFUSED)
def test_where_no_tree_is_without_a_grave_doubt_nothing_is_done(said: Said, text: str, doubt: str) -> None:
    assert said(text) == ["CONDITION"]
    assert said(text, frozenset([doubt])) != ["CONDITION"]


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("go straight ahead two feet", "moving(direction=straight, distance=2, distance_unit=feet)"),
        ("Take the second book from the top.", "taking(theme=the second book from the top)"),
        ("Show Bob the way to the garden.", "guiding(cotheme=Bob, goal=the garden)"),
        ("go up the ramp to the gate", "navigating_to_location(goal=the gate, path=the ramp)"),
    ],
)
def test_a_likely_tree_stays(said: Said, text: str, meant: str) -> None:
    assert said(text) == [meant]


def test_the_trace_names_the_word_and_the_reason(parser: Parser, known: FramedLexicon) -> None:
    trace = Trace()
    hear(parser.parse("Bring Anna Bob's cup."), known, policy=MEANING_ONLY, trace=trace)
    (line,) = [line for line in trace.lines if line.rule == RULE]
    assert line.after == f"Anna: iobj of Bring. {DOUBTS['unmarked_possessor'].reason}"


def test_a_refusal_quotes_what_is_not_clear(parser: Parser, known: FramedLexicon) -> None:
    text = "Ask Bob where he wants to go and take him there."
    outcome = hear(parser.parse(text), known, policy=MEANING_ONLY).outcome
    assert isinstance(outcome, Refusal)
    assert '"where he wants to go and take him there"' in outcome.sentence
