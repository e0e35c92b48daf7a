"""The offline pipeline: the replies of the nodes, and a trace that names the rule."""

import pytest
import yaml

from command_server.stop_words import is_stop
from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.pipeline import BEHAVIOURS, Parameters, Pipeline, to_json
from roboframenet_testing.workspace import package
from semantic_framer.behaviour_2012 import Arguments, Questions
from semantic_framer.values.dialogue import Context
from semantic_framer.values.outcome import LeftOverWords, Policy


@pytest.fixture(scope="module")
def pipeline() -> Pipeline:
    knowledge = load_knowledge([shipped_domains()])
    pretend_servers(knowledge.graph)
    return Pipeline(knowledge, is_traced=True)


#: Sentences that were read wrongly or oddly at some time, and a line of the trace that says which rule did it.
ODD = (
    ("Tell her lunch is ready.", "quotations: lunch: nsubj(ready) -> flat:quoted(ready)"),
    ("take a right", "side_is_no_thing: taking(theme=a right): dropped."),
    ("take a look", "noun_of_another_verb: taking(theme=a look): dropped."),
    ("set the thermostat to 20", "number_is_no_place: placing(theme=the thermostat, goal=20): dropped."),
    ("lift a bit", "degree_is_no_thing: lifting(theme=a bit): dropped."),
    ("no, the office", "utterance_kind: correction: against_what_runs"),
    ("Bob turned left", "utterance_kind: Bob turned left: report: statement"),
    ("how many guests are in the hall", "utterance_kind: how many guests are in the hall: question: question_word"),
    ("remind me at eight to call Bob", "times: at eight: says when"),
    ("turn the lights off in the bedroom", "places_of_devices: bedroom: obl(turn) -> nmod(lights)"),
    ("give me a high five", "lists_less: low_fiving(hand=five, partner=me): dropped."),
    ("take Anna to the hall", "wrong_type: bringing(theme=Anna, goal=the hall): dropped."),
    ("carry Anna to the hall", 'wrong_type: carry Anna to the hall: asked. For me, "Anna" is a person'),
    ("take the frobnicator to the hall", "doubtful_type: guiding(cotheme=the frobnicator, goal=the hall): dropped."),
    ("Can I have the mug?", "light_verbs: have: VERB/have have -> VERB/want want"),
    (
        "I was wondering if you could open the door",
        "surroundings: 'I was wondering if you could open the door' -> 'Open the door'",
    ),
    ("go to the kitchen, sorry, the office", "corrections: kitchen: obl(go) -> reparandum(office)"),
    (
        "put the mug on the table and the plate in the sink",
        "argument_clusters: and the plate in the sink: a clause of its own",
    ),
    ("Go to the office and then to the kitchen.", "shared_verbs: kitchen: conj(office) -> obl(Go)"),
    ("turn 90° left", "degree_sign: 'turn 90° left' -> 'turn 90 degrees left'"),
    ("turn the volume to level three", "leaves_more_over: facing(goal=level three): dropped."),
    ("stop", "stop_words: stops at once"),
    ("Count the chairs in the hall.", "reattached: in the hall: ground of the verb, not part of chairs"),
    ("bring the mug closer to the door", 'words_before: closer: part of the goal "door"'),
    ("could you go to the hall and take the mug", "shared_subject: you: agent of this clause too"),
    ("bring the mug to the", "unfinished: to the: no noun for goal"),
    ("drive east", "no_default: something else is said for direction than forward"),
    ("take a left at the door", "phrases_left_over: turning(direction=left, angle=90, angle_unit=degrees): left over"),
    ("take the mug and bring it to me", "references: bringing(theme=it, beneficiary=me): bringing(theme=the mug"),
    ("bring it to me", "references: it: asked."),
    ("follow", "missing_element: following(): asked. No words for cotheme."),
    ("go to the office frobnicatingly", 'left_over_words: "frobnicatingly": asked. No server heeds it.'),
    ("take the mug without the plate", "left_over_words: plate: refused."),
    ("turn left or go back", "choices: turn left or go back: asked."),
)


@pytest.mark.parametrize("text, line", ODD, ids=[text for text, _ in ODD])
def test_trace_names_the_rule(pipeline: Pipeline, text: str, line: str) -> None:
    lines = [str(each) for each in pipeline.understand(text).trace]
    assert any(each.startswith(line) for each in lines), lines


@pytest.mark.parametrize("text, _", ODD, ids=[text for text, _ in ODD])
def test_the_trace_changes_nothing(pipeline: Pipeline, text: str, _: str) -> None:
    untraced = Pipeline(pipeline.knowledge, pipeline.parser)
    understanding = untraced.understand(text)
    assert understanding.trace == ()
    assert to_json(understanding) == to_json(pipeline.understand(text))


def test_trace_ends_with_what_came_of_it(pipeline: Pipeline) -> None:
    rules = [line.rule for line in pipeline.understand("Fribble the mug.").trace]
    assert rules[-2:] == ["unknown_verb", "outcome"]


@pytest.mark.parametrize(
    "text, without",
    [
        ("turn the lights off in the bedroom", "places_of_devices"),
        ("Tell her lunch is ready.", "quotations"),
        ("take 3ft", "units"),
    ],
)
def test_a_pass_is_switched_off_by_name(pipeline: Pipeline, text: str, without: str) -> None:
    lacking = Pipeline(pipeline.knowledge, pipeline.parser, without=frozenset([without]), is_traced=True)
    understanding = lacking.understand(text)
    assert without not in {line.rule for line in understanding.trace}
    assert understanding.tree_read != pipeline.understand(text).tree_read


