"""Train, pack and score small Stanza models of English robot commands."""

__version__ = "1.0.0"
