"""Requests that the registrar and the framer do not know are made again."""

from pathlib import Path

import pytest

from rfnserver.registration import (
    Answers,
    Circumstances,
    KnownState,
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


def refuse(answers: Answers, request: RegistrationRequest, circumstances: Circumstances, **how: bool) -> None:
    answers.refuse(request, circumstances, now_s=100.0, **how)


def test_refused_file_is_offered_again_when_it_or_the_other_side_has_changed() -> None:
    answers = Answers(retry_s=10.0)
    asked = Circumstances("framer_1", (1, 20))
    assert answers.due_in_s(UNIT, asked, now_s=100.0) == 0.0
    refuse(answers, UNIT, asked, is_final=True)
    assert answers.due_in_s(UNIT, asked, now_s=1e9) > 0.0
    assert answers.due_in_s(UNIT, Circumstances("framer_1", (2, 20)), now_s=100.0) == 0.0
    assert answers.due_in_s(UNIT, Circumstances("framer_1"), now_s=100.0) == 0.0
    assert answers.due_in_s(UNIT, Circumstances("framer_2", (1, 20)), now_s=100.0) == 0.0
    assert answers.due_in_s(FRAME, asked, now_s=100.0) == 0.0


def test_request_without_an_answer_is_repeated_after_a_time() -> None:
    answers = Answers(retry_s=10.0)
    asked = Circumstances("registrar_1")
    refuse(answers, REGISTRATION, asked, is_final=False)
    assert answers.due_in_s(REGISTRATION, asked, now_s=109.9) > 0.0
    assert answers.due_in_s(REGISTRATION, asked, now_s=110.0) == 0.0


@pytest.mark.parametrize("known_id", ["registrar_1", ""])
def test_what_was_granted_is_not_asked_again_because_an_older_state_lacks_it(known_id: str) -> None:
    answers = Answers(retry_s=10.0)
    answers.grant(REGISTRATION, Circumstances(known_id), now_s=100.0)
    assert answers.due_in_s(REGISTRATION, Circumstances("registrar_1"), now_s=109.9) > 0.0
    assert answers.due_in_s(REGISTRATION, Circumstances("registrar_1"), now_s=110.0) == 0.0


def test_a_restarted_registrar_is_asked_at_once_for_what_the_old_one_granted() -> None:
    answers = Answers(retry_s=10.0)
    refuse(answers, REGISTRATION, Circumstances("registrar_1"), is_final=False)
    answers.grant(REGISTRATION, Circumstances("registrar_1"), now_s=105.0)
    assert answers.due_in_s(REGISTRATION, Circumstances("registrar_2"), now_s=105.0) == 0.0


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


def test_a_server_that_started_just_before_the_registrar_restarted_asks_at_once() -> None:
    answers = Answers(retry_s=10.0)
    answers.grant(REGISTRATION, Circumstances(""), now_s=100.0)
    answers.confirm(REGISTRATION, "registrar_1")
    assert answers.due_in_s(REGISTRATION, Circumstances("registrar_1"), now_s=103.0) == 7.0
    assert answers.due_in_s(REGISTRATION, Circumstances("registrar_2"), now_s=103.0) == 0.0


def test_what_was_not_granted_is_not_confirmed() -> None:
    answers = Answers(retry_s=10.0)
    answers.confirm(REGISTRATION, "registrar_1")
    assert answers.due_in_s(REGISTRATION, Circumstances("registrar_1"), now_s=100.0) == 0.0
