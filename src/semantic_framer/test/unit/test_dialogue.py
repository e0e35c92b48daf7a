"""Questions, answers and statements, on parses written by hand: no model needed."""

from dataclasses import replace
from typing import Any, Dict, List, Tuple

import pytest

from semantic_framer.framer import Alternatives, LeftOverWords, Policy, Question, Refusal, Understood, read
from semantic_framer.units.lexicon import Lexicon
from semantic_framer.values.dialogue import Context, is_no, is_yes
from semantic_frames import load_frame
from semantic_frames.frame import SemanticFrame
from utterance_passes.trees.conllu import from_conllu

FRAMES = {
    frame.name: frame
    for frame in (
        load_frame(text, "frame.yaml")
        for text in (
            """
name: moving
frame_elements:
  - name: distance
    is_core: True
    quantity: length
    unit_element: distance_unit
    question: How far?
    answer: three feet
  - {name: distance_unit, is_core: True}
""",
            """
name: turning
frame_elements:
  - {name: direction, is_core: True, values: [left, right], question: "Left or right?", answer: left}
""",
            "name: taking\nframe_elements:\n  - {name: theme, is_core: True}\n",
        )
    )
}
UNITS = """
- frame_name: moving
  verb: move
  frame_element_grammatical_relations:
    - {name: distance, relation: measure}
- frame_name: turning
  verb: turn
  frame_element_grammatical_relations:
    - {name: direction, relation: advmod, words: [left, right]}
- frame_name: taking
  verb: take
  frame_element_grammatical_relations:
    - {name: theme, relation: dobj, argument: phrase}
"""
MOVE = "1 Move move VERB VB _ 0 root _ _"
TURN = "1 Turn turn VERB VB _ 0 root _ _"
TURN_LEFT = TURN + "\n2 left left ADV RB _ 1 advmod _ _"
TWO_METRES = "1 two two NUM CD _ 2 nummod _ _\n2 metres metre NOUN NNS _ 0 root _ _"


def lexicon() -> Lexicon:
    made = Lexicon()
    made.add_file(UNITS, "units.yaml")
    return made


def hear(*utterances: str, policy: Policy = Policy(), frames: Dict[str, SemanticFrame] = FRAMES) -> List[Any]:
    """Outcome of each utterance, one after the other."""
    context = Context()
    outcomes = []
    for rows in utterances:
        tree = from_conllu(rows)
        tree = replace(tree, text=" ".join(word.form for word in tree.words))
        outcome, context = read(tree, lexicon(), frames, context=context, policy=policy)
        outcomes.append(outcome)
    return outcomes


def arguments(outcome: Any) -> List[Tuple[str, Dict[str, str]]]:
    assert isinstance(outcome, Understood), outcome
    return [
        (readings[0].unit.frame_name, {value.name: value.text for value in readings[0].arguments})
        for readings in outcome.clauses
    ]


def test_fragment_fills_the_element_that_was_asked_for() -> None:
    question, done = hear(MOVE, TWO_METRES)
    assert isinstance(question, Question) and question.code == "MISSING_ELEMENT" and "three feet" in question.sentence
    assert arguments(done) == [("moving", {"distance": "2", "distance_unit": "metres"})]


@pytest.mark.parametrize(
    "answer",
    [
        "1 not not PART RB _ 3 advmod _ _\n2 two two NUM CD _ 3 nummod _ _\n3 metres metre NOUN NNS _ 0 root _ _",
        TWO_METRES
        + "\n3 if if SCONJ IN _ 5 mark _ _\n4 Bob Bob PROPN NNP _ 5 nsubj _ _\n5 agrees agree VERB VBZ _ 2 acl _ _",
        TWO_METRES
        + "\n3 in in ADP IN _ 5 case _ _\n4 five five NUM CD _ 5 nummod _ _\n5 minutes minute NOUN NNS _ 2 nmod _ _",
        TWO_METRES + "\n3 later later ADV RB _ 2 advmod _ _",
        TWO_METRES + "\n3 sideways sideways ADV RB _ 2 advmod _ _",
    ],
)
def test_answer_that_says_more_than_the_answer_is_not_acted_on(answer: str) -> None:
    assert isinstance(hear(MOVE, answer)[1], Refusal)


