"""Lets an action server of any type take filled frames."""

import copy
import threading
from typing import Any, Callable, Dict, Iterable, Mapping, Optional, Tuple

import rospy
from actionlib_msgs.msg import GoalStatus
from roboframenet_msgs.msg import (
    EmptySemanticFrame,
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
    mapped_elements,
    plan_goal,
)
from rfnserver.goal_types import Filling
from rfnserver.heeding import heeded_by, listed_elements, refusal_of, spoken, unheeded_argument
from rfnserver.registration import FrameFit, RequestKind
from rfnserver.results import BY_CONVENTION, ResultNames, plan_result
from rfnserver.ros_goal_forwarding import ForwardedEnd, GoalForwarder
from rfnserver.ros_goal_messages import fields_in_lists, fields_of, fill, goal_type_of, result_type_of, with_constants
from rfnserver.ros_places import Places, UnknownPlace
from rfnserver.ros_registration import Registration, public_name
from rfnserver.ros_typed_frame import NotedFrame, TypedFrame, typed_frame
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
        constants: Optional[Mapping[str, Any]] = None,
    ) -> None:
        """
        Args:
            goal_type: class of the message to make
            mapping: see :mod:`rfnserver.goal_binding`
            ignored_elements: elements that need not fill a field
            constants: what each message holds before an element fills a field, also in its lists
        Raises:
            ValueError: the message cannot hold the constants
        """
        self._blank = with_constants(goal_type, constants or {})
        self._fields = fields_of(goal_type) + fields_in_lists(self._blank)
        self._mapping = mapping
        self._ignored = tuple(ignored_elements)
        self._defaults: Dict[str, Mapping[str, str]] = {}
        # Listens only where a place may be asked for: every topic costs threads.
        has_places = any(field.filling is Filling.PLACE for field in self._fields)
        self._places = Places() if has_places else None

    def note_defaults(self, frame_name: str, defaults: Mapping[str, str]) -> None:
        """Keep the defaults of the elements of a frame: they may fill no field, because nobody has said them."""
        self._defaults[frame_name] = dict(defaults)

    def plan(self, elements: Iterable[BoundElement], profile: ServerProfile) -> GoalPlan:
        """Decide how a frame with these elements fills the message, for a server that states a profile.

        Raises:
            BindingError: it does not; the message names the fields
        """
        known = list(elements)
        listed = [element.name for element in known if element.name in listed_elements(profile)]
        return plan_goal(self._fields, known, mapping=self._mapping, ignored_elements=(*self._ignored, *listed))

    def make(self, frame: TypedFrame, profile: ServerProfile) -> Any:
        """Return the message for a filled frame.

        Args:
            frame: the frame
            profile: what the server states for it
        Raises:
            ArgumentError: an argument does not fit its field
        """
        arguments = {argument.name: argument for argument in frame.arguments}
        try:
            # An element that was not said may be missing; core elements were checked when the server registered.
            names = dict.fromkeys((*arguments, *mapped_elements(self._mapping), *self._ignored))
            plan = self.plan((BoundElement(name, is_core=False) for name in names), profile)
            heeded = {source.element for source in plan.sources}.union(
                (source.unit_element for source in plan.sources), self._ignored
            )
            defaults = self._defaults.get(frame.name, {})
            lost = unheeded_argument(frame.arguments, heeded, profile=profile, defaults=defaults)
            if lost is not None:
                raise ArgumentError(refusal_of(lost))
            values = goal_values(plan, arguments, locate=self._places.locate if self._places else _nowhere)
        except (BindingError, UnknownPlace) as error:
            raise ArgumentError(str(error)) from error
        return fill(copy.deepcopy(self._blank), values)


def _nowhere(words: str) -> Any:
    raise ArgumentError(f'no field of the goal is a place: "{words}".')


