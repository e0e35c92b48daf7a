"""How long a topic may stay unread while nobody asks for it."""

#: Nobody has asked for so long when the pauses begin, seconds.
LIVELY_S = 2.0
#: The longest pause, seconds.
LONGEST_PAUSE_S = 0.5
#: What may wait in a socket, bytes: a small part of what fits in, so that no publisher is ever blocked.
MOST_UNREAD_BYTES = 16384
#: A shorter pause is not worth while, seconds.
_SHORTEST_PAUSE_S = 0.05


class Unasked:
    """The pauses between two messages; times are monotonic seconds. The caller serialises the calls."""

    def __init__(self, *, now_s: float) -> None:
        """Begin as if somebody had just asked."""
        self._asked_s = self._since_s = now_s
        self._since_count = 0
        self._per_s = 0.0

    def ask(self, *, count: int, now_s: float) -> None:
        """Somebody wants each message from now on.

        Args:
            count: messages so far
            now_s: now
        """
        if now_s - self._asked_s >= LIVELY_S:
            self._since_s, self._since_count = now_s, count
            self._per_s = 0.0
        self._asked_s = now_s

    def pause_s(self, *, count: int, size: int, now_s: float) -> float:
        """Return how long to wait before the next message is read; 0 for not at all.

        Args:
            count: messages so far, with this one; those that were dropped unread do not count
            size: of this message, bytes
            now_s: now
        """
        if now_s - self._asked_s < LIVELY_S:
            return 0.0
        if not self._per_s:
            # Every message was read until now.
            self._per_s = (count - self._since_count) / (now_s - self._since_s)
        pause_s = min(LONGEST_PAUSE_S, MOST_UNREAD_BYTES / max(1.0, size * self._per_s))
        return pause_s if pause_s >= _SHORTEST_PAUSE_S else 0.0
