"""The node ``frame_bindings``: serves all frames of the binding files."""

from typing import Any, List, Tuple

import rosgraph
import rospy
from roboframenet_msgs.msg import FilledSemanticFrame, FilledSemanticFrameFeedback

from frame_bindings.binding_file import Binding, load_bindings
from frame_bindings.ros_targets import TARGET_OF_KIND, UnknownType
from rfnserver import RFNServer
from rfnserver.arguments import ArgumentError
from rfnserver.ros_frame_adapter import GoalMaker, check_frame, conclude
from semantic_frames.problem import FileRefused
from semantic_frames.source_files import read_text


class BoundServer:
    """An RFNServer for one binding.

    Actions:
        the binding's name (roboframenet_msgs/FilledSemanticFrameAction)
    """

    def __init__(self, binding: Binding) -> None:
        """
        Raises:
            UnknownType: a type that the binding names does not exist
        """
        self._binding = binding
        self._target = TARGET_OF_KIND[binding.kind](binding)
        self._maker = GoalMaker(
            self._target.message_type, mapping=binding.fields, ignored_elements=binding.ignored_elements
        )
        self._server = RFNServer(binding.name, callback=self._on_frame, check=self._check)
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

    def _check(self, frame_name: str) -> Tuple[bool, str]:
        is_known, fault = check_frame(frame_name, self._maker)
        return is_known, fault or self._type_fault()

    def _on_frame(self, frame: FilledSemanticFrame) -> None:
        fault = self._type_fault()
        if fault:
            self._server.set_aborted(None, fault)
            return
        try:
            message = self._maker.make(frame)
        except ArgumentError as error:
            self._server.set_aborted(None, str(error))
            return
        end = self._target.carry_out(message, self._server.is_preempt_requested, self._on_feedback)
        conclude(self._server, end)

    def _on_feedback(self, _feedback: Any) -> None:
        self._server.publish_feedback(FilledSemanticFrameFeedback(is_succeeding=True))


def bound_servers(paths: List[str]) -> List[BoundServer]:
    """Serve the bindings of some files. A wrong file or binding is logged; the others are served."""
    servers: List[BoundServer] = []
    for path in paths:
        try:
            bindings = load_bindings(read_text(path), path)
        except FileRefused as refused:
            for problem in refused.problems:
                rospy.logerr("%s", problem)
            continue
        for binding in bindings:
            try:
                servers.append(BoundServer(binding))
            except UnknownType as error:
                rospy.logerr("%s:%d: %s: %s", path, binding.line, binding.name, error)
    return servers


def main() -> None:
    """Run the node.

    Parameters:
        ~files (list of strings, or one): binding files
    """
    rospy.init_node("frame_bindings")
    files = rospy.get_param("~files", [])
    servers = bound_servers([files] if isinstance(files, str) else [str(path) for path in files])
    if not servers:
        rospy.logfatal("no frame is bound; ~files: %s", files)
        raise SystemExit(1)
    rospy.loginfo("%d frames are bound", len(servers))
    for server in servers:
        server.register()
    rospy.spin()
