"""Why a call is refused before anything is asked of the robot."""


class CallRefused(ValueError):
    """A call that is not passed on.

    Attributes:
        code: stable name of the reason, as in a reply: VALUE_NOT_ALLOWED, LIMIT, MISSING_ELEMENT, ...
    """

    def __init__(self, code: str, sentence: str) -> None:
        """
        Args:
            code: stable name of the reason
            sentence: for a person and for the agent
        """
        super().__init__(sentence)
        self.code = code
