"""What a recording repeats is told from what is said now."""

from roboframenet_ros.replays import AGAIN, OLDEST_NS, Replays, Taken, is_old

NOW_NS = 1_000 * 1_000_000_000
OLD_NS = NOW_NS - OLDEST_NS - 1


def test_stamp_of_zero_or_of_the_future_is_not_old() -> None:
    assert is_old(OLD_NS, NOW_NS)
    assert not any(is_old(stamp_ns, NOW_NS) for stamp_ns in (0, NOW_NS - OLDEST_NS, NOW_NS, 2 * NOW_NS))


def test_each_command_is_taken_once() -> None:
    replays = Replays()
    assert replays.refusal("one", stamp_ns=NOW_NS, now_ns=NOW_NS) == ""
    assert replays.refusal("one", stamp_ns=NOW_NS, now_ns=NOW_NS) == AGAIN
    assert replays.refusal("two", stamp_ns=NOW_NS, now_ns=NOW_NS) == ""


def test_old_command_is_refused_with_its_age_each_time() -> None:
    replays = Replays()
    for _ in range(2):
        assert "was said 500 s ago" in replays.refusal("one", stamp_ns=NOW_NS // 2, now_ns=NOW_NS)


def test_command_that_a_slow_stage_had_for_long_is_taken_while_it_is_open() -> None:
    replays = Replays()
    replays.hear_open(["slow"], stamp_ns=NOW_NS, now_ns=NOW_NS)
    assert replays.refusal("other", stamp_ns=OLD_NS, now_ns=NOW_NS) != ""
    assert replays.refusal("slow", stamp_ns=OLD_NS, now_ns=NOW_NS) == ""


def test_what_a_recording_tells_of_open_commands_is_ignored() -> None:
    replays = Replays()
    replays.hear_open(["recorded"], stamp_ns=OLD_NS, now_ns=NOW_NS)
    assert replays.refusal("recorded", stamp_ns=OLD_NS, now_ns=NOW_NS) != ""


def test_ids_are_kept_to_a_number_and_no_id_is_none() -> None:
    taken = Taken()
    taken.add("")
    assert "" not in taken
    for number in range(2000):
        taken.add(str(number))
    assert "1999" in taken
    assert "0" not in taken
