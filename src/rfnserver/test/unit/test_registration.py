"""Requests that the registrar and the framer do not know are made again."""

from pathlib import Path

import pytest

from rfnserver.registration import (
    Circumstances,
    KnownState,
    Refusals,
    RegistrationRequest,
    RequestKind,
    absolute_path,
    file_state,
    missing_requests,
)

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


def refuse(refusals: Refusals, request: RegistrationRequest, circumstances: Circumstances, **how: bool) -> None:
    refusals.note(request, circumstances, now_s=100.0, **how)


def test_refused_file_is_offered_again_when_it_or_the_other_side_has_changed() -> None:
    refusals = Refusals(retry_s=10.0)
    asked = Circumstances("framer_1", (1, 20))
    assert refusals.is_due(UNIT, asked, now_s=100.0)
    refuse(refusals, UNIT, asked, is_final=True)
    assert not refusals.is_due(UNIT, asked, now_s=1e9)
    assert refusals.is_due(UNIT, Circumstances("framer_1", (2, 20)), now_s=100.0)
    assert refusals.is_due(UNIT, Circumstances("framer_1"), now_s=100.0)
    assert refusals.is_due(UNIT, Circumstances("framer_2", (1, 20)), now_s=100.0)
    assert refusals.is_due(FRAME, asked, now_s=100.0)


def test_request_without_an_answer_is_repeated_after_a_time() -> None:
    refusals = Refusals(retry_s=10.0)
    asked = Circumstances("registrar_1")
    refuse(refusals, REGISTRATION, asked, is_final=False)
    assert not refusals.is_due(REGISTRATION, asked, now_s=109.9)
    assert refusals.is_due(REGISTRATION, asked, now_s=110.0)
    refusals.forget(REGISTRATION)
    assert refusals.is_due(REGISTRATION, asked, now_s=100.0)


def test_state_of_a_file(tmp_path: Path) -> None:
    path = tmp_path / "waving.yaml"
    assert file_state(str(path)) is None
    assert file_state("a\0b") is None
    path.write_text("name: waving")
    assert file_state(str(path)) == (path.stat().st_mtime_ns, 12)


def test_relative_path_counts_from_the_working_directory_or_else_from_the_program(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    program, elsewhere = tmp_path / "program", tmp_path / "elsewhere"
    for folder in (program, elsewhere):
        folder.mkdir()
    monkeypatch.setattr("sys.argv", [str(program / "waving_server.py")])
    monkeypatch.chdir(elsewhere)
    assert absolute_path("waving.yaml") == str(elsewhere / "waving.yaml")
    (program / "waving.yaml").touch()
    assert absolute_path("waving.yaml") == str(program / "waving.yaml")
    (elsewhere / "waving.yaml").touch()
    assert absolute_path("waving.yaml") == str(elsewhere / "waving.yaml")
    assert absolute_path("/a/waving.yaml") == "/a/waving.yaml"
