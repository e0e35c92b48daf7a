"""``RFNServer``: an action server that registers for semantic frames."""

from typing import Any, Callable, Iterable, Mapping, Optional, Union

from roboframenet_msgs.msg import FilledSemanticFrameAction, FilledSemanticFrameGoal, FilledSemanticFrameResult

from rfnserver.goal_binding import Declaration
from rfnserver.registration import RequestKind
from rfnserver.results import ResultNames
from rfnserver.ros_frame_adapter import FrameAdapter, FrameToGoal, name_and_text
from rfnserver.ros_goal_messages import is_action_type
from rfnserver.ros_registration import FrameCheck, Registration
from rfnserver.ros_typed_frame import TypedFrame, typed_frame
from roboframenet_ros.ros_quiet_action_server import QuietActionServer, QuietSimpleActionServer
from semantic_frames.server_statement import stated_profile

FrameCallback = Callable[[TypedFrame], Any]


class _Registering:
    """Registers a server for frames. Files and registrations may be added before and after ``start()``; they are
    repeated when the registrar or the framer restarts."""

    _registration: Registration
    #: Only for servers with an action type of their own.
    _adapter: Optional[FrameAdapter] = None

    @property
    def last_error(self) -> str:
        """Why the last call to the registrar or the framer failed; empty when it succeeded."""
        return self._registration.last_error

    def register_with_frame(
        self,
        frame_name: str,
        *,
        goal_mapping: Optional[Mapping[str, Declaration]] = None,
        ignored_elements: Iterable[str] = (),
        **statement: Any,
    ) -> bool:
        """Carry out a frame from now on, or watch it.

        Args:
            frame_name: of a frame, also one whose file is added later
            goal_mapping: for a server with an action type: which element of this frame fills which field; None for
                the mapping (or the function) that the server was made with
            ignored_elements: for a server with an action type: elements of this frame that need not fill a field, or
                that the function need not read
            **statement: what the server states for this frame, instead of what it was made with
        Returns:
            True when the registrar accepted; False when it refused or is not running, or when no goal can be made of
            that frame: this is logged, and tried again later
        Raises:
            TypeError: a mapping, or elements to ignore, for a server without an action type
            ProfileError: the statement is wrong
        """
        if statement:
            self._registration.state(frame_name, stated_profile(statement))
        ignored = tuple(ignored_elements)
        if goal_mapping is not None or ignored:
            if self._adapter is None:
                raise TypeError(
                    f"frame {frame_name}: goal_mapping and ignored_elements need a server with the class of an action; "
                    "a server of frames names what it ignores in 'unheeded'"
                )
            self._adapter.map_frame(frame_name, goal_mapping, ignored)
        return self._request(RequestKind.REGISTRATION, frame_name)

    def add_semantic_frame(self, path: str) -> bool:
        """Add a frame file.

        Args:
            path: of the file; the registrar reads it, so both share a file system
        Returns:
            True when it was accepted; False when not: this is logged, and tried again when a registrar starts
        """
        return self._request(RequestKind.FRAME_FILE, path)

    def add_lexical_unit(self, path: str) -> bool:
        """Add a lexical unit file; see :meth:`add_semantic_frame`."""
        return self._request(RequestKind.LEXICAL_UNIT_FILE, path)

    def _request(self, kind: RequestKind, subject: str) -> bool:
        if self._adapter is not None:
            return self._adapter.request(kind, subject)
        return self._registration.request(kind, subject)


