"""Registration requests of a server: what it asks the registrar and the framer for, and what they do not know yet."""

import math
import os
import sys
from dataclasses import dataclass, replace
from enum import Enum
from typing import Dict, FrozenSet, Iterable, Optional, Tuple

from semantic_frames.server_profile import HeededElement, ServerProfile

#: Time of change and size of a file; None for one that does not exist.
FileState = Optional[Tuple[int, int]]


class RequestKind(Enum):
    """The service that is called."""

    FRAME_FILE = "add_frame"
    LEXICAL_UNIT_FILE = "add_lexical_unit"
    REGISTRATION = "register_with_frame"


@dataclass(frozen=True)
class RegistrationRequest:
    """A service call, repeated whenever the node that was called no longer knows of it.

    Attributes:
        kind: which service
        subject: absolute path of a file, or name of a frame
    """

    kind: RequestKind
    subject: str


@dataclass(frozen=True)
class FrameFit:
    """How a frame fits a server.

    Attributes:
        is_known: whether the registrar knows the frame
        fault: why the server cannot carry it out; empty when it can
        heeds: what the server heeds beside what the frame declares
        unheeded: elements of the frame that it does not heed
    """

    is_known: bool
    fault: str = ""
    heeds: Tuple[HeededElement, ...] = ()
    unheeded: Tuple[str, ...] = ()

    def added_to(self, profile: ServerProfile) -> ServerProfile:
        """Return a profile with what follows from the frame; what the server states itself counts first."""
        stated = {heeded.name for heeded in profile.heeds}
        return replace(
            profile,
            heeds=profile.heeds + tuple(heeded for heeded in self.heeds if heeded.name not in stated),
            unheeded=profile.unheeded
            + tuple(name for name in self.unheeded if name not in stated and name not in profile.unheeded),
        )


@dataclass(frozen=True)
class KnownState:
    """What the registrar or the framer publishes as known to it.

    Attributes:
        id: new for each start of the node
        files: paths
        registrations: frames for which this server is registered
    """

    id: str
    files: FrozenSet[str] = frozenset()
    registrations: FrozenSet[str] = frozenset()


def missing_requests(
    requests: Iterable[RegistrationRequest], *, registrar: Optional[KnownState], framer: Optional[KnownState]
) -> Tuple[RegistrationRequest, ...]:
    """Return the requests that the node which serves them does not know.

    Args:
        requests: in the order in which they were made; files come before the registrations that need them
        registrar: state of the registrar; None while it is not running, and nothing can be requested from it
        framer: state of the framer; None while it is not running
    """
    return tuple(request for request in requests if _is_missing(request, registrar, framer))


def _is_missing(request: RegistrationRequest, registrar: Optional[KnownState], framer: Optional[KnownState]) -> bool:
    if request.kind is RequestKind.LEXICAL_UNIT_FILE:
        return framer is not None and request.subject not in framer.files
    if registrar is None:
        return False
    known = registrar.files if request.kind is RequestKind.FRAME_FILE else registrar.registrations
    return request.subject not in known


@dataclass(frozen=True)
class Circumstances:
    """What the answer to a request depends on: it is not asked again while this stays the same.

    Attributes:
        node_id: of the registrar or the framer that is asked; empty while it is not running
        file: state of the file
        known_files: files that the registrar knows: a registration is odd or refused because one is missing or other
            than expected, a frame when it does not fit its children
    """

    node_id: str
    file: FileState = None
    known_files: FrozenSet[str] = frozenset()


@dataclass(frozen=True)
class _Refused:
    circumstances: Circumstances
    asked_s: float
    is_final: bool
    times: int


@dataclass(frozen=True)
class _Granted:
    node_id: str
    answered_s: float
    times: int


@dataclass(frozen=True)
class Pauses:
    """Pauses between attempts that get the same answer: each is twice as long as the one before.

    Attributes:
        first_s: the first one, seconds
        longest_s: no pause is longer, seconds
    """

    first_s: float
    longest_s: float

    def after(self, times: int) -> float:
        """Return the pause after so many attempts, 1 or more; seconds."""
        pause_s = self.first_s
        for _ in range(times - 1):
            if pause_s >= self.longest_s:
                break
            pause_s *= 2.0
        return min(pause_s, self.longest_s)


