"""Lets an action server of any type take filled frames."""

import threading
from typing import Any, Callable, Dict, Iterable, Mapping, Optional

import rospy
from actionlib_msgs.msg import GoalStatus
from roboframenet_msgs.msg import (
    FilledSemanticFrameAction,
    FilledSemanticFrameFeedback,
    FilledSemanticFrameGoal,
    FilledSemanticFrameResult,
)
from roboframenet_msgs.srv import GetEmptyFrame

from rfnserver.arguments import ArgumentError
from rfnserver.goal_binding import (
    BindingError,
    BoundElement,
    Declaration,
    GoalPlan,
    goal_values,
    heeded_by,
    mapped_elements,
    plan_goal,
    refuse_unheeded,
)
from rfnserver.goal_types import Filling
from rfnserver.registration import FrameFit, RequestKind
from rfnserver.ros_goal_forwarding import ForwardedEnd, GoalForwarder
from rfnserver.ros_goal_messages import fields_of, fill, goal_type_of
from rfnserver.ros_places import Places, UnknownPlace
from rfnserver.ros_registration import Registration, public_name
from rfnserver.ros_typed_frame import TypedFrame, typed_frame
from roboframenet_ros.ros_quiet_action_server import QuietSimpleActionServer
from roboframenet_ros.ros_service import ServiceError, call_service
from semantic_frames.server_profile import AS_IN_2012, ServerProfile

#: A server takes frames under its name and this suffix.
FRAME_SUFFIX = "/frame"
CATALOGUE_TIMEOUT_S = 2.0

FrameToGoal = Callable[[TypedFrame], Any]


class GoalMaker:
    """Makes goals of one message type out of filled frames."""

    def __init__(
        self,
        goal_type: Any,
        *,
        mapping: Optional[Mapping[str, Declaration]] = None,
        ignored_elements: Iterable[str] = (),
    ) -> None:
        """
        Args:
            goal_type: class of the message to make
            mapping: see :mod:`rfnserver.goal_binding`
            ignored_elements: elements that need not fill a field
        """
        self._goal_type = goal_type
        self._fields = fields_of(goal_type)
        self._mapping = mapping
        self._ignored = tuple(ignored_elements)
        self._defaults: Dict[str, Mapping[str, str]] = {}
        # Listens only where a place may be asked for: every topic costs threads.
        has_places = any(field.filling is Filling.PLACE for field in self._fields)
        self._places = Places() if has_places else None

    def note_defaults(self, frame_name: str, defaults: Mapping[str, str]) -> None:
        """Keep the defaults of the elements of a frame: they may fill no field, because nobody has said them."""
        self._defaults[frame_name] = dict(defaults)

    def plan(self, elements: Iterable[BoundElement]) -> GoalPlan:
        """Decide how a frame with these elements fills the message.

        Raises:
            BindingError: it does not; the message names the fields
        """
        return plan_goal(self._fields, elements, mapping=self._mapping, ignored_elements=self._ignored)

    def make(self, frame: TypedFrame) -> Any:
        """Return the message for a filled frame.

        Raises:
            ArgumentError: an argument does not fit its field
        """
        arguments = {argument.name: argument for argument in frame.arguments}
        try:
            # An element that was not said may be missing; core elements were checked when the server registered.
            names = dict.fromkeys((*arguments, *mapped_elements(self._mapping), *self._ignored))
            plan = self.plan(BoundElement(name, is_core=False) for name in names)
            refuse_unheeded(plan, arguments, defaults=self._defaults.get(frame.name, {}))
            values = goal_values(plan, arguments, locate=self._places.locate if self._places else _nowhere)
        except (BindingError, UnknownPlace) as error:
            raise ArgumentError(str(error)) from error
        return fill(self._goal_type(), values)


def _nowhere(words: str) -> Any:
    raise ArgumentError(f'no field of the goal is a place: "{words}".')


def check_frame(frame_name: str, maker: GoalMaker) -> FrameFit:
    """Ask the registrar for a frame, and find out whether goals can be made of it."""
    try:
        frame = call_service(
            "get_empty_frame", GetEmptyFrame, timeout_s=CATALOGUE_TIMEOUT_S, frame_name=frame_name
        ).frame
    except ServiceError:
        return FrameFit(is_known=False)
    if not frame.name:
        return FrameFit(is_known=False)
    try:
        plan = maker.plan(BoundElement(element.name, element.is_core) for element in frame.frame_elements)
    except BindingError as error:
        return FrameFit(is_known=True, fault=str(error))
    maker.note_defaults(frame.name, {element.name: element.default for element in frame.frame_elements})
    log = rospy.logwarn if plan.unheeded else rospy.loginfo
    log("frame %s: %s", frame_name, plan)
    own = [element.name for element in frame.frame_elements]
    return FrameFit(is_known=True, heeds=heeded_by(plan, own), unheeded=plan.unheeded)