@pytest.mark.parametrize("text", ["", "   ", "\t"])
def test_silence_has_the_reply_of_the_command_server(pipeline: Pipeline, text: str) -> None:
    reply = pipeline.understand(text).reply
    assert (reply.code, reply.sentence) == ("EMPTY_TEXT", "Nothing was said.")


def test_what_has_no_words_has_the_reply_of_the_parser(pipeline: Pipeline) -> None:
    assert pipeline.understand("?!").reply.sentence == "I cannot read that: there are no words in it."


def test_a_long_text_is_refused(pipeline: Pipeline) -> None:
    short = Pipeline(pipeline.knowledge, pipeline.parser, parameters=Parameters(max_text_length=10))
    assert short.understand("Turn left now.").reply.code == "TEXT_TOO_LONG"


@pytest.mark.parametrize("text", ["Stop.", "please stop", "stop there"])
def test_a_stop_is_not_parsed(pipeline: Pipeline, text: str) -> None:
    assert is_stop(text)
    understanding = pipeline.understand(text)
    assert (understanding.reply.outcome, understanding.tree) == ("DONE", None)


def test_parameters_are_those_of_the_nodes(pipeline: Pipeline) -> None:
    careless = Parameters(policy=Policy(left_over_words=LeftOverWords.IGNORE))
    text = "Turn left on the moon."
    assert pipeline.understand(text).reply.code == "LEFT_OVER_WORDS"
    assert Pipeline(pipeline.knowledge, pipeline.parser, parameters=careless).understand(text).reply.code == "DONE"


def test_the_context_is_carried_on(pipeline: Pipeline) -> None:
    asked = pipeline.understand("Move forward.")
    assert asked.reply.code == "MISSING_ELEMENT"
    assert pipeline.understand("three feet", asked.context).reply.code == "DONE"
    assert pipeline.understand("three feet").reply.code != "DONE"


def test_an_error_becomes_a_reply(pipeline: Pipeline, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(text: str, context: Context) -> None:
        raise RuntimeError("broken")

    monkeypatch.setattr(pipeline, "understand", fail)
    result = to_json(pipeline.understand_safely("Turn left."))
    assert result["reply"] == {"outcome": "FAILED", "code": "STAGE_ERROR", "sentence": "RuntimeError: broken"}


BEHAVIOUR_FILES = package("roboframenet_bringup") / "config" / "behaviours"


@pytest.mark.parametrize("name", BEHAVIOURS)
def test_behaviours_are_those_of_the_launch_files(name: str) -> None:
    framer = yaml.safe_load((BEHAVIOUR_FILES / f"{name}.yaml").read_text(encoding="utf-8"))["semantic_framer"]
    parameters = BEHAVIOURS[name]
    assert framer == {
        "left_over_words": parameters.policy.left_over_words.value,
        "alternatives": parameters.policy.alternatives.value,
        "arguments": parameters.arguments.value,
        "questions": parameters.questions.value,
        "fragment_timeout_s": parameters.policy.fragment_timeout_s,
    }


def test_habits_of_2012(pipeline: Pipeline) -> None:
    old = Pipeline(pipeline.knowledge, pipeline.parser, parameters=BEHAVIOURS["2012"], is_traced=True)
    went = old.understand("Go to Roger's office.")
    assert [(value.name, value.text) for value in went.readings[0].arguments] == [("goal", "office")]
    assert "behaviour_2012" in {line.rule for line in went.trace}
    asked = old.understand("Follow.")
    assert (asked.reply.outcome, asked.reply.code) == ("REFUSED", "MISSING_ELEMENT")
    assert asked.context.pending is None


def test_each_habit_of_2012_is_set_alone(pipeline: Pipeline) -> None:
    words = Parameters(arguments=Arguments.SINGLE_WORDS)
    asks_nothing = Parameters(questions=Questions.REFUSE)
    short = Pipeline(pipeline.knowledge, pipeline.parser, parameters=words).understand("Go to Roger's office.")
    assert short.candidates[0][0].frames[0].texts == (("goal", "office"),)
    long = Pipeline(pipeline.knowledge, pipeline.parser, parameters=asks_nothing).understand("Go to Roger's office.")
    assert long.candidates[0][0].frames[0].texts == (("goal", "Roger's office"),)


def test_the_command_behind_a_stop_is_understood(pipeline: Pipeline) -> None:
    stopped = pipeline.understand("stop and go to the office")
    assert stopped.reply.sentence == "Stopped." and not stopped.candidates
    assert stopped.behind is not None and stopped.behind.text == "go to the office"
    assert stopped.behind.candidates[0][0].frames[0].texts == (("goal", "the office"),)
    assert to_json(stopped)["behind"] == to_json(stopped.behind)
    assert stopped.context == stopped.behind.context


@pytest.mark.parametrize("text", ["stop", "stop, you will hit the lamp", "stop moving", "stop and " + "x" * 5000])
def test_nothing_is_behind_other_stops(pipeline: Pipeline, text: str) -> None:
    stopped = pipeline.understand(text)
    assert stopped.reply.sentence == "Stopped." and stopped.behind is None
