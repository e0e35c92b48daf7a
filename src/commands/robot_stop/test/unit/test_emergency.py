"""The state of the emergency stop, its file, and who acts against it."""

import json
import threading

import pytest

from robot_stop.braking import Evidence, LiveGoal, VelocitySeen, obedience_of_held
from robot_stop.emergency import Emergency, engaged, from_json, newer, released, to_json
from robot_stop.emergency_file import EmergencyFile
from robot_stop.servers import Server

NOW_S = 1_700_000_000.0


def test_a_second_engagement_changes_nothing_and_names_the_first():
    first = engaged(Emergency(), by="the page", now_s=NOW_S)
    assert engaged(first, by="the lock", now_s=NOW_S + 5.0) == first
    assert "the page" in first.sentence
    assert '"release the emergency stop"' in first.sentence


def test_each_change_counts_above_the_last_one():
    state = Emergency()
    for turn in range(3):
        held = engaged(state, by="a", now_s=NOW_S)
        let_go = released(held, by="b", now_s=NOW_S)
        assert state.number < held.number < let_go.number, turn
        assert newer(held, let_go) == newer(let_go, held) == let_go
        assert not let_go.sentence
        state = let_go


def test_nobody_holds_what_was_never_engaged():
    assert released(Emergency(), by="b", now_s=NOW_S) == Emergency()


def test_of_equal_numbers_the_one_that_holds_counts():
    held, free = Emergency(7, True, "a", NOW_S), Emergency(7, False, "b", NOW_S)
    assert newer(free, held) == newer(held, free) == held


def test_a_lost_file_counts_on_above_what_others_know():
    known = released(engaged(Emergency(), by="a", now_s=NOW_S), by="b", now_s=NOW_S + 60.0)
    again = engaged(Emergency(), by="c", now_s=NOW_S + 120.0)
    assert newer(known, again) == again


def test_a_file_gives_back_what_was_written(tmp_path):
    file = EmergencyFile(tmp_path / "new" / "state.json")
    assert file.load() == Emergency()
    written = file.update(Emergency(), lambda state: engaged(state, by="a", now_s=NOW_S))
    assert EmergencyFile(file.path).load() == written
    assert written.is_engaged


def test_what_another_process_wrote_is_the_beginning_of_a_change(tmp_path):
    file = EmergencyFile(tmp_path / "state.json")
    theirs = file.update(Emergency(), lambda state: engaged(state, by="them", now_s=NOW_S))
    assert file.update(Emergency(), lambda state: engaged(state, by="us", now_s=NOW_S)) == theirs


@pytest.mark.parametrize(
    "damaged",
    [
        b"",
        b"{",
        b"[]",
        b"null",
        b"\xff\xfe",
        b"[" * 4000,
        b'{"number": 3, "is_engaged": false}',
        b'{"number": -1, "is_engaged": false, "by": "", "since_s": 0}',
        b'{"number": true, "is_engaged": false, "by": "", "since_s": 0}',
        b'{"number": 4294967296, "is_engaged": false, "by": "", "since_s": 0}',
        b'{"number": 3, "is_engaged": 0, "by": "", "since_s": 0}',
        b'{"number": 3, "is_engaged": false, "by": "", "since_s": "0"}',
        b'{"number": 3, "is_engaged": false, "by": "a", "since_s": 0' + b" " * 5000 + b"}",
    ],
)
def test_a_damaged_file_holds_the_robot_and_says_so(tmp_path, damaged):
    path = tmp_path / "state.json"
    path.write_bytes(damaged)
    state = EmergencyFile(path).load()
    assert state.is_engaged
    assert f"{path} cannot be read" in state.sentence


def test_a_damaged_file_can_be_released_and_is_whole_then(tmp_path):
    file = EmergencyFile(tmp_path / "state.json")
    file.path.write_bytes(b"{")
    held = file.load()
    free = file.update(held, lambda state: released(state, by="a", now_s=held.since_s))
    assert not free.is_engaged
    assert file.load() == free


def test_a_folder_in_the_place_of_the_file_holds_the_robot(tmp_path):
    (tmp_path / "state.json").mkdir()
    file = EmergencyFile(tmp_path / "state.json")
    assert file.load().is_engaged
    with pytest.raises(OSError):
        file.update(file.load(), lambda state: released(state, by="a", now_s=NOW_S))


def test_writers_wait_for_each_other(tmp_path):
    path = tmp_path / "state.json"

    def change():
        file = EmergencyFile(path)
        for _ in range(10):
            file.update(Emergency(), lambda state: engaged(released(state, by="", now_s=0.0), by="", now_s=0.0))

    writers = [threading.Thread(target=change) for _ in range(4)]
    for writer in writers:
        writer.start()
    for writer in writers:
        writer.join(60.0)
    # Each change but the first one releases and engages: no change was lost.
    assert EmergencyFile(path).load() == Emergency(79, True, "", 0.0)


def test_json_is_what_it_was():
    state = engaged(Emergency(), by="a\nb", now_s=NOW_S)
    assert from_json(json.loads(json.dumps(to_json(state)))) == state
    assert "\n" not in state.by


def test_who_drives_or_has_a_goal_acts_against_it():
    server = Server("/arm", takes_frames=True)
    evidence = Evidence(
        velocities=(VelocitySeen("/joystick", "/cmd_vel", heard_s=9.5), VelocitySeen("/old", "/cmd_vel", heard_s=5.0)),
        goals=(LiveGoal(server, "1", 0),),
    )
    found = obedience_of_held(evidence, now_s=10.0)
    assert found.names == ("/arm", "/joystick")
    assert not found.is_complete
    assert obedience_of_held(Evidence(), now_s=10.0).is_complete
    assert not obedience_of_held(Evidence(is_complete=False), now_s=10.0).is_complete
