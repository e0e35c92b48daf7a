"""The one exception that the tool raises for anything the user can mend."""


class TrainingError(Exception):
    """A wrong file, argument or state; the message says where, what was expected and what to do."""
