"""What a server wants the registrar and the framer to know, and what of it they do not know yet."""

from dataclasses import dataclass
from enum import Enum
from typing import FrozenSet, Iterable, Optional, Tuple


class WishKind(Enum):
    """Who is asked, and for what."""

    FRAME_FILE = "add_frame"
    LEXICAL_UNIT_FILE = "add_lexical_unit"
    REGISTRATION = "register_with_frame"


@dataclass(frozen=True)
class Wish:
    """One call that has to be made, and made again when the other side has forgotten it.

    Attributes:
        kind: which service
        subject: absolute path of a file, or name of a frame
    """

    kind: WishKind
    subject: str


@dataclass(frozen=True)
class Knowledge:
    """What the registrar or the framer says that it knows.

    Attributes:
        id: new for each start of the node
        files: paths
        registrations: frames for which this server is registered
    """

    id: str
    files: FrozenSet[str] = frozenset()
    registrations: FrozenSet[str] = frozenset()


def forgotten(
    wishes: Iterable[Wish], *, registrar: Optional[Knowledge], framer: Optional[Knowledge]
) -> Tuple[Wish, ...]:
    """Return the wishes that the other side does not know.

    Args:
        wishes: in the order in which they were made; files come before the registrations that need them
        registrar: what the registrar knows; None while there is none, then nothing can be asked of it
        framer: what the framer knows; None while there is none
    """
    missing = []
    for wish in wishes:
        if (
            (wish.kind is WishKind.FRAME_FILE and registrar is not None and wish.subject not in registrar.files)
            or (
                wish.kind is WishKind.REGISTRATION
                and registrar is not None
                and wish.subject not in registrar.registrations
            )
            or (wish.kind is WishKind.LEXICAL_UNIT_FILE and framer is not None and wish.subject not in framer.files)
        ):
            missing.append(wish)
    return tuple(missing)
