"""The error of models that cannot be loaded."""


class ModelError(RuntimeError):
    """The model is missing or cannot be loaded; the message says what was expected, where, and what to do."""