class RFNServer(_Registering, QuietSimpleActionServer):
    """A ``SimpleActionServer`` that also carries out semantic frames.

    As in 2012, for frames alone::

        server = RFNServer("waving", wave)          # wave(filled_semantic_frame)
        server.register_with_frame("waving")
        server.start()

    The callback gets the filled frame, and with it the meaning of each argument: ``frame["goal"].relation``,
    ``frame["angle"].si`` (:class:`rfnserver.TypedFrame`). If it returns without having ended the goal, the goal
    succeeds, or is preempted when a preemption was requested; if it raises, the goal is aborted with the reason.
    ``set_aborted(text=...)`` tells the person why.

    Or in place of ``SimpleActionServer``, with the same arguments::

        server = RFNServer("fibonacci", FibonacciAction, execute_cb=execute, auto_start=False)
        server.register_with_frame("computing_sequence")
        server.start()

    Such a server keeps its clients, and takes frames under the name "fibonacci/frame": each becomes a goal of its own
    type, see :mod:`rfnserver.goal_binding`.
    """

    def __init__(
        self,
        name: str,
        ActionSpec: Any = None,  # noqa: N803 (the name is SimpleActionServer's)
        execute_cb: Optional[Callable[[Any], None]] = None,
        auto_start: bool = True,
        *,
        callback: Optional[FrameCallback] = None,
        check: Optional[FrameCheck] = None,
        frame_callback: Optional[FrameToGoal] = None,
        goal_mapping: Optional[Mapping[str, Declaration]] = None,
        ignored_elements: Iterable[str] = (),
        success_field: Optional[str] = None,
        text_field: Optional[str] = None,
        error_field: Optional[Union[str, Mapping[str, Any]]] = None,
        **statement: Any,
    ) -> None:
        """
        Args:
            name: of the action server
            ActionSpec: class of an action; or, in the form of 2012, the callback for filled frames
            execute_cb: called with each goal, in a thread of its own; without it, ``register_goal_callback`` is used
            auto_start: start at once, as SimpleActionServer does by default; a server for frames alone never does
            callback: the form of 2012 by keyword
            check: for frames alone: returns how a frame fits the server
            frame_callback: with an action type: gets the filled frame and returns a goal, or None when it has carried
                the frame out itself. The frame is refused when something was said that it did not read
            goal_mapping: with an action type: which element fills which field, where their names differ
            ignored_elements: with an action type: elements that need not fill a field, or that ``frame_callback``
                need not read
            success_field: with an action type: the bool of the result that says whether a frame was done; None: by
                convention, see :mod:`rfnserver.results`
            text_field: the string of the result that says why not, or answers the person
            error_field: the error code of the result, ``{"name": "error_code", "ok": 0}``
            **statement: what the server states about itself: ``heeds={"Manner": ["slow", "quick"]}``,
                ``occupies=["base"]``, ``purpose="watches"``; see :mod:`semantic_frames.server_statement`
        Raises:
            TypeError: neither an action type nor a callback
            ProfileError: the statement is wrong
            ResultError: the result has no such fields
        """
        results = ResultNames(success_field, text_field, error_field)
        profile = stated_profile(statement)
        if is_action_type(ActionSpec):
            self._adapter = FrameAdapter(
                name,
                ActionSpec,
                frame_callback=frame_callback,
                mapping=goal_mapping,
                ignored_elements=ignored_elements,
                profile=profile,
                result_names=results,
            )
            self._registration = self._adapter.registration
            super().__init__(name, ActionSpec, execute_cb=execute_cb, auto_start=auto_start)
            return
        self._frame_callback = callback or ActionSpec
        if not callable(self._frame_callback):
            raise TypeError(
                f"RFNServer {name}: expected the class of an action or a callback for filled frames, found "
                f"{self._frame_callback!r}"
            )
        of_actions = (execute_cb, frame_callback, goal_mapping, tuple(ignored_elements) or None)
        if any(one is not None for one in of_actions) or results != ResultNames():
            raise TypeError(
                f"RFNServer {name}: execute_cb, frame_callback, goal_mapping, ignored_elements and the fields of a "
                "result need the class of an action"
            )
        self._registration = Registration(name, check=check, profile=profile)
        super().__init__(name, FilledSemanticFrameAction, execute_cb=self._execute_frame, auto_start=False)
        self.action_server.cancel_orphans()

    def start(self) -> None:
        """Take goals from now on."""
        super().start()
        if self._adapter is not None:
            self._adapter.start()

    def text_of_exception(self, error: Exception) -> str:
        """Return what clients are told: a person reads what frames end with, and old clients what they know."""
        return super().text_of_exception(error) if self._adapter is not None else name_and_text(error)

    def _execute_frame(self, _goal: FilledSemanticFrameGoal) -> None:
        self._frame_callback(typed_frame(self.current_goal.goal))
        if not self.is_active():
            return
        if self.is_preempt_requested():
            self.set_preempted(FilledSemanticFrameResult(success=False))
        else:
            self.set_succeeded(FilledSemanticFrameResult(success=True))


class RFNActionServer(_Registering, QuietActionServer):
    """An ``actionlib.ActionServer``, with many goals at a time, that takes frames too: see :class:`RFNServer`."""

    def __init__(
        self,
        ns: str,  # the names of the arguments are ActionServer's
        ActionSpec: Any,  # noqa: N803
        goal_cb: Callable[[Any], None],
        cancel_cb: Optional[Callable[[Any], None]] = None,
        auto_start: bool = True,
        *,
        frame_callback: Optional[FrameToGoal] = None,
        goal_mapping: Optional[Mapping[str, Declaration]] = None,
        ignored_elements: Iterable[str] = (),
        success_field: Optional[str] = None,
        text_field: Optional[str] = None,
        error_field: Optional[Union[str, Mapping[str, Any]]] = None,
        **statement: Any,
    ) -> None:
        """
        Args:
            ns: name of the action server
            ActionSpec: class of an action
            goal_cb: called with the handle of each goal
            cancel_cb: called with the handle of each goal that is cancelled
            auto_start: start at once
            frame_callback: see :class:`RFNServer`
            goal_mapping: see :class:`RFNServer`
            ignored_elements: see :class:`RFNServer`
            success_field: see :class:`RFNServer`
            text_field: see :class:`RFNServer`
            error_field: see :class:`RFNServer`
            **statement: see :class:`RFNServer`
        """
        self._adapter = FrameAdapter(
            ns,
            ActionSpec,
            frame_callback=frame_callback,
            mapping=goal_mapping,
            ignored_elements=ignored_elements,
            profile=stated_profile(statement),
            result_names=ResultNames(success_field, text_field, error_field),
        )
        self._registration = self._adapter.registration
        optional = {} if cancel_cb is None else {"cancel_cb": cancel_cb}
        super().__init__(ns, ActionSpec, goal_cb, auto_start=auto_start, **optional)

    def start(self) -> None:
        """Take goals from now on."""
        super().start()
        self._adapter.start()