TWO_WAYS = """
- {frame_name: moving, verb: go, frame_element_grammatical_relations: [{name: distance, relation: measure}]}
- {frame_name: turning, verb: go, frame_element_grammatical_relations: [{name: direction, relation: advmod}]}
- {frame_name: taking, verb: go, frame_element_grammatical_relations: [{name: theme, relation: dobj}]}
- {frame_name: taking, verb: go, frame_element_grammatical_relations: [{name: theme, relation: iobj}]}
"""
GO = "1 Go go VERB VB _ 0 root _ _"


@pytest.mark.parametrize(
    "reply, done",
    [
        (TWO_METRES, [("moving", {"distance": "2", "distance_unit": "metres"})]),
        ("1 left left ADV RB _ 0 root _ _", [("turning", {"direction": "left"})]),
        ("1 mugs mug NOUN NNS _ 0 root _ _", [("taking", {"theme": "mugs"})]),
    ],
)
def test_answer_is_postmodifier_of_of_several_readings_was_meant(reply: str, done: List[Any]) -> None:
    made = Lexicon()
    made.add_file(TWO_WAYS, "units.yaml")
    question, context = read(from_conllu(GO), made, FRAMES)
    assert isinstance(question, Question) and question.code == "MISSING_ELEMENT"
    for part in ("How far?", "Left or right?", "What is the theme?"):
        assert question.sentence.count(part) == 1
    outcome, _ = read(from_conllu(reply), made, FRAMES, context=context)
    assert arguments(outcome) == done
    assert {reading.unit.frame_name for reading in outcome.clauses[0]} == {name for name, _ in done}


def test_what_several_readings_have_in_common_is_asked_once() -> None:
    made = Lexicon()
    made.add_file("- {frame_name: taking, verb: get}\n- {frame_name: lifting, verb: get}\n", "units.yaml")
    lifting = replace(FRAMES["taking"], name="lifting")
    frames = {"taking": FRAMES["taking"], "lifting": lifting}
    question, context = read(from_conllu("1 Get get VERB VB _ 0 root _ _"), made, frames)
    assert isinstance(question, Question) and question.sentence == "What is the theme?"
    outcome, _ = read(from_conllu("1 mugs mug NOUN NNS _ 0 root _ _"), made, frames, context=context)
    assert isinstance(outcome, Understood)
    assert {reading.unit.frame_name for reading in outcome.clauses[0]} == {"taking", "lifting"}


def test_no_ends_a_question() -> None:
    _, declined, late = hear(MOVE, "1 no no INTJ UH _ 0 root _ _", TWO_METRES)
    assert isinstance(declined, Refusal) and declined.code == "DECLINED"
    assert isinstance(late, Refusal)


def test_command_behind_an_answer_does_not_swallow_it() -> None:
    both = TWO_METRES + (
        "\n3 and and CCONJ CC _ 4 cc _ _\n4 turn turn VERB VB _ 2 conj _ _\n5 left left ADV RB _ 4 advmod _ _"
    )
    outcome = hear(MOVE, both)[1]
    assert isinstance(outcome, Refusal) and outcome.left_over == ("two", "metres")


def test_left_over_words_are_refused_before_anything_is_asked() -> None:
    (outcome,) = hear(MOVE + "\n2 sideways sideways ADV RB _ 1 advmod _ _")
    assert isinstance(outcome, Refusal) and outcome.left_over == ("sideways",)


