"""Registration requests of a server: what it asks the registrar and the framer for, and what they do not know yet."""

from dataclasses import dataclass
from enum import Enum
from typing import FrozenSet, Iterable, Optional, Tuple


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
