"""Who may open the page: the names by which it is called, and the token where other machines can reach it."""

import hmac
import ipaddress
import re
from typing import Sequence, Tuple

_LOCAL_NAMES = ("localhost", "127.0.0.1", "[::1]")
SHORTEST_TOKEN = 16
_LONGEST_TOKEN = 4096


class AccessError(ValueError):
    """The page must not be offered like this; the message says why, and what to do."""


def is_local(address: str) -> bool:
    """Whether only programs of this machine can reach an address."""
    try:
        return ipaddress.ip_address(address).is_loopback
    except ValueError:
        return False


def host_pattern(address: str, names: Sequence[str]) -> str:
    """Return the regular expression of the Host headers that are answered, without ports.

    A page of another origin whose name was made to point here (DNS rebinding) sends its own name.

    Args:
        address: where the server listens
        names: names by which other machines call this one
    """
    allowed: Tuple[str, ...] = (*_LOCAL_NAMES, *names)
    if address not in ("0.0.0.0", "::", *allowed):
        allowed += (f"[{address}]" if ":" in address else address,)
    return "^(" + "|".join(re.escape(name.lower()) for name in allowed) + ")$"


def check_access(address: str, token: str) -> None:
    """Check that an address may be offered.

    Args:
        address: where the server listens
        token: what a page must know; empty for none

    Raises:
        AccessError: other machines can reach the address, and there is no token, or a short one
    """
    if token and not SHORTEST_TOKEN <= len(token) <= _LONGEST_TOKEN:
        raise AccessError(
            f"~token_file holds {len(token)} characters; expected {SHORTEST_TOKEN} to {_LONGEST_TOKEN} "
            "(for instance the output of: openssl rand -hex 16)"
        )
    if not token and not is_local(address):
        raise AccessError(
            f"~address is {address}, which other machines can reach: set ~token_file to a file with a secret of at "
            f"least {SHORTEST_TOKEN} characters, or use 127.0.0.1"
        )


def read_token(path: str) -> str:
    """Return the secret in a file; empty for no file.

    Raises:
        AccessError: the file cannot be read
    """
    if not path:
        return ""
    try:
        with open(path, encoding="utf-8") as file:
            return file.read(2 * _LONGEST_TOKEN).strip()
    except (OSError, ValueError) as error:
        raise AccessError(f"~token_file {path!r} cannot be read: {error}") from error


def is_token(said: str, token: str) -> bool:
    """Whether a page knows the token; takes the same time for each answer."""
    return hmac.compare_digest(said.encode(), token.encode())
