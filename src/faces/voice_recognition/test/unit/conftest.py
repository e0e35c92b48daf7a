"""Tests of what pocketsphinx hears in a sound, which its versions hear differently."""

from importlib.metadata import PackageNotFoundError, version
from typing import List

import pytest

#: Sounds that version 0.1.15, of Debian 12, hears, and 5.0.4, which pip has for newer Pythons, does not.
_NOT_HEARD_BY_5 = frozenset(
    [
        "test_a_command_that_sounds_like_a_stop_is_none",
        "test_a_cry_is_a_stop_though_it_is_long",
        "test_a_stop_is_heard_in_noise",
        "test_an_emergency_stop_is_told_from_a_stop",
        "test_answers_are_heard",
        "test_clean_sentences_are_right_or_asked_again",
        "test_commands_are_heard",
        "test_talk_and_silence_move_nothing",
        "test_whisper_decides_about_a_doubtful_one",
        "test_who_cannot_tell_or_does_not_answer_decides_nothing",
    ]
)


def pytest_collection_modifyitems(items: List[pytest.Item]) -> None:
    """Skip them with another version."""
    try:
        is_other = not version("pocketsphinx").startswith("0.")
    except PackageNotFoundError:
        return
    skip = pytest.mark.skip(reason="the sounds are those that pocketsphinx 0.1.15 hears")
    for item in items:
        if is_other and item.path.parent.parent.parent.name == "voice_recognition":
            if getattr(item, "originalname", item.name) in _NOT_HEARD_BY_5:
                item.add_marker(skip)
