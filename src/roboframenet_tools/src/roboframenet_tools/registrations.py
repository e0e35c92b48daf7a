"""What ``rfn doctor`` says of the servers that are registered."""

from typing import Collection, Sequence, Tuple

from roboframenet_tools.finding import Finding
from semantic_frames.marked_yaml import did_you_mean


def registration_findings(
    frames: Collection[str], registrations: Sequence[Tuple[str, str, bool]]
) -> Tuple[Finding, ...]:
    """Check the registrations of servers.

    Args:
        frames: names of the frames that files describe
        registrations: frame name, server, and whether the server is alive
    """
    findings = []
    for frame, server, is_alive in registrations:
        if frame not in frames:
            advice = (
                did_you_mean(frame, frames) or "add its frame file, or correct the name that the server registers for"
            )
            findings.append(Finding(server, f"registered for '{frame}', which no file describes", advice))
        if not is_alive:
            findings.append(Finding(server, "registered, and not running", "start it, or look into its log"))
    if not findings:
        findings.append(Finding("registrations", f"{len(registrations)}, each for a frame that a file describes"))
    return tuple(dict.fromkeys(findings))
