"""Whether a server that runs on demand is up, and when it may go."""

from dataclasses import dataclass, replace


@dataclass(frozen=True)
class Residence:
    """A server between its start and its end.

    Attributes:
        is_up: its processes were started and have not ended
        users: goals that need it now
        used_s: when it was last needed, monotonic seconds
    """

    is_up: bool = False
    users: int = 0
    used_s: float = 0.0

    def entered(self, now_s: float) -> "Residence":
        """A goal needs it: it is up from now on."""
        return replace(self, is_up=True, users=self.users + 1, used_s=now_s)

    def left(self, now_s: float) -> "Residence":
        """A goal does not need it any more."""
        return replace(self, users=max(0, self.users - 1), used_s=now_s)

    def seen_busy(self, now_s: float) -> "Residence":
        """It works on a goal that somebody else sent."""
        return replace(self, used_s=max(self.used_s, now_s))

    def down(self) -> "Residence":
        """Its processes have ended."""
        return replace(self, is_up=False)

    def may_go(self, *, idle_s: float, now_s: float) -> bool:
        """Whether nobody has needed it for so long, seconds."""
        return self.is_up and self.users == 0 and now_s - self.used_s >= idle_s
