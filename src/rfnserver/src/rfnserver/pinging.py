"""The answer to "Ping."."""

from typing import Iterable, Tuple


def ping_sentence(callbacks: Iterable[Tuple[str, str, bool]]) -> str:
    """Return a sentence that names the servers that are alive.

    Args:
        callbacks: frame name, action server, and whether the server is alive
    Returns:
        a sentence for a person
    """
    known = list(callbacks)
    alive = sorted({server for _, server, is_alive in known if is_alive})
    dead = sorted({server for _, server, is_alive in known if not is_alive} - set(alive))
    sentence = f"I am alive, with {len(alive)} server{'' if len(alive) == 1 else 's'}: {', '.join(alive) or 'none'}."
    return sentence + (f" Not running: {', '.join(dead)}." if dead else "")
