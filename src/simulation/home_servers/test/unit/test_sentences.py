"""Each frame is carried out in the home by a sentence: from the text to what is true afterwards."""

import os
import random

import pytest
import yaml
from direct_body import DirectBody

from home_servers.body import CannotDo, Interrupted
from home_servers.frames import DOMAINS, FRAMES, STATEMENTS
from home_servers.skills import Skills
from offline_pipeline.knowledge import load_knowledge, shipped_domains
from offline_pipeline.pipeline import Pipeline
from roboframenet_sim.home_engine import Home
from roboframenet_sim.home_file import load_home_file
from roboframenet_sim.home_floor import Floor
from roboframenet_sim.home_truth import truth_of
from semantic_frames.server_statement import stated_profile

HERE = os.path.dirname(os.path.realpath(__file__))
HOME_FILE = os.path.join(HERE, "..", "..", "..", "roboframenet_sim", "config", "home.yaml")
with open(os.path.join(HERE, "..", "sentences.yaml"), encoding="utf-8") as file:
    SENTENCES = yaml.safe_load(file)
#: Some of them, another domain each; all of them take minutes.
PLAN, STATE = load_home_file(HOME_FILE)
FLOOR = Floor(PLAN)
SAMPLE = random.Random(11).sample(SENTENCES, 18)


def ids(entry):
    return entry["say"]


@pytest.fixture(scope="module")
def pipeline():
    knowledge = load_knowledge([shipped_domains()])
    for frame in FRAMES:
        assert knowledge.graph.register(frame, "home", stated_profile(STATEMENTS.get(frame, {}))) == ()
    return Pipeline(knowledge)


def carry_out(pipeline, skills, text, *, must_confirm=False):
    """Say a sentence, and yes if the robot asks.

    Returns:
        names of the frames of its readings and of the first candidates, and what came of it: ok, or the reason
    """
    understanding = pipeline.understand(text)
    assert (understanding.reply.code == "CONFIRM") == must_confirm, understanding.reply
    if must_confirm:
        assert pipeline.understand("No.", understanding.context).reply.code == "DECLINED"
        understanding = pipeline.understand("Yes.", understanding.context)
    assert understanding.reply.outcome == "DONE", understanding.reply
    steps = [frame for candidates in understanding.candidates for frame in candidates[0].frames]
    frames = [frame.name for frame in steps] + [reading.unit.frame_name for reading in understanding.readings]
    try:
        for frame in steps:
            FRAMES[frame.name](skills, frame)
            skills.tidy()
    except CannotDo as reason:
        return frames, str(reason)
    except Interrupted:
        return frames, "interrupted"
    return frames, "ok"


def check(pipeline, entry):
    plan, state = PLAN, STATE
    home = Home(plan, state, floor=FLOOR)
    home.change(reason="test", **entry.get("before", {}))
    if "person" in entry:
        assert home.tell_person(*entry["person"].split()) is None
    body = DirectBody(home, most_s=entry.get("most_s", 900.0))
    skills = Skills(body, speaker="alice")
    if "first" in entry:
        assert carry_out(pipeline, skills, entry["first"])[1] == "ok"
    frames, outcome = carry_out(pipeline, skills, entry["say"], must_confirm=entry.get("confirm", False))
    assert entry["frame"] in frames
    assert outcome == entry.get("outcome", "ok")
    truth = truth_of(plan, home.state)
    expected = entry.get("truth", {})
    assert {name: truth.get(name) for name in expected} == expected
    if "said" in entry:
        assert any(entry["said"].lower() in text.lower() for text in body.said), body.said
    for ident, words in entry.get("knows", {}).items():
        known = body.memory.get(ident)
        assert set(words) <= {*known.names, *known.states, *known.attributes, known.category}, known
        assert ident in [told.id for told in body.told]
    if entry.get("event"):
        assert any(entry["event"] in event.what for event in home.state.events), home.state.events


@pytest.mark.parametrize("entry", SAMPLE, ids=ids)
def test_sentence_of_the_sample(pipeline, entry):
    check(pipeline, entry)


@pytest.mark.acceptance
@pytest.mark.parametrize("entry", SENTENCES, ids=ids)
def test_sentence(pipeline, entry):
    check(pipeline, entry)


def test_every_frame_has_a_sentence():
    assert set(FRAMES) <= {entry["frame"] for entry in SENTENCES}


def test_every_frame_is_one_of_the_domains():
    knowledge = load_knowledge([shipped_domains()])
    assert set(FRAMES) <= set(knowledge.frames)
    assert sum(map(len, DOMAINS.values())) == len(FRAMES)


@pytest.mark.parametrize(
    "said", ["Drive two metres along the corridor.", "Take a picture to your left.", "Go backwards along the corridor."]
)
def test_what_no_skill_heeds_is_not_left_out_without_a_word(pipeline, said):
    assert pipeline.understand(said).reply.outcome != "DONE"


@pytest.mark.parametrize(
    "text, answer",
    [
        ("Tell me how many chairs are in the office.", "There is 1 chair in the office."),
        ("Tell me where the mug is.", "The mug is on the kitchen table"),
        ("Tell Bob where the mug is.", "I told Bob: the mug is on the kitchen table"),
        ("Count the chairs in the kitchen.", "I see 0 chairs."),
        ("Tell me who is in the office.", "Bob is in the office."),
        ("Check whether the mug is clean and tell me.", "No, the mug is not clean."),
        ("Say hello.", ""),
    ],
)
def test_what_is_found_out_is_in_the_reply(pipeline, text, answer):
    home = Home(PLAN, STATE, floor=FLOOR)
    skills = Skills(DirectBody(home), speaker="alice")
    assert carry_out(pipeline, skills, text)[1] == "ok"
    assert " ".join(skills.answers).startswith(answer) and bool(skills.answers) == bool(answer)


@pytest.mark.parametrize(
    "text, heard",
    [
        ("Tell Bob that I am late.", "Bob, I was asked to tell you: I am late."),
        ("Tell Bob that dinner is ready.", "Bob, dinner is ready."),
        ("Tell Bob your name.", "Bob, I am the robot of this home."),
    ],
)
def test_the_robot_does_not_say_of_itself_what_the_speaker_says(pipeline, text, heard):
    body = DirectBody(Home(PLAN, STATE, floor=FLOOR))
    assert carry_out(pipeline, Skills(body, speaker="alice"), text)[1] == "ok"
    assert body.said[-1] == heard
