"""Text that goes with an event must not fill the queues of those who listen."""

#: Characters of a trace; a sentence of ten words has about three thousand.
MAX_LENGTH = 20_000


def bounded(text: str, max_length: int = MAX_LENGTH) -> str:
    """Return whole lines of a text up to a length, and how many more there are."""
    if len(text) <= max_length:
        return text
    kept = text[:max_length].rpartition("\n")[0]
    more = text[len(kept) :].strip("\n").count("\n") + 1
    return f"{kept}\n... {more} more lines".lstrip("\n")
