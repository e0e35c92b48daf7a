"""What registrar and framer have forgotten."""

from rfnserver.wishes import Knowledge, Wish, WishKind, forgotten

FRAME = Wish(WishKind.FRAME_FILE, "/a/frame.yaml")
UNIT = Wish(WishKind.LEXICAL_UNIT_FILE, "/a/unit.yaml")
REGISTRATION = Wish(WishKind.REGISTRATION, "waving")
WISHES = (FRAME, UNIT, REGISTRATION)


def test_nothing_can_be_asked_of_nobody() -> None:
    assert forgotten(WISHES, registrar=None, framer=None) == ()


def test_new_registrar_and_framer_know_nothing() -> None:
    assert forgotten(WISHES, registrar=Knowledge("1"), framer=Knowledge("2")) == WISHES


def test_what_is_known_is_not_asked_again() -> None:
    registrar = Knowledge("1", files=frozenset(["/a/frame.yaml"]), registrations=frozenset(["waving"]))
    assert forgotten(WISHES, registrar=registrar, framer=Knowledge("2")) == (UNIT,)
