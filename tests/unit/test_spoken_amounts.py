"""Spoken amounts become the right radians and metres, or the robot asks or refuses; they are never wrong."""

import pytest
from spoken_amounts.judging import Judge, table
from spoken_amounts.phrases import SEED, generate


@pytest.fixture(scope="module")
def judge() -> Judge:
    return Judge()


def judged(judge: Judge, count: int, policy: str) -> None:
    verdicts = list(judge.verdicts(generate(count, SEED), policy))
    print("\n".join(table(verdicts)))
    wrong = [
        (verdict.phrase.text, verdict.phrase.motions, verdict.done)
        for verdict in verdicts
        if verdict.outcome == "wrong"
    ]
    assert not wrong
    plain = [verdict for verdict in verdicts if verdict.phrase.motions is not None and verdict.phrase.is_within_limits]
    # A framer that refuses everything would never be wrong.
    assert sum(verdict.outcome == "right" for verdict in plain) > 0.9 * len(plain)


@pytest.mark.parametrize("policy", ["strict", "ignore"])
def test_a_sample_is_never_wrong(judge: Judge, policy: str) -> None:
    judged(judge, 300, policy)


@pytest.mark.acceptance
@pytest.mark.parametrize("policy", ["strict", "ignore"])
def test_ten_thousand_are_never_wrong(judge: Judge, policy: str) -> None:
    judged(judge, 10_000, policy)
