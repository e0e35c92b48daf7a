"""The table of what people cry: what must stop the robot, and what must not.

The frozen third was set aside before the rule was written. At first sight the rule had 379 of its 379 utterances right,
219 that must stop and 160 that must not; of the open ones, 747 of 752.
"""

import os
from collections import Counter

import pytest

from command_server.stop_words import CRIES, find_cry, is_stop


def rows():
    path = os.path.join(os.path.dirname(__file__), "stop_table.tsv")
    with open(path, encoding="utf-8") as file:
        return [tuple(line.rstrip("\n").split("\t")) for line in file if not line.startswith("#")]


def test_the_table_is_large_enough_and_has_each_utterance_once():
    counts = Counter("no" if kind == "no" else "stop" for _, kind, _ in rows())
    assert counts["stop"] >= 300 and counts["no"] >= 300
    assert [utterance for utterance, times in Counter(row[0] for row in rows()).items() if times > 1] == []


@pytest.mark.parametrize("utterance, kind, _part", rows())
def test_table(utterance, kind, _part):
    cry = find_cry(utterance)
    assert (cry.kind.value if cry else "no") == kind


@pytest.mark.parametrize("utterance", [row[0] for row in rows() if row[1] != "no"])
def test_capitals_do_not_matter(utterance):
    assert is_stop(utterance.upper())


@pytest.mark.parametrize("utterance", [row[0] for row in rows() if row[1] != "no"])
def test_what_is_quoted_or_told_to_somebody_else_stops_nothing(utterance):
    assert not is_stop(f'Say "{utterance.strip(chr(34))}" to Anna.')
    assert not is_stop(f"tell Anna {utterance.rstrip('.!?')}") or any(mark in utterance for mark in ".!?")


@pytest.mark.parametrize("utterance", [row[0] for row in rows() if row[1] != "no"])
def test_a_name_a_filler_or_politeness_in_front_changes_nothing(utterance):
    for front in ("Robot, ", "please ", "okay ", "uh ", "hey robot "):
        assert is_stop(front + utterance) or " " not in utterance.strip()


def test_each_cry_of_the_table_of_words_stands_once_and_stops():
    phrases = [phrase for _, _, phrases in CRIES for phrase in phrases.split(";")]
    assert [phrase for phrase, times in Counter(map(str.strip, phrases)).items() if times > 1] == []
    for kind, tail, phrases in CRIES:
        for phrase in phrases.split(";"):
            cry = find_cry(phrase + (" that" if tail.value == "needs_object" else ""))
            assert cry is not None and cry.kind is kind, phrase
