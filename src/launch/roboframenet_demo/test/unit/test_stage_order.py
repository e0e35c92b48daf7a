"""What the stages report is shown in their order."""

import itertools

import pytest

from roboframenet_demo.stage_order import STAGES, StageOrder


@pytest.mark.parametrize("arrival", list(itertools.permutations(STAGES)))
def test_reports_are_shown_in_the_order_of_the_stages(arrival: str) -> None:
    order = StageOrder(longest_s=1.0)
    shown = [text for stage in arrival for text in order.add("7", stage, stage, now_s=0.0)]
    assert tuple(shown) == STAGES
    # The executor reports several times.
    assert order.add("7", "executor", "done", now_s=0.5) == ("done",)


def test_report_waits_only_for_its_own_command_and_not_for_long() -> None:
    order = StageOrder(longest_s=1.0)
    assert order.add("8", "executor", "resumed", now_s=0.0) == ()
    assert order.add("9", "stanford_parser_ros", "parsed", now_s=0.5) == ("parsed",)
    assert order.add("9", "question_answering", "answered", now_s=0.5) == ("answered",)
    assert order.due(now_s=0.9) == ()
    assert order.due(now_s=1.0) == ("resumed",)
    assert order.add("8", "executor", "done", now_s=1.1) == ("done",)