def empty_frame(frame_name: str) -> Optional[EmptySemanticFrame]:
    """Ask the registrar for a frame; None while it does not know it, or is not running."""
    try:
        frame = call_service(
            "get_empty_frame", GetEmptyFrame, timeout_s=CATALOGUE_TIMEOUT_S, frame_name=frame_name
        ).frame
    except ServiceError:
        return None
    return frame if frame.name else None


def check_frame(frame_name: str, maker: GoalMaker, profile: ServerProfile) -> FrameFit:
    """Ask the registrar for a frame, and find out whether goals can be made of it.

    Args:
        frame_name: of the frame
        maker: of the goals
        profile: what the server states for the frame
    """
    frame = empty_frame(frame_name)
    if frame is None:
        return FrameFit(is_known=False)
    try:
        plan = maker.plan((BoundElement(element.name, element.is_core) for element in frame.frame_elements), profile)
    except BindingError as error:
        return FrameFit(is_known=True, fault=str(error))
    maker.note_defaults(frame.name, {element.name: element.default for element in frame.frame_elements})
    log = rospy.logwarn if plan.unheeded else rospy.loginfo
    log("frame %s: %s", frame_name, plan)
    own = [element.name for element in frame.frame_elements]
    return FrameFit(is_known=True, heeds=heeded_by(plan, own), unheeded=plan.unheeded)


class CallbackMaker:
    """Lets a callback make the goals, and refuses frames of which it has not read everything that was said."""

    def __init__(self, callback: FrameToGoal) -> None:
        """
        Args:
            callback: gets the filled frame
        """
        self._callback = callback
        self._ignored: Dict[str, Tuple[str, ...]] = {}
        self._defaults: Dict[str, Mapping[str, str]] = {}

    def ignore(self, frame_name: str, elements: Iterable[str]) -> None:
        """Set the elements of a frame that the callback need not read; an empty name is for all other frames."""
        self._ignored[frame_name] = tuple(elements)

    def _ignored_of(self, frame_name: str) -> Tuple[str, ...]:
        return self._ignored.get(frame_name, self._ignored.get("", ()))

    def check(self, frame_name: str) -> FrameFit:
        """Ask the registrar for the defaults of a frame: nobody has said those."""
        frame = empty_frame(frame_name)
        if frame is None:
            return FrameFit(is_known=False)
        known = [element.name for element in frame.frame_elements]
        unknown = [name for name in self._ignored_of(frame_name) if name not in known]
        if unknown:
            return FrameFit(
                is_known=True, fault=f"no element '{unknown[0]}' to ignore, only {', '.join(known) or 'none'}"
            )
        self._defaults[frame_name] = {element.name: element.default for element in frame.frame_elements}
        return FrameFit(is_known=True)

    def make(self, frame: TypedFrame, profile: ServerProfile) -> Tuple[Any, str]:
        """Call the callback.

        Args:
            frame: the frame
            profile: what the server states for it
        Returns:
            its goal, or None when it has carried the frame out itself; and then, what it did not take into account
        Raises:
            ArgumentError: it has made a goal and not read everything that was said
        """
        noted = NotedFrame(frame)
        goal = self._callback(noted)
        heeded = noted.read.union(self._ignored_of(frame.name))
        defaults = self._defaults.get(frame.name, {})
        lost = unheeded_argument(frame.arguments, heeded, profile=profile, defaults=defaults)
        if lost is None:
            return goal, ""
        if goal is not None:
            raise ArgumentError(refusal_of(lost))
        return None, f"I did not take {spoken(lost)} into account."


class _FrameServer(QuietSimpleActionServer):
    def text_of_exception(self, error: Exception) -> str:
        return name_and_text(error)


