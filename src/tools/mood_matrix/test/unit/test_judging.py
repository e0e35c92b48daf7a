"""What counts as right, with the answers of today and with queries as they are to be."""

from dataclasses import replace
from typing import Dict, Tuple

import pytest

from mood_matrix.constructions import Sentence
from mood_matrix.judging import Judge, Verdict
from mood_matrix.mood_command import cause_table, matrix, row_table, sample_of, share_right, total_table
from mood_matrix.units import load_frames, load_served
from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.pipeline import Parameters, Pipeline, Reply, Understanding
from roboframenet_testing.workspace import package
from semantic_framer.values.clause_plan import PlanPart
from semantic_framer.values.outcome import MEANING_ONLY
from semantic_framer.values.reading import Reading
from typed_arguments import EmbeddedFrame, TypedArgument

DOMAINS = package("roboframenet_domains") / "domains"
#: Of the sample, in percent or sentences, on 29 November 2026, with some room. They only rise, or for ACTED fall.
RIGHT_IN_SAMPLE, FROZEN_RIGHT_IN_SAMPLE, ACTED_IN_SAMPLE = 93.0, 90.0, 1
#: The same of the whole matrix.
RIGHT, FROZEN_RIGHT, ACTED = 95.5, 94.5, 1


@pytest.fixture(scope="module")
def pipeline() -> Pipeline:
    knowledge = load_knowledge([shipped_domains()])
    pretend_servers(knowledge.graph)
    return Pipeline(knowledge, parameters=Parameters(policy=MEANING_ONLY))


@pytest.fixture(scope="module")
def judge(pipeline: Pipeline) -> Judge:
    return Judge(pipeline, load_served(load_frames(DOMAINS)))


@pytest.fixture(scope="module")
def locking(pipeline: Pipeline) -> Reading:
    return pipeline.understand("Lock the door.").readings[0]


def about(frame: str, thing: str = "") -> Dict[int, Sentence]:
    """Return the sentences about a deed, and about a thing if one is given, by row."""
    return {one.row: one for one in matrix(DOMAINS) if one.expected.deed.frame == frame and thing in one.text}


@pytest.fixture(scope="module")
def rows() -> Dict[int, Sentence]:
    """The sentences about locking the door, which results in a state."""
    return about("locking")


def answered(*readings: Reading, plan: PlanPart = None) -> Understanding:  # type: ignore[assignment]
    return Understanding("", Reply("DONE", "DONE", ""), readings=readings, plan=plan)


def refused(code: str) -> Understanding:
    return Understanding("", Reply("REFUSED", code, ""))


def renamed(reading: Reading, frame: str, *arguments: TypedArgument) -> Reading:
    return replace(reading, unit=replace(reading.unit, frame_name=frame), arguments=arguments)


def query(
    reading: Reading, asks: str, aspect: str, agent: str = "robot", *, thing: str = "the door", is_negated: bool = False
) -> Reading:
    elements = (TypedArgument("container_portal", thing), TypedArgument("agent", "you"))
    deed = EmbeddedFrame("says", "locking", mood="question", is_negated=is_negated, frame_elements=elements)
    texts = {"asks": asks, "aspect": aspect, "agent": agent}
    return renamed(
        reading,
        "question_of_event",
        TypedArgument("deed", "lock the door", frames=(deed,)),
        *(TypedArgument(name, text) for name, text in texts.items()),
    )


@pytest.mark.parametrize(
    "row, asks, aspect, more",
    [
        (8, "whether", "done", {}),
        (9, "container_portal", "done", {"thing": "which door"}),
        (10, "when", "done", {}),
        (11, "why", "done", {"is_negated": True}),
        (12, "whether", "ever_done", {}),
        (13, "how_often", "done", {}),
        (14, "whether", "running", {}),
        (15, "whether", "able", {"thing": "doors"}),
        (16, "who", "done", {"agent": "who"}),
        (22, "whether", "done", {}),
    ],
)
def test_a_query_about_the_deed_is_right(
    row: int, asks: str, aspect: str, more: Dict[str, object], judge: Judge, locking: Reading, rows: Dict[int, Sentence]
) -> None:
    right = query(locking, asks, aspect, **more)  # type: ignore[arg-type]
    assert judge.verdict(rows[row], answered(right)).verdict is Verdict.RIGHT
    for other in (
        query(locking, "where", aspect, **more),  # type: ignore[arg-type]
        query(locking, asks, "planned", **more),  # type: ignore[arg-type]
        query(locking, asks, aspect, **{**more, "agent": "speaker"}),  # type: ignore[arg-type]
        query(locking, asks, aspect, **{**more, "is_negated": row != 11}),  # type: ignore[arg-type]
    ):
        assert judge.verdict(rows[row], answered(other)).verdict is not Verdict.RIGHT


