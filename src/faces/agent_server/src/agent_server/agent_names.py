"""Names of agents, and the ids of their commands, which say who asked."""

import itertools
import re
import uuid

from roboframenet_ros.command_ids import AGENT, TextSource, is_spoken

_LONGEST_NAME = 32
_ID = re.compile(r"agent-(?P<name>[\w.]{1,32})-[0-9a-f]{8}-\d+(-then)?", re.ASCII)


def clean_name(name: str) -> str:
    """Return a name of letters, digits, "_" and "." for what a client calls itself."""
    return re.sub(r"[^\w.]+", "_", name, flags=re.ASCII).strip("_.")[:_LONGEST_NAME] or "unnamed"


def who_asked(command_id: str) -> str:
    """Return who gave a command, by its id: "agent claude", "a person" or "a program or page"."""
    found = _ID.fullmatch(command_id)
    if found is not None:
        return f"agent {found['name']}"
    if is_spoken(command_id) or command_id.startswith((TextSource.STOP.value, TextSource.UNHEARD.value)):
        return "a person"
    return "a program or page"


class CommandIds:
    """The ids of the commands of one agent; no other gives the same ones."""

    def __init__(self, name: str) -> None:
        """
        Args:
            name: a clean name
        """
        self.prefix = f"{AGENT}{name}-{uuid.uuid4().hex[:8]}-"
        self._numbers = itertools.count(1)

    def next_id(self) -> str:
        """Return an id that was not given before."""
        return f"{self.prefix}{next(self._numbers)}"
