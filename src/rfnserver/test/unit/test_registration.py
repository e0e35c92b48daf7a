"""Requests that the registrar and the framer do not know are made again."""

from rfnserver.registration import KnownState, RegistrationRequest, RequestKind, missing_requests

FRAME = RegistrationRequest(RequestKind.FRAME_FILE, "/a/frame.yaml")
UNIT = RegistrationRequest(RequestKind.LEXICAL_UNIT_FILE, "/a/unit.yaml")
REGISTRATION = RegistrationRequest(RequestKind.REGISTRATION, "waving")
REQUESTS = (FRAME, UNIT, REGISTRATION)


def test_nothing_is_requested_while_nobody_runs() -> None:
    assert missing_requests(REQUESTS, registrar=None, framer=None) == ()


def test_new_registrar_and_framer_know_nothing() -> None:
    assert missing_requests(REQUESTS, registrar=KnownState("1"), framer=KnownState("2")) == REQUESTS


def test_what_is_known_is_not_asked_again() -> None:
    registrar = KnownState("1", files=frozenset(["/a/frame.yaml"]), registrations=frozenset(["waving"]))
    assert missing_requests(REQUESTS, registrar=registrar, framer=KnownState("2")) == (UNIT,)
