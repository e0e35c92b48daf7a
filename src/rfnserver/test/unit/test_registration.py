"""Requests that the registrar and the framer do not know are made again."""

from pathlib import Path

import pytest

from rfnserver.registration import (
    Answers,
    Circumstances,
    KnownState,
    LateChecks,
    Pauses,
    RegistrationRequest,
    RequestKind,
    absolute_path,
    file_state,
    missing_requests,
)

FRAME = RegistrationRequest(RequestKind.FRAME_FILE, "/a/frame.yaml")
UNIT = RegistrationRequest(RequestKind.LEXICAL_UNIT_FILE, "/a/unit.yaml")
REGISTRATION = RegistrationRequest(RequestKind.REGISTRATION, "waving")
PAUSES = Pauses(10.0, 80.0)
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
    answers = Answers(PAUSES)
    asked = Circumstances("framer_1", (1, 20))
    assert answers.due_in_s(UNIT, asked, now_s=100.0) == 0.0
    refuse(answers, UNIT, asked, is_final=True)
    assert answers.due_in_s(UNIT, asked, now_s=1e9) > 0.0
    assert answers.due_in_s(UNIT, Circumstances("framer_1", (2, 20)), now_s=100.0) == 0.0
    assert answers.due_in_s(UNIT, Circumstances("framer_1"), now_s=100.0) == 0.0
    assert answers.due_in_s(UNIT, Circumstances("framer_2", (1, 20)), now_s=100.0) == 0.0
    assert answers.due_in_s(FRAME, asked, now_s=100.0) == 0.0


def test_request_without_an_answer_is_repeated_after_a_time() -> None:
    answers = Answers(PAUSES)
    asked = Circumstances("registrar_1")
    refuse(answers, REGISTRATION, asked, is_final=False)
    assert answers.due_in_s(REGISTRATION, asked, now_s=109.9) > 0.0
    assert answers.due_in_s(REGISTRATION, asked, now_s=110.0) == 0.0


@pytest.mark.parametrize("known_id", ["registrar_1", ""])
def test_what_was_granted_is_not_asked_again_because_an_older_state_lacks_it(known_id: str) -> None:
    answers = Answers(PAUSES)
    answers.grant(REGISTRATION, Circumstances(known_id), now_s=100.0)
    assert answers.due_in_s(REGISTRATION, Circumstances("registrar_1"), now_s=109.9) > 0.0
    assert answers.due_in_s(REGISTRATION, Circumstances("registrar_1"), now_s=110.0) == 0.0


def test_a_restarted_registrar_is_asked_at_once_for_what_the_old_one_granted() -> None:
    answers = Answers(PAUSES)
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
    answers = Answers(PAUSES)
    answers.grant(REGISTRATION, Circumstances(""), now_s=100.0)
    answers.confirm(REGISTRATION, "registrar_1")
    assert answers.due_in_s(REGISTRATION, Circumstances("registrar_1"), now_s=103.0) == 7.0
    assert answers.due_in_s(REGISTRATION, Circumstances("registrar_2"), now_s=103.0) == 0.0


def test_what_was_not_granted_is_not_confirmed() -> None:
    answers = Answers(PAUSES)
    answers.confirm(REGISTRATION, "registrar_1")
    assert answers.due_in_s(REGISTRATION, Circumstances("registrar_1"), now_s=100.0) == 0.0


def test_pauses_between_attempts_with_the_same_answer_grow_to_the_longest() -> None:
    answers = Answers(PAUSES)
    asked = Circumstances("registrar_1", known_files=frozenset(["/a/frame.yaml"]))
    for give in (
        lambda now_s: answers.refuse(REGISTRATION, asked, is_final=False, now_s=now_s),
        lambda now_s: answers.grant(REGISTRATION, asked, now_s=now_s),
    ):
        pauses = []
        for now_s in range(6):
            give(float(now_s))
            pauses.append(answers.due_in_s(REGISTRATION, asked, now_s=float(now_s)))
        assert pauses == [10.0, 20.0, 40.0, 80.0, 80.0, 80.0]


def test_a_refused_registration_is_tried_at_once_when_a_file_comes_and_then_begins_with_a_short_pause() -> None:
    answers = Answers(PAUSES)
    before, after = (Circumstances("registrar_1", known_files=frozenset(files)) for files in ([], ["/a/frame.yaml"]))
    for _ in range(4):
        refuse(answers, REGISTRATION, before, is_final=False)
    assert answers.due_in_s(REGISTRATION, after, now_s=100.0) == 0.0
    refuse(answers, REGISTRATION, after, is_final=False)
    assert answers.due_in_s(REGISTRATION, after, now_s=100.0) == 10.0


def test_a_frame_without_a_file_is_checked_at_once_when_one_comes_and_else_ever_more_rarely() -> None:
    checks = LateChecks(PAUSES)
    before, after = (Circumstances("registrar_1", known_files=frozenset(files)) for files in ([], ["/a/frame.yaml"]))
    assert checks.due_in_s(before, now_s=0.0) == {}
    checks.find("waving", False, before, now_s=100.0)
    assert checks.due_in_s(before, now_s=103.0) == {"waving": 7.0}
    checks.find("waving", False, before, now_s=110.0)
    assert checks.due_in_s(before, now_s=110.0) == {"waving": 20.0}
    assert checks.due_in_s(after, now_s=110.0) == {"waving": 0.0}
    checks.find("waving", False, after, now_s=110.0)
    assert checks.due_in_s(after, now_s=110.0) == {"waving": 10.0}
    checks.find("waving", True, after, now_s=120.0)
    assert checks.due_in_s(before, now_s=1e9) == {}
