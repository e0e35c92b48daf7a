"""Cuts the text of an event, so that it does not fill the queues of subscribers."""

#: Most characters of a trace; that of a sentence of ten words has about three thousand.
MAX_LENGTH = 20_000


def bounded(text: str, max_length: int = MAX_LENGTH) -> str:
    """Return the first lines of a text, up to a length, and the number of the lines left out."""
    if len(text) <= max_length:
        return text
    kept = text[:max_length].rpartition("\n")[0]
    more = text[len(kept) :].strip("\n").count("\n") + 1
    return f"{kept}\n... {more} more lines".lstrip("\n")
