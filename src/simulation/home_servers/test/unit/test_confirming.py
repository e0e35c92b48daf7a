"""What is hot, locked, thrown, powered off or private wants a yes, and nothing is done before; the rest does not."""

from typing import Tuple

import pytest

from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.pipeline import Pipeline

CONFIRMED: Tuple[Tuple[str, str], ...] = (
    ("hot", "Boil the eggs."),
    ("hot", "Fry the onions."),
    ("hot", "Bake the bread."),
    ("hot", "Cook the pasta."),
    ("hot", "Iron the shirt."),
    ("hot", "Turn on the stove."),
    ("hot", "Switch the kettle on."),
    ("locked", "Lock the front door."),
    ("locked", "Unlock the cupboard."),
    ("thrown", "Throw the ball to Bob."),
    ("powered off", "Turn the radio off."),
    ("powered off", "Switch off the router."),
    ("powered off", "Reboot the router."),
    ("private", "Take a picture of Anna."),
    ("private", "Take a photo of me."),
)
AT_ONCE = (
    "Turn the radio on.",
    "Close the front door.",
    "Take the ball.",
    "Chop the cucumber.",
    "Fold the shirt.",
    "Take a picture of the plant.",
)


@pytest.fixture(scope="module")
def pipeline() -> Pipeline:
    knowledge = load_knowledge([shipped_domains()])
    pretend_servers(knowledge.graph)
    return Pipeline(knowledge)


@pytest.mark.parametrize(("kind", "text"), CONFIRMED)
def test_what_may_do_harm_wants_a_yes(kind: str, text: str, pipeline: Pipeline) -> None:
    asked = pipeline.understand(text)
    assert (asked.reply.outcome, asked.reply.code) == ("NEEDS_INFORMATION", "CONFIRM"), (kind, asked.reply)
    assert not asked.candidates
    assert pipeline.understand("No.", asked.context).reply.code == "DECLINED"
    assert pipeline.understand("Yes.", asked.context).reply.outcome == "DONE"


@pytest.mark.parametrize("text", AT_ONCE)
def test_the_rest_is_done_at_once(text: str, pipeline: Pipeline) -> None:
    assert pipeline.understand(text).reply.outcome == "DONE"
