"""Userdata as text: what viewers load, and what is read from the wire."""

import base64
import collections
import enum
import pickle
import pickletools

import pytest
from std_msgs.msg import String

import smach
from smach_ros.local_data import from_json, to_json, to_pickle


class Colour(enum.IntEnum):
    RED = 1


class Name(str):
    __slots__ = ()


def userdata(**values):
    filled = smach.UserData()
    for key, value in values.items():
        filled[key] = value
    return filled


ODD = userdata(
    number=3,
    colour=Colour.RED,
    name=Name("Ann"),
    message=String("hello"),
    ordered=collections.OrderedDict(a=1),
    infinite=float("inf"),
    deep=[[[[[[[1]]]]]]],
    callback=len,
)


def test_pickle_for_viewers_names_no_class_and_calls_nothing():
    text = base64.b64decode(to_pickle(ODD))
    opcodes = {opcode.name for opcode, _, _ in pickletools.genops(text)}
    assert not opcodes & {"GLOBAL", "STACK_GLOBAL", "REDUCE", "INST", "OBJ", "NEWOBJ", "NEWOBJ_EX", "BUILD", "EXT1"}
    loaded = pickle.loads(text)  # noqa: S301 (written above)
    assert (loaded["number"], loaded["colour"], loaded["name"]) == (3, 1, "Ann")
    assert type(loaded["colour"]) is int and type(loaded["name"]) is str
    assert loaded["infinite"] == "inf" and "hello" in loaded["message"]


def test_json_is_read_back():
    assert from_json(to_json(userdata(a=[1, "x", None], b={"c": 2.5}))) == {"a": [1, "x", None], "b": {"c": 2.5}}
    assert from_json("") == from_json(to_json(smach.UserData())) == {}
    assert from_json(to_json(ODD))["infinite"] == "inf"


def test_no_userdata_is_the_same_text_for_every_implementation():
    assert to_json(smach.UserData()) == to_pickle(smach.UserData()) == "gAJ9cQAu"


@pytest.mark.parametrize("text", [to_pickle(userdata(a=1)), "(dp0\n.", "[1]", '{"_data": 1}', "{"])
def test_anything_else_is_refused(text):
    with pytest.raises(ValueError):
        from_json(text)