def test_a_query_about_another_thing_is_not_right(judge: Judge, locking: Reading, rows: Dict[int, Sentence]) -> None:
    for row, thing in ((8, "the window"), (15, "the door")):
        other = query(locking, "whether", "done" if row == 8 else "able", thing=thing)
        assert judge.verdict(rows[row], answered(other)).verdict is not Verdict.RIGHT


def test_a_pattern_is_right_where_its_words_are_the_whole_deed(
    judge: Judge, locking: Reading, rows: Dict[int, Sentence]
) -> None:
    reason = renamed(locking, "question_of_reason", TypedArgument("deed", "lock the door"))
    assert judge.verdict(rows[11], answered(reason)).verdict is Verdict.RIGHT
    less = renamed(locking, "question_of_reason", TypedArgument("deed", "lock"))
    assert judge.verdict(rows[11], answered(less)).verdict is Verdict.ANSWERED
    assert judge.verdict(rows[8], answered(reason)).verdict is Verdict.ANSWERED


def test_a_deed_for_a_question_is_acted_on_wrongly(judge: Judge, locking: Reading, rows: Dict[int, Sentence]) -> None:
    assert judge.verdict(rows[1], answered(locking)).verdict is Verdict.RIGHT
    for row in (6, 8, 15, 17, 19, 21, 23, 24):
        assert judge.verdict(rows[row], answered(locking)).verdict is Verdict.ACTED


def test_a_stop_is_acted_on_wrongly_where_none_was_meant(judge: Judge, rows: Dict[int, Sentence]) -> None:
    assert judge.verdict(rows[6], answered()).verdict is Verdict.ACTED


def test_refusals_are_right_where_they_say_why(judge: Judge) -> None:
    unseen, seen = about("ironing"), about("closing")
    assert judge.verdict(unseen[6], refused("NEGATED")).verdict is Verdict.RIGHT
    assert judge.verdict(unseen[17], refused("NO_SERVER")).verdict is Verdict.RIGHT
    assert judge.verdict(unseen[23], refused("REPORT")).verdict is Verdict.RIGHT
    for row in (6, 17, 23):
        assert judge.verdict(unseen[row], refused("STAGE_ERROR")).verdict is Verdict.REFUSED
    for row in (17, 20, 23):
        assert judge.verdict(seen[row], refused("NO_SERVER")).verdict is Verdict.REFUSED


def test_what_somebody_does_is_waited_for_and_noted_by_its_result(
    judge: Judge, pipeline: Pipeline, locking: Reading
) -> None:
    rows = about("closing", "the door")
    hello = pipeline.understand("Say hello.").readings[0]
    waits = planned("SEQUENCE", planned("WAIT", condition()), DO_THEN)
    alone = planned("WAIT", condition())
    for thing, state, right in (
        ("the door", "closed", Verdict.RIGHT),
        ("the door", "open", Verdict.ACTED),
        ("the gate", "closed", Verdict.ACTED),
    ):
        arguments = (TypedArgument("theme", thing), TypedArgument("state", state))
        state_said = renamed(locking, "condition_of_state", *arguments)
        assert judge.verdict(rows[17], answered(state_said, hello, plan=waits)).verdict is right
        is_right = right is Verdict.RIGHT
        assert (judge.verdict(rows[20], answered(state_said, plan=alone)).verdict is Verdict.RIGHT) is is_right
        noted = renamed(locking, "being_in_state", *arguments)
        assert (judge.verdict(rows[23], answered(noted)).verdict is Verdict.RIGHT) is is_right


