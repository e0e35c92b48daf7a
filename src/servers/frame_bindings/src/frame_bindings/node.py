"""The node ``frame_bindings``: serves all frames of the binding files."""

from dataclasses import dataclass, replace
from typing import Any, List, Sequence, Tuple, Union

import rosgraph
import rospy
from roboframenet_msgs.msg import FilledSemanticFrame, FilledSemanticFrameFeedback

from checked_files.problem import FileRefused
from checked_files.source_files import read_text
from frame_bindings.binding_file import Binding, load_bindings
from frame_bindings.ros_conditions import BoundCondition
from frame_bindings.ros_targets import TARGET_OF_KIND
from rfnserver import RFNServer
from rfnserver.arguments import ArgumentError
from rfnserver.registration import FrameFit
from rfnserver.ros_frame_adapter import GoalMaker, check_frame, conclude
from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_node import StartError, read_parameters, run_node
from semantic_frames.server_statement import stated_profile


@dataclass(frozen=True)
class Settings(Parameters):
    """Private parameters, checked.

    Attributes:
        files: binding files

    Raises:
        ParameterError: not a list of names
    """

    files: Tuple[str, ...] = parameter((), may_be_single=True)


class BoundServer:
    """An RFNServer for one binding.

    Actions:
        the binding's name (roboframenet_msgs/FilledSemanticFrameAction)
    """

    def __init__(self, binding: Binding) -> None:
        """
        Raises:
            UnknownType: a type that the binding names does not exist
            ResultError: the result lacks fields that the binding names
            ValueError: the message cannot hold the constants
        """
        self._binding = binding
        self._target = TARGET_OF_KIND[binding.kind](binding)
        self._maker = GoalMaker(
            self._target.message_type,
            mapping=binding.fields,
            ignored_elements=binding.ignored_elements,
            constants=binding.constants,
        )
        self._profile = stated_profile(binding.statement)
        self._server = RFNServer(binding.name, callback=self._on_frame, check=self._check, **binding.statement)
        self._server.start()

    def register(self) -> None:
        """Register for the frame. Without a registrar this takes seconds, and is repeated when a registrar starts."""
        self._server.register_with_frame(self._binding.frame_name)

    def _type_fault(self) -> str:
        """Return the problem with the type of the live server; empty while there is no server."""
        try:
            live = self._target.live_type()
        except (rosgraph.MasterException, OSError) as error:
            rospy.logwarn("%s: the type of %s cannot be seen: %s", self._binding.name, self._binding.target, error)
            return ""
        if live is None or live == self._binding.type_name:
            return ""
        return f"{self._binding.kind.value} {self._binding.target} is of type {live}, not {self._binding.type_name}"

    def _check(self, frame_name: str) -> FrameFit:
        fit = check_frame(frame_name, self._maker, self._profile)
        return replace(fit, fault=fit.fault or self._type_fault())

    def _on_frame(self, frame: FilledSemanticFrame) -> None:
        fault = self._type_fault()
        if fault:
            self._server.set_aborted(None, fault)
            return
        try:
            message = self._maker.make(frame, self._profile)
        except ArgumentError as error:
            self._server.set_aborted(None, str(error))
            return
        end = self._target.carry_out(message, self._server.is_preempt_requested, self._on_feedback)
        conclude(self._server, end)

    def _on_feedback(self, _feedback: Any) -> None:
        self._server.publish_feedback(FilledSemanticFrameFeedback(is_succeeding=True))


Bound = Union[BoundServer, BoundCondition]


def bound_servers(paths: Sequence[str]) -> List[Bound]:
    """Serve the bindings of some files. A wrong file or binding is logged; the others are served."""
    servers: List[Bound] = []
    for path in paths:
        try:
            bound = load_bindings(read_text(path), path)
        except FileRefused as refused:
            _log(refused)
            continue
        for binding in bound.bindings:
            try:
                servers.append(BoundServer(binding))
            except ValueError as error:  # of the binding: its types, its result, its constants
                rospy.logerr("%s:%d: %s: %s", path, binding.line, binding.name, error)
        for condition in bound.conditions:
            try:
                servers.append(BoundCondition(condition))
            except FileRefused as refused:
                _log(refused)
    return servers


def _log(refused: FileRefused) -> None:
    for problem in refused.problems:
        rospy.logerr("%s", problem)


def _start() -> List[Bound]:
    settings = read_parameters(Settings)
    servers = bound_servers(settings.files)
    if not servers:
        raise StartError(f"no frame is bound; ~files: {', '.join(settings.files) or 'empty'}")
    rospy.loginfo("%d %s bound", len(servers), "frame is" if len(servers) == 1 else "frames are")
    for server in servers:
        server.register()
    return servers


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when it cannot start."""
    run_node("frame_bindings", _start)
