"""Each element, relation and number that the servers of the home heed changes what the robot does, or is refused."""

import os
from dataclasses import replace

import pytest
import yaml
from remembering_body import RememberingBody

from frame_registrar.search import Reading, Refusal, search
from home_servers.body import CannotDo, Interrupted
from home_servers.frames import FRAMES, STATEMENTS
from home_servers.skills import Skills
from offline_pipeline.knowledge import load_knowledge, shipped_domains
from roboframenet_sim.home_file import load_home_file
from semantic_frames.frame import Quantity
from semantic_frames.server_statement import stated_profile
from typed_arguments import FilledFrame, Measure, TypedArgument
from typed_arguments.attribute_names import RELATIONS

HERE = os.path.dirname(os.path.realpath(__file__))
PLAN, STATE = load_home_file(os.path.join(HERE, "..", "..", "..", "roboframenet_sim", "config", "home.yaml"))
with open(os.path.join(HERE, "..", "heeded.yaml"), encoding="utf-8") as file:
    WORDS = yaml.safe_load(file)
KNOWLEDGE = load_knowledge([shipped_domains()])
#: Elements whose words name what the frame is about anyway: "take a *picture*", "give me a *hug*", "wait *here*".
IN_THE_FRAME = {
    # Where somebody is looked for, if it is said who (the next test).
    ("following", "source"),
    ("guiding", "source"),
    ("photographing", "representation"),
    ("high_fiving", "hand"),
    ("low_fiving", "hand"),
    ("pounding", "target"),
    ("hugging", "act"),
}
#: Relations that ask the same of the robot.
ALIKE = [
    {"", "to", "at", "into", "in"},
    {"", "to", "at", "near", "next_to", "beside", "by"},
    {"on", "onto", "over", "in", "to", "at", ""},
    {"in", "into"},
    {"under", "below"},
    {"through", "along", "across", "down", "up", "in", "at", "around", "on", "near"},
    {"to", "towards", "at"},
]
MEASURES = {
    Quantity.DURATION: Measure("duration", "five minutes", 5.0, "minute", 200.0),
    Quantity.ANGLE: Measure("angle", "40 degrees", 40.0, "degree", 0.7),
    Quantity.LENGTH: Measure("length", "two metres", 2.0, "metre", 2.0),
}


def argument(frame, element):
    if element.quantity in MEASURES:
        measure = MEASURES[element.quantity]
        return TypedArgument(element.name, measure.words, measure=measure)
    text = str(WORDS["frames"].get(frame, {}).get(element.name) or WORDS["elements"][element.name])
    head = text.split()[-1]
    return TypedArgument(element.name, text, head=head, lemma=head)


def done(frame, arguments):
    """Return what the robot does for a frame, and how it ends."""
    body = RememberingBody(PLAN, STATE, held=("red_mug", "blue_mug") if frame == "ungrasping" else ())
    try:
        FRAMES[frame](Skills(body, speaker="alice"), FilledFrame(frame, tuple(arguments)))
    except (CannotDo, Interrupted) as end:
        return body.done, str(end)
    return body.done, "done"


def heeded():
    """Return each element that a server heeds without stating the words: frame, element."""
    for frame in FRAMES:
        stated = STATEMENTS.get(frame, {})
        units = {element.unit_element for element in KNOWLEDGE.frames[frame].frame_elements}
        for element in KNOWLEDGE.frames[frame].frame_elements:
            limits = stated.get("heeds", {}).get(element.name, {})
            has_values = isinstance(limits, list) or "values" in limits
            if element.name in (*stated.get("unheeded", ()), *units) or (frame, element.name) in IN_THE_FRAME:
                continue
            if not element.is_core and not has_values:
                yield frame, element.name


def cores(frame):
    return [argument(frame, one) for one in KNOWLEDGE.frames[frame].frame_elements if one.is_core]


