"""A clock for tests."""


class Clock:
    """A clock that stands still until a test sets `now_s`; called, it returns the time in seconds."""

    def __init__(self) -> None:
        self.now_s = 100.0

    def __call__(self) -> float:
        return self.now_s
