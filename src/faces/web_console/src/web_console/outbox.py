"""What still has to be sent to a page."""

from collections import OrderedDict
from typing import Optional

#: Messages that may wait; a page that takes none for long misses commands that nobody looks at any more.
MOST_WAITING = 100


class Outbox:
    """Messages for one page, the latest of each view only: a slow page gets fewer, and always the newest state."""

    def __init__(self) -> None:
        self._messages: OrderedDict[str, str] = OrderedDict()

    def put(self, key: str, message: str) -> None:
        """Replace the waiting message of a view, or add one at the end."""
        self._messages[key] = message
        if len(self._messages) > MOST_WAITING:
            # Keys of several words are those of single commands; every other view has one message.
            del self._messages[next((old for old in self._messages if " " in old), key)]

    def take(self) -> Optional[str]:
        """Remove and return the oldest message; None when nothing waits."""
        return self._messages.popitem(last=False)[1] if self._messages else None

    def __len__(self) -> int:
        return len(self._messages)