def test_a_condition_may_be_the_deed_inside_another_frame(
    judge: Judge, pipeline: Pipeline, locking: Reading, rows: Dict[int, Sentence]
) -> None:
    hello = pipeline.understand("Say hello.").readings[0]
    plan = planned("IF", condition(is_negated=True), DO_THEN)
    for frame, right in (("locking", Verdict.RIGHT), ("opening", Verdict.ACTED)):
        door = (TypedArgument("container_portal", "the door"),)
        deed = EmbeddedFrame("says", frame, mood="statement", is_negated=True, frame_elements=door)
        done = renamed(locking, "condition_of_deed", TypedArgument("deed", "lock the door", frames=(deed,)))
        assert judge.verdict(rows[19], answered(done, hello, plan=plan)).verdict is right


def planned(kind: str, *children: PlanPart, **more: object) -> PlanPart:
    return PlanPart(kind, "", children, **more)  # type: ignore[arg-type]


def condition(*, is_negated: bool = False) -> PlanPart:
    return PlanPart("CONDITION", "", clause=0, is_negated=is_negated)


DO_THEN = PlanPart("DO", "", clause=1)


def test_what_is_decided_by_the_log_is_a_negated_condition(
    judge: Judge, pipeline: Pipeline, locking: Reading, rows: Dict[int, Sentence]
) -> None:
    hello = pipeline.understand("Say hello.").readings[0]
    plans: Tuple[Tuple[PlanPart, Verdict], ...] = (
        (planned("IF", condition(is_negated=True), DO_THEN), Verdict.RIGHT),
        (planned("IF", condition(), DO_THEN), Verdict.ACTED),
        (planned("WHENEVER", condition(is_negated=True), DO_THEN), Verdict.ACTED),
    )
    for plan, verdict in plans:
        assert judge.verdict(rows[19], answered(locking, hello, plan=plan)).verdict is verdict


def test_nothing_is_said_before_the_door_is_locked(
    judge: Judge, pipeline: Pipeline, locking: Reading, rows: Dict[int, Sentence]
) -> None:
    hello = pipeline.understand("Say hello.").readings[0]
    waits = planned("SEQUENCE", planned("WAIT", condition()), DO_THEN)
    assert judge.verdict(rows[21], answered(locking, hello, plan=waits)).verdict is Verdict.RIGHT
    both = planned("SEQUENCE", PlanPart("DO", "", clause=0), DO_THEN)
    assert judge.verdict(rows[21], answered(locking, hello, plan=both)).verdict is Verdict.ACTED
    assert judge.verdict(rows[18], answered(locking, hello, plan=both)).verdict is Verdict.RIGHT


def test_a_thing_is_gone_to_that_the_log_knows(judge: Judge, locking: Reading, rows: Dict[int, Sentence]) -> None:
    locked = EmbeddedFrame("describes", "locking", frame_elements=(TypedArgument("container_portal", "that"),))
    goal = TypedArgument("goal", "the door that you locked", head="door", frames=(locked,))
    going = renamed(locking, "navigating_to_location", goal)
    assert judge.verdict(rows[24], answered(going)).verdict is Verdict.RIGHT
    any_door = renamed(locking, "navigating_to_location", replace(goal, frames=()))
    assert judge.verdict(rows[24], answered(any_door)).verdict is Verdict.ACTED


def test_a_sample_of_the_matrix_gets_the_right_answers(judge: Judge) -> None:
    judged = [judge.judge(one) for one in sample_of(matrix(DOMAINS), 300, 0)]
    frozen = [one for one in judged if one.sentence.is_frozen]
    open_rows = [one for one in judged if not one.sentence.is_frozen]
    shown = "\n".join([*row_table(judged), *total_table(judged), *cause_table(open_rows)])
    assert share_right(judged) >= RIGHT_IN_SAMPLE, shown
    assert share_right(frozen) >= FROZEN_RIGHT_IN_SAMPLE, shown
    assert sum(one.verdict is Verdict.ACTED for one in judged) <= ACTED_IN_SAMPLE, shown


@pytest.mark.acceptance
def test_the_matrix_gets_the_right_answers(judge: Judge) -> None:
    judged = [judge.judge(one) for one in matrix(DOMAINS)]
    frozen = [one for one in judged if one.sentence.is_frozen]
    shown = "\n".join([*row_table(judged), *total_table(judged)])
    assert share_right(judged) >= RIGHT, shown
    assert share_right(frozen) >= FROZEN_RIGHT, shown
    assert sum(one.verdict is Verdict.ACTED for one in judged) <= ACTED, shown