def name_and_text(error: Exception) -> str:
    """Return an exception as a person is told it: "KeyError: 'speed'"."""
    return f"{type(error).__name__}: {error}"


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
        result_names: ResultNames = BY_CONVENTION,
    ) -> None:
        """
        Args:
            name: of the server with its own type
            action_type: of that server
            frame_callback: gets the filled frame and returns a goal of the server's type, or None when it has carried
                the frame out itself; without one the goal is made by name and ``mapping``
            mapping: see :mod:`rfnserver.goal_binding`
            ignored_elements: elements that need not fill a field, or that ``frame_callback`` need not read
            profile: what the server states about itself
            result_names: fields of the server's results that say whether a goal was done
        Raises:
            ResultError: its results have no such fields
        """
        name = self._name = public_name(name)
        self._action_type = action_type
        self._lock = threading.Lock()
        self._is_started = False
        self._server: Optional[QuietSimpleActionServer] = None
        self._forwarder: Optional[GoalForwarder] = None
        self._mapping = mapping
        self._result_names = result_names
        plan_result(fields_of(result_type_of(action_type)), result_names)
        self._maker: Optional[GoalMaker] = None
        self._callback: Optional[CallbackMaker] = None
        if frame_callback is not None:
            self._callback = CallbackMaker(frame_callback)
            self._callback.ignore("", ignored_elements)
        else:
            self._maker = GoalMaker(goal_type_of(action_type), mapping=mapping, ignored_elements=ignored_elements)
        #: Of the frames that have a mapping of their own.
        self._makers: Dict[str, GoalMaker] = {}
        self.registration = Registration(name + FRAME_SUFFIX, check=self._check, profile=profile)

    def start(self) -> None:
        """Take frames from now on, or from the first registration on."""
        with self._lock:
            self._is_started = True
            if self._server is not None:
                self._server.start()

    def map_frame(
        self, frame_name: str, mapping: Optional[Mapping[str, Declaration]], ignored_elements: Iterable[str]
    ) -> None:
        """Make the goals of one frame in a way of its own.

        Args:
            frame_name: of the frame
            mapping: None for what the server was made with
            ignored_elements: elements that need not fill a field, or be read
        """
        if mapping is None and self._callback is not None:
            self._callback.ignore(frame_name, ignored_elements)
            return
        self._makers[frame_name] = GoalMaker(
            goal_type_of(self._action_type),
            mapping=self._mapping if mapping is None else mapping,
            ignored_elements=ignored_elements,
        )

    def request(self, kind: RequestKind, subject: str) -> bool:
        """See :meth:`Registration.request`; the server for frames exists from the first registration on."""
        with self._lock:
            if kind is RequestKind.REGISTRATION and self._server is None:
                self._server = _FrameServer(
                    self._name + FRAME_SUFFIX, FilledSemanticFrameAction, execute_cb=self._execute, auto_start=False
                )
                self._server.action_server.cancel_orphans()
                if self._is_started:
                    self._server.start()
        return self.registration.request(kind, subject)

    def _check(self, frame_name: str) -> FrameFit:
        maker = self._makers.get(frame_name, self._maker)
        if maker is not None:
            return check_frame(frame_name, maker, self.registration.stated(frame_name))
        return self._callback.check(frame_name)

    def _goal_for(self, frame: TypedFrame) -> Tuple[Any, str]:
        """Return the goal for a frame; None, and what the person is told, when the frame is carried out.

        Raises:
            ArgumentError: no goal can be made, or it would not say everything
        """
        profile = self.registration.stated(frame.name)
        maker = self._makers.get(frame.name, self._maker)
        return self._callback.make(frame, profile) if maker is None else (maker.make(frame, profile), "")

    def _execute(self, _goal: FilledSemanticFrameGoal) -> None:
        try:
            own_goal, remark = self._goal_for(typed_frame(self._server.current_goal.goal))
        except ArgumentError as error:
            # Nothing has begun: the server has not got its goal.
            self._server.set_aborted(None, str(error))
            return
        if own_goal is None:
            end = ForwardedEnd(GoalStatus.SUCCEEDED, remark)
        else:
            if self._forwarder is None:
                self._forwarder = GoalForwarder(self._name, self._action_type, result_names=self._result_names)
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
        server.set_preempted(FilledSemanticFrameResult(success=False), end.text)
    else:
        server.set_aborted(FilledSemanticFrameResult(success=False), end.text)
