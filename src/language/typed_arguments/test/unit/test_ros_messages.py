"""Typed arguments survive the way through a message, and malformed messages are refused."""

import copy
import io
import math

import pytest
from generated_arguments import arguments
from roboframenet_msgs import msg

from typed_arguments import TypedArgument
from typed_arguments import argument as values
from typed_arguments.ros_messages import from_message, to_message


def over_the_wire(message):
    buffer = io.BytesIO()
    message.serialize(buffer)
    return type(message)().deserialize(buffer.getvalue())


def test_generated_arguments_come_back_as_they_were():
    made = arguments(300)
    assert max(argument.size for argument in made) > 20
    for argument in made:
        assert from_message(over_the_wire(to_message(argument))) == argument


@pytest.mark.parametrize("name", ["Modifier", "Measure", "EmbeddedFrame"])
def test_value_and_message_have_the_same_attributes(name):
    expected = set(getattr(msg, name).__slots__) - {"element_names", "element_phrases"}
    assert set(getattr(values, name).__dataclass_fields__) - {"frame_elements"} == expected


def test_argument_and_phrase_have_the_same_attributes():
    assert set(TypedArgument.__dataclass_fields__) - {"name"} == set(msg.Phrase.__slots__)
    times = {"begin", "end", "offset", "length", "period"}
    named = {f"{name}_s" if name in times else name for name in msg.TimeExpression.__slots__}
    assert set(values.TimeExpression.__dataclass_fields__) == named
    constants = {name: value for name, value in vars(msg.Phrase).items() if name.isupper() and isinstance(value, int)}
    assert {source.name: source.value for source in values.Source} == constants


def test_none_is_told_apart_from_nothing():
    phrase = to_message(TypedArgument("theme", "the mug")).phrases[0]
    assert phrase.count == -1
    assert (phrase.measure.kind, phrase.time.kind) == ("", "")
    assert from_message(to_message(TypedArgument("theme", "no mug", count=0))).count == 0
    length = values.Measure("length", "a bit")
    assert math.isnan(to_message(TypedArgument(measure=length)).phrases[0].measure.si)


def two_members():
    return to_message(TypedArgument("theme", "a and b", members=(TypedArgument(text="a"), TypedArgument(text="b"))))


def changed(change):
    message = copy.deepcopy(two_members())
    change(message.phrases)
    return message


@pytest.mark.parametrize(
    "message,part",
    [
        (msg.TypedArgument(name="theme"), "1 to 64 phrases, got 0"),
        (changed(lambda phrases: phrases.extend([msg.Phrase()] * 64)), "got 67"),
        (
            changed(lambda phrases: phrases.append(msg.Phrase(count=-1))),
            r"phrases \[3\] of the argument 'theme' are parts",
        ),
        (changed(lambda phrases: setattr(phrases[0], "members", [1, 1])), "phrase 1 is missing"),
        (changed(lambda phrases: setattr(phrases[0], "members", [1, 3])), "phrase 3 is missing"),
        (changed(lambda phrases: setattr(phrases[0], "members", [1, -1])), "phrase -1 is missing"),
        (changed(lambda phrases: setattr(phrases[0], "members", [0, 1])), "phrase 0 is missing"),
        (changed(lambda phrases: setattr(phrases[2], "possessor", 1)), "phrase 2 .* phrase 1 is missing"),
        (changed(lambda phrases: setattr(phrases[1], "possessor", 1)), "phrase 1 .* phrase 1 is missing"),
        (changed(lambda phrases: setattr(phrases[0], "source", 9)), "9 is not a valid Source"),
        (changed(lambda phrases: setattr(phrases[0], "count", -2)), "the count -2 is less than -1"),
        (changed(lambda phrases: setattr(phrases[0], "positions", [2, 1])), "do not ascend"),
        (
            changed(
                lambda phrases: (
                    setattr(phrases[0].measure, "kind", "length") or setattr(phrases[0].measure, "si", math.inf)
                )
            ),
            "si is inf",
        ),
        (
            changed(lambda phrases: phrases[0].frames.append(msg.EmbeddedFrame(role="says", element_names=["a"]))),
            "not as many phrases as elements",
        ),
        (changed(lambda phrases: phrases[0].modifiers.append(msg.Modifier())), "a modifier has no kind"),
    ],
)
def test_malformed_message_is_refused_with_the_reason(message, part):
    with pytest.raises(ValueError, match=part):
        from_message(message)
