"""The answer to "Ping."."""

from typing import Iterable, Sequence, Tuple


def living_and_dead(callbacks: Iterable[Tuple[str, str, bool]]) -> Tuple[Sequence[str], Sequence[str]]:
    """Return the names of the servers that are alive, and of those that are not.

    Args:
        callbacks: frame name, action server, and whether the server is alive
    """
    known = list(callbacks)
    alive = sorted({server for _, server, is_alive in known if is_alive})
    dead = sorted({server for _, server, is_alive in known if not is_alive} - set(alive))
    return alive, dead


def ping_sentence(alive: Sequence[str], dead: Sequence[str]) -> str:
    """Return the answer for a person, without names that only engineers know."""
    if dead:
        return f"I am alive, but {len(dead)} of my {len(alive) + len(dead)} programs {_do(len(dead))} not run."
    return f"I am alive, and {'my only program runs' if len(alive) == 1 else f'all {len(alive)} of my programs run'}."


def _do(count: int) -> str:
    return "does" if count == 1 else "do"
