"""Keeps the newest view of everything, and tells which have changed."""

from collections import OrderedDict
from typing import Any, Dict, Tuple

from web_console.views import as_json


class Board:
    """The newest views, by key. Not thread-safe: one thread owns it.

    A key is the name of the view, or "command" and an id: a page shows several commands.
    """

    def __init__(self, *, most_commands: int) -> None:
        """Start empty.

        Args:
            most_commands: how many views of commands are kept
        """
        self._most_commands = most_commands
        self._views: OrderedDict[str, Tuple[str, Any]] = OrderedDict()
        self._changed: Dict[str, None] = {}

    def show(self, kind: str, view: Any, *, which: str = "") -> bool:
        """Replace a view; returns whether it has changed.

        Args:
            kind: name of the view
            view: the value
            which: id of a command
        """
        key = f"{kind} {which}" if which else kind
        if key in self._views and self._views[key][1] == view:
            return False
        self._views[key] = (kind, view)
        self._changed[key] = None
        if which:
            commands = [other for other in self._views if other.startswith(f"{kind} ")]
            for old in commands[: max(0, len(commands) - self._most_commands)]:
                del self._views[old]
                self._changed.pop(old, None)
        return True

    def take_changes(self) -> Tuple[Tuple[str, str], ...]:
        """Return the keys that have changed since the last call, and their messages."""
        changed, self._changed = self._changed, {}
        return tuple((key, as_json(*self._views[key])) for key in changed)

    def forget_changes(self) -> None:
        """Nobody looks: the next page gets everything anyway."""
        self._changed = {}

    def snapshot(self) -> Tuple[Tuple[str, str], ...]:
        """Return all keys and messages, for a page that has just come; other views first, then commands by age."""
        return tuple((key, as_json(*view)) for key, view in self._views.items())
