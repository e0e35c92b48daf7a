"""One hundred questions about twenty random states of the home: right answers, and nothing invented.

The answers are judged by the state of the home, which the robot knows in part.
"""

import random
from typing import List, Optional, Sequence, Tuple

import pytest
from home_questions.judging import TEMPLATES, Asker, Question, Verdict, judge
from home_questions.states import Scene, known_of, scene_of

from offline_pipeline.pipeline import Pipeline
from question_answering.answers import ANSWERS, answer
from question_answering.robot_knowledge import RobotKnowledge
from typed_arguments import TypedArgument

QUESTIONS_OF_A_SCENE = 5
#: About measures, order and numbers.
OF_MEASURES = ("ranked", "height", "comparison", "choice", "more")
#: The figures that must be reached, of a hundred.
LEAST_RIGHT, LEAST_RIGHT_OF_MEASURES = 95, 75


def answered(text: str, pipeline: Pipeline, known: RobotKnowledge) -> Optional[str]:
    """Return the answer to a question, direct or told; None when it is not understood as one."""
    readings = pipeline.in_world(known.world).understand(text).readings
    if len(readings) != 1:
        return None
    if readings[0].unit.frame_name in ANSWERS:
        return answer(readings[0].unit.frame_name, readings[0].arguments, known)
    return next((found for one in readings[0].arguments for found in [_told(one, known)] if found), None)


def _told(message: TypedArgument, known: RobotKnowledge) -> Optional[str]:
    asked = next((frame for frame in message.frames if frame.frame_name in ANSWERS), None)
    return answer(asked.frame_name, asked.frame_elements, known) if asked is not None else None


def run(
    pipeline: Pipeline, share: str, scenes: range, kinds: Sequence[str]
) -> Tuple[List[Tuple[Question, Optional[str], Verdict]], List[Scene]]:
    """Ask some questions about each scene, of some kinds in turn."""
    results = []
    asked = 0
    found = []
    for seed in scenes:
        scene = scene_of(seed)
        found.append(scene)
        known = RobotKnowledge(known_of(scene))
        asker = Asker(scene, random.Random(f"{share} {seed}"), share)
        for _ in range(QUESTIONS_OF_A_SCENE):
            question = asker.ask(kinds[asked % len(kinds)])
            asked += 1
            said = answered(question.text, pipeline, known)
            results.append((question, said, judge(question, said, scene)))
    return results, found


def described(results: List[Tuple[Question, Optional[str], Verdict]]) -> str:
    """Return the wrong answers, for people."""
    return "\n".join(
        f"{question.kind}: {question.text} -> {said}; wanted {question.verdict or list(map(sorted, question.must))}; "
        f"invented: {', '.join(verdict.invented) or 'nothing'}"
        for question, said, verdict in results
        if not verdict.is_right
    )


def test_every_kind_is_answered_in_some_scenes(pipeline: Pipeline) -> None:
    results, _ = run(pipeline, "tune", range(100, 104), sorted(TEMPLATES))
    assert not [verdict.invented for _, _, verdict in results if verdict.invented], described(results)
    assert all(verdict.is_right for _, _, verdict in results), described(results)


@pytest.mark.acceptance
@pytest.mark.parametrize("share", ["tune", "held", "fresh", "spoken"])
def test_a_hundred_questions_about_twenty_scenes(share: str, pipeline: Pipeline) -> None:
    for kinds, least in ((sorted({*TEMPLATES} - {*OF_MEASURES}), LEAST_RIGHT), (OF_MEASURES, LEAST_RIGHT_OF_MEASURES)):
        results, _ = run(pipeline, share, range(20), kinds)
        assert len(results) == 100
        assert not [verdict.invented for _, _, verdict in results if verdict.invented], described(results)
        assert sum(verdict.is_right for _, _, verdict in results) >= least, described(results)


@pytest.mark.parametrize(
    ("said", "is_right", "is_invented"),
    [
        ("The newspaper is on the {holder} in the {room}.", True, False),
        ("The newspaper is somewhere.", False, False),
        ("The newspaper is on the piano in the {other}.", False, True),
        (None, False, False),
    ],
)
def test_the_judge_knows_wrong_answers(said: Optional[str], is_right: bool, is_invented: bool) -> None:
    scene = scene_of(1)
    paper = scene.plan.entities["newspaper"]
    holder = scene.plan.entities[scene.state.places["newspaper"].holder]
    room = scene.plan.entities[scene.room_of(paper)]
    other = next(one for one in scene.entities("room") if one != room)
    names = frozenset([*paper.names, *holder.names, *room.names])
    question = Question("place", "Where is the newspaper?", (names - frozenset(paper.names),), names)
    text = said and said.format(holder=holder.name, room=room.name, other=other.name)
    verdict = judge(question, text, scene)
    assert (verdict.is_right, bool(verdict.invented)) == (is_right, is_invented)


@pytest.mark.parametrize(
    ("said", "is_right", "is_invented"),
    [
        ("I know of no box but the toolbox, which is in the {garage}.", True, False),
        ("The toolbox is in the {garage}.", False, False),
        ("I know of no box but the toolbox, which is in the {other}.", False, True),
        ("I have not seen any box. The toolbox has it.", False, True),
    ],
)
def test_the_judge_knows_what_is_true_of_another_thing(said: str, is_right: bool, is_invented: bool) -> None:
    scene = scene_of(1)
    rooms = {one.id: one.name for one in scene.entities("room")}
    box = scene.plan.entities["box"]
    names = frozenset(name.lower() for name in box.names)
    question = Question("unseen", "Where is the box?", names=names, verdict="unknown", noun="box")
    verdict = judge(question, said.format(garage=rooms["garage"], other=rooms["kitchen"]), scene)
    assert (verdict.is_right, bool(verdict.invented)) == (is_right, is_invented)
