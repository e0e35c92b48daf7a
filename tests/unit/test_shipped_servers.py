"""What a shipped frame with a server can express changes the goal or the motion, or is refused by name."""

from pathlib import Path
from typing import Any, Tuple

import pytest
import yaml

from frame_bindings.binding_file import load_bindings
from frame_registrar.graph import FrameGraph
from frame_registrar.search import Reading, Refusal, search
from pr2_props.named_arms import ARM_NOUNS, named_arms
from pr2_props.node import STATEMENTS
from pr2_props.props import Arm
from roboframenet_testing.workspace import package
from semantic_frames import load_frame
from semantic_frames.server_statement import stated_profile
from typed_arguments import TypedArgument

DOMAINS = package("roboframenet_domains") / "domains"
GOING = DOMAINS / "navigation" / "frames" / "navigating_to_location.yaml"
ARMS = tuple(DOMAINS / "pick_and_place" / "frames" / f"{name}.yaml" for name in ("extending_arm", "retracting_arm"))
BINDING = package("frame_bindings") / "config" / "move_base.yaml"
#: Relations that say the same to a robot that knows one pose for each place: it will be there.
BEING_THERE = {"to", "into", "in", "at"}


def outcome(path: Path, statement: Any, argument: TypedArgument) -> Any:
    graph = FrameGraph()
    frame = load_frame(path.read_text(encoding="utf-8"), str(path))
    graph.add(frame)
    assert graph.register(frame.name, "server", stated_profile(statement)) == ()
    return search(graph, [[Reading(frame.name, (argument,))]], max_candidates=8)


def declared(path: Path, element: str, key: str) -> Tuple[Any, ...]:
    (found,) = [
        one for one in yaml.safe_load(path.read_text(encoding="utf-8"))["frame_elements"] if one["name"] == element
    ]
    return tuple(found[key])


@pytest.mark.parametrize("relation", declared(GOING, "goal", "relations"))
def test_place_is_gone_to_or_the_relation_is_refused(relation: str) -> None:
    (binding,) = load_bindings(BINDING.read_text(encoding="utf-8"), str(BINDING)).bindings
    words = f"{relation} the table"
    found = outcome(GOING, binding.statement, TypedArgument("goal", "the table", relation=relation, words=words))
    if relation in BEING_THERE:
        assert not isinstance(found, Refusal)
    else:
        assert isinstance(found, Refusal) and f'"{words}"' in found.sentence


@pytest.mark.parametrize("path", ARMS, ids=lambda path: path.stem)
@pytest.mark.parametrize("count", [*declared(ARMS[0], "limb", "counts"), 3])
def test_number_of_arms_is_the_number_that_move(count: int, path: Path) -> None:
    argument = TypedArgument("limb", "arm", count=count, is_plural=count > 1, words=f"{count} arms")
    found = outcome(path, STATEMENTS[path.stem], argument)
    if count in (1, 2):
        assert not isinstance(found, Refusal)
        assert len(named_arms(argument) or (Arm.RIGHT,)) == count
    else:
        assert isinstance(found, Refusal) and '"3 arms"' in found.sentence


@pytest.mark.parametrize("path", ARMS, ids=lambda path: path.stem)
@pytest.mark.parametrize("quantifier", [*declared(ARMS[0], "limb", "quantifiers"), "no", "another"])
def test_quantifier_chooses_the_arms_or_is_refused(quantifier: str, path: Path) -> None:
    argument = TypedArgument("limb", "arm", quantifier=quantifier, words=f"{quantifier} arm")
    found = outcome(path, STATEMENTS[path.stem], argument)
    if quantifier in ("no", "another"):
        assert isinstance(found, Refusal) and f'"{quantifier} arm"' in found.sentence
        return
    assert not isinstance(found, Refusal)
    assert len(named_arms(argument)) == (2 if quantifier in ("each", "every", "both", "all") else 0)


@pytest.mark.parametrize("path", ARMS, ids=lambda path: path.stem)
@pytest.mark.parametrize("noun", [*ARM_NOUNS, "leg"])
def test_other_limbs_are_refused(noun: str, path: Path) -> None:
    found = outcome(path, STATEMENTS[path.stem], TypedArgument("limb", noun, words=f"your {noun}"))
    assert isinstance(found, Refusal) is (noun == "leg")