@pytest.mark.parametrize("left_over_words", [LeftOverWords.WARN, LeftOverWords.IGNORE])
def test_answer_to_a_sentence_with_words_left_over(left_over_words: LeftOverWords) -> None:
    rows = MOVE + (
        "\n2 and and CCONJ CC _ 3 cc _ _\n3 turn turn VERB VB _ 1 conj _ _\n4 left left ADV RB _ 3 advmod _ _"
        "\n5 quickly quickly ADV RB _ 3 advmod _ _"
    )
    _, done = hear(rows, TWO_METRES, policy=Policy(left_over_words=left_over_words))
    assert [name for name, _ in arguments(done)] == ["moving", "turning"]


CONFIRMED = {name: replace(frame, is_confirmed=True) for name, frame in FRAMES.items()}


def test_yes_confirms_and_no_does_not() -> None:
    question, done = hear(TURN_LEFT, "1 yes yes INTJ UH _ 0 root _ _", frames=CONFIRMED)
    assert isinstance(question, Question) and question.code == "CONFIRM" and "turn left" in question.sentence
    assert arguments(done) == [("turning", {"direction": "left"})]
    assert isinstance(hear(TURN_LEFT, "1 no no INTJ UH _ 0 root _ _", frames=CONFIRMED)[1], Refusal)


def test_answer_that_could_be_a_yes_confirms_nothing() -> None:
    outcomes = hear(TURN, "1 right right ADV RB _ 0 root _ _", "1 yes yes INTJ UH _ 0 root _ _", frames=CONFIRMED)
    assert [getattr(outcome, "code", "") for outcome in outcomes] == ["MISSING_ELEMENT", "CONFIRM", ""]
    assert arguments(outcomes[2]) == [("turning", {"direction": "right"})]


def test_yes_to_a_frame_that_is_gone_does_nothing() -> None:
    context = Context()
    _, context = read(from_conllu(TURN_LEFT), lexicon(), CONFIRMED, context=context, policy=Policy())
    yes = replace(from_conllu("1 yes yes INTJ UH _ 0 root _ _"), text="yes")
    assert isinstance(read(yes, lexicon(), {}, context=context)[0], Refusal)


MUG_OR_PLATE = (
    "1 Take take VERB VB _ 0 root _ _\n2 the the DET DT _ 3 det _ _\n3 mug mug NOUN NN _ 1 obj _ _"
    "\n4 or or CCONJ CC _ 6 cc _ _\n5 the the DET DT _ 6 det _ _\n6 plate plate NOUN NN _ 3 conj _ _"
)


def test_only_what_was_offered_answers_which_one() -> None:
    policy = Policy(alternatives=Alternatives.ASK)
    plate = "1 the the DET DT _ 2 det _ _\n2 plate plate NOUN NN _ 0 root _ _"
    assert arguments(hear(MUG_OR_PLATE, plate, policy=policy)[1]) == [("taking", {"theme": "the plate"})]
    assert isinstance(hear(MUG_OR_PLATE, plate.replace("plate", "spoon"), policy=policy)[1], Refusal)


def test_choice_between_two_actions_is_asked_and_not_done_twice() -> None:
    rows = TURN_LEFT + (
        "\n3 or or CCONJ CC _ 4 cc _ _\n4 turn turn VERB VB _ 1 conj _ _\n5 right right ADV RB _ 4 advmod _ _"
    )
    (outcome,) = hear(rows)
    assert isinstance(outcome, Question) and outcome.code == "AMBIGUOUS"
    assert '"Turn left" or "turn right"' in outcome.sentence


@pytest.mark.parametrize(
    "before, verb",
    [
        ("1 I I PRON PRP _ 2 nsubj _ _", "turned VERB VBD"),
        ("1 Bob Bob PROPN NNP _ 2 nsubj _ _", "turned VERB VBD"),
        ("1 Bob Bob PROPN NNP _ 2 vocative _ _", "turned VERB VBD"),
        ("1 did do AUX VBD _ 3 aux _ _\n2 you you PRON PRP _ 3 nsubj _ _", "turn VERB VB"),
        ("1 Bob Bob PROPN NNP _ 3 nsubj _ _\n2 is be AUX VBZ _ 3 aux _ _", "turning VERB VBG"),
    ],
)
def test_statement_is_no_command(before: str, verb: str) -> None:
    index = before.count("\n") + 2
    form, tags = verb.split(" ", 1)
    verb_row = f"{index} {form} turn {tags} _ 0 root _ _"
    (outcome,) = hear(f"{before}\n{verb_row}\n{index + 1} left left ADV RB _ {index} advmod _ _")
    assert isinstance(outcome, Refusal) and outcome.code in ("REPORT", "QUESTION")


