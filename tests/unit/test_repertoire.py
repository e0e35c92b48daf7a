"""What people ask of a service robot: each ability has a frame with several verbs, examples and typed elements."""

from pathlib import Path

import pytest
import yaml

from offline_pipeline.knowledge import load_knowledge, shipped_domains
from offline_pipeline.pipeline import Pipeline

TABLE = yaml.safe_load((Path(__file__).resolve().parent / "repertoire.yaml").read_text(encoding="utf-8"))
KNOWLEDGE = load_knowledge([shipped_domains()])
#: Abilities for which English has one verb that everybody says.
ONE_VERB = {"docking", "nodding", "reminding"}
#: Anything may be awaited, followed, inspected and made sure of.
ANYTHING = {"awaiting", "following", "inspecting", "verifying"}


@pytest.mark.parametrize(
    "ability, text, frame", [(a, text, f) for a, said in TABLE.items() for text, f in said.items()]
)
def test_ability_is_understood(pipeline: Pipeline, ability: str, text: str, frame: str) -> None:
    understanding = pipeline.understand(text)
    assert [reading.unit.frame_name for reading in understanding.readings] == [frame], understanding.reply


@pytest.mark.parametrize("frame", sorted({frame for said in TABLE.values() for frame in said.values()}))
def test_frame_has_verbs_examples_and_types(frame: str) -> None:
    units = [unit for unit in KNOWLEDGE.lexicon.units if unit.frame_name == frame and not unit.questions]
    verbs = {verb for unit in units for verb in unit.verbs}
    assert len(verbs) >= (1 if frame in ONE_VERB else 2), verbs
    assert sum(len(unit.examples) for unit in units) >= 3
    elements = KNOWLEDGE.frames[frame].frame_elements
    typed = [one for one in elements if one.semantic_types or one.quantity is not None or one.values]
    assert typed or frame in ANYTHING
