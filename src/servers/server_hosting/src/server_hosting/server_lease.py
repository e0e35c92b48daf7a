"""Whether a server that runs on demand is up, and when it may be stopped."""

from dataclasses import dataclass, replace


@dataclass(frozen=True)
class ServerLease:
    """Who uses a server that runs on demand, and when it was last used.

    Attributes:
        is_up: its processes were started and have not ended
        users: number of goals that use it now
        used_s: when it was last used, monotonic seconds
    """

    is_up: bool = False
    users: int = 0
    used_s: float = 0.0

    def acquired(self, now_s: float) -> "ServerLease":
        """A goal uses it: it is up from now on."""
        return replace(self, is_up=True, users=self.users + 1, used_s=now_s)

    def released(self, now_s: float) -> "ServerLease":
        """A goal uses it no more."""
        return replace(self, users=max(0, self.users - 1), used_s=now_s)

    def seen_busy(self, now_s: float) -> "ServerLease":
        """It works on a goal of another client."""
        return replace(self, used_s=max(self.used_s, now_s))

    def ended(self) -> "ServerLease":
        """Its processes have ended."""
        return replace(self, is_up=False)

    def is_expired(self, *, idle_s: float, now_s: float) -> bool:
        """Whether nobody has used it for ``idle_s`` seconds."""
        return self.is_up and self.users == 0 and now_s - self.used_s >= idle_s