def test_nobody_is_a_negation() -> None:
    rows = (
        "1 nobody nobody PRON NN _ 2 nsubj _ _\n2 wants want VERB VBZ _ 0 root _ _\n3 you you PRON PRP _ 2 obj _ _"
        "\n4 to to PART TO _ 5 mark _ _\n5 turn turn VERB VB _ 2 xcomp _ _\n6 left left ADV RB _ 5 advmod _ _"
    )
    (outcome,) = hear(rows)
    assert isinstance(outcome, Refusal) and outcome.code == "NEGATED"


YOU_TURN_LEFT = "1 You you PRON PRP _ 2 nsubj _ _\n2 turn turn VERB VBP _ 0 root _ _\n3 left left ADV RB _ 2 advmod _ _"


@pytest.mark.parametrize("rows", [TURN_LEFT, YOU_TURN_LEFT])
def test_request_with_and_without_a_subject(rows: str) -> None:
    assert arguments(hear(rows)[0]) == [("turning", {"direction": "left"})]


@pytest.mark.parametrize(
    "word, near",
    [("trun", ("turn",)), ("tern", ("turn",)), ("tur", ("turn",)), ("mmove", ("move",)), ("fly", ())],
)
def test_verbs_one_letter_away_are_offered(word: str, near: Tuple[str, ...]) -> None:
    assert lexicon().nearest_verbs(word) == near


def test_verb_that_is_gone_is_not_offered() -> None:
    made = lexicon()
    made.add_file("frame_name: moving\nverb: go\n", "units.yaml")
    assert made.nearest_verbs("trun") == ()


def test_only_some_values_want_a_yes() -> None:
    turning = FRAMES["turning"]
    elements = tuple(
        replace(element, confirmed_values=("left",) if element.name == "direction" else ())
        for element in turning.frame_elements
    )
    frames = {**FRAMES, "turning": replace(turning, frame_elements=elements)}
    assert hear(TURN_LEFT, frames=frames)[0].code == "CONFIRM"
    assert isinstance(hear(TURN_LEFT.replace("left", "right"), frames=frames)[0], Understood)


def test_without_questions_nobody_is_asked_for_a_yes() -> None:
    assert isinstance(hear(TURN_LEFT, frames=CONFIRMED, policy=Policy(confirms=False))[0], Understood)


def test_silence_confirms_nothing() -> None:
    question, context = read(from_conllu(TURN_LEFT), lexicon(), CONFIRMED, policy=Policy(), now_s=100.0)
    assert isinstance(question, Question)
    yes = replace(from_conllu("1 yes yes INTJ UH _ 0 root _ _"), text="yes")
    late, _ = read(
        yes, lexicon(), CONFIRMED, context=context, policy=Policy(), now_s=100.0 + Policy.question_timeout_s + 1.0
    )
    assert isinstance(late, Refusal)


@pytest.mark.parametrize("text", ["Yes.", "Of course!", "Yes, please do.", "Yes, I'm sure.", "Yes, I\u2019m sure."])
def test_words_that_agree(text: str) -> None:
    assert is_yes(text) and not is_no(text)


@pytest.mark.parametrize("text", ["No.", "Of course not.", "Please don't."])
def test_words_that_decline(text: str) -> None:
    assert is_no(text) and not is_yes(text)


@pytest.mark.parametrize("text", ["I'm not sure.", "Maybe.", "Why?"])
def test_words_that_do_neither(text: str) -> None:
    assert not is_yes(text) and not is_no(text)
