"""What a person is told about a stop."""

from typing import Sequence

from roboframenet_ros.spoken_text import join_with_and
from robot_stop.braking import Finding, Obedience

#: Code of the reply to a stop that was carried out, while words beside it were not.
REST_NOT_DONE = "REST_NOT_DONE"
#: Codes of the replies that say that the robot stands still.
STOPPED_CODES = frozenset(["DONE", REST_NOT_DONE])


def may_still_move(obedience: Obedience) -> str:
    """The nodes and servers that do not obey, as a sentence."""
    return f"The robot may still move: {obedience.describe()}."


def sentence_of(finding: Finding, *, server_count: int, limit_s: float) -> str:
    """Say what was found out about a stop.

    Args:
        finding: what was found out
        server_count: how many servers the cancel was sent to
        limit_s: longest time for which zero velocity is repeated, seconds
    """
    if not finding.obedience.is_complete:
        zero = f"has ended after {limit_s:g} s" if finding.is_last else f"is repeated for up to {limit_s:g} s"
        return f"{may_still_move(finding.obedience)} Zero velocity {zero}."
    if not finding.is_first:
        return "Stopped now: every node obeys."
    if server_count == 0:
        return "Stopped: zero velocity; there was no action server to cancel."
    return f"Stopped: zero velocity, and no goal is left on {server_count} action server{'s' * (server_count != 1)}."


def sentence_of_rest(words: Sequence[str]) -> str:
    """Say what else was said beside a stop, and is not done; empty when there is nothing.

    Args:
        words: as they were said
    """
    if not words:
        return ""
    named = join_with_and([f'"{part}"' for part in words])
    return f"I did not do the rest: {named}."
