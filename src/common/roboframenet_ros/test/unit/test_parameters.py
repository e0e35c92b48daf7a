"""Parameters of the right type and within their range pass; every other one is named."""

import enum
from dataclasses import dataclass
from typing import Tuple

import pytest

from roboframenet_ros.parameters import LiveParameter, ParameterError, Parameters, live_parameters, parameter


class Mode(enum.Enum):
    OWN = "own"
    SERVICE = "service"


@dataclass(frozen=True)
class Settings(Parameters):
    timeout_s: float = parameter(2.0, least=0.1, most=60.0)
    offset: float = parameter(0.0)
    count: int = parameter(100, least=1, most=1000)
    seed: int = parameter(-1)
    speed_m: float = parameter(1.0, above=0.0)
    is_on: bool = parameter(True)
    mode: Mode = parameter(Mode.OWN)
    policy: str = parameter("random", may_be_empty=False)
    remark: str = parameter("")
    topics: Tuple[str, ...] = parameter(("cmd_vel",))
    paths: Tuple[str, ...] = parameter((), may_be_single=True)


@pytest.mark.parametrize(
    "name, value",
    [
        ("timeout_s", 0.1),
        ("timeout_s", 60),
        ("offset", -1e9),
        ("count", 1),
        ("count", 1000),
        ("seed", -5),
        ("is_on", False),
        ("speed_m", 1e-9),
        ("speed_m", 1e9),
        ("mode", Mode.SERVICE),
        ("policy", "all"),
        ("remark", ""),
        ("topics", ("a", "b")),
        ("topics", ()),
    ],
)
def test_right_value_is_kept(name, value):
    assert getattr(Settings(**{name: value}), name) == value


def test_defaults_are_right():
    assert Settings() == Settings(
        timeout_s=2.0,
        offset=0.0,
        count=100,
        seed=-1,
        is_on=True,
        speed_m=1.0,
        mode=Mode.OWN,
        policy="random",
        remark="",
        topics=("cmd_vel",),
        paths=(),
    )
    assert Settings.timeout_s == 2.0


def test_text_is_as_a_person_would_set_them():
    text = str(Settings(topics=("a", "b")))
    assert text.startswith("timeout_s=2, offset=0, count=100")
    assert text.endswith("mode=own, policy=random, remark='', topics=[a, b], paths=[]")


def test_list_becomes_a_tuple():
    assert Settings(topics=["a", "b"]).topics == ("a", "b")
    assert Settings(paths="one").paths == ("one",)


def test_text_becomes_a_member_of_the_enum():
    assert Settings(mode="service").mode is Mode.SERVICE


def test_other_fields_are_not_checked():
    @dataclass(frozen=True)
    class Mixed(Parameters):
        count: int = parameter(1)
        other: object = None

    assert Mixed(other="x").other == "x"


@pytest.mark.parametrize(
    "name, value, told",
    [
        ("timeout_s", 0.0, "~timeout_s must be 0.1 to 60 s, got 0.0"),
        ("timeout_s", 61, "~timeout_s must be 0.1 to 60 s, got 61"),
        ("timeout_s", float("nan"), "~timeout_s must be 0.1 to 60 s, got nan"),
        ("timeout_s", float("inf"), "~timeout_s must be 0.1 to 60 s, got inf"),
        ("timeout_s", True, "~timeout_s must be 0.1 to 60 s, got True"),
        ("timeout_s", "2", "~timeout_s must be 0.1 to 60 s, got '2'"),
        ("offset", float("inf"), "~offset must be a number, got inf"),
        ("count", 0, "~count must be an integer from 1 to 1000, got 0"),
        ("count", 2.0, "~count must be an integer from 1 to 1000, got 2.0"),
        ("count", True, "~count must be an integer from 1 to 1000, got True"),
        ("seed", "x", "~seed must be an integer, got 'x'"),
        ("speed_m", 0.0, "~speed_m must be more than 0 m, got 0.0"),
        ("speed_m", float("inf"), "~speed_m must be more than 0 m, got inf"),
        ("mode", "launch", "~mode must be one of own, service, got 'launch'"),
        ("mode", 1, "~mode must be one of own, service, got 1"),
        ("is_on", 1, "~is_on must be true or false, got 1"),
        ("policy", "", "~policy must be a name, got ''"),
        ("remark", None, "~remark must be a text, got None"),
        ("topics", "a", "~topics must be a list of names, got 'a'"),
        ("topics", ["a", ""], "~topics must be a list of names, got ['a', '']"),
        ("paths", [1], "~paths must be a list of names, got [1]"),
    ],
)
def test_wrong_value_is_named_with_what_is_expected(name, value, told):
    with pytest.raises(ParameterError) as raised:
        Settings(**{name: value})
    assert str(raised.value) == told


@dataclass(frozen=True)
class Tunable(Parameters):
    fixed: float = parameter(1.0, above=0.0)
    speed_m: float = parameter(1.0, above=0.0, is_live=True)
    count: int = parameter(100, least=1, most=1000, is_live=True)
    mode: Mode = parameter(Mode.OWN, is_live=True)


def test_live_parameters_have_their_bounds_and_choices():
    assert live_parameters(Tunable) == (
        LiveParameter("speed_m", 1.0, least=0.0, most=None),
        LiveParameter("count", 100, least=1, most=1000),
        LiveParameter("mode", "own", least=None, most=None, choices=("own", "service")),
    )
    assert live_parameters(Settings) == ()