class FrameAdapter:
    """An action server for frames beside one of another type; turns each frame into a goal of that type.

    Actions:
        NAME/frame (roboframenet_msgs/FilledSemanticFrameAction)
        NAME (the server's own type): client, connected when the first frame arrives
    """

    def __init__(
        self,
        name: str,
        action_type: Any,
        *,
        frame_callback: Optional[FrameToGoal] = None,
        mapping: Optional[Mapping[str, Declaration]] = None,
        ignored_elements: Iterable[str] = (),
        profile: ServerProfile = AS_IN_2012,
    ) -> None:
        """
        Args:
            name: of the server with its own type
            action_type: of that server
            frame_callback: gets the filled frame and returns a goal of the server's type, or None when it has carried
                the frame out itself; without one the goal is made by name and ``mapping``
            mapping: see :mod:`rfnserver.goal_binding`
            ignored_elements: elements that need not fill a field
            profile: what the server states about itself
        """
        name = self._name = public_name(name)
        self._action_type = action_type
        self._lock = threading.Lock()
        self._is_started = False
        self._server: Optional[QuietSimpleActionServer] = None
        self._forwarder: Optional[GoalForwarder] = None
        self._maker: Optional[GoalMaker] = None
        self._callback: FrameToGoal
        if frame_callback is not None:
            self._callback = frame_callback
        else:
            self._maker = GoalMaker(goal_type_of(action_type), mapping=mapping, ignored_elements=ignored_elements)
            self._callback = self._maker.make
        #: Of the frames that have a mapping of their own.
        self._makers: Dict[str, GoalMaker] = {}
        self.registration = Registration(name + FRAME_SUFFIX, check=self._check, profile=profile)

    def start(self) -> None:
        """Take frames from now on, or from the first registration on."""
        with self._lock:
            self._is_started = True
            if self._server is not None:
                self._server.start()

    def map_frame(self, frame_name: str, mapping: Mapping[str, Declaration], ignored_elements: Iterable[str]) -> None:
        """Make the goals of one frame by a mapping of its own."""
        self._makers[frame_name] = GoalMaker(
            goal_type_of(self._action_type), mapping=mapping, ignored_elements=ignored_elements
        )

    def request(self, kind: RequestKind, subject: str) -> bool:
        """See :meth:`Registration.request`; the server for frames exists from the first registration on."""
        with self._lock:
            if kind is RequestKind.REGISTRATION and self._server is None:
                self._server = QuietSimpleActionServer(
                    self._name + FRAME_SUFFIX, FilledSemanticFrameAction, execute_cb=self._execute, auto_start=False
                )
                self._server.action_server.cancel_orphans()
                if self._is_started:
                    self._server.start()
        return self.registration.request(kind, subject)

    def _check(self, frame_name: str) -> FrameFit:
        maker = self._makers.get(frame_name, self._maker)
        return check_frame(frame_name, maker) if maker else FrameFit(is_known=True)

    def _execute(self, _goal: FilledSemanticFrameGoal) -> None:
        try:
            frame = typed_frame(self._server.current_goal.goal)
            maker = self._makers.get(frame.name)
            own_goal = maker.make(frame) if maker else self._callback(frame)
        except ArgumentError as error:
            self._server.set_aborted(None, str(error))
            return
        if own_goal is None:
            end = ForwardedEnd(GoalStatus.SUCCEEDED, "")
        else:
            if self._forwarder is None:
                self._forwarder = GoalForwarder(self._name, self._action_type)
            end = self._forwarder.carry_out(
                own_goal, is_to_end=self._server.is_preempt_requested, on_feedback=self._on_feedback
            )
        conclude(self._server, end)

    def _on_feedback(self, _feedback: Any) -> None:
        self._server.publish_feedback(FilledSemanticFrameFeedback(is_succeeding=True))


def conclude(server: QuietSimpleActionServer, end: ForwardedEnd) -> None:
    """End the goal of a server for frames in the way in which the forwarded goal ended."""
    if not server.is_active():
        return
    if end.status == GoalStatus.SUCCEEDED:
        server.set_succeeded(FilledSemanticFrameResult(success=True), end.text)
    elif end.status == GoalStatus.PREEMPTED:
        server.set_preempted(FilledSemanticFrameResult(success=False), end.text or "preempted")
    else:
        server.set_aborted(FilledSemanticFrameResult(success=False), end.text)
