"""What an id tells of how a command came."""

import pytest

from roboframenet_ros.command_ids import TextIds, TextSource, came_by_action, is_spoken, sent_on_id


def test_ids_differ_within_a_run_and_between_runs():
    runs = [TextIds(TextSource.TEXT) for _ in range(3)]
    given = [run.next_id() for run in runs for _ in range(3)]
    assert len(set(given)) == 9


@pytest.mark.parametrize("source", TextSource)
def test_what_came_as_text_cannot_be_cancelled_by_its_id(source):
    assert not came_by_action(TextIds(source).next_id())
    assert came_by_action(sent_on_id(TextIds(source).next_id(), 1))


def test_goal_of_a_program_came_by_action():
    assert came_by_action("/page-1-1795358987.551")
    assert not is_spoken("/page-1-1795358987.551")


def test_what_a_fleet_sends_on_is_spoken_if_it_was_spoken_to_the_fleet():
    said = TextIds(TextSource.TEXT).next_id()
    assert is_spoken(said)
    assert is_spoken(sent_on_id(said, 7))
    assert not is_spoken(sent_on_id("/page-1-1795358987.551", 7))
