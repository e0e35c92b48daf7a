"""The text of a goal: every argument comes back; what is wrong leaves the strings of 2012, and says why."""

import doctest
import json
import random
from pathlib import Path

import pytest
from generated_arguments import arguments

from typed_arguments import Measure, TypedArgument, from_goal_text, to_goal_text
from typed_arguments.goal_text import LONGEST_GOAL_TEXT, MOST_ARGUMENTS

GOAL = [("theme", "the mug"), ("goal", "the table")]
PLAIN = (TypedArgument("theme", "the mug"), TypedArgument("goal", "the table"))
UNDER = TypedArgument("goal", "the table", relation="under", measure=Measure("length", si=0.5))


def whole(**changes):
    """A text that is right but for the changes."""
    return json.dumps({"typed_arguments": 1, "arguments": [{"name": "goal", "text": "the table"}], **changes})


def one(**attributes):
    return whole(arguments=[{"name": "goal", "text": "the table", **attributes}])


def test_generated_arguments_come_back_as_they_were():
    for argument in arguments(300):
        found = from_goal_text(to_goal_text([argument]), [(argument.name, argument.text)])
        assert found.arguments == (argument,)
        assert not found.reason


def test_text_is_ascii_and_as_short_as_may_be():
    text = to_goal_text([TypedArgument("goal", "die Küche")])
    assert text.isascii()
    assert json.loads(text)["arguments"] == [{"name": "goal", "text": "die Küche"}]


def test_elements_keep_the_order_of_the_goal():
    found = from_goal_text(to_goal_text([UNDER]), GOAL)
    assert (found.arguments, found.reason) == ((PLAIN[0], UNDER), "")


def test_goal_of_a_client_of_2012_has_its_strings_and_no_reason():
    found = from_goal_text("", GOAL)
    assert (found.arguments, found.reason) == (PLAIN, "")


def test_each_attribute_is_believed_only_in_its_type():
    assert from_goal_text(one(measure={"kind": "length", "si": 3}), GOAL).arguments[1].si == 3.0


@pytest.mark.parametrize(
    "text,part",
    [
        ("map", "Expecting value"),
        ("0", "something else"),
        ("[]", "something else"),
        ("null", "something else"),
        ('{"a": 1}', "something else"),
        ("__import__('os').system('true')", "Expecting value"),
        (whole()[:-1], "delimiter"),
        (whole() + "x", "Extra data"),
        (whole(typed_arguments=2), "its version is 2, and 1 is known"),
        (whole(typed_arguments=True), "its version is True"),
        (whole(typed_arguments=1.0), "its version is 1.0"),
        (whole(typed_arguments="1"), "its version is '1'"),
        (whole(more=1), "it has the keys"),
        ('{"typed_arguments": 1}', "it has the keys"),
        ('{"typed_arguments": 1, "arguments": [], "arguments": []}', "a key stands twice"),
        (whole(arguments={}), "arguments is no list"),
        (whole(arguments=[{}] * (MOST_ARGUMENTS + 1)), f"may have {MOST_ARGUMENTS}"),
        (whole(arguments=["goal"]), "arguments is no object"),
        (whole(arguments=[{"name": "goal"}]), "no element 'goal' with the argument ''"),
        (whole(arguments=[{"name": "path", "text": "the table"}]), "no element 'path'"),
        (whole(arguments=[{"name": "goal", "text": "the shelf"}]), "with the argument 'the shelf'"),
        (whole(arguments=[{"name": "goal", "text": "the table"}] * 2), "two arguments for 'goal'"),
        (one(colour="red"), "unknown keys: colour"),
        (one(__class__="x"), "unknown keys: __class__"),
        (one(relation=1), "relation is int, and must be str"),
        (one(relation=None), "relation is NoneType"),
        (one(count=True), "count is bool"),
        (one(count=2.0), "count is float"),
        (one(count=-1), "the count -1"),
        (one(count=10**30), "does not fit in 32 bits"),
        (one(is_plural=1), "is_plural is int"),
        (one(source=7), "7 is not a valid Source"),
        (one(source=True), "source is bool"),
        (one(positions=[1.0]), "positions is float"),
        (one(positions="12"), "positions is no list"),
        (one(measure={}), "measure lacks kind"),
        (one(measure={"kind": "length", "si": "3"}), "si is str"),
        (one(measure={"kind": "length", "si": 3}).replace("3}", "NaN}"), "NaN is no number"),
        (one(measure={"kind": "length", "si": 3}).replace("3}", "1e999}"), "si is inf"),
        (one(measure={"kind": "length", "si": 3}).replace("3}", "1" + "0" * 400 + "}"), "si is int"),
        (one(members=[{"text": "a"}]), "a list has one member"),
        (one(referents=["\ud800"]), "surrogates not allowed"),
        (one(text="x" * LONGEST_GOAL_TEXT), f"may have {LONGEST_GOAL_TEXT}"),
        ("[" * LONGEST_GOAL_TEXT, "nested too deeply"),
        # How deep Python reads differs from version to version.
        ('{"possessor":' * 5000, "the goal's text of typed arguments is not used"),
    ],
)
def test_what_is_wrong_leaves_the_strings_and_says_why(text, part):
    found = from_goal_text(text, GOAL)
    assert found.arguments == PLAIN
    assert part in found.reason


def test_goal_with_an_element_twice_has_its_strings():
    twice = [("goal", "the table"), ("goal", "the shelf")]
    found = from_goal_text(whole(), twice)
    assert [argument.text for argument in found.arguments] == ["the table", "the shelf"]
    assert "twice" in found.reason


@pytest.mark.parametrize("depth", [8, 17, 18, 900])
def test_deep_parts_are_refused(depth):
    part = {"text": "x"}
    for _ in range(depth):
        part = {"possessor": part}
    found = from_goal_text(one(**part), GOAL)
    assert found.arguments == PLAIN
    assert "levels" in found.reason


def test_texts_with_mistakes_never_raise():
    chance = random.Random(1)
    texts = [to_goal_text([UNDER])] + [to_goal_text([argument]) for argument in arguments(20)]
    for _ in range(3000):
        text = list(chance.choice(texts))
        for _ in range(chance.randrange(1, 4)):
            at = chance.randrange(len(text))
            text[at : at + chance.randrange(3)] = chance.choice(
                ['"', "}", "[", "1", "-", "", "\0", "\ud800", "語", "null"]
            )
        found = from_goal_text("".join(text), GOAL)
        assert [(argument.name, argument.text) for argument in found.arguments] == GOAL
        assert found.reason or found.arguments[0] == PLAIN[0]


def test_too_much_is_not_written():
    with pytest.raises(ValueError, match="may have"):
        to_goal_text([TypedArgument("goal", "x" * LONGEST_GOAL_TEXT)])
    with pytest.raises(ValueError, match="may have"):
        to_goal_text([UNDER] * (MOST_ARGUMENTS + 1))


def test_examples_of_the_readme():
    readme = Path(__file__).resolve().parents[2] / "README.md"
    results = doctest.testfile(
        str(readme), module_relative=False, optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
    )
    assert results.attempted > 5
    assert not results.failed
