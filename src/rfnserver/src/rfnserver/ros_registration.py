"""Registers a server with the registrar and the framer, again when they restart."""

import math
import threading
import time
from dataclasses import replace
from typing import Any, Callable, Dict, List, Optional, Sequence, Set, Tuple

import rospy
from roboframenet_msgs.msg import FrameServers, Lexicon
from roboframenet_msgs.srv import AddFrame, AddLexicalUnit, RegisterServer, RegisterWithFrame

from rfnserver.registration import (
    Answers,
    Circumstances,
    FrameFit,
    KnownState,
    LateChecks,
    Pauses,
    RegistrationRequest,
    RequestKind,
    absolute_path,
    file_state,
    missing_requests,
)
from roboframenet_ros.ros_robots import own_robot
from roboframenet_ros.ros_service import ServiceError, call_service, is_offered
from semantic_frames.ros_server_profile import profile_to_message
from semantic_frames.server_profile import AS_IN_2012, Purpose, ServerProfile

#: Deadline of a call for its service to exist, and again for the answer, seconds.
SERVICE_TIMEOUT_S = 5.0
#: A request that was not answered, a registration that was refused, and what was granted and is still missing: all are
#: repeated after this time, seconds, and after twice as long each time that this changed nothing.
RETRY_S = 10.0
_LONGEST_RETRY_S = 80.0

FrameCheck = Callable[[str], FrameFit]


def public_name(name: str) -> str:
    """Return the name under which other nodes find a server: a private one ("~gripper") names its node, and that of a
    robot of a fleet its robot."""
    return str(rospy.resolve_name(name)) if name.startswith("~") or own_robot() else name


