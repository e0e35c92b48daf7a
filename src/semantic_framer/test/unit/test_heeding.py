"""Elements that reach a server, and what the robot says about those that do not."""

from typing import Any, Dict, FrozenSet

import pytest

from semantic_framer.framer import LeftOverWords, Policy, Question, Refusal, Understood, hear
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.heeding import EVERYTHING, heeded_elements
from semantic_frames import load_frame
from semantic_frames.frame import SemanticFrame
from semantic_frames.server_profile import AS_IN_2012
from semantic_frames.server_statement import stated_profile
from typed_arguments import TypedArgument

PARENT = """
name: moving
frame_elements: [{name: distance, is_core: True}, {name: direction}, {name: manner}, {name: area}]
children:
  - name: forward
    frame_element_relations:
      - {parent_name: distance, child_name: distance}
      - {parent_name: direction, child_value: forward}
  - - {name: turning, frame_element_relations: [{parent_name: area, child_name: angle}]}
    - {name: nowhere}
"""
CHILDREN = (
    "{name: forward, frame_elements: [{name: distance}]}",
    "{name: turning, frame_elements: [{name: angle}]}",
)


def frames() -> Dict[str, SemanticFrame]:
    return {frame.name: frame for frame in (load_frame(text, "x.yaml") for text in (PARENT, *CHILDREN))}


@pytest.mark.parametrize(
    "served, expected",
    [
        (["moving"], {"moving": {"distance", "direction", "manner", "area"}}),
        (["forward"], {"moving": {"distance", "direction"}, "forward": {"distance"}}),
        (["turning"], {"turning": {"angle"}}),
        ([], {}),
    ],
)
def test_elements_reach_a_server_directly_or_by_relations(served: Any, expected: Any) -> None:
    found = heeded_elements(frames(), dict.fromkeys(served, (AS_IN_2012,)))
    assert {name: set(elements) for name, elements in found.items()} == expected


def outcome_of(text: str, parser: Any, known: FramedLexicon, policy: Policy = Policy()) -> Any:
    verbs: FrozenSet[str] = frozenset(verb.split()[0] for verb in known.lexicon.verbs)
    return hear(parser.parse(text, verbs), known, policy=policy).outcome


def test_what_no_server_gets_is_asked_about(parser: Any, lexicon: Any, frames: Any) -> None:
    known = FramedLexicon(lexicon, frames, heeded={"navigating_to_location": {"goal": EVERYTHING}})
    text = "Go to the kitchen quickly."
    asked = outcome_of(text, parser, known)
    assert isinstance(asked, Question) and '"quickly"' in asked.sentence
    assert isinstance(outcome_of("Could you go to the kitchen?", parser, known), Understood)
    refused = outcome_of(text, parser, known, Policy(left_over_words=LeftOverWords.STRICT))
    assert isinstance(refused, Refusal) and refused.left_over == ("quickly",)
    assert isinstance(outcome_of(text, parser, known, Policy(left_over_words=LeftOverWords.IGNORE)), Understood)
    everything = FramedLexicon(lexicon, frames, heeded=heeded_elements(frames, dict.fromkeys(frames, (AS_IN_2012,))))
    assert isinstance(outcome_of(text, parser, everything), Understood)


def test_what_was_understood_but_reaches_no_server_is_refused_by_its_words(
    parser: Any, lexicon: Any, frames: Any
) -> None:
    known = FramedLexicon(lexicon, frames, heeded={"pushing": {"theme": EVERYTHING}})
    refused = outcome_of("Push the chair onto the table.", parser, known)
    assert isinstance(refused, Refusal) and refused.left_over == ("table",)
    assert refused.sentence == 'I cannot do the "onto the table" part, so I do nothing.'


def profiled(known: Any, frames: Any, frame: str, **statement: Any) -> FramedLexicon:
    return FramedLexicon(known, frames, heeded=heeded_elements(frames, {frame: [stated_profile(statement)]}))


def test_extra_thematic_elements_are_asked_about_unless_the_server_heeds_them(
    parser: Any, lexicon: Any, frames: Any
) -> None:
    text = "Follow me silently."
    asked = outcome_of(text, parser, profiled(lexicon, frames, "following"))
    assert isinstance(asked, Question) and '"silently"' in asked.sentence
    asked = outcome_of(text, parser, profiled(lexicon, frames, "following", heeds={"Manner": ["quick"]}))
    assert isinstance(asked, Question) and '"silently"' in asked.sentence
    heard = outcome_of(text, parser, profiled(lexicon, frames, "following", heeds={"Manner": ["silent"]}))
    assert isinstance(heard, Understood)
    manner = heard.clauses[0][0].argument("manner")
    assert manner is not None and (manner.text, manner.lemma) == ("silently", "silently")
    assert heard.clauses[0][0].left_over == () and heard.clauses[0][0].extra == ()


def test_an_element_that_the_server_does_not_heed_is_asked_about(parser: Any, lexicon: Any, frames: Any) -> None:
    text = "Go to the kitchen quickly."
    known = profiled(lexicon, frames, "navigating_to_location", unheeded=["manner"])
    assert isinstance(outcome_of(text, parser, known), Question)


def test_members_of_a_sequence_heed_together() -> None:
    parent = """
    name: fetching
    frame_elements: [{name: theme}]
    children:
      - - {name: forward, frame_element_relations: [{parent_name: theme, child_name: distance}]}
        - {name: turning}
    """
    known = {**frames(), "fetching": load_frame(parent, "x.yaml")}
    quick, any_manner = (stated_profile({"heeds": {"Manner": values}}) for values in (["quick"], None))
    nothing = AS_IN_2012
    for turning, is_heeded in ((any_manner, True), (quick, True), (nothing, False)):
        found = heeded_elements(known, {"forward": [quick], "turning": [turning]})["fetching"]
        assert ("Manner" in found) is is_heeded
        if is_heeded:
            assert found["Manner"].fits(TypedArgument("Manner", "quickly"))
            assert not found["Manner"].fits(TypedArgument("Manner", "slowly"))


def test_a_mapping_with_a_relation_replaces_the_one_that_was_said() -> None:
    parent = """
    name: putting
    frame_elements: [{name: goal}]
    children:
      - {name: forward, frame_element_relations: [{parent_name: goal, child_name: distance, relation: to}]}
    """
    known = {**frames(), "putting": load_frame(parent, "x.yaml")}
    under = TypedArgument("goal", "the table", relation="under")
    for relation, is_heeded in (("to", True), ("on", False)):
        profile = stated_profile({"heeds": {"distance": {"relations": [relation]}}})
        assert heeded_elements(known, {"forward": [profile]})["putting"]["goal"].fits(under) is is_heeded
