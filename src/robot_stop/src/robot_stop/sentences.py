"""What a person hears of a stop."""

from robot_stop.braking import Finding, Obedience


def may_still_move(obedience: Obedience) -> str:
    """Who does not obey, as a sentence."""
    return f"The robot may still move: {obedience.describe()}."


def sentence_of(finding: Finding, *, server_count: int, limit_s: float) -> str:
    """What was found out about a stop.

    Args:
        finding: what was found out
        server_count: how many servers heard the cancel
        limit_s: for how long zero velocity is repeated at most
    """
    if not finding.obedience.is_complete:
        zero = f"has ended after {limit_s:g} s" if finding.is_last else f"goes on for up to {limit_s:g} s"
        return f"{may_still_move(finding.obedience)} Zero velocity {zero}."
    if not finding.is_first:
        return "Stopped now: everybody obeys."
    if server_count == 0:
        return "Stopped: zero velocity; there was no action server to cancel."
    return f"Stopped: zero velocity, and no goal of {server_count} action server{'s' * (server_count != 1)} goes on."
