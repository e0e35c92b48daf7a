"""Which servers a process hosts: "NAME=package.module:Class" on its command line."""

import re
from dataclasses import dataclass
from typing import Iterable, List, Tuple

_HOSTED = re.compile(r"^(?P<name>[A-Za-z]\w*)=(?P<module>[A-Za-z_]\w*(\.[A-Za-z_]\w*)*):(?P<class_name>[A-Za-z_]\w*)$")


class HostedError(ValueError):
    """A command line argument does not name a server to host."""


@dataclass(frozen=True)
class Hosted:
    """One server of a host.

    Attributes:
        name: namespace of its parameters
        module: of its class
        class_name: constructed with the keyword ``parameters``, the prefix of its parameters
    """

    name: str
    module: str
    class_name: str

    @property
    def parameters(self) -> str:
        """The prefix of its parameters: "~moo/" for "moo"."""
        return f"~{self.name}/"


def read_hosted(arguments: Iterable[str]) -> Tuple[Hosted, ...]:
    """Read the arguments of a host.

    Args:
        arguments: "moo=moo.node:MooServer" and so on; those that roslaunch appends ("__name:=...") are ignored
    Raises:
        HostedError: one of them has another form, or two have the same name
    """
    hosted: List[Hosted] = []
    for argument in arguments:
        if ":=" in argument:
            continue
        match = _HOSTED.match(argument)
        if match is None:
            raise HostedError(f"{argument!r}: expected NAME=package.module:Class, such as moo=moo.node:MooServer")
        one = Hosted(name=match["name"], module=match["module"], class_name=match["class_name"])
        if one.name in [other.name for other in hosted]:
            raise HostedError(f"{argument!r}: a second server is named {one.name!r}")
        hosted.append(one)
    if not hosted:
        raise HostedError("no server is named; expected arguments such as moo=moo.node:MooServer")
    return tuple(hosted)
