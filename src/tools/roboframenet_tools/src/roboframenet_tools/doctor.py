"""``rfn doctor``: finds out why the system does not work, and what to do about it."""

import argparse
import importlib
import importlib.util
import os
import sys
from typing import List, Tuple

from roboframenet_tools.finding import Finding
from stanford_parser_ros.inference import JOINT, ModelError, shipped_model_dir
from stanford_parser_ros.joint.model_folder import read_joint_folder
from stanford_parser_ros.words.word_folder import read_word_folder
from stanford_parser_ros.words.words import FOLDER
from voice_recognition.engines import Engine, chosen
from voice_recognition.whisper_client import WhisperProcess

EXAMPLES = """examples:
  rfn doctor
  rfn doctor --no-master    only checks that need no running graph
  rfn doctor --robot        also what a robot needs before the first sentence
  rfn doctor --robot --moves-nothing /recognize_objects

exit status: 0 no problem, 1 a problem
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn doctor``."""
    parser.epilog = EXAMPLES
    parser.add_argument("--no-master", action="store_true", help="do not look for a running graph")
    parser.add_argument(
        "--robot", action="store_true", help="check network, base, odometry, localisation, tf, stop and bindings, too"
    )
    parser.add_argument(
        "--moves-nothing",
        action="append",
        default=[],
        metavar="SERVER",
        help="with --robot: an action server that a stop need not cancel; may be given several times",
    )


def run(arguments: argparse.Namespace) -> int:
    """Print the findings; return the exit status."""
    findings = [interpreter(), library("onnxruntime"), library("rospy"), models(), host_name(), agents(), voice()]
    if not arguments.no_master:
        try:
            from roboframenet_tools.ros_doctor import graph_findings

            findings += graph_findings(robot=arguments.robot, moves_nothing=arguments.moves_nothing)
        except ImportError as error:
            findings.append(Finding("graph", str(error), "source devel/setup.sh (or setup.sh of the install space)"))
    for finding in findings:
        print(finding)
    return 1 if any(finding.advice for finding in findings) else 0


def interpreter() -> Finding:
    """Check the Python interpreter."""
    found = f"{sys.executable} {sys.version.split()[0]}"
    return Finding("interpreter", found, "" if sys.version_info >= (3, 8) else "use Python 3.8 or later")


def library(name: str) -> Finding:
    """Check whether a library can be imported."""
    try:
        module = importlib.import_module(name)
    except ImportError as error:
        advice = (
            "source devel/setup.sh"
            if name == "rospy"
            else "run 'make setup', and rfn with the Python of its environment"
        )
        return Finding(name, str(error), advice)
    return Finding(name, str(getattr(module, "__version__", "there")))


def models() -> Finding:
    """Check the models of the parser by their sums."""
    folder = shipped_model_dir()
    try:
        read_joint_folder(folder / JOINT)
        read_word_folder(folder / FOLDER)
    except ModelError as error:
        what, _, advice = str(error).rpartition("; ")
        return Finding("models", what, advice)
    return Finding("models", str(folder))


def agents(version: Tuple[int, ...] = sys.version_info[:3], sdk: str = "mcp") -> Finding:
    """Tell whether agents can command the robot; nobody has to want it.

    Args:
        version: of Python
        sdk: name of the module
    """
    if version < (3, 10):
        return Finding("agents", "agent_server does not run: its SDK needs Python 3.10 or later")
    if importlib.util.find_spec(sdk) is None:
        return Finding("agents", "the SDK of agent_server is not installed ('make agents' installs it)")
    return Finding("agents", "agent_server can run")


def voice(wished: Engine = Engine.AUTO) -> Finding:
    """Tell which recogniser hears what is said, how long it takes to load it, and how much memory it holds.

    Args:
        wished: as the parameter `engine` of voice_recognition
    """
    engine, reason = chosen(wished)
    if engine is not Engine.WHISPER:
        return Finding("voice", "pocketsphinx hears" + (f"; {reason}" if reason else ""))
    whisper = WhisperProcess()
    try:
        whisper.start()
        if not whisper.wait_until_ready():
            return Finding(
                "voice", f"Whisper does not hear: {whisper.problem}", "launch with voice_engine:=pocketsphinx"
            )
        return Finding("voice", f"Whisper hears: loaded in {whisper.loaded_in_s:.1f} s, {whisper.memory_mb} MB")
    finally:
        whisper.close()


def host_name() -> Finding:
    """Check the host name under which other nodes reach this machine."""
    names: List[str] = [f"{name}={os.environ[name]}" for name in ("ROS_HOSTNAME", "ROS_IP") if os.environ.get(name)]
    if names:
        return Finding("host name", ", ".join(names))
    return Finding(
        "host name", "neither ROS_HOSTNAME nor ROS_IP is set", "export ROS_HOSTNAME=127.0.0.1 for one machine"
    )