class LateChecks:
    """Checks of frames that no file described when a server registered for them.

    A check is due when the registrar knows other files than before, and else after a pause: the registrar may not have
    answered the one before.
    """

    def __init__(self, pauses: Pauses) -> None:
        """
        Args:
            pauses: between two checks while the registrar knows the same files
        """
        self._pauses = pauses
        #: Of each frame: the circumstances of the last check, its time, and how often they were the same.
        self._checked: Dict[str, Tuple[Circumstances, float, int]] = {}

    def find(self, frame_name: str, is_known: bool, circumstances: Circumstances, *, now_s: float) -> None:
        """Take up the outcome of a check; a frame that is known needs no other one."""
        if is_known:
            self._checked.pop(frame_name, None)
            return
        before, _, times = self._checked.get(frame_name, (None, 0.0, 0))
        self._checked[frame_name] = (circumstances, now_s, times + 1 if before == circumstances else 1)

    def due_in_s(self, circumstances: Circumstances, *, now_s: float) -> Dict[str, float]:
        """Return after how many seconds each frame is to be checked; 0 for now."""
        return {
            frame_name: max(0.0, checked_s + self._pauses.after(times) - now_s) if before == circumstances else 0.0
            for frame_name, (before, checked_s, times) in sorted(self._checked.items())
        }


class Answers:
    """Answers to requests, so that nobody asks for the same again and again.

    A file that was refused is offered again when it has changed, or when the other side knows other files or was
    restarted. Everything else, such as a service that did not answer, is also tried again after a pause. What was
    granted may be missing from what the other side published before: it is asked for again after a pause, too.
    """

    def __init__(self, pauses: Pauses) -> None:
        """
        Args:
            pauses: between two attempts
        """
        self._pauses = pauses
        self._refused: Dict[RegistrationRequest, _Refused] = {}
        self._granted: Dict[RegistrationRequest, _Granted] = {}

    def refuse(
        self, request: RegistrationRequest, circumstances: Circumstances, *, is_final: bool, now_s: float
    ) -> None:
        """A request was refused.

        Args:
            request: the request
            circumstances: under which it was asked
            is_final: the answer would be the same again; False when there was none
            now_s: monotonic seconds
        """
        self._granted.pop(request, None)
        before = self._refused.get(request)
        times = before.times + 1 if before is not None and before.circumstances == circumstances else 1
        self._refused[request] = _Refused(circumstances, now_s, is_final, times)

    def grant(self, request: RegistrationRequest, circumstances: Circumstances, *, now_s: float) -> None:
        """A request was granted; the arguments are those of :meth:`refuse`."""
        self._refused.pop(request, None)
        before = self._granted.get(request)
        times = before.times + 1 if before is not None and before.node_id == circumstances.node_id else 1
        self._granted[request] = _Granted(circumstances.node_id, now_s, times)

    def unconfirmed(self) -> FrozenSet[RegistrationRequest]:
        """Return what was granted by one whose id was not known."""
        return frozenset(request for request, granted in self._granted.items() if not granted.node_id)

    def confirm(self, request: RegistrationRequest, node_id: str) -> None:
        """The other side knows what it granted, perhaps before its first word: now its id is known, too."""
        granted = self._granted.get(request)
        if granted is not None and not granted.node_id:
            self._granted[request] = replace(granted, node_id=node_id)

    def due_in_s(self, request: RegistrationRequest, circumstances: Circumstances, *, now_s: float) -> float:
        """Return after how many seconds a missing request is to be made: 0 for now, infinity for not at all."""
        granted = self._granted.get(request)
        # Before the first word of the other side its id is not known.
        if granted is not None and granted.node_id in ("", circumstances.node_id):
            return max(0.0, granted.answered_s + self._pauses.after(granted.times) - now_s)
        refused = self._refused.get(request)
        if refused is None or refused.circumstances != circumstances:
            return 0.0
        return math.inf if refused.is_final else max(0.0, refused.asked_s + self._pauses.after(refused.times) - now_s)


def file_state(path: str) -> FileState:
    """Return the state of a file."""
    try:
        status = os.stat(path)
    except (OSError, ValueError):
        return None
    return status.st_mtime_ns, status.st_size


def absolute_path(path: str) -> str:
    """Return the absolute path of a file that a program names.

    A relative path counts from the working directory, as everywhere, or else from the folder of the program: a node
    that roslaunch starts has another working directory than one that is started by hand.
    """
    named = os.path.expanduser(path)
    if os.path.isabs(named) or os.path.exists(named):
        return os.path.abspath(named)
    beside_program = os.path.join(os.path.dirname(os.path.realpath(sys.argv[0] if sys.argv else "")), named)
    return os.path.abspath(beside_program if os.path.exists(beside_program) else named)
