"""What ``rfn doctor`` finds about registered servers."""

import difflib
from dataclasses import dataclass
from typing import Iterable, List

from roboframenet_tools.finding import Finding


@dataclass(frozen=True)
class Registered:
    """A server that is registered for a frame, and whether it answers."""

    frame: str
    server: str
    is_alive: bool


def registration_findings(frames: Iterable[str], servers: Iterable[Registered]) -> List[Finding]:
    """Find servers for frames that no file describes, and servers that do not answer.

    Args:
        frames: names of the frames that files describe
        servers: as the catalogue lists them
    """
    known, registered = list(frames), list(servers)
    findings: List[Finding] = []
    for one in registered:
        if one.frame not in known:
            alike = difflib.get_close_matches(one.frame, known, n=1)
            hint = f"did you mean '{alike[0]}'? Correct the name, or add" if alike else "correct the name, or add"
            findings.append(
                Finding(
                    "frame", f"{one.server} registered for '{one.frame}', which no file describes", f"{hint} the file"
                )
            )
        elif not one.is_alive:
            findings.append(
                Finding("server", f"{one.server} ({one.frame}) does not answer", "start it again, or see why it hangs")
            )
    return findings or [Finding("servers", f"{len(registered)} registered, all answer")]
