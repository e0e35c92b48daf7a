"""Launch files and READMEs agree on arguments, robots, policies and behaviours."""

import re
import subprocess
from typing import Dict, Set
from xml.etree import ElementTree

import pytest
import yaml

from arbitrator.policy import POLICIES
from roboframenet_testing.workspace import REPOSITORY, packages
from web_console.settings import Settings as ConsoleSettings

BRINGUP = packages()["roboframenet_bringup"]
ROBOTS = {path.stem for path in (BRINGUP / "launch" / "robots").glob("*.launch")}

#: What the page gets without an argument.
CONSOLE = {name: getattr(ConsoleSettings(), name) for name in ("address", "port", "token_file", "host_names")}


def meanings(launch_file: str) -> Dict[str, str]:
    """Return the documentation of each argument of a launch file."""
    root = ElementTree.parse(str(BRINGUP / "launch" / launch_file)).getroot()
    return {argument.attrib["name"]: argument.attrib.get("doc", "") for argument in root.findall("arg")}


def readme_meanings() -> Dict[str, str]:
    """Return the meaning of each argument of robot.launch in the README."""
    # A later section has the arguments of fleet.launch.
    text = (BRINGUP / "README.md").read_text(encoding="utf-8").partition("## Several robots")[0]
    return dict(re.findall(r"^\| `(\w+)` \|.*\| ([^|]+) \|$", text, re.MULTILINE))


def listed(text: str) -> Set[str]:
    """Return the names after the colon: "which robot: pr2 or turtlebot; empty: the first"."""
    return set(re.split(r", | or ", text.split(": ", 1)[1].split(";")[0]))


def behaviour(name: str) -> Dict[str, str]:
    """Return the parameters that ``behaviour:=NAME`` sets, as ``node/parameter``."""
    text = (BRINGUP / "config" / "behaviours" / f"{name}.yaml").read_text(encoding="utf-8")
    return {
        f"{node}/{parameter}": str(value)
        for node, parameters in yaml.safe_load(text).items()
        for parameter, value in parameters.items()
    }


def default_of(parameter: str) -> str:
    """Return the default of ``node/parameter`` in the README of the node's package."""
    package, name = parameter.split("/")
    text = (packages()[package] / "README.md").read_text(encoding="utf-8")
    found = re.search(rf"^\| `~{name}` \| \w+ \| `?([\w.]+)`? \|", text, re.MULTILINE)
    assert found, f"{package}/README.md does not list ~{name}"
    return found.group(1)


def run_robot(name: str) -> "subprocess.CompletedProcess[str]":
    """Start a robot as ``make run`` does."""
    return subprocess.run(
        [str(REPOSITORY / "scripts" / "run"), f"robot:={name}"],
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )


def test_listed_policies_are_those_that_exist() -> None:
    known = set(POLICIES) | {"package.module:ClassName"}
    assert listed(meanings("robot.launch")["policy"]) == listed(readme_meanings()["policy"]) == known


def test_every_robot_is_listed() -> None:
    assert ROBOTS
    assert listed(meanings("robot.launch")["robot"]) == listed(readme_meanings()["robot"]) == ROBOTS


def test_readme_lists_the_arguments_of_the_launch_file() -> None:
    assert readme_meanings() == meanings("robot.launch")


def test_an_unknown_robot_is_refused_with_the_known_names() -> None:
    ended = run_robot("pepper")
    assert ended.returncode == 2
    assert "no robot 'pepper'" in ended.stderr
    assert all(robot in ended.stderr for robot in ROBOTS)


def test_behaviour_now_equals_the_defaults_of_the_nodes() -> None:
    assert behaviour("now") == {parameter: default_of(parameter) for parameter in behaviour("now")}


def test_readme_and_files_of_the_behaviours_agree() -> None:
    text = (BRINGUP / "README.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| `(\w+/\w+)` \| ([\w.]+) \| ([\w.]+) \|", text, re.MULTILINE)
    assert {parameter: value for parameter, value, _ in rows} == behaviour("now")
    assert {parameter: value for parameter, _, value in rows} == behaviour("2012")


def console_parameters(*arguments: str) -> Dict[str, object]:
    """Return the parameters that ``robot.launch`` gives to the page."""
    dumped = subprocess.run(
        ["roslaunch", "--dump-params", "roboframenet_bringup", "robot.launch", "console:=true", *arguments],
        capture_output=True,
        text=True,
        timeout=60,
        check=True,
    ).stdout
    found = yaml.safe_load(dumped).items()
    return {name.rpartition("/")[2]: value for name, value in found if name.startswith("/web_console/")}


def test_page_is_offered_where_the_launch_arguments_say() -> None:
    unset = console_parameters()
    assert unset == {name: list(value) if isinstance(value, tuple) else value for name, value in CONSOLE.items()}
    arguments = ("address:=0.0.0.0", "port:=80", "token_file:=/token", "host_names:=robot,robot.example")
    assert console_parameters(*(f"console_{argument}" for argument in arguments)) == {
        "address": "0.0.0.0",
        "port": 80,
        "token_file": "/token",
        "host_names": ["robot", "robot.example"],
    }


@pytest.mark.parametrize("launch_file", ["pipeline.launch", "robot.launch"])
def test_every_behaviour_is_listed(launch_file: str) -> None:
    names = {path.stem for path in (BRINGUP / "config" / "behaviours").glob("*.yaml")}
    assert names == set(re.findall(r"(?:^|or )(\w+)", meanings(launch_file)["behaviour"]))