class Registration:
    """The registration requests of one server, and a thread that repeats them.

    Subscribes:
        frame_servers, lexicon (latched): what registrar and framer know, and when they restarted
    Services:
        add_frame, add_lexical_unit, register_with_frame, register_server: called
    """

    def __init__(
        self, server_name: str, *, check: Optional[FrameCheck] = None, profile: ServerProfile = AS_IN_2012
    ) -> None:
        """
        Args:
            server_name: name of the action server
            check: returns how a frame fits the server
            profile: what the server states about itself
        """
        self._server_name = public_name(server_name)
        self._check = check
        self._robot = own_robot()
        self._profile = self._of_robot(profile)
        #: Profiles of frames that have one of their own; what was registered for each frame.
        self._profiles: Dict[str, ServerProfile] = {}
        self._registered: Dict[str, ServerProfile] = {}
        pauses = Pauses(RETRY_S, _LONGEST_RETRY_S)
        self._late_checks = LateChecks(pauses)
        self._condition = threading.Condition()
        self._requests: List[RegistrationRequest] = []
        self._registrar: Optional[KnownState] = None
        self._framer: Optional[KnownState] = None
        self._answers = Answers(pauses)
        #: Requests that a thread is making.
        self._asking: Set[RegistrationRequest] = set()
        #: When the registrar first found a registration odd, by frame; and those that were told.
        self._remarks: Dict[str, float] = {}
        self._told: Set[str] = set()
        self._reported: Dict[RegistrationRequest, str] = {}
        self._is_stale = False
        self._is_closed = False
        self._thread: Optional[threading.Thread] = None
        self._subscribers: Tuple[rospy.Subscriber, ...] = ()
        #: Why the last call failed; empty after one that succeeded.
        self.last_error = ""

    def request(self, kind: RequestKind, subject: str) -> bool:
        """Make a request now, and again whenever it is missing.

        Args:
            kind: which service
            subject: path of a file, made absolute here, or name of a frame
        Returns:
            whether it was granted at once; if not, :attr:`last_error` says why, and it is repeated later
        """
        request = RegistrationRequest(kind, subject if kind is RequestKind.REGISTRATION else absolute_path(subject))
        self._watch()
        with self._condition:
            if request not in self._requests:
                self._requests.append(request)
        return self._ask(request)

    def state(self, frame_name: str, profile: ServerProfile) -> None:
        """Register for one frame with another profile."""
        self._profiles[frame_name] = self._of_robot(profile)

    def stated(self, frame_name: str) -> ServerProfile:
        """Return what the server states for a frame."""
        return self._profiles.get(frame_name, self._profile)

    def _of_robot(self, profile: ServerProfile) -> ServerProfile:
        """Return a profile with the robot of this namespace, unless it names one."""
        return replace(profile, robot=profile.robot or self._robot)

    def close(self) -> None:
        """Repeat requests no more; return when the thread has ended."""
        with self._condition:
            self._is_closed = True
            self._condition.notify_all()
            thread = self._thread
        self._unsubscribe()
        if thread is not None and thread is not threading.current_thread():
            thread.join(2.0 * SERVICE_TIMEOUT_S)

    def _unsubscribe(self) -> None:
        with self._condition:
            subscribers, self._subscribers = self._subscribers, ()
        for subscriber in subscribers:
            subscriber.unregister()

    def _watch(self) -> None:
        """Subscribe and start the thread, with the first request."""
        with self._condition:
            if self._thread is not None or self._is_closed:
                return
            # Started at once: a shutdown may close this object at any time, and waits for the thread.
            self._thread = threading.Thread(target=self._run, name=f"registration of {self._server_name}", daemon=True)
            self._thread.start()
        subscribers = (
            rospy.Subscriber("frame_servers", FrameServers, self._on_servers, queue_size=1),
            rospy.Subscriber("lexicon", Lexicon, self._on_lexicon, queue_size=1),
        )
        with self._condition:
            self._subscribers = subscribers
            is_closed = self._is_closed
        if is_closed:
            self._unsubscribe()
        rospy.on_shutdown(self.close)

    def _on_servers(self, message: FrameServers) -> None:
        known = KnownState(
            id=message.registrar_id,
            files=frozenset(message.paths),
            registrations=frozenset(
                callback.frame_name for callback in message.callbacks if callback.callback_topic == self._server_name
            ),
        )
        with self._condition:
            self._registrar = known
            self._hear_known()

    def _on_lexicon(self, message: Lexicon) -> None:
        with self._condition:
            self._framer = KnownState(id=message.framer_id, files=frozenset(file.path for file in message.files))
            self._hear_known()

    def _hear_known(self) -> None:
        """Take up what the other side knows. Called with the lock."""
        unconfirmed = self._answers.unconfirmed()
        if unconfirmed:
            for request in unconfirmed.difference(self._missing()):
                self._answers.confirm(request, self._circumstances(request).node_id)
        self._is_stale = True
        self._condition.notify_all()

    def _missing(self) -> Tuple[RegistrationRequest, ...]:
        return missing_requests(self._requests, registrar=self._registrar, framer=self._framer)

    def _due_in_s(self, request: RegistrationRequest) -> float:
        """Return after how many seconds a missing request is due. Called with the lock."""
        if request in self._asking:
            return RETRY_S
        return self._answers.due_in_s(request, self._circumstances(request), now_s=time.monotonic())

    def _run(self) -> None:
        rest_s: Optional[float] = RETRY_S
        while not rospy.is_shutdown():
            with self._condition:
                self._condition.wait_for(lambda: self._is_stale or self._is_closed, timeout=rest_s)
                if self._is_closed:
                    return
                self._is_stale = False
                missing = self._missing()
                unchecked = [frame_name for frame_name, due_s in self._late_checks_due().items() if due_s <= 0.0]
            for request in missing:
                with self._condition:
                    # Looked up for each: another thread may have made the request meanwhile.
                    is_due = self._due_in_s(request) <= 0.0
                if not is_due:
                    continue
                again = " again" if self._reported.get(request) == "" else ""
                if self._ask(request):
                    rospy.loginfo("%s: %s %s%s", self._server_name, request.kind.value, request.subject, again)
            self._tell_remarks()
            for frame_name in unchecked:
                self._check_late(frame_name)
            with self._condition:
                rest_s = self._rest_s(missing)

    def _rest_s(self, missing: Sequence[RegistrationRequest]) -> Optional[float]:
        """Return how long there is nothing to do, in seconds; None for until something is heard. With the lock."""
        pauses = [self._due_in_s(request) for request in missing]
        pauses += self._late_checks_due().values()
        pauses += [max(0.0, since_s + RETRY_S - time.monotonic()) for since_s in self._remarks.values()]
        if any(request.kind is not RequestKind.REGISTRATION for request in missing):
            # Nobody tells when a file changes.
            pauses.append(RETRY_S)
        rest_s = min(pauses, default=math.inf)
        return None if math.isinf(rest_s) else rest_s

    def _late_checks_due(self) -> Dict[str, float]:
        """Return after how many seconds each frame is checked that had no file. Called with the lock."""
        return self._late_checks.due_in_s(self._known_circumstances(), now_s=time.monotonic())

    def _known_circumstances(self) -> Circumstances:
        """Return what the answer to a registration depends on. Called with the lock."""
        registrar = self._registrar or KnownState("")
        return Circumstances(registrar.id, None, registrar.files)

    def _circumstances(self, request: RegistrationRequest) -> Circumstances:
        """Return what the answer to a request depends on. Called with the lock."""
        if request.kind is RequestKind.REGISTRATION:
            return self._known_circumstances()
        file = file_state(request.subject)
        if request.kind is RequestKind.LEXICAL_UNIT_FILE:
            return Circumstances(self._framer.id if self._framer else "", file)
        return replace(self._known_circumstances(), file=file)

    def _ask(self, request: RegistrationRequest) -> bool:
        with self._condition:
            circumstances = self._circumstances(request)
            self._asking.add(request)
        is_answered = True
        try:
            error = self._call(request)
        except ServiceError as failure:
            error = str(failure)
            is_answered = False
        with self._condition:
            self._asking.discard(request)
            if error:
                # Whether a registration is granted may also depend on a frame that is added later.
                is_final = is_answered and request.kind is not RequestKind.REGISTRATION
                self._answers.refuse(request, circumstances, is_final=is_final, now_s=time.monotonic())
            else:
                self._answers.grant(request, circumstances, now_s=time.monotonic())
            # The thread finds out when it is to be made again.
            self._is_stale = True
            self._condition.notify_all()
        self._report(request, error)
        return not error

    def _report(self, request: RegistrationRequest, error: str) -> None:
        """Keep an error, and log it unless the same request failed in the same way before: it is repeated for ever."""
        self.last_error = error
        if error and self._reported.get(request) != error:
            rospy.logerr("%s: %s %s: %s", self._server_name, request.kind.value, request.subject, error)
        self._reported[request] = error

    def _call(self, request: RegistrationRequest) -> str:
        """Make the call; return why it was refused, empty when it was granted."""
        if request.kind is RequestKind.REGISTRATION:
            fit = self._fit(request.subject)
            if fit.fault:
                return fit.fault
            is_granted, reasons = self._register(request.subject, self._profile_for(request.subject, fit))
            with self._condition:
                self._remark(request.subject, "; ".join(reasons) if is_granted else "")
            return "" if is_granted else "; ".join(reasons) or "refused"
        if file_state(request.subject) is None:
            return "no such file"
        service: Any = AddFrame if request.kind is RequestKind.FRAME_FILE else AddLexicalUnit
        response = call_service(
            request.kind.value, service, timeout_s=SERVICE_TIMEOUT_S, absolute_file_path=request.subject
        )
        return "" if response.success else "the file was refused; the topic file_problems says why"

    def _remark(self, frame_name: str, remark: str) -> None:
        """Keep what the registrar finds odd. Files may be added after a registration, so it is told only later."""
        if not remark:
            self._remarks.pop(frame_name, None)
        elif frame_name not in self._told:
            self._remarks.setdefault(frame_name, time.monotonic())

    def _tell_remarks(self) -> None:
        """Ask again about each registration that was odd some time ago, and log what is still odd."""
        with self._condition:
            old = [name for name, since_s in self._remarks.items() if time.monotonic() - since_s >= RETRY_S]
            self._told.update(old)
        for frame_name in old:
            try:
                _, reasons = self._register(frame_name, self._profile_for(frame_name, self._fit(frame_name)))
            except ServiceError:
                with self._condition:
                    self._remarks[frame_name] = time.monotonic()
                continue
            with self._condition:
                self._remarks.pop(frame_name, None)
            if reasons:
                rospy.logwarn("%s: registered, but %s", self._server_name, "; ".join(reasons))

    def _register(self, frame_name: str, profile: ServerProfile) -> Tuple[bool, Sequence[str]]:
        """Register for a frame, by the call of 2012 if the server states nothing.

        Returns:
            whether that was granted, and the reasons or remarks of the registrar
        Raises:
            ServiceError: the registrar is not running or does not answer
        """
        if profile != AS_IN_2012:
            if is_offered("register_server", beside="register_with_frame", timeout_s=SERVICE_TIMEOUT_S):
                response = call_service(
                    "register_server",
                    RegisterServer,
                    timeout_s=SERVICE_TIMEOUT_S,
                    frame_name=frame_name,
                    server=self._server_name,
                    profile=profile_to_message(profile),
                )
                self._registered[frame_name] = profile
                return response.success, response.error
            if profile.purpose is Purpose.WATCHES:
                return False, ["the registrar knows only servers that act: it has no service register_server"]
            rospy.logwarn(
                "%s: registered for %s as in 2012, without what the server states: the registrar has no service "
                "register_server",
                self._server_name,
                frame_name,
            )
        response = call_service(
            "register_with_frame",
            RegisterWithFrame,
            timeout_s=SERVICE_TIMEOUT_S,
            frame_name=frame_name,
            callback_topic=self._server_name,
        )
        self._registered[frame_name] = profile
        return response.success, response.error

    def _profile_for(self, frame_name: str, fit: FrameFit) -> ServerProfile:
        return fit.added_to(self.stated(frame_name))

    def _check_late(self, frame_name: str) -> None:
        """Check a frame whose file was added after the registration, and register again if it says more now."""
        fit = self._fit(frame_name)
        request = RegistrationRequest(RequestKind.REGISTRATION, frame_name)
        if fit.is_known and not fit.fault and self._profile_for(frame_name, fit) != self._registered.get(frame_name):
            self._ask(request)
        else:
            self._report(request, fit.fault)

    def _fit(self, frame_name: str) -> FrameFit:
        """Return how a frame fits this server; an unknown frame is checked when its file is added."""
        if self._check is None:
            return FrameFit(is_known=True)
        with self._condition:
            circumstances = self._known_circumstances()
        fit = self._check(frame_name)
        with self._condition:
            self._late_checks.find(frame_name, fit.is_known, circumstances, now_s=time.monotonic())
        return fit