@pytest.mark.parametrize("frame, name", heeded())
def test_what_is_said_of_an_element_changes_what_is_done(frame, name):
    said = argument(frame, KNOWLEDGE.frames[frame].element(name))
    assert done(frame, [*cores(frame), said]) != done(frame, cores(frame))


@pytest.mark.parametrize("frame", ["guiding", "following"])
def test_who_is_guided_or_followed_is_looked_for_where_it_is_said(frame):
    words = {"cotheme": "person", "source": "living room", "goal": "desk"}
    said = [TypedArgument(name, text, head=text.split()[-1], lemma=text.split()[-1]) for name, text in words.items()]
    assert done(frame, said) != done(frame, [one for one in said if one.name != "source"])


RELATED = [
    (frame, name, relation)
    for frame, stated in STATEMENTS.items()
    for name, limits in stated.get("heeds", {}).items()
    for relation in (limits.get("relations", ()) if isinstance(limits, dict) else ())
]


def with_relation(frame, name, relation):
    said = replace(argument(frame, KNOWLEDGE.frames[frame].element(name)), relation=relation)
    return [*(one for one in cores(frame) if one.name != name), said]


@pytest.mark.parametrize("frame, name, relation", RELATED)
def test_relation_changes_what_is_done(frame, name, relation):
    mine = done(frame, with_relation(frame, name, relation))
    for other_frame, other_name, other in RELATED:
        is_other = (other_frame, other_name) == (frame, name) and other != relation
        if is_other and not any({relation, other} <= alike for alike in ALIKE):
            assert mine != done(frame, with_relation(frame, name, other)), other


@pytest.fixture(scope="module")
def graph():
    knowledge = load_knowledge([shipped_domains()])
    for frame in FRAMES:
        assert knowledge.graph.register(frame, "home", stated_profile(STATEMENTS.get(frame, {}))) == ()
    return knowledge.graph


@pytest.mark.parametrize("frame, name", sorted({(frame, name) for frame, name, _ in RELATED}))
def test_other_relations_are_refused_by_name(graph, frame, name):
    mine = {relation for one, other, relation in RELATED if (one, other) == (frame, name)}
    for relation in sorted(RELATIONS - mine):
        words = f"{relation} the desk"
        arguments = [replace(one, words=words) for one in with_relation(frame, name, relation)]
        found = search(graph, [[Reading(frame, tuple(arguments))]], max_candidates=8)
        assert isinstance(found, Refusal) or all(
            step.name != frame for clause in found for candidate in clause for step in candidate.frames
        )


#: Elements whose number is part of words or of what is counted, and places where something is.
WITHOUT_NUMBER = {
    ("asking", "message"),
    ("being_in_category", "category"),
    ("being_in_category", "item"),
    ("being_located", "location"),
    ("being_located", "theme"),
    ("comparing", "item"),
    ("counting", "entity"),
    ("fetching", "source"),
    ("finding_out", "content"),
    ("listing", "items"),
    ("playing", "performance"),
    ("reminding", "topic"),
    ("requesting", "message"),
    ("saying", "message"),
    ("stacking", "theme"),
    ("telling", "message"),
    ("verifying", "content"),
}


@pytest.mark.parametrize(
    "frame, name",
    [
        (frame, element.name)
        for frame in sorted(FRAMES)
        for element in KNOWLEDGE.frames[frame].frame_elements
        if element.is_core and element.quantity is None and (frame, element.name) not in WITHOUT_NUMBER
    ],
)
def test_number_changes_what_is_done_or_is_refused(graph, frame, name):
    one = [
        *cores(frame),
        *(
            argument(frame, known)
            for known in KNOWLEDGE.frames[frame].frame_elements
            if known.name == "operational_state"
        ),
    ]
    two = [replace(other, count=2, is_plural=True) if other.name == name else other for other in one]
    found = search(graph, [[Reading(frame, tuple(two))]], max_candidates=8)
    assert isinstance(found, Refusal) or done(frame, two) != done(frame, one)
