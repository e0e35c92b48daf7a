"""Elements that reach a server, and what the robot says about those that do not."""

from typing import Any, Dict, FrozenSet

import pytest

from semantic_framer.framed_lexicon import FramedLexicon
from semantic_framer.framer import LeftOverWords, Policy, Question, Refusal, Understood, hear
from semantic_framer.heeding import heeded_elements
from semantic_frames import load_frame
from semantic_frames.frame import SemanticFrame

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
    assert heeded_elements(frames(), served) == {name: frozenset(elements) for name, elements in expected.items()}


def outcome_of(text: str, parser: Any, known: FramedLexicon, policy: Policy = Policy()) -> Any:
    verbs: FrozenSet[str] = frozenset(verb.split()[0] for verb in known.lexicon.verbs)
    return hear(parser.parse(text, verbs), known, policy=policy).outcome


def test_what_no_server_gets_is_asked_about(parser: Any, lexicon: Any, frames: Any) -> None:
    known = FramedLexicon(lexicon, frames, heeded={"navigating_to_location": frozenset(["goal"])})
    text = "Go to the kitchen quickly."
    asked = outcome_of(text, parser, known)
    assert isinstance(asked, Question) and '"quickly"' in asked.sentence
    assert isinstance(outcome_of("Could you go to the kitchen?", parser, known), Understood)
    refused = outcome_of(text, parser, known, Policy(left_over_words=LeftOverWords.STRICT))
    assert isinstance(refused, Refusal) and refused.left_over == ("quickly",)
    assert isinstance(outcome_of(text, parser, known, Policy(left_over_words=LeftOverWords.IGNORE)), Understood)
    everything = FramedLexicon(lexicon, frames, heeded=heeded_elements(frames, frames))
    assert isinstance(outcome_of(text, parser, everything), Understood)
