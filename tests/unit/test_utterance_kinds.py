"""Questions, reports, wishes, prohibitions and talk start nothing; a request does what the plain command does."""

import hashlib
from collections import Counter
from typing import Iterable, List

import pytest
from utterance_kinds.inflection import Forms, inflect, inflect_clause
from utterance_kinds.judging import Judge, Verdict, table_by_kind
from utterance_kinds.utterances import (
    CLAUSES_PER_TEMPLATE,
    FOLDER,
    SETS,
    STYLES,
    Clause,
    Template,
    Utterance,
    fill,
    generate,
    load_clauses,
    load_templates,
    sample,
)

#: Do not edit the frozen templates. If a change cannot be avoided, explain it in the commit that changes this sum.
FROZEN_SHA256 = "5626f692156c405af7a6cffb776baa8fc29b8fb5b4af32584be818efe98c3be9"
QUESTION = Template("tune", "question", False, "listener", "?", "did you {base}")
WISH = Template("tune", "wish_of_speaker", False, "speaker", ".", "I want to {base}")
REQUEST = Template("tune", "request", True, "listener", "?", "could you {base}")


@pytest.fixture(scope="module")
def judge() -> Judge:
    return Judge()


@pytest.fixture(scope="module")
def everything() -> List[Utterance]:
    return [utterance for which in SETS for utterance in generate(which)]


@pytest.mark.parametrize(
    "verb, forms",
    [
        ("open", Forms("open", "opens", "opened", "opened", "opening")),
        ("pass", Forms("pass", "passes", "passed", "passed", "passing")),
        ("carry", Forms("carry", "carries", "carried", "carried", "carrying")),
        ("grab", Forms("grab", "grabs", "grabbed", "grabbed", "grabbing")),
        ("take", Forms("take", "takes", "took", "taken", "taking")),
        ("lie", Forms("lie", "lies", "lay", "lain", "lying")),
        ("see", Forms("see", "sees", "saw", "seen", "seeing")),
        ("put", Forms("put", "puts", "put", "put", "putting")),
        ("have", Forms("have", "has", "had", "had", "having")),
        ("go", Forms("go", "goes", "went", "gone", "going")),
        ("moo", Forms("moo", "moos", "mooed", "mooed", "mooing")),
    ],
)
def test_a_verb_is_inflected(verb: str, forms: Forms) -> None:
    assert inflect(verb) == forms


def test_in_a_clause_only_the_verb_is_inflected() -> None:
    assert inflect_clause("pick up the box").past == "picked up the box"
    assert inflect_clause("high five me").gerund == "high fiving me"


def test_a_template_is_filled() -> None:
    give = Clause("giving", "give me your mug", "")
    hang = Clause("hanging_clothes", "hang up the shirts", "the shirts")
    passive = Template("tune", "report", False, "other", ".", "{object} {has} been {passive}")
    assert fill(QUESTION, give) == "did you give me your mug"
    assert fill(WISH, give) == "I want to give you my mug"
    assert fill(passive, hang) == "the shirts have been hung up"


def test_an_utterance_is_written_in_four_styles() -> None:
    follow = Clause("following", "follow Alice", "Alice")
    assert [Utterance(REQUEST, follow, style).text for style in STYLES] == [
        "Could you follow Alice?",
        "could you follow alice",
        "Could you follow Alice",
        "could you follow alice?",
    ]


def test_set_is_large_and_uses_each_template_clause_and_style(everything: List[Utterance]) -> None:
    templates = [template for which in SETS for template in load_templates(which)]
    assert Counter(template.acts for template in templates)[False] >= 60
    assert Counter(template.acts for template in templates)[True] >= 25
    assert len({template.template for template in templates}) == len(templates)
    for acts, least in ((False, 2000), (True, 1000)):
        used = [utterance for utterance in everything if utterance.template.acts is acts]
        assert len(used) >= least
        assert {utterance.clause for utterance in used} == set(load_clauses())
        assert {utterance.style for utterance in used} == set(STYLES)
        counts = Counter(utterance.template for utterance in used)
        assert set(counts) == {template for template in templates if template.acts is acts}
        assert set(counts.values()) == {CLAUSES_PER_TEMPLATE[acts]}


def test_a_third_of_each_kind_is_frozen_and_unchanged() -> None:
    tune, frozen = (Counter(template.kind for template in load_templates(which)) for which in SETS)
    for kind in tune:
        assert abs(frozen[kind] - (tune[kind] + frozen[kind]) / 3) < 1
    assert hashlib.sha256((FOLDER / "templates_frozen.yaml").read_bytes()).hexdigest() == FROZEN_SHA256


def test_a_request_must_do_what_the_plain_command_does_and_a_question_nothing(judge: Judge) -> None:
    door = Clause("opening", "open the door", "the door")
    (request,) = judge.verdicts([Utterance(REQUEST, door, STYLES[0])])
    assert request.is_right and request.acted
    assert request.meaning == (("opening", (("container_portal", "the door"),)),)
    never = Template("tune", "prohibition", False, "listener", ".", "don't {base}")
    (prohibition,) = judge.verdicts([Utterance(never, door, STYLES[0])])
    assert prohibition.is_right and not prohibition.acted
    mistaken = Template("tune", "report", False, "listener", ".", "{base}")
    (command,) = judge.verdicts([Utterance(mistaken, door, STYLES[0])])
    assert command.acted and not command.is_right


def wrong(verdicts: Iterable[Verdict]) -> List[str]:
    """Return what is wrong, in a form that can be read in the report of the test."""
    return [f"{verdict.text}: {verdict.code} {verdict.meaning}" for verdict in verdicts if not verdict.is_right]


@pytest.mark.parametrize("acts, count", [(False, 100), (True, 50)], ids=["no act", "request"])
def test_in_a_sample_only_requests_act(judge: Judge, acts: bool, count: int) -> None:
    utterances = tuple(utterance for utterance in generate("tune") if utterance.template.acts is acts)
    assert wrong(judge.verdicts(sample(utterances, count))) == []


@pytest.mark.acceptance
@pytest.mark.parametrize("which", SETS)
@pytest.mark.parametrize("acts", [False, True], ids=["no act", "request"])
def test_in_the_whole_set_only_requests_act(judge: Judge, which: str, acts: bool) -> None:
    utterances = [utterance for utterance in generate(which) if utterance.template.acts is acts]
    verdicts = list(judge.verdicts(utterances))
    assert len(verdicts) >= 0.9 * len(utterances), "too many plain commands do nothing"
    if which == "frozen" and wrong(verdicts):  # The writer of the rules may see how many are wrong, but not which.
        pytest.fail("\n".join(table_by_kind(verdicts)), pytrace=False)
    assert wrong(verdicts) == []
